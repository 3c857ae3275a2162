/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Named sets of partial factors, their keys and ranges. */

#include "scene/partial_factors.h"

#include "partial_factors_table.h"

#include "number/ratio.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct factor_set {
  const char *name;
  bool toppling_alone;
  struct {
    long numerator;
    unsigned long denominator;
  } values[TP_PARTIAL_FACTORS];
} factor_set;

#define AS_SET(own_name, alone, ...) {own_name, alone, {__VA_ARGS__}},
static const factor_set sets[] = {TP_PARTIAL_FACTOR_SETS(AS_SET)};
#undef AS_SET
enum { SETS = sizeof sets / sizeof sets[0] };

const char *tp_partial_factor_key(tp_partial_factor factor) {
  static const char *const keys[TP_PARTIAL_FACTORS] = {"permanent_unfavourable",
                                                       "permanent_favourable",
                                                       "water_unfavourable",
                                                       "water_favourable",
                                                       "variable_unfavourable",
                                                       "variable_favourable",
                                                       "earthquake",
                                                       "friction",
                                                       "cohesion",
                                                       "anchor",
                                                       "resistance"};
  return keys[factor];
}

tp_partial_factors *tp_partial_factors_new(tp_place place) {
  tp_partial_factors *factors = calloc(1, sizeof *factors);
  if (factors == NULL) return NULL;
  factors->place = place;
  for (int k = 0; k < TP_PARTIAL_FACTORS; k++) {
    fmpq_init(factors->values + k);
    fmpq_one(factors->values + k);
  }
  return factors;
}

void tp_partial_factors_free(tp_partial_factors *factors) {
  if (factors == NULL) return;
  for (int k = 0; k < TP_PARTIAL_FACTORS; k++) fmpq_clear(factors->values + k);
  free(factors);
}

bool tp_partial_factors_take_set(tp_partial_factors *factors, const char *name) {
  int k = 0;
  while (k < SETS && strcmp(sets[k].name, name) != 0) k++;
  if (k == SETS) return false;
  factors->name = sets[k].name;
  factors->toppling_alone = sets[k].toppling_alone;
  for (int n = 0; n < TP_PARTIAL_FACTORS; n++) {
    fmpq_set_si(factors->values + n, sets[k].values[n].numerator, sets[k].values[n].denominator);
  }
  return true;
}

const char *const *tp_partial_factors_names(void) {
#define AS_NAME(own_name, ...) own_name,
  static const char *const names[] = {TP_PARTIAL_FACTOR_SETS(AS_NAME) NULL};
#undef AS_NAME
  return names;
}

void tp_partial_factors_list(char *list, size_t size) {
  list[0] = '\0';
  for (int k = 0; k < SETS; k++) {
    const size_t used = strlen(list);
    snprintf(list + used, size - used, "%s%s", k > 0 ? ", " : "", sets[k].name);
  }
}

tp_status tp_partial_factor_check(tp_partial_factor factor, const fmpq_t value, tp_place place,
                                  tp_message *message) {
  enum { MOST = 10 }; /* far beyond any code: a slip of the pen */
  const char *key = tp_partial_factor_key(factor);
  const bool favourable = factor == TP_PARTIAL_PERMANENT_FAVOURABLE ||
                          factor == TP_PARTIAL_WATER_FAVOURABLE ||
                          factor == TP_PARTIAL_VARIABLE_FAVOURABLE;
  char text[64];
  tp_ratio_text(text, sizeof text, value);
  if (favourable && (fmpq_sgn(value) < 0 || fmpq_cmp_si(value, 1) > 0)) {
    return tp_refuse(message, TP_FAULT_RANGE, place,
                     "'%s' must lie between 0 and 1, not %s: it lessens what helps", key, text);
  }
  if (factor == TP_PARTIAL_PERMANENT_FAVOURABLE && fmpq_is_zero(value)) {
    return tp_refuse(message, TP_FAULT_RANGE, place, "'%s' must be above 0: the block has a weight",
                     key);
  }
  if (!favourable && (fmpq_cmp_si(value, 1) < 0 || fmpq_cmp_si(value, MOST) > 0)) {
    return tp_refuse(message, TP_FAULT_RANGE, place,
                     "'%s' must be 1 or more, up to %d, not %s: it %s; of a resistance factor such "
                     "as 0.8 of LRFD give the inverse, 1/0.8",
                     key, MOST, text,
                     factor <= TP_PARTIAL_EARTHQUAKE ? "raises what drives the block"
                                                     : "divides what holds it");
  }
  return TP_OK;
}
