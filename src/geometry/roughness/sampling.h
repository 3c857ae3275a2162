/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A profile sampled anew at an even step, and with a straight line taken off. */

#ifndef TP_ROUGHNESS_SAMPLING_H
#define TP_ROUGHNESS_SAMPLING_H

#include "roughness/course.h"

/* The heights at 0, step, 2 step, ... as far as the course goes: on the straight lines between
 * them, or on the natural cubic spline through them. Fails where fewer than two steps fit, or more
 * than 50 million. `sampled` is empty on failure. */
TP_MUST_USE tp_status tp_course_resample(tp_course *sampled, const tp_course *course, double step,
                                         tp_profile_resampling resampling, tp_message *message);

/* The slope of the line of least squares through the whole chain, not its points alone: that
 * minimises the integral of the squared distance along y. `middle` gets its height amid the
 * length. */
tp_bounded tp_course_trend(const tp_course *course, tp_bounded *middle);

/* Take a line off. */
void tp_course_detrend(tp_course *course, tp_profile_detrend detrend);

#endif
