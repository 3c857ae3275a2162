/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Moments of regions with curved sides, in balls: sums of triangles, of which the integral of a
 * product of coordinates p q is A / 12 (sum p sum q + sum p q over the corners), and of circular
 * sectors about their own centres, moved to the origin. The balls are the bound. */

#ifndef TP_BLOCK_REGION_H
#define TP_BLOCK_REGION_H

#include "block/ring_sums.h"

/* Area, int x, int y, int x^2, int y^2, int x y. */
typedef struct tp_region {
  arb_struct of[6];
} tp_region;

void tp_region_init(tp_region *region);
void tp_region_clear(tp_region *region);

typedef struct tp_ball_point {
  arb_t x, y;
} tp_ball_point;

void tp_ball_point_init(tp_ball_point *point);
void tp_ball_point_clear(tp_ball_point *point);

/* (q - p) x (r - p): twice the area of the triangle, above zero where it is counter-clockwise. */
void tp_ball_point_cross(arb_t cross, const tp_ball_point *p, const tp_ball_point *q,
                         const tp_ball_point *r, long bits);

/* Add the triangle p, q, r: positive counter-clockwise. */
void tp_region_add_triangle(tp_region *region, const tp_ball_point *p, const tp_ball_point *q,
                            const tp_ball_point *r, long bits);

/* Take off the sector of a circle about `centre` of the given radius and angle (radians), whose
 * bisector points in the direction of the unit vector `along`. In the frame of the bisector and its
 * normal, of a sector of radius r and angle t: area r^2 t / 2, first moment 2/3 r^3 sin(t / 2)
 * along the bisector, second moments r^4 (t + sin t) / 8 and r^4 (t - sin t) / 8. */
void tp_region_subtract_sector(tp_region *region, const tp_ball_point *centre, const arb_t radius,
                               const arb_t angle, const tp_ball_point *along, long bits);

/* Add the tip between two tangents of a circle, which meet in `vertex`, and their arc: the kite of
 * vertex, tangent points and centre less the sector. */
void tp_region_add_tip(tp_region *region, const tp_ball_point *vertex, const tp_ball_point *before,
                       const tp_ball_point *after, const tp_ball_point *centre, long bits);

/* Add the segment between a chord of a circle, of less than half of it, and its arc; the chord runs
 * clockwise about the centre. */
void tp_region_add_segment(tp_region *region, const tp_ball_point *from, const tp_ball_point *to,
                           const tp_ball_point *centre, long bits);

/* In the scale of the boundary sums: twice the area, six times the first moments, … */
void tp_region_sums(arb_struct sums[TP_SUM_COUNT], const tp_region *region, long bits);

#endif
