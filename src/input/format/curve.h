/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Curves into chains of points and arcs.
 *
 * Arcs stay arcs: from p to q with the bulge b, the tangent of a quarter of the angle, so that a
 * piece of it from p on with the tangent t of a quarter of its own angle ends in a point that is
 * rational where p, q, b and t are. Chords in place of arcs, and of Bezier curves, leave the curve
 * by at most a tolerance; their ends are rounded to decimals finer than 1/1000 of that.
 *
 *   arc of radius r and angle A in n chords: r (1 - cos(A / 2n)) <= r (A / n)^2 / 8
 *   Bezier curve, rational with weights above zero: it lies in the hull of its control points, so
 *   within the largest distance of these from its chord; halved until that is small enough */

#ifndef TP_FORMAT_CURVE_H
#define TP_FORMAT_CURVE_H

#include "format/drawing.h"

#include <arb.h>

enum { TP_CURVE_DEGREE = 10 }; /* of a spline, at most */

/* Of the tolerance, for the distance of curve and chord; the rest is for the rounding of its ends.
 */
#define TP_CURVE_SHARE 0.99

typedef enum tp_curve_outcome {
  TP_CURVE_DONE,
  TP_CURVE_NO_MEMORY,
  TP_CURVE_TOO_FINE /* more points than the object may have (format/drawing_work.h) */
} tp_curve_outcome;

/* Why an object that is too fine can be no outline. */
#define TP_CURVE_TOO_FINE_TEXT                                                                     \
  "takes too many chords at this 'tolerance', half a million and more; give a larger one"

/* The tolerance of the options; where there is none, 1/10000 of a length that a curve has. */
void tp_curve_tolerance(fmpq_t tolerance, const tp_drawing_options *options, const fmpq_t length);

/* To the nearest decimal that is finer than the tolerance by three places. */
void tp_curve_round(fmpq_t value, const fmpq_t tolerance);

/* A whole circle, exactly: the object is empty, and closed then. */
TP_MUST_USE bool tp_curve_circle(tp_drawing_object *object, const fmpq_t x, const fmpq_t y,
                                 const fmpq_t radius, tp_mark mark);

/* An arc counter-clockwise about a centre from one angle, in radians, to another that is larger by
 * at most a turn: the object is empty, and open then. Its ends are within 1e-18 of the radius;
 * `uncertainty` says how far from there the file may mean them. */
TP_MUST_USE bool tp_curve_arc(tp_drawing_object *object, const fmpq_t x, const fmpq_t y,
                              const fmpq_t radius, const arb_t from, const arb_t to, tp_mark mark);

/* A ball of many bits as a decimal within 1e-18 of its size, or of 1 where it is smaller. */
void tp_curve_decimal(fmpq_t value, const arb_t ball);

/* Chords in place of all arcs. */
TP_MUST_USE tp_curve_outcome tp_curve_flatten(tp_drawing_object *object, const fmpq_t tolerance);

/* A closed object of two points with arcs gets a point in the middle of each arc, on it. */
TP_MUST_USE bool tp_curve_split_lens(tp_drawing_object *object);

/* A control point with its weight, in homogeneous coordinates x w, y w, w. */
typedef struct tp_control_point {
  fmpq_t x, y, w;
} tp_control_point;

void tp_control_points_init(tp_control_point *points, long count);
void tp_control_points_clear(tp_control_point *points, long count);

/* Chords of a Bezier curve behind the last point of the object, which is its first control point;
 * its last one ends it, as it stands. The control points are used up. */
TP_MUST_USE tp_curve_outcome tp_curve_bezier(tp_drawing_object *object, tp_control_point *points,
                                             int degree, const fmpq_t tolerance, tp_mark mark);

/* Say of an object that chords leave a curve by that. */
void tp_curve_deviates(tp_drawing_object *object, const fmpq_t tolerance);

#endif
