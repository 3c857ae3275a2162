/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Checks the rule of a toothed base (skew, scatter, seed) and makes its profile by
 * generate/generate.h. */

#include "generate/generate.h"
#include "scene/check.h"
#include "scene/profile_make.h"
#include "scene/rule_check.h"

/* Both facets of a tooth keep a run. */
static tp_status check_skew(const tp_profile_rule *rule, tp_message *message) {
  fmpq_t most, limit;
  fmpq_init(most);
  fmpq_init(limit);
  fmpq_abs(most, rule->skew.value);
  fmpq_add(most, most, rule->scatter[2].value);
  fmpq_set_si(limit, 9, 10);
  const bool fits = fmpq_cmp(most, limit) <= 0;
  fmpq_clear(most);
  fmpq_clear(limit);
  if (fits) return TP_OK;
  return tp_refuse(
      message, TP_FAULT_RANGE, rule->first_place,
      "the skew and its scatter are together at most 0.9 in size: each facet of a tooth "
      "keeps a part of its wavelength");
}

/* What is scattered is drawn by a seed. */
static tp_status check_seed(uint64_t *seed, const tp_profile_rule *rule, tp_message *message) {
  bool draws = false;
  for (int k = 0; k < 3; k++) draws = draws || !fmpq_is_zero(rule->scatter[k].value);
  if (!draws || rule->seed.given) return tp_check_seed(seed, &rule->seed, message);
  return tp_refuse(message, TP_FAULT_KEY, rule->first_place,
                   "'seed' is missing here, for example 'seed: 1'");
}

static tp_status check(tp_teeth_options *o, const tp_profile_rule *rule, tp_message *message) {
  static const char *const most[] = {"0.9", "1", "0.9"};
  tp_status status =
      tp_check_tooth_count(&o->count, rule->count.value, "count", rule->count.place, message);
  if (status == TP_OK) {
    status = tp_check_rule(TP_RULE_ABOVE_ZERO, rule->wavelength.value, "wavelength",
                           rule->wavelength.place, message);
  }
  if (status == TP_OK) {
    status = tp_check_rule(TP_RULE_ABOVE_ZERO, rule->amplitude.value, "amplitude",
                           rule->amplitude.place, message);
  }
  if (status == TP_OK) {
    status = tp_check_within(&rule->skew, "skew", "-0.9", "0.9", false, message);
  }
  for (int k = 0; k < 3 && status == TP_OK; k++) {
    status = tp_check_within(rule->scatter + k, tp_scatter_keys[k], "0", most[k], false, message);
  }
  if (status == TP_OK) status = check_skew(rule, message);
  return status == TP_OK ? check_seed(&o->seed, rule, message) : status;
}

tp_status tp_rule_make_teeth(tp_polyline *line, const tp_profile_rule *rule, tp_message *message) {
  tp_teeth_options o;
  tp_teeth_options_init(&o);
  o.left_end_valley = rule->left_end_valley;
  fmpq_set(o.wavelength, rule->wavelength.value);
  fmpq_set(o.amplitude, rule->amplitude.value);
  fmpq_set(o.skew, rule->skew.value);
  fmpq_set(o.wavelength_scatter, rule->scatter[0].value);
  fmpq_set(o.amplitude_scatter, rule->scatter[1].value);
  fmpq_set(o.skew_scatter, rule->scatter[2].value);
  fmpq_set(o.x, rule->start_x.value);
  fmpq_set(o.y, rule->start_y.value);
  tp_status status = check(&o, rule, message);
  if (status == TP_OK && !tp_generate_teeth(line, &o)) {
    status = tp_fail_memory(message, "the profile");
  }
  tp_teeth_options_clear(&o);
  return status;
}
