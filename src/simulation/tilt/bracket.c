/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Bisection between a tilt at which a run stands and one at which it moves, begun at the tilts that
 * statics expects. */

#include "tilt/bracket.h"

#include <math.h>

/* What runs have shown by now. */
typedef struct search {
  tp_tilting *tilting;
  tp_tilt_look *look;
  double least_deg, most_deg;
  bool stands, moves; /* at `least_deg`, at `most_deg`; else it was not run there */
  bool ended;         /* a run was open, or stopped */
} search;

static void learn(search *s, tp_tilt_verdict verdict, double angle_deg) {
  if (verdict == TP_VERDICT_STANDS) {
    s->least_deg = angle_deg;
    s->stands = true;
  } else if (verdict == TP_VERDICT_MOVES) {
    s->most_deg = angle_deg;
    s->moves = true;
  } else {
    s->ended = true;
    s->tilting->own->end = verdict == TP_VERDICT_STOPPED ? TP_TILT_STOPPED : TP_TILT_OPEN;
  }
  tp_tilting_tell(s->tilting, s->least_deg, s->most_deg);
}

static tp_status look(search *s, double angle_deg) {
  tp_tilt_verdict verdict = TP_VERDICT_STOPPED;
  const tp_status status =
      tp_tilting_stopped(s->tilting) ? TP_OK : s->look(&verdict, s->tilting, angle_deg);
  if (status == TP_OK) learn(s, verdict, angle_deg);
  return status;
}

tp_status tp_tilting_look(tp_tilt_verdict *verdict, tp_tilting *tilting, double angle_deg) {
  tp_body_state last = {.turned = 0};
  const tp_status status = tp_tilting_try(verdict, &last, tilting, angle_deg, NULL);
  if (status == TP_OK && *verdict == TP_VERDICT_MOVES) tilting->moves_off = last;
  return status;
}

static tp_status narrow(search *s, double tolerance_deg) {
  tp_status status = TP_OK;
  while (status == TP_OK && !s->ended && s->stands && s->moves &&
         s->most_deg - s->least_deg > tolerance_deg) {
    const double middle = s->least_deg + 0.5 * (s->most_deg - s->least_deg);
    if (!(middle > s->least_deg && middle < s->most_deg)) break; /* no double between them */
    status = look(s, middle);
  }
  return status;
}

static void tell(const search *s, double tolerance_deg) {
  tp_tilt_case *own = s->tilting->own;
  const bool at_once = s->moves && s->most_deg == 0;
  own->stands_at_deg = s->stands ? s->least_deg : at_once ? 0 : NAN;
  own->lets_go_at_deg = s->most_deg;
  own->has_bracket = s->moves && (s->stands || s->most_deg == 0);
  own->converged =
      !s->ended &&
      (s->moves ? own->lets_go_at_deg - own->stands_at_deg <= tolerance_deg : s->stands);
}

tp_status tp_tilting_bracket(tp_tilting *tilting, tp_tilt_look *by, double least_deg,
                             double most_deg, double last) {
  const double tolerance = tilting->settings->tolerance_deg;
  search s = {.tilting = tilting, .look = by, .most_deg = last};
  tp_status status = TP_OK;
  if (least_deg > 0 && least_deg < last) status = look(&s, least_deg);
  if (status == TP_OK && !s.ended && most_deg > s.least_deg && most_deg < s.most_deg) {
    status = look(&s, most_deg);
  }
  if (status == TP_OK && !s.ended && !s.stands) status = look(&s, 0);
  if (status == TP_OK && !s.ended && !s.moves) status = look(&s, last);
  if (status == TP_OK) status = narrow(&s, tolerance);
  if (status == TP_OK) tell(&s, tolerance);
  return status;
}

/* The tilt at which a run began to move, by its history, which ends there: that it is sure to move
 * for good is noticed later, and the motion is simulated anew from there. */
static double cut_at_collapse(tp_history *history, double otherwise) {
  size_t k = history->event_count;
  while (k > 0 && history->events[k - 1].what != TP_EVENT_COLLAPSES) k--;
  if (k == 0) return otherwise;
  const tp_tilt_event *collapse = history->events + k - 1;
  history->event_count = k;
  while (history->moment_count > 0 &&
         history->moments[history->moment_count - 1].time_s > collapse->time_s) {
    history->moment_count--;
  }
  while (history->reaction_count > 0 &&
         history->reactions[history->reaction_count - 1].moment >= history->moment_count) {
    history->reaction_count--;
  }
  return collapse->angle_deg;
}

tp_status tp_tilting_ramp(tp_tilting *tilting) {
  const double tolerance = tilting->settings->tolerance_deg, until = tilting->settings->until_deg;
  search s = {.tilting = tilting, .look = tp_tilting_look, .most_deg = until};
  tp_tilt_verdict verdict = TP_VERDICT_OPEN;
  tp_body_state last = {.turned = 0};
  tp_status status = tp_tilting_try(&verdict, &last, tilting, until, &tilting->history);
  if (status != TP_OK) return status;
  if (verdict == TP_VERDICT_MOVES) tilting->moves_off = last;
  learn(&s, verdict,
        verdict == TP_VERDICT_MOVES ? cut_at_collapse(&tilting->history, until) : until);
  /* tables that stop ever farther before it, until one holds */
  double back = 0.9 * tolerance;
  while (status == TP_OK && s.moves && !s.stands && !s.ended && s.most_deg > 0) {
    status = look(&s, fmax(0, s.most_deg - back));
    back *= 4;
  }
  if (status == TP_OK) status = narrow(&s, tolerance);
  if (status == TP_OK) tell(&s, tolerance);
  return status;
}
