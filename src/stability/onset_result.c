/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "stability/onset_result.h"

#include "stability/loaded.h"

#include <math.h>
#include <stdlib.h>

long tp_onset_first_window(const tp_motion_windows *windows, const tp_judge *judge) {
  arb_t level;
  arb_init(level);
  long found = -1;
  for (long k = 0; k < windows->count && found == -1; k++) {
    const tp_motion_window *w = windows->items + k;
    const tp_answer holds = tp_window_holds(w, level);
    if (holds == TP_YES || (!w->from.endless && arb_is_positive(w->from.degrees))) found = k;
    if (holds != TP_OPEN) continue;
    const bool at_lower_end = !w->from.endless && arb_contains_zero(w->from.degrees);
    found = at_lower_end && judge->settled ? k : -2;
  }
  arb_clear(level);
  return found;
}

void tp_onset_centre(tp_bounded *x_m, tp_bounded *y_m, const tp_onset_telling *t,
                     const tp_vector *twist) {
  tp_evaluation *e = t->e;
  const tp_lattice *l = &e->problem->lattice;
  const double log2_size = (double)l->bits + log2(fmpq_get_d(l->step_m));
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  arb_div(x, twist->of + 1, twist->of + 2, e->rung.bits);
  arb_neg(x, x);
  arb_div(y, twist->of, twist->of + 2, e->rung.bits);
  if (t->result->towards == TP_TOWARDS_RIGHT) arb_neg(x, x);
  tp_loaded_metres(x, y, e);
  *x_m = tp_evaluation_result_within(e, x, log2_size);
  *y_m = tp_evaluation_result_within(e, y, log2_size);
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
    if (!own->from_below) own->from_deg = tp_evaluation_result(t->e, from->from.degrees);
    if (!own->to_above) own->to_deg = tp_evaluation_result(t->e, from->to.degrees);
  }
  return true;
}

static void set_first(const tp_onset_telling *t, const tp_motion_window *w) {
  tp_onset *onset = &t->result->onset;
  const tp_limit *limit = &t->result->limit;
  onset->mechanism = w->mechanism;
  onset->tie = w->tie;
  onset->tied_with = w->tied_with;
  onset->kind = w->from.endless ? TP_ONSET_NOWHERE : TP_ONSET_AT_ANGLE;
  if (w->from.endless) return;
  onset->critical_angle_deg = tp_evaluation_result(t->e, w->from.degrees);
  onset->has_centre = w->has_ray && t->motions->twists.rays[w->ray].axis < 0;
  if (onset->has_centre) {
    tp_onset_centre(&onset->centre_x_m, &onset->centre_y_m, t,
                    &t->motions->twists.rays[w->ray].twist);
  }
  onset->below_limit =
      limit->kind == TP_LIMIT_INTERLOCKED ||
      (limit->kind == TP_LIMIT_AT_ANGLE &&
       tp_evaluation_is_above(t->e, limit->critical_angle_deg, onset->critical_angle_deg));
}

/* From here on, till the next window, no forces hold it: a motion begins, by the limit's mechanism.
 */
static void begin_at_limit(const tp_onset_telling *t, long first) {
  const tp_limit *limit = &t->result->limit;
  tp_onset *onset = &t->result->onset;
  tp_window *own = onset->windows + (first >= 0 ? (size_t)first : onset->window_count++);
  if (first < 0) own->to_above = true;
  own->from_below = limit->kind == TP_LIMIT_NOWHERE;
  own->from_deg = limit->critical_angle_deg;
  own->begins = onset->mechanism = limit->mechanism;
  onset->kind = own->from_below ? TP_ONSET_NOWHERE : TP_ONSET_AT_ANGLE;
  onset->critical_angle_deg = limit->critical_angle_deg;
  onset->tie = limit->tie;
  onset->tied_with = limit->tied_with;
  onset->has_centre = limit->has_centre;
  onset->centre_x_m = limit->centre_x_m;
  onset->centre_y_m = limit->centre_y_m;
  onset->below_limit = false;
}

/* Under cohesion, modes alone may leave a gap beyond the static limit: what opens loses it at once,
 * and so does not resist as the limit lets it. */
static void stay_below_limit(const tp_onset_telling *t, long first) {
  const tp_limit *limit = &t->result->limit;
  const tp_onset *onset = &t->result->onset;
  if (t->question->strong == NULL) return;
  const bool angle = limit->kind == TP_LIMIT_AT_ANGLE, nowhere = limit->kind == TP_LIMIT_NOWHERE;
  const tp_bounded *a = &onset->critical_angle_deg, *b = &limit->critical_angle_deg;
  const bool beyond =
      onset->kind == TP_ONSET_NEVER ||
      (onset->kind == TP_ONSET_AT_ANGLE && (nowhere || a->value - a->error > b->value + b->error));
  if ((angle || nowhere) && beyond) begin_at_limit(t, first);
}

bool tp_onset_describe(const tp_onset_telling *t, long first) {
  if (!set_windows(t)) return false;
  if (first >= 0) {
    set_first(t, t->windows->items + first);
  } else {
    t->result->onset.kind = TP_ONSET_NEVER;
    t->result->onset.mechanism = TP_STANDS;
  }
  stay_below_limit(t, first);
  return true;
}
