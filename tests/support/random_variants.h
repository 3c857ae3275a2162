/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Changes of a scene that change nothing, or something known, about its block. */

#ifndef TP_TEST_RANDOM_VARIANTS_H
#define TP_TEST_RANDOM_VARIANTS_H

#include "compare_solutions.h"
#include "random_scenes.h"

typedef struct random_variant {
  const char *name;
  /* Change the scene, and tell how its solution is related to the one before. False: it does not
   * apply to this scene. */
  bool (*change)(random_scene *scene, relation *r, random_numbers *state);
} random_variant;

enum { VARIANTS = 11 };
extern const random_variant random_variants[VARIANTS];

/* Give the scene whole and even vertices and no move; then all its lengths times 2^power. What the
 * lattice takes for the middle of the block is then the same point at every power. */
void random_scene_make_even(random_scene *scene);
void random_scene_double(random_scene *scene, int power);

#endif
