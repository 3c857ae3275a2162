/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Points, circles and arcs in exact rationals: the point at the angle t from another one is
 * rational with tan(t / 2), (1 - u^2, 2 u) / (1 + u^2), so an arc needs no roots. */

#ifndef TP_BLOCK_CIRCLE_H
#define TP_BLOCK_CIRCLE_H

#include <flint/fmpq.h>
#include <stdbool.h>

/* A point or a vector. */
typedef struct tp_point {
  fmpq_t x, y;
} tp_point;

void tp_point_init(tp_point *p);
void tp_point_clear(tp_point *p);
void tp_point_difference(tp_point *d, const tp_point *p, const tp_point *q);

/* p + t q */
void tp_point_along(tp_point *sum, const tp_point *p, const fmpq_t t, const tp_point *q);

/* An arc from p to q, counter-clockwise about its centre. */
typedef struct tp_circle_arc {
  tp_point p, q, centre;
} tp_circle_arc;

void tp_circle_arc_init(tp_circle_arc *a);
void tp_circle_arc_clear(tp_circle_arc *a);

/* The centre of the arc from p through m to q; false where m is not to the right of the chord. */
bool tp_circle_arc_set_centre(tp_circle_arc *a, const tp_point *m);

/* Its angle, in (0, 2 pi), rounded: for the choice of points on it alone. */
double tp_circle_arc_angle(const tp_circle_arc *a);

/* A point of the circle: p turned about the centre by the angle whose half has the tangent t. */
void tp_circle_arc_point(tp_point *r, const tp_circle_arc *a, const fmpq_t t);

/* Where the tangents at two points of the circle meet. */
void tp_circle_arc_tangents_meet(tp_point *m, const tp_circle_arc *a, const tp_point *p,
                                 const tp_point *q);

#endif
