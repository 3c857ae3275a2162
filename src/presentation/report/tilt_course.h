/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How a drawing that moves goes through the moments of a test: by their time; where nothing is
 * timed, by the tilt. It takes as long as the motion did, slowed down or hastened to between 2 and
 * 12 seconds. */

#ifndef TP_REPORT_TILT_COURSE_H
#define TP_REPORT_TILT_COURSE_H

#include "report/tilt_svg.h"

typedef struct tp_tilt_course {
  const tp_tilt_view *view;
  double from, to; /* time, or tilt where nothing is timed: what is shown of the test */
  double seconds;  /* that the drawing takes */
  bool timed;
} tp_tilt_course;

tp_tilt_course tp_tilt_course_of(const tp_tilt_view *view, bool timed);

/* The time or tilt of a moment. */
double tp_tilt_course_at(const tp_tilt_course *course, const tp_tilt_moment *moment);

#endif
