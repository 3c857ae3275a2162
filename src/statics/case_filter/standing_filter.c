/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Follows the intervals of tan(tilt) of the modes from a block's own tilt down to a critical one.
 */

#include "case_filter/standing_filter.h"

bool tp_filter_holds(const tp_near_interval *own, tp_near tangent) {
  return !own->empty && !own->perhaps &&
         (!own->has_low || tp_near_sign(tp_near_sub(tangent, own->low)) > 0) &&
         (!own->has_high || tp_near_sign(tp_near_sub(own->high, tangent)) > 0);
}

/* Modes that hold the tilt at hand lead down to their lower ends. Where they end before it, balls
 * tell. */
tp_filter_standing tp_filter_begins_from(const tp_onset_filter *o, tp_near critical,
                                         tp_near tangent) {
  static const double beside = 0x1p-30;
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
