/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Public records of states, from and to those of the rule. */

#include "solid_tilt/solid_safety.h"

#include <math.h>

static tp_solid_outlook outlook_of(tp_motion_verdict verdict) {
  return verdict == TP_VERDICT_COLLAPSES  ? TP_SOLID_COLLAPSES
         : verdict == TP_VERDICT_CAN_MOVE ? TP_SOLID_CAN_MOVE
         : verdict == TP_VERDICT_STANDS   ? TP_SOLID_STANDS
                                          : TP_SOLID_OPEN;
}

static tp_motion_verdict verdict_of(tp_solid_outlook outlook) {
  return outlook == TP_SOLID_COLLAPSES  ? TP_VERDICT_COLLAPSES
         : outlook == TP_SOLID_CAN_MOVE ? TP_VERDICT_CAN_MOVE
         : outlook == TP_SOLID_STANDS   ? TP_VERDICT_STANDS
                                        : TP_VERDICT_OPEN;
}

void tp_state_ranges_add(tp_state_ranges *state, tp_fos_definition definition,
                         tp_mechanism mechanism, double least, double most) {
  state->ranges[state->count++] = (tp_factor_range){definition, mechanism, least, most};
}

void tp_state_ranges_add_near(tp_state_ranges *state, tp_fos_definition definition,
                              tp_mechanism mechanism, tp_near number) {
  const tp_fos fos = {TP_FOS_NUMBER, {.value = number.value, .error = number.error}};
  const tp_factor_range entry = tp_factor_range_of(definition, mechanism, fos);
  const bool told = isfinite(number.value) && isfinite(number.error);
  tp_state_ranges_add(state, definition, mechanism, told ? entry.least : 0,
                      told ? entry.most : INFINITY);
}

/* ---- the rule ----------------------------------------------------------------------------------
 */

static tp_safety safety_of(const tp_solid_state *state) {
  tp_factor_range ranges[TP_SOLID_FACTORS];
  for (size_t k = 0; k < state->factor_count; k++) {
    const tp_solid_factor *entry = state->factors + k;
    ranges[k] = (tp_factor_range){entry->definition, entry->mechanism, entry->least, entry->most};
  }
  return tp_safety_of(verdict_of(state->motion), ranges, state->factor_count);
}

static tp_safety all_of(const tp_solid_safety *safety, tp_safety states[TP_SOLID_STATES]) {
  for (size_t k = 0; k < safety->state_count; k++) states[k] = safety_of(safety->states + k);
  return tp_safety_of_all(states, safety->state_count);
}

static void settle(tp_solid_safety *safety) {
  tp_safety states[TP_SOLID_STATES];
  const tp_safety all = all_of(safety, states);
  safety->governing = tp_safety_governing(states, safety->state_count);
  const tp_solid_state *governs = safety->states + safety->governing;
  safety->motion = outlook_of(all.verdict);
  safety->least = all.least;
  safety->most = all.most;
  safety->fos = tp_safety_fos(&all);
  safety->has_factor = all.has_factor;
  if (all.has_factor) safety->factor = governs->factors[all.factor];
}

void tp_solid_safety_add(tp_solid_safety *safety, const tp_state_ranges *state) {
  tp_solid_state *entry = safety->states + safety->state_count++;
  *entry = (tp_solid_state){.is_static = state->is_static,
                            .motion = outlook_of(state->verdict),
                            .factor_count = state->count};
  for (size_t k = 0; k < state->count; k++) {
    const tp_factor_range *from = state->ranges + k;
    entry->factors[k] =
        (tp_solid_factor){from->definition, from->mechanism, from->least, from->most};
  }
  const tp_safety alone = safety_of(entry);
  entry->least = alone.least;
  entry->most = alone.most;
  settle(safety);
}

void tp_solid_safety_add_mean(tp_solid_safety *safety, const tp_solid_safety *mean) {
  for (size_t k = 0; k < mean->state_count && safety->state_count < TP_SOLID_STATES; k++) {
    tp_solid_state *entry = safety->states + safety->state_count++;
    *entry = mean->states[k];
    entry->has_mean_normals = true;
  }
  settle(safety);
}

tp_design tp_solid_safety_meets(const tp_solid_safety *safety, double required) {
  tp_safety states[TP_SOLID_STATES];
  if (safety->state_count == 0) return TP_DESIGN_OPEN;
  const tp_safety all = all_of(safety, states);
  return tp_safety_meets(&all, required);
}

bool tp_solid_safety_number(tp_bounded *fos, tp_mechanism *mechanism,
                            const tp_solid_safety *safety) {
  if (safety->fos.state != TP_FOS_NUMBER) return false;
  *fos = safety->fos.value;
  *mechanism = safety->has_factor ? safety->factor.mechanism : TP_MECHANISM_UNDECIDED;
  return true;
}
