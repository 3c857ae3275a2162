/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Random polygons with integer vertices, counter-clockwise and simple. */

#ifndef TP_TEST_RANDOM_POLYGONS_H
#define TP_TEST_RANDOM_POLYGONS_H

#include "random_runs.h"

enum { POLYGON_MOST = 1024 };

typedef struct polygon {
  long count;
  long x[POLYGON_MOST], y[POLYGON_MOST];
} polygon;

void polygon_add(polygon *p, long x, long y);

/* Angles jump by 0.6 to 1.4 of a full turn over `count`, radii are 0.3 to 1 of the given ones:
 * simple while rounding to integers is less than a jump. */
void draw_star(polygon *p, long count, double radius_x, double radius_y, random_numbers *state);

/* Between a lower and an upper chain over rising x: `count` vertices or one more, steps up to
 * `step`, y up to `height` for the lower chain and beyond `height` up to twice that for the upper
 * one; upright at both ends. Teeth and slabs are of this kind. */
void draw_between_chains(polygon *p, long count, long step, long height, random_numbers *state);

/* x += along * y and y += up * x, one after the other: a shear keeps a polygon simple, and its
 * area.
 */
void polygon_shear(polygon *p, long along, long up);

#endif
