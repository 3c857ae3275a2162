/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Blocks and bases on a tiny grid, on which shared edges, notches and corners on corners are the
 * rule, and what touches by every pair of their edges, in whole numbers. */

#ifndef TP_TEST_GRID_CONTACT_H
#define TP_TEST_GRID_CONTACT_H

#include "base/profile.h"
#include "random_numbers.h"

enum { GRID = 6, GRID_MOST_VERTICES = 7, GRID_MOST_POINTS = 5, GRID_MOST_RESTRAINTS = 200 };

typedef struct grid_point {
  long x, y;
} grid_point;

/* (b - a) x (d - c) and (b - a) . (d - c) */
long grid_cross(grid_point a, grid_point b, grid_point c, grid_point d);
long grid_dot(grid_point a, grid_point b, grid_point c, grid_point d);
bool grid_same(grid_point a, grid_point b);

/* The block's outline, counter-clockwise; the base from its lower left corner along the profile to
 * its lower right one. */
typedef struct grid_figure {
  long outline_count, base_count;
  grid_point outline[GRID_MOST_VERTICES + 1], base[GRID_MOST_VERTICES + GRID_MOST_POINTS + 4];
} grid_figure;

/* A simple polygon; a profile from left to right, with a step now and then, but not at its ends. */
void grid_draw_outline(grid_figure *f, random_numbers *state);
void grid_draw_profile(tp_polyline *profile, random_numbers *state);

/* The outline into an empty ring of a section; the base from what the library made of it. */
void grid_set_ring(tp_polyline *ring, const grid_figure *f);
void grid_take_base(grid_figure *f, const tp_base *base);

/* A point of the lattice of ring and base. */
grid_point grid_point_of(const grid_figure *f, long point);

/* A point that may not be pressed through a line of a direction, which is in lowest terms. */
typedef struct grid_restraint {
  grid_point at, along;
} grid_restraint;

typedef struct grid_restraints {
  long count;
  grid_restraint of[GRID_MOST_RESTRAINTS];
} grid_restraints;

bool grid_contains(const grid_restraints *all, grid_restraint own);

/* Add one by two points of its line, if it is not there yet. */
void grid_add(grid_restraints *all, grid_point at, grid_point from, grid_point to);

/* All that restrains, and without directions the vertices of either that lie on the other. The
 * lower corners of the base are out of reach. */
void grid_compare_edges(grid_restraints *all, grid_restraints *touching, const grid_figure *f);

/* Does the block lie partly below a profile that runs from left to right? Between two neighbouring
 * abscissae of the grid its lowest edge and the profile are straight. */
bool grid_overlaps(const grid_figure *f);

#endif
