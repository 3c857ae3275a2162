/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Interval of time or tilt that an animation shows, with long rests cut, and its duration. */

#include "report/tilt_course.h"

#include <math.h>

double tp_tilt_course_at(const tp_tilt_course *course, const tp_tilt_moment *moment) {
  return course->timed ? moment->time_s : moment->angle_deg;
}

/* A table may tilt for minutes before the block begins to move: as much of it is shown as of the
 * motion, at most. A block may rest for minutes after: a tenth as much is. */
static void leave_out_rest(tp_tilt_course *c) {
  const tp_tilt_case *own = c->view->own;
  double begins = c->from, ends = c->to;
  for (size_t k = 0; k < own->event_count; k++) {
    const tp_tilt_event *e = own->events + k;
    if (e->what == TP_EVENT_COLLAPSES) begins = e->time_s;
    if (e->what == TP_EVENT_RESTS) ends = e->time_s;
  }
  if (own->end != TP_TILT_RESTS) ends = c->to;
  if (!(ends > begins)) return;
  c->from = fmax(c->from, begins - (ends - begins));
  c->to = fmin(c->to, ends + 0.1 * (ends - begins));
}

tp_tilt_course tp_tilt_course_of(const tp_tilt_view *view, bool timed) {
  const tp_tilt_case *own = view->own;
  tp_tilt_course c = {.view = view, .timed = timed, .seconds = 8};
  if (own->moment_count == 0) return c;
  c.from = tp_tilt_course_at(&c, own->moments);
  c.to = tp_tilt_course_at(&c, own->moments + own->moment_count - 1);
  if (timed) leave_out_rest(&c);
  if (timed) c.seconds = fmin(12, fmax(2, c.to - c.from));
  return c;
}
