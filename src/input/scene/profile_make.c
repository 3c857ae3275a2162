/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A profile by its rule: what it begins with, then noise, scaling and wear, each where it is asked
 * for. */

#include "scene/profile_make.h"

#include "generate/generate.h"
#include "number/ratio.h"
#include "scene/check.h"
#include "scene/rule_check.h"
#include "scene/rule_jrc.h"

/* ---- what changes a profile --------------------------------------------------------------------
 */

static tp_status add_noise(tp_polyline *line, const tp_profile_rule *rule, tp_message *message) {
  const tp_quantity *deviation = &rule->deviation;
  uint64_t seed = 0;
  if (!deviation->given) return TP_OK;
  tp_status status =
      tp_check_rule(TP_RULE_ABOVE_ZERO, deviation->value, "deviation", deviation->place, message);
  if (status == TP_OK) status = tp_check_seed(&seed, &rule->noise_seed, message);
  if (status == TP_OK) tp_add_noise(line, deviation->value, seed);
  return status;
}

static tp_status scale(tp_polyline *line, const tp_profile_rule *rule, tp_message *message) {
  const int kind = tp_given_of(rule->scaled, TP_ROUGHNESS_KINDS);
  bool is_height = false;
  tp_roughness own = {0};
  if (kind < 0) return TP_OK;
  const tp_place place = rule->scaled[kind].place;
  fmpq_t size;
  fmpq_init(size);
  tp_status status = tp_check_roughness(size, &is_height, rule->scaled, message);
  if (status == TP_OK &&
      !tp_roughness_of(&own, line, is_height ? TP_TARGET_RMS_HEIGHT : TP_TARGET_Z2)) {
    status =
        tp_refuse(message, TP_FAULT_GEOMETRY, place,
                  "the profile folds back or steps upright, and has no %s to be scaled: it needs "
                  "one height at each x",
                  is_height ? "RMS height" : "Z2");
  } else if (status == TP_OK && own.size == 0) {
    status = tp_refuse(message, TP_FAULT_GEOMETRY, place,
                       "the profile is level, and stays so by any factor; give it points or noise "
                       "that are rough");
  }
  if (status == TP_OK) tp_scale_heights(line, size, &own);
  fmpq_clear(size);
  return status;
}

static tp_status check_depth(const tp_polyline *line, tp_wear wear, const tp_quantity *depth,
                             tp_message *message) {
  tp_status status =
      tp_check_rule(TP_RULE_ABOVE_ZERO, depth->value, tp_wear_keys[wear], depth->place, message);
  if (status != TP_OK || wear == TP_WEAR_ROUNDED) return status;
  fmpq_t most;
  fmpq_init(most);
  tp_wear_most(most, line, wear);
  if (fmpq_cmp(depth->value, most) >= 0) {
    char text[80];
    tp_ratio_text(text, sizeof text, most);
    status =
        tp_refuse(message, TP_FAULT_GEOMETRY, depth->place,
                  "'%s' removes all of the roughness: the highest point stands %s above the "
                  "%s; take less",
                  tp_wear_keys[wear], text, wear == TP_WEAR_CUT ? "lowest" : "mean of all points");
  }
  fmpq_clear(most);
  return status;
}

static tp_status wear_off(tp_polyline *line, const tp_profile_rule *rule, tp_message *message) {
  const int wear = tp_given_of(rule->worn, TP_WEAR_KINDS);
  if (wear < 0) return TP_OK;
  const tp_quantity *depth = rule->worn + wear;
  const tp_status status = check_depth(line, (tp_wear)wear, depth, message);
  if (status == TP_OK && !tp_wear_off(line, (tp_wear)wear, depth->value)) {
    return tp_fail_memory(message, "the profile");
  }
  return status;
}

/* ---- the whole ---------------------------------------------------------------------------------
 */

/* Points of its own, which may be changed. */
static tp_status take_measured(tp_polyline *line, const tp_profile_rule *rule,
                               tp_message *message) {
  if (rule->measured.count < 2) {
    return tp_refuse(message, TP_FAULT_RANGE, rule->first_place,
                     "a base profile needs at least two points");
  }
  return tp_polyline_copy(line, &rule->measured) ? TP_OK : tp_fail_memory(message, "the profile");
}

static tp_status begin(tp_polyline *line, const tp_profile_rule *rule, const fmpq_t metres_per_unit,
                       tp_message *message) {
  switch (rule->made) {
  case TP_MADE_OF_TEETH:
    return tp_rule_make_teeth(line, rule, message);
  case TP_MADE_SELF_AFFINE:
    return tp_rule_make_self_affine(line, rule, message);
  case TP_MADE_LIKE_STANDARD:
    return tp_rule_make_standard(line, rule, metres_per_unit, message);
  case TP_MADE_OF_MEASURED:
  case TP_MADE_OF_POINTS:
    break;
  }
  return take_measured(line, rule, message);
}

/* What a rule makes of numbers in range may be out of it. */
static tp_status check_range(const tp_polyline *line, tp_place place, tp_message *message) {
  const long last = line->count - 1;
  tp_status status = tp_check_range(line->x + last, "the profile's x", place, message);
  for (long k = 0; k <= last && status == TP_OK; k++) {
    status = tp_check_range(line->y + k, "the profile's y", place, message);
  }
  return status;
}

tp_status tp_profile_make(tp_polyline *line, const tp_profile_rule *rule,
                          const fmpq_t metres_per_unit, tp_message *message) {
  const tp_place place = rule->place;
  tp_polyline own = {.file = place.file, .mark = {place.line, place.column}};
  tp_status status = begin(&own, rule, metres_per_unit, message);
  if (status == TP_OK) status = add_noise(&own, rule, message);
  if (status == TP_OK) status = scale(&own, rule, message);
  if (status == TP_OK) status = wear_off(&own, rule, message);
  if (status == TP_OK) status = check_range(&own, place, message);
  if (status == TP_OK && !tp_polyline_make_shared(&own)) {
    status = tp_fail_memory(message, "the profile");
  }
  if (status == TP_OK) {
    *line = own;
  } else {
    tp_polyline_clear(&own);
  }
  return status;
}
