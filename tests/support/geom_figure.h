/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rings of whole numbers to ask the geometry about, and their vectors in 128 bits. */

#ifndef TP_TEST_GEOM_FIGURE_H
#define TP_TEST_GEOM_FIGURE_H

#include "geom/geom.h"

#include "random_numbers.h"

enum { MOST = 64, RINGS = 3 };
typedef struct figure {
  size_t ring_count, count, start[RINGS + 1];
  double u[MOST], v[MOST];
} figure;

typedef __int128 wide;
typedef struct vector {
  wide u, v;
} vector;

/* Rings in the coordinates of one path only, lest it take the other's; big ones moved, scaled. */
tp_geom_rings view(const figure *f, bool small);

void add_ring(figure *f, const long (*points)[2], size_t count);
/* 3 to 9 vertices on the grid 0 … 6, no two neighbours equal. */
void add_random_ring(figure *f, random_numbers *state);

/* Star-shaped about (u, 0): angles jump by less than a half turn, radii are 0.3 to 1 `radius`. */
void add_star(figure *f, long u, double radius, size_t count, random_numbers *state);

size_t ring_of(const figure *f, size_t vertex);
size_t next_of(const figure *f, size_t vertex);
vector between(const figure *f, size_t from, size_t to);
wide cross(vector a, vector b);

#endif
