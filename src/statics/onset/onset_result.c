/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* First window above level and all windows of a case as bounded tilts, with their mechanisms and
 * centres of rotation. */

#include "onset/onset_result.h"

#include "evaluation/loaded.h"

#include <math.h>
#include <stdlib.h>

long tp_onset_first_window(const tp_motion_windows *windows, const tp_judge *judge) {
  arb_t level;
  arb_init(level);
  long found = TP_NO_WINDOW;
  for (long k = 0; k < windows->count && found == TP_NO_WINDOW; k++) {
    const tp_motion_window *w = windows->items + k;
    const tp_answer holds = tp_window_holds(w, level);
    if (holds == TP_YES || (!w->from.endless && arb_is_positive(w->from.degrees))) found = k;
    if (holds != TP_OPEN) continue;
    const bool at_lower_end = !w->from.endless && arb_contains_zero(w->from.degrees);
    found = at_lower_end && tp_judge_takes_equal(judge) ? k : TP_WINDOW_OPEN;
  }
  arb_clear(level);
  return found;
}

void tp_onset_centre(tp_bounded *x_m, tp_bounded *y_m, const tp_onset_telling *t,
                     const tp_vector *twist) {
  const tp_evaluation *e = t->e;
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  arb_div(x, twist->of + 1, twist->of + 2, e->rung.bits);
  arb_neg(x, x);
  arb_div(y, twist->of, twist->of + 2, e->rung.bits);
  tp_ball_mirror(x, t->result->towards);
  tp_loaded_metres(x, y, e);
  tp_result_place(x_m, y_m, e, x, y, e->log2_extent, t->certainty);
  arb_clear(x);
  arb_clear(y);
}

static bool set_windows(const tp_onset_telling *t) {
  const tp_motion_windows *w = t->windows;
  tp_onset *onset = &t->result->onset;
  onset->windows = calloc((size_t)w->count + 1, sizeof *onset->windows);
  if (onset->windows == NULL) return false;
  onset->window_count = (size_t)w->count;
  for (long k = 0; k < w->count; k++) {
    const tp_motion_window *from = w->items + k;
    tp_window *own = onset->windows + k;
    own->from_below = from->from.endless;
    own->to_above = from->to.endless;
    own->begins = from->mechanism;
    if (!own->from_below) own->from_deg = tp_result(t->e, from->from.degrees, t->certainty);
    if (!own->to_above) own->to_deg = tp_result(t->e, from->to.degrees, t->certainty);
  }
  return true;
}

static void set_first(const tp_onset_telling *t, const tp_motion_window *w) {
  tp_onset *onset = &t->result->onset;
  onset->mechanism = w->mechanism;
  onset->tie = w->tie;
  onset->tied_with = w->tied_with;
  onset->tie_bits = w->tie && !w->tie_exact ? t->question->judge.bits : 0;
  onset->kind = w->from.endless ? TP_ONSET_NOWHERE : TP_ONSET_AT_ANGLE;
  if (w->from.endless) return;
  onset->critical_angle_deg = tp_result(t->e, w->from.degrees, t->certainty);
  onset->has_centre = w->has_ray && t->motions->twists.rays[w->ray].axis < 0;
  if (onset->has_centre) {
    tp_onset_centre(&onset->centre_x_m, &onset->centre_y_m, t,
                    &t->motions->twists.rays[w->ray].twist);
  }
}

bool tp_onset_describe(const tp_onset_telling *t, long first) {
  if (!set_windows(t)) return false;
  if (first >= 0) {
    set_first(t, t->windows->items + first);
  } else {
    t->result->onset.kind = TP_ONSET_NEVER;
    t->result->onset.mechanism = TP_STANDS;
  }
  return true;
}
