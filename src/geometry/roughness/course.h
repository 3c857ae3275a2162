/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The course of a profile: its points in doubles, with one bound for all abscissas and one for all
 * heights: |x - truth| <= x_error, |y - truth| <= y_error. They come from exact points, moved
 * exactly so that the first lies at the origin, and only then rounded; every step after that adds
 * what it rounds. */

#ifndef TP_ROUGHNESS_COURSE_H
#define TP_ROUGHNESS_COURSE_H

#include "number/bounded.h"
#include "plane/polyline.h"
#include "topple_profile.h"

/* The least and the largest distance along x; bounds of the sizes of all slopes and heights. */
typedef struct tp_course_extent {
  double least_step, largest_step, steepest, highest;
} tp_course_extent;

typedef struct tp_course {
  size_t count;
  double *x, *y;
  double x_error, y_error;
  tp_course_extent extent;
} tp_course;

void tp_course_clear(tp_course *course);

/* Room for so many; false when memory is exhausted, and then empty. */
TP_MUST_USE bool tp_course_init(tp_course *course, size_t count);

/* Of a chain from left to right without upright steps, scaled; else bad input at the point that
 * turns back. On failure `course` is empty. */
TP_MUST_USE tp_status tp_course_from_chain(tp_course *course, const tp_polyline *chain,
                                           double scale, tp_message *message);

/* The points of a chain in doubles, scaled, the first one at the origin; `course` has room. */
void tp_course_convert(tp_course *course, const tp_polyline *chain, double scale);

/* Exchange left and right. */
void tp_course_mirror(tp_course *course);

/* Look at all points for their extent. */
void tp_course_measure(tp_course *course);

/* Do all points lie where even distances would put them, but for a millionth of one? */
bool tp_course_are_even(const tp_course *course);

#endif
