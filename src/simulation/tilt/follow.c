/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Mechanism from the velocity of the block as it begins to move, and the run of dynamics after
 * that, appended to the history of the ramp with shifted times. */

#include "tilt/follow.h"

#include "tilt/peak.h"
#include "tilt/settings.h"

#include <math.h>

static const tp_tilt_end ends[] = {
    [TP_RUN_STANDS] = TP_TILT_STANDS,       [TP_RUN_RESTS] = TP_TILT_RESTS,
    [TP_RUN_MOVES] = TP_TILT_MOVES,         [TP_RUN_OVERTURNED] = TP_TILT_OVERTURNED,
    [TP_RUN_LEFT_BASE] = TP_TILT_LEFT_BASE, [TP_RUN_UNDECIDED] = TP_TILT_OPEN,
    [TP_RUN_NO_MEMORY] = TP_TILT_OPEN};

/* ---- how it begins -----------------------------------------------------------------------------
 */

tp_mechanism tp_tilting_mechanism(tp_xy *centre, bool *has_centre, const tp_rigid_body *body,
                                  const tp_body_state *moving) {
  const double near = 0.01 * body->extent_m;
  const double speed = hypot(moving->speed.x, moving->speed.y);
  *has_centre = fabs(moving->turning) * body->extent_m > 1e-3 * speed && moving->turning != 0;
  if (!*has_centre) return speed > 0 ? TP_SLIDES : TP_MECHANISM_UNDECIDED;
  *centre = (tp_xy){moving->moved.x - moving->speed.y / moving->turning,
                    moving->moved.y + moving->speed.x / moving->turning};
  for (long k = 0; k < body->closed_count; k++) {
    const tp_xy at = tp_rigid_body_place(moving, body->closed[k].at);
    if (hypot(at.x - centre->x, at.y - centre->y) < near) return TP_TOPPLES;
  }
  return TP_SLIDES_AND_TOPPLES;
}

/* ---- to the end --------------------------------------------------------------------------------
 */

/* That the block begins to move, and what its contacts do as it does, is in the history of a ramp
 * already: of the events behind `from` those of that moment are left out, and that it begins to
 * move for the first time. */
static void drop_told(tp_history *history, size_t from) {
  size_t kept = from;
  /* of two events at one time that are alike the second is not told: one at the start is not there
   */
  bool begun = from > 0 && history->events[from - 1].time_s == 0;
  for (size_t k = from; k < history->event_count; k++) {
    const tp_tilt_event event = history->events[k];
    const bool begins = event.what == TP_EVENT_COLLAPSES && !begun;
    begun = begun || begins;
    if (event.time_s == 0 || begins) continue;
    history->events[kept++] = event;
  }
  history->event_count = kept;
}

/* What was added behind these happened `later`. */
static void shift_times(tp_history *history, size_t events, size_t moments, double later) {
  for (size_t k = events; k < history->event_count; k++) history->events[k].time_s += later;
  for (size_t k = moments; k < history->moment_count; k++) history->moments[k].time_s += later;
}

static double last_time(const tp_history *history) {
  double last = 0;
  if (history->event_count > 0) last = history->events[history->event_count - 1].time_s;
  if (history->moment_count > 0) {
    last = fmax(last, history->moments[history->moment_count - 1].time_s);
  }
  return last;
}

tp_status tp_tilting_follow(tp_tilting *tilting) {
  const tp_tilt_settings *s = tilting->settings;
  const bool release = s->protocol == TP_TILT_RELEASE;
  const double from = tp_tilt_radians(release ? s->release_deg : tilting->own->lets_go_at_deg);
  const double longest = tp_tilt_duration(s, tilting->body) + tilting->shaking_s;
  const bool ramp = s->protocol == TP_TILT_RAMP;
  const tp_drive drive = {.angle = from,
                          .speed = ramp ? tp_tilt_radians(s->speed_deg_min) / 60 : 0,
                          .final_angle = ramp ? tp_tilt_radians(s->until_deg) : from,
                          .shaking = tilting->shaking};
  tp_turn_range turns = {0};
  const tp_run run = {.drive = &drive,
                      .longest_s = longest,
                      .moments_every_s = longest / (double)(tilting->options->moments - 1),
                      .history = &tilting->history,
                      .turns = tilting->shaking != NULL ? &turns : NULL};
  const size_t events = tilting->history.event_count, moments = tilting->history.moment_count;
  const double later = last_time(&tilting->history);
  tp_body_state last = {.turned = 0};
  tp_run_end end = TP_RUN_UNDECIDED;
  const tp_status status = tp_tilting_run(&end, &last, tilting, &run);
  if (status != TP_OK) return status;
  if (ramp) drop_told(&tilting->history, events);
  shift_times(&tilting->history, events, moments, later);
  tp_tilt_case *own = tilting->own;
  own->end = end == TP_RUN_UNDECIDED && tp_tilting_stopped(tilting) ? TP_TILT_STOPPED : ends[end];
  own->run_out_m = (tilting->body->towards == TP_TOWARDS_LEFT ? -1 : 1) * last.moved.x;
  own->turned_deg = tp_tilt_degrees(last.turned);
  if (tilting->shaking != NULL) tp_tilting_peak(tilting, &turns, from);
  return TP_OK;
}
