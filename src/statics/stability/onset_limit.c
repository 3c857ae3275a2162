/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The onset compared with the static limit of the same case: under cohesion and bonds the modes may
 * begin later than the limit, where the onset is then put, as no forces hold the block beyond
 * it. */

#include "stability/onset.h"
#include "stability/onset_question.h"

/* The window that begins at the onset, or, without one, the one behind the last, for which there is
 * room. */
static tp_window *window_of(tp_onset *onset) {
  size_t k = 0;
  while (k < onset->window_count &&
         (onset->windows[k].from_below || onset->kind != TP_ONSET_AT_ANGLE ||
          onset->windows[k].from_deg.value != onset->critical_angle_deg.value)) {
    k++;
  }
  if (k < onset->window_count) return onset->windows + k;
  onset->windows[k].to_above = true;
  return onset->windows + onset->window_count++;
}

/* From the limit on, till the next window, no forces hold it: a motion begins, by the limit's
 * mechanism. */
static void begin_at_limit(tp_onset *onset, const tp_limit *limit) {
  tp_window *own = window_of(onset);
  own->from_below = limit->kind == TP_LIMIT_NOWHERE;
  own->from_deg = limit->critical_angle_deg;
  own->begins = onset->mechanism = limit->mechanism;
  onset->kind = own->from_below ? TP_ONSET_NOWHERE : TP_ONSET_AT_ANGLE;
  onset->critical_angle_deg = limit->critical_angle_deg;
  onset->tie = limit->tie;
  onset->tied_with = limit->tied_with;
  onset->tie_bits = limit->tie_bits;
  onset->has_centre = limit->has_centre;
  onset->centre_x_m = limit->centre_x_m;
  onset->centre_y_m = limit->centre_y_m;
}

/* Under cohesion, modes alone may leave a gap beyond the static limit: what opens loses it at once,
 * and so does not resist as the limit lets it. */
void tp_onset_meet_limit(tp_case *result, const tp_evaluation *e, tp_onset_found *found,
                         const tp_direction_ball *at, tp_certainty *certainty) {
  tp_onset *onset = &result->onset;
  const tp_limit *limit = &result->limit;
  const bool angle = limit->kind == TP_LIMIT_AT_ANGLE, nowhere = limit->kind == TP_LIMIT_NOWHERE;
  const tp_bounded *a = &onset->critical_angle_deg, *b = &limit->critical_angle_deg;
  const bool at_angle = onset->kind == TP_ONSET_AT_ANGLE;
  const double error = a->error + b->error;
  const bool beyond = onset->kind == TP_ONSET_NEVER ||
                      (at_angle && (nowhere || (angle && a->value - b->value > error)));
  if ((angle || nowhere) && beyond && tp_onset_has_strength(e)) {
    begin_at_limit(onset, limit);
    arb_set(found->degrees, at->degrees);
  }
  onset->below_limit = at_angle && (limit->kind == TP_LIMIT_INTERLOCKED ||
                                    (angle && tp_result_is_above(e, *b, *a, certainty)));
}
