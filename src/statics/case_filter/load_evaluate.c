/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The loads of a sample by the plan of its scene: with the weight of the sample, and what else its
 * numbers change. */

#include "case_filter/load_plan.h"

#include <math.h>

static const tp_near zero = {0, 0};

/* (k_h, -k_v) - t (k_v, k_h) */
static bool add_earthquake(tp_filter_loads *loads, tp_near horizontal, tp_near vertical) {
  const tp_filter_load own = {
      .at = {horizontal, tp_near_neg(vertical), zero},
      .rise = {tp_near_neg(vertical), tp_near_neg(horizontal), zero},
      .side = TP_FILTER_EARTHQUAKE,
  };
  return tp_filter_loads_add(loads, &own);
}

/* A moment in metres in the unit of the shape. */
static tp_near in_units(tp_near moment, const tp_load_plan *plan) {
  return tp_near_is_zero(moment) ? moment : tp_near_div(moment, plan->metres_per_unit);
}

/* Of the water, over the weight: g h / 2 a metre of length. */
static bool add_water(tp_filter_loads *loads, const tp_load_plan *plan,
                      const tp_near numbers[TP_LOAD_NUMBERS], tp_near weight) {
  static const tp_near half = {0.5, 0}, three = {3, 0};
  const tp_near height = tp_near_times(numbers[TP_NUMBER_WATER_HEIGHT], plan->metres_per_length);
  if (tp_near_sign(tp_near_minus(plan->top, height)) <= 0) return false;
  const tp_near product =
      tp_near_times(tp_near_times(numbers[TP_NUMBER_WATER_WEIGHT], height), half);
  const tp_near head = tp_near_is_zero(product) ? zero : tp_near_div(product, weight);
  const tp_near push = tp_near_times(head, height);
  const tp_near over = tp_near_plus(plan->heel_y, tp_near_div(height, three));
  const tp_filter_load face = {
      .at = {push, zero, in_units(tp_near_neg(tp_near_times(over, push)), plan)},
      .side = TP_FILTER_WATER};
  if (!tp_filter_loads_add(loads, &face)) return false;
  if (!plan->lifts) return true;
  const tp_near lift = tp_near_times(head, plan->joint);
  const tp_near x = tp_near_minus(plan->heel_x, tp_near_div(plan->joint, three));
  const tp_filter_load uplift = {
      .at = {zero, tp_near_neg(lift), in_units(tp_near_neg(tp_near_times(x, lift)), plan)},
      .side = TP_FILTER_WATER};
  return tp_filter_loads_add(loads, &uplift);
}

/* A weight beside the centroid. */
static bool add_surcharge(tp_filter_loads *loads, const tp_load_plan *plan,
                          const tp_planned_surcharge *own, tp_near weight) {
  const tp_near share = tp_near_is_zero(own->kn_m) ? zero : tp_near_div(own->kn_m, weight);
  const tp_filter_load load = {
      .at = {zero, share, in_units(tp_near_times(own->x, share), plan)},
      .rise = {share, zero, in_units(tp_near_neg(tp_near_times(own->y, share)), plan)}};
  return tp_filter_loads_add(loads, &load);
}

static bool is_given(const tp_load_plan *plan, const tp_near numbers[TP_LOAD_NUMBERS],
                     tp_load_number number) {
  const tp_near own = numbers[number], given = plan->numbers[number];
  return own.value == given.value && own.error == given.error;
}

/* A number times one of the sample over that of the scene. */
static tp_near scaled(tp_near number, const tp_load_plan *plan,
                      const tp_near numbers[TP_LOAD_NUMBERS], tp_load_number with) {
  if (is_given(plan, numbers, with)) return number;
  return tp_near_div(tp_near_mul(number, numbers[with]), plan->numbers[with]);
}

tp_near tp_load_plan_weight(const tp_load_plan *plan, const tp_near numbers[TP_LOAD_NUMBERS]) {
  return scaled(plan->weight_kn_m, plan, numbers, TP_NUMBER_UNIT_WEIGHT);
}

/* Over the weight of the sample, with the number that it is in proportion to. */
static bool add_staying(tp_filter_loads *loads, const tp_load_plan *plan,
                        const tp_staying_load *own, const tp_near numbers[TP_LOAD_NUMBERS]) {
  static const tp_near one = {1, 0};
  const tp_near size = own->with < TP_LOAD_NUMBERS ? scaled(one, plan, numbers, own->with) : one;
  const tp_near share = tp_near_div(size, scaled(one, plan, numbers, TP_NUMBER_UNIT_WEIGHT));
  tp_filter_load load = own->load;
  for (int k = 0; k < 3; k++) load.fixed[k] = tp_near_times(share, load.fixed[k]);
  return tp_filter_loads_add(loads, &load);
}

/* An earthquake beyond this is none that a filter has been tried with. */
static bool is_moderate(tp_near share) {
  return fabs(share.value) <= 10;
}

bool tp_load_plan_evaluate(tp_filter_loads *loads, const tp_load_plan *plan,
                           const tp_near numbers[TP_LOAD_NUMBERS]) {
  tp_filter_loads_init(loads);
  loads->called_for = plan->called_for;
  const tp_near horizontal = numbers[TP_NUMBER_HORIZONTAL], vertical = numbers[TP_NUMBER_VERTICAL];
  if (plan->shakes && !(is_moderate(horizontal) && is_moderate(vertical) &&
                        add_earthquake(loads, horizontal, vertical))) {
    return false;
  }
  if (!tp_load_plan_knows_outline(plan)) return true;
  if (plan->staying.has_capacity && !is_given(plan, numbers, TP_NUMBER_BOLT_FORCE)) return false;
  const tp_near weight = tp_load_plan_weight(plan, numbers);
  if (tp_near_sign(weight) <= 0) return false;
  if (plan->has_water && !add_water(loads, plan, numbers, weight)) return false;
  for (int k = 0; k < plan->surcharge_count; k++) {
    if (!add_surcharge(loads, plan, plan->surcharges + k, weight)) return false;
  }
  for (int k = 0; k < plan->staying.count; k++) {
    if (!add_staying(loads, plan, plan->staying.items + k, numbers)) return false;
  }
  return true;
}
