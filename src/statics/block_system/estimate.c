/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Both estimates begin from forces of the program with friction, which holds the blocks at its
 * limit. No estimate is above that limit. */

#include "block_system/estimate.h"

#include "block_system/near_motion.h"
#include "block_system/undilated.h"

#include <math.h>

/* Forces can hold the blocks, but whether a motion can begin is not known: as they are given, or
 * not up to near the factor at which no forces hold them. */
static bool is_open(const tp_system_case *one) {
  static const double near_enough = 1.01;
  if (one->verdict == TP_SYSTEM_CAN_HOLD) return true;
  const bool is_gap = one->fos.state == TP_FOS_NUMBER && !one->fos_is_least &&
                      one->fos.value.value > near_enough * one->standing_fos;
  const bool is_near = one->has_moving_fos && one->moving_fos <= near_enough * one->standing_fos;
  return one->verdict == TP_SYSTEM_STANDS && one->has_standing_fos && !one->standing_fos_is_least &&
         is_gap && !is_near;
}

static tp_status by_strength(tp_system_case *one, const tp_estimate_task *t, tp_message *message) {
  if (!t->strength->is_bounded || t->strength->is_never || t->strength->collapse.forces == NULL) {
    return TP_OK;
  }
  const tp_undilated_task task = {.system = t->system,
                                  .loads = &t->resultant->loads,
                                  .live = t->resultant->target,
                                  .divisor = exp(t->strength->bound),
                                  .forces = t->strength->collapse.forces};
  tp_undilated found;
  const tp_status status = tp_undilated_find(&found, &task, message);
  if (status != TP_OK || !found.has_factor) return status;
  one->has_undilated_fos = true;
  one->undilated_fos = fmin(found.factor, exp(t->strength->bound));
  one->undilated_fos_spread = found.spread;
  return TP_OK;
}

static tp_status on_driving(tp_system_case *one, const tp_estimate_task *t, tp_message *message) {
  const tp_fos *limit = &one->fos_driving;
  if (!t->driving->drives || limit->state != TP_FOS_NUMBER || one->fos_driving_is_least) {
    return TP_OK;
  }
  const tp_undilated_task task = {
      .system = t->system, .loads = &t->driving->loads, .on_driving = true, .divisor = 1};
  tp_undilated found;
  const tp_status status = tp_undilated_find(&found, &task, message);
  if (status != TP_OK || !found.has_factor) return status;
  one->has_undilated_fos_driving = true;
  one->undilated_fos_driving = fmin(found.factor, limit->value.value + limit->value.error);
  one->undilated_fos_driving_spread = found.spread;
  return TP_OK;
}

tp_status tp_estimate_find(tp_system_case *one, const tp_estimate_task *t, tp_message *message) {
  if (!is_open(one)) return TP_OK;
  tp_status status = t->asks_factor ? by_strength(one, t, message) : TP_OK;
  if (status == TP_OK && t->asks_factor) status = on_driving(one, t, message);
  if (status != TP_OK || one->sought != TP_SYSTEM_SOUGHT_TOO_MANY) return status;
  return tp_near_motion_find(one, t->system, t->resultant, message);
}

static void take_less(bool *has, double *factor, double *spread, bool other_has,
                      double other_factor, double other_spread) {
  if (!other_has || (*has && *factor <= other_factor)) return;
  *has = true;
  *factor = other_factor;
  *spread = other_spread;
}

void tp_estimate_join(tp_system_case *one, const tp_system_case *other) {
  take_less(&one->has_undilated_fos, &one->undilated_fos, &one->undilated_fos_spread,
            other->has_undilated_fos, other->undilated_fos, other->undilated_fos_spread);
  take_less(&one->has_undilated_fos_driving, &one->undilated_fos_driving,
            &one->undilated_fos_driving_spread, other->has_undilated_fos_driving,
            other->undilated_fos_driving, other->undilated_fos_driving_spread);
}
