/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Checks the rule of a self-affine base (steps, band of wavelengths, Hurst exponent) and makes its
 * profile by generate/generate.h. */

#include "generate/generate.h"
#include "number/ratio.h"
#include "scene/check.h"
#include "scene/profile_make.h"
#include "scene/rule_check.h"

/* A whole number of steps. */
static tp_status check_length(tp_self_affine_options *o, const tp_profile_rule *rule,
                              tp_message *message) {
  tp_status status =
      tp_check_rule(TP_RULE_ABOVE_ZERO, rule->length.value, "length", rule->length.place, message);
  if (status == TP_OK) {
    status = tp_check_rule(TP_RULE_ABOVE_ZERO, rule->step.value, "step", rule->step.place, message);
  }
  if (status != TP_OK) return status;
  fmpq_t steps;
  fmpq_init(steps);
  fmpq_div(steps, rule->length.value, rule->step.value);
  if (!fmpz_is_one(fmpq_denref(steps)) || fmpq_cmp_si(steps, TP_SELF_AFFINE_LEAST) < 0 ||
      fmpq_cmp_si(steps, TP_SELF_AFFINE_MOST) >= 0) {
    char text[80];
    tp_ratio_text(text, sizeof text, steps);
    status = tp_refuse(message, TP_FAULT_RANGE, rule->step.place,
                       "the length must be a whole number of steps, from %d to %d; it is %s",
                       TP_SELF_AFFINE_LEAST, TP_SELF_AFFINE_MOST - 1, text);
  } else {
    o->steps = fmpz_get_si(fmpq_numref(steps));
    fmpq_set(o->step, rule->step.value);
  }
  fmpq_clear(steps);
  return status;
}

/* 2 step <= shortest < longest <= length, which the two are at their ends unless given. */
static tp_status check_band(tp_self_affine_options *o, const tp_profile_rule *rule,
                            tp_message *message) {
  const tp_quantity *shortest = &rule->shortest, *longest = &rule->longest;
  fmpq_t twice;
  fmpq_init(twice);
  fmpq_mul_2exp(twice, o->step, 1);
  fmpq_set(o->shortest, shortest->given ? shortest->value : twice);
  fmpq_set(o->longest, longest->given ? longest->value : rule->length.value);
  const bool in_order = fmpq_cmp(twice, o->shortest) <= 0 &&
                        fmpq_cmp(o->shortest, o->longest) < 0 &&
                        fmpq_cmp(o->longest, rule->length.value) <= 0;
  fmpq_clear(twice);
  if (in_order) return TP_OK;
  return tp_refuse(message, TP_FAULT_RANGE,
                   shortest->given  ? shortest->place
                   : longest->given ? longest->place
                                    : rule->first_place,
                   "wavelengths go from 'shortest', at least two steps, to 'longest', above it and "
                   "at most the length");
}

static tp_status check(tp_self_affine_options *o, const tp_profile_rule *rule,
                       tp_message *message) {
  bool is_height = false;
  tp_status status = check_length(o, rule, message);
  if (status == TP_OK) status = check_band(o, rule, message);
  if (status == TP_OK) status = tp_check_within(&rule->hurst, "hurst", "0", "1", true, message);
  if (status == TP_OK) status = tp_check_roughness(o->size, &is_height, rule->roughness, message);
  if (status != TP_OK) return status;
  o->hurst = fmpq_get_d(rule->hurst.value);
  o->target = is_height ? TP_TARGET_RMS_HEIGHT : TP_TARGET_Z2;
  fmpq_set(o->x, rule->start_x.value);
  fmpq_set(o->y, rule->start_y.value);
  return tp_check_seed(&o->seed, &rule->seed, message);
}

tp_status tp_rule_make_self_affine(tp_polyline *line, const tp_profile_rule *rule,
                                   tp_message *message) {
  tp_self_affine_options o;
  bool no_wave = false;
  tp_self_affine_options_init(&o);
  tp_status status = check(&o, rule, message);
  if (status == TP_OK && !tp_generate_self_affine(line, &no_wave, &o)) {
    status = tp_fail_memory(message, "the profile");
  }
  if (status == TP_OK && no_wave) {
    status = tp_refuse(message, TP_FAULT_RANGE, rule->first_place,
                       "no wave of the profile's period lies between 'shortest' and 'longest'; set "
                       "them farther apart");
  }
  tp_self_affine_options_clear(&o);
  return status;
}
