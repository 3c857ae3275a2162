/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Expressions in exact rationals. */

#include "scene/expression.h"

#include <math.h>
#include <string.h>

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

static bool set_name(void *value, const char *name, size_t length, const void *context) {
  const tp_parameters *known = context;
  for (long k = known != NULL ? known->count - 1 : -1; k >= 0; k--) {
    if (strlen(known->names[k]) == length && strncmp(known->names[k], name, length) == 0) {
      fmpq_set(value, known->values + k);
      return true;
    }
  }
  return false;
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

static const char *combine(void *value, char op, const void *other, const void *context) {
  (void)context;
  switch (op) {
  case '+':
    fmpq_add(value, value, other);
    break;
  case '-':
    fmpq_sub(value, value, other);
    break;
  case '*':
    fmpq_mul(value, value, other);
    break;
  case '/':
    if (fmpq_is_zero(other)) return "division by zero";
    fmpq_div(value, value, other);
    break;
  default:
    return power(value, other);
  }
  const fmpq *result = value;
  const bool bounded = fmpz_bits(fmpq_numref(result)) + fmpz_bits(fmpq_denref(result)) <= MOST_BITS;
  return bounded ? NULL : too_large;
}

const tp_algebra tp_rational_algebra = {init, clear, set_number, set_name, negate, combine};

tp_status tp_expression_evaluate(fmpq_t value, const char *text, tp_place place,
                                 const tp_parameters *parameters, tp_message *message) {
  fmpq_t result;
  fmpq_init(result);
  const tp_status status =
      tp_expression_read(result, &tp_rational_algebra, parameters, text, place, message);
  if (status == TP_OK) fmpq_swap(value, result);
  fmpq_clear(result);
  return status;
}
