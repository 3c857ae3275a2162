/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scenes of small blocks on small bases, what touches in them, and the library's solution. */

#ifndef TP_TEST_GRID_SCENE_H
#define TP_TEST_GRID_SCENE_H

#include "exact_vectors.h"
#include "grid_contact.h"
#include "topple.h"

typedef struct grid_scene {
  grid_figure f;
  grid_restraints all, touching;
  exact_point centroid;
  long friction_deg;
} grid_scene;

/* A block that touches its base and does not cut into it; friction of 0, 20, 45 or 70 degrees. */
void grid_scene_init(grid_scene *s, random_numbers *state);
void grid_scene_clear(grid_scene *s);

/* Solved towards both sides, tilted by 45 degrees. */
void grid_scene_solve(tp_solution **solution, const grid_scene *s);

#endif
