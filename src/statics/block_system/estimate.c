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
static bool is_open(const tp_system_case *own) {
  static const double near_enough = 1.01;
  if (own->verdict == TP_SYSTEM_CAN_HOLD) return true;
  const bool is_gap = own->fos.state == TP_FOS_NUMBER && !own->fos_is_least &&
                      own->fos.value.value > near_enough * own->standing_fos;
  const bool is_near = own->has_moving_fos && own->moving_fos <= near_enough * own->standing_fos;
  return own->verdict == TP_SYSTEM_STANDS && own->has_standing_fos && !own->standing_fos_is_least &&
         is_gap && !is_near;
}

static tp_status by_strength(tp_system_case *own, const tp_estimate_task *t, tp_message *message) {
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
  own->has_undilated_fos = true;
  own->undilated_fos = fmin(found.factor, exp(t->strength->bound));
  own->undilated_fos_spread = found.spread;
  return TP_OK;
}

static tp_status on_driving(tp_system_case *own, const tp_estimate_task *t, tp_message *message) {
  const tp_fos *limit = &own->fos_driving;
  if (!t->driving->drives || limit->state != TP_FOS_NUMBER || own->fos_driving_is_least) {
    return TP_OK;
  }
  const tp_undilated_task task = {
      .system = t->system, .loads = &t->driving->loads, .on_driving = true, .divisor = 1};
  tp_undilated found;
  const tp_status status = tp_undilated_find(&found, &task, message);
  if (status != TP_OK || !found.has_factor) return status;
  own->has_undilated_fos_driving = true;
  own->undilated_fos_driving = fmin(found.factor, limit->value.value + limit->value.error);
  own->undilated_fos_driving_spread = found.spread;
  return TP_OK;
}

tp_status tp_estimate_find(tp_system_case *own, const tp_estimate_task *t, tp_message *message) {
  if (!is_open(own)) return TP_OK;
  tp_status status = by_strength(own, t, message);
  if (status == TP_OK) status = on_driving(own, t, message);
  if (status != TP_OK || own->sought != TP_SYSTEM_SOUGHT_TOO_MANY) return status;
  return tp_near_motion_find(own, t->system, t->resultant, message);
}

static void take_less(bool *has, double *factor, double *spread, bool other_has,
                      double other_factor, double other_spread) {
  if (!other_has || (*has && *factor <= other_factor)) return;
  *has = true;
  *factor = other_factor;
  *spread = other_spread;
}

void tp_estimate_join(tp_system_case *own, const tp_system_case *other) {
  take_less(&own->has_undilated_fos, &own->undilated_fos, &own->undilated_fos_spread,
            other->has_undilated_fos, other->undilated_fos, other->undilated_fos_spread);
  take_less(&own->has_undilated_fos_driving, &own->undilated_fos_driving,
            &own->undilated_fos_driving_spread, other->has_undilated_fos_driving,
            other->undilated_fos_driving, other->undilated_fos_driving_spread);
}
