/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Names of the keys of a rule, and its reset to no rule. */

#include "scene/profile_rule.h"

const char *const tp_roughness_keys[] = {"rms_height", "z2", "jrc", NULL};
const char *const tp_wear_keys[] = {"cut", "rounded", "abraded", NULL};
const char *const tp_scatter_keys[] = {"wavelength", "amplitude", "skew", NULL};

static void drop(tp_quantity *quantities, int count) {
  for (int k = 0; k < count; k++) {
    quantities[k].given = false;
    fmpq_zero(quantities[k].value);
  }
}

void tp_profile_rule_drop(tp_profile_rule *rule) {
  tp_quantity *const singly[] = {
      &rule->count,   &rule->wavelength, &rule->amplitude, &rule->skew,      &rule->length,
      &rule->step,    &rule->hurst,      &rule->shortest,  &rule->longest,   &rule->start_x,
      &rule->start_y, &rule->seed,       &rule->standard,  &rule->deviation, &rule->noise_seed};
  rule->made = TP_MADE_OF_POINTS;
  tp_polyline_clear(&rule->measured);
  for (size_t k = 0; k < sizeof singly / sizeof singly[0]; k++) drop(singly[k], 1);
  drop(rule->scatter, 3);
  drop(rule->roughness, TP_ROUGHNESS_KINDS);
  drop(rule->scaled, TP_ROUGHNESS_KINDS);
  drop(rule->worn, TP_WEAR_KINDS);
}

int tp_given_of(const tp_quantity *quantities, int count) {
  for (int k = 0; k < count; k++) {
    if (quantities[k].given) return k;
  }
  return -1;
}
