/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The quantities of a scene at many points, shared out to threads; and by the first of several
 * ranks, which alone knows the points, to the others. */

#ifndef TP_STUDY_POINTS_H
#define TP_STUDY_POINTS_H

#include "study/study.h"

/* What there is of each: the quantities, and the tilt. */
enum { TP_POINT_TILT = TP_STUDY_QUANTITIES, TP_POINT_NUMBERS };

/* Of each of `count` points, whose values are one point after another; NaN where there is no
 * number.
 * `*stopped` where options.stop said so. */
TP_MUST_USE tp_status tp_study_solve_points(double *numbers, const tp_study *study,
                                            const double *values, size_t count,
                                            const tp_study_options *options, bool *stopped,
                                            tp_message *message);

/* Of a rank that is not the first: solve what the first gives out, until it ends that. What failed
 * is told to the first. */
TP_MUST_USE tp_status tp_study_help_with_points(const tp_study *study,
                                                const tp_study_options *options,
                                                tp_message *message);
/* Of the first, with its status, which it returns if all goes well. */
TP_MUST_USE tp_status tp_study_end_points(const tp_study_options *options, tp_status status,
                                          tp_message *message);

#endif
