/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Bounds, seeds and measures of roughness of a profile rule, compared as rationals; JRC is
 * converted by scene/rule_jrc.h. */

#include "scene/rule_check.h"

#include "number/ratio.h"
#include "number/word.h"
#include "scene/check.h"
#include "scene/rule_jrc.h"

#include <string.h>

tp_status tp_check_within(const tp_quantity *quantity, const char *name, const char *low,
                          const char *high, bool strictly, tp_message *message) {
  const char *problem = NULL;
  bool within = true;
  if (!quantity->given) return TP_OK;
  fmpq_t bound;
  fmpq_init(bound);
  for (int end = 0; end < 2; end++) {
    const char *text = end == 0 ? low : high;
    (void)tp_ratio_read_fraction(bound, text, strlen(text), &problem);
    const int side = fmpq_cmp(quantity->value, bound) * (end == 0 ? 1 : -1);
    within = within && (strictly ? side > 0 : side >= 0);
  }
  fmpq_clear(bound);
  if (within) return TP_OK;
  char text[80];
  tp_ratio_text(text, sizeof text, quantity->value);
  return tp_refuse(message, TP_FAULT_RANGE, quantity->place, "%s must lie %s %s and %s; it is %s",
                   name, strictly ? "strictly between" : "between", low, high, text);
}

tp_status tp_check_seed(uint64_t *seed, const tp_quantity *quantity, tp_message *message) {
  const fmpq *value = quantity->value;
  if (!quantity->given) return TP_OK;
  const tp_status status =
      tp_check_rule(TP_RULE_NOT_NEGATIVE, quantity->value, "seed", quantity->place, message);
  if (status != TP_OK) return status;
  if (!fmpz_is_one(fmpq_denref(value)) || fmpz_bits(fmpq_numref(value)) > 63) {
    return tp_refuse(message, TP_FAULT_RANGE, quantity->place,
                     "a seed is a whole number from 0 to 9223372036854775807");
  }
  *seed = (uint64_t)tp_word_get(fmpq_numref(value));
  return TP_OK;
}

tp_status tp_check_roughness(fmpq_t size, bool *is_height, const tp_quantity *by,
                             tp_message *message) {
  const int kind = tp_given_of(by, TP_ROUGHNESS_KINDS);
  const char *name = tp_roughness_keys[kind];
  *is_height = kind == TP_ROUGHNESS_RMS_HEIGHT;
  fmpq_set(size, by[kind].value);
  switch ((tp_roughness_by)kind) {
  case TP_ROUGHNESS_RMS_HEIGHT:
    return tp_check_rule(TP_RULE_ABOVE_ZERO, size, name, by[kind].place, message);
  case TP_ROUGHNESS_Z2:
    return tp_check_within(by + kind, name, "0.000001", "1000", false, message);
  case TP_ROUGHNESS_JRC:
    break;
  }
  const tp_status status = tp_check_within(by + kind, name, "0", "20", false, message);
  if (status == TP_OK) tp_z2_of_jrc(size, by[kind].value);
  return status;
}
