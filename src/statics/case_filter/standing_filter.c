/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Follows the intervals of tan(tilt) of the modes from the sample's tilt to a factor's critical
 * angle, and looks just beside that angle for a motion that can begin. */

#include "case_filter/standing_filter.h"

/* Can motions begin just beside a tilt at which none need to at the block's own? */
static tp_filter_standing begins_beside(const tp_case_told *told, tp_near critical) {
  static const double beside = 0x1p-30;
  for (int side = 1; side >= -1; side -= 2) {
    bool moves = false;
    unsigned beginnings = 0;
    const tp_near at = tp_near_mul(critical, (tp_near){1 + side * beside, 0});
    if (!tp_onset_filter_look(&moves, &beginnings, &told->onset, at)) return TP_FILTER_OPEN;
    if (moves) return TP_FILTER_COUNTS;
  }
  return TP_FILTER_EXCLUDED;
}

bool tp_filter_holds(const tp_near_interval *own, tp_near tangent) {
  return !own->empty && !own->perhaps &&
         (!own->has_low || tp_near_sign(tp_near_sub(tangent, own->low)) > 0) &&
         (!own->has_high || tp_near_sign(tp_near_sub(own->high, tangent)) > 0);
}

/* Modes that hold the tilt at hand lead down to their lower ends. Where they end before it, balls
 * tell. */
tp_filter_standing tp_filter_begins_from(const tp_case_told *told, tp_near critical,
                                         tp_near tangent) {
  static const double beside = 0x1p-30;
  const tp_onset_filter *o = &told->onset;
  const tp_near wanted = tp_near_mul(critical, (tp_near){1 + beside, 0});
  tp_near at = tangent;
  for (int step = 0; step <= o->plan->mode_count; step++) {
    tp_near least = at;
    for (int k = 0; k < o->plan->mode_count; k++) {
      const tp_near_interval *own = &o->modes[k].all;
      if (!tp_filter_holds(own, at)) continue;
      if (!own->has_low) return TP_FILTER_COUNTS;
      if (tp_near_sign(tp_near_sub(least, own->low)) > 0) least = own->low;
    }
    if (tp_near_sign(tp_near_sub(wanted, least)) > 0) return TP_FILTER_COUNTS;
    if (tp_near_sign(tp_near_sub(at, least)) <= 0) return TP_FILTER_OPEN;
    at =
        tp_near_mul(least, (tp_near){1 - beside, 0}); /* within the next one, where that meets it */
  }
  return TP_FILTER_OPEN;
}

tp_filter_standing tp_standing_filter(const tp_case_told *told, const tp_filter_state *s,
                                      const tp_filter_way *own) {
  static const tp_near one = {1, 0};
  const bool number = own->fos.state == TP_FOS_NUMBER;
  const int side = number ? tp_near_sign(tp_near_sub(own->fos.value, one)) : 1;
  if (side == 0) return TP_FILTER_OPEN;
  if (side < 0 && !(s->moves && own->begins)) return TP_FILTER_EXCLUDED;
  if ((side > 0 && s->moves) || !own->has_critical) return TP_FILTER_COUNTS;
  return s->moves ? tp_filter_begins_from(told, own->critical, s->tangent)
                  : begins_beside(told, own->critical);
}
