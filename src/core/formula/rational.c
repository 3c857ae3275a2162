/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Operations of the algebra over FLINT's rationals, with the size of each result bounded before it
 * is formed. */

#include "formula/rational.h"

#include <math.h>

enum { MOST_BITS = 20000 };
static const char too_large[] = "the value grows beyond 20 000 bits here";

static void init(void *value, const void *context) {
  (void)context;
  fmpq_init(value);
}

static void clear(void *value, const void *context) {
  (void)context;
  fmpq_clear(value);
}

static void set_number(void *value, const fmpq_t number, const void *context) {
  (void)context;
  fmpq_set(value, number);
}

static bool set_name(void *value, long name, tp_evaluator *evaluator) {
  const fmpq *values = evaluator->context;
  fmpq_set(value, values + name);
  return true;
}

static void swap(void *value, void *other, const void *context) {
  (void)context;
  fmpq_swap(value, other);
}

static void negate(void *value, const void *context) {
  (void)context;
  fmpq_neg(value, value);
}

static const char *power(fmpq *base, const fmpq *exponent) {
  if (!fmpz_is_one(fmpq_denref(exponent))) return "an exponent must be a whole number";
  if (fmpq_is_zero(base) && fmpq_sgn(exponent) < 0) {
    return "division by zero: zero to a negative power";
  }
  const double bits = (double)(fmpz_bits(fmpq_numref(base)) + fmpz_bits(fmpq_denref(base)));
  const double size = bits * fabs(fmpz_get_d(fmpq_numref(exponent)));
  if (size > MOST_BITS || !fmpz_fits_si(fmpq_numref(exponent))) return too_large;
  fmpq_pow_si(base, base, fmpz_get_si(fmpq_numref(exponent)));
  return NULL;
}

/* value = value op other; NULL, or what is wrong. */
static const char *apply(fmpq *value, tp_formula_kind kind, const fmpq *other) {
  switch (kind) {
  case TP_FORMULA_ADD:
    fmpq_add(value, value, other);
    break;
  case TP_FORMULA_SUBTRACT:
    fmpq_sub(value, value, other);
    break;
  case TP_FORMULA_MULTIPLY:
    fmpq_mul(value, value, other);
    break;
  case TP_FORMULA_DIVIDE:
    if (fmpq_is_zero(other)) return "division by zero";
    fmpq_div(value, value, other);
    break;
  default:
    return power(value, other);
  }
  const bool bounded = fmpz_bits(fmpq_numref(value)) + fmpz_bits(fmpq_denref(value)) <= MOST_BITS;
  return bounded ? NULL : too_large;
}

static bool combine(void *value, tp_formula_kind kind, const void *other, tp_evaluator *evaluator) {
  const char *problem = apply(value, kind, other);
  return problem == NULL || tp_evaluator_fail(evaluator, problem);
}

const tp_algebra tp_rational_algebra = {
    .size = sizeof(fmpq),
    .init = init,
    .clear = clear,
    .swap = swap,
    .negate = negate,
    .set_number = set_number,
    .set_name = set_name,
    .combine = combine,
};
