/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Splines by knots and control points, with weights or without (NURBS), as chords.
 *
 * Over a span between two knots the spline is a Bezier curve, whose control points are values of
 * its polar form, b_k = f(u, … u, v, … v) with k times v, found by de Boor's scheme in rationals.
 * Ends of the spline that are control points stay what they are; ends of spans are rounded as
 * chords' are. */

#ifndef TP_FORMAT_SPLINE_H
#define TP_FORMAT_SPLINE_H

#include "format/curve.h"

typedef struct tp_spline {
  int degree;
  long count; /* of control points */
  tp_control_point *points;
  fmpq *knots; /* count + degree + 1 of them, in order */
} tp_spline;

/* Into an object without points. `*problem` says what keeps it from being an outline, a static
 * text, and is left alone else. */
TP_MUST_USE tp_curve_outcome tp_spline_add(tp_drawing_object *object, const tp_spline *spline,
                                           const fmpq_t tolerance, tp_mark mark,
                                           const char **problem);

#endif
