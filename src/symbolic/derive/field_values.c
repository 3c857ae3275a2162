/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Values of rational functions: exact at the scene's parameters within a bound of bits, or in
 * balls; and the common sign of a polynomial's coefficients. */

#include "derive/field.h"
#include "number/ball.h"

/* Bits that powers of the values may have: a quarter of a megabyte. */
static const double most_bits = 2e6;

/* A bound of the bits of a term at the values. */
static double term_bits(const fmpz_mpoly_t polynomial, const fmpq *values, long count,
                        const tp_field *field) {
  if (polynomial->length == 0) return 0;
  double bits = 0;
  slong *degrees = flint_malloc((size_t)field->symbol_count * sizeof *degrees);
  fmpz_mpoly_degrees_si(degrees, polynomial, field->ring);
  for (long k = 0; k < count; k++) {
    if (degrees[k] <= 0) continue;
    bits += (double)degrees[k] * ((double)fmpz_bits(fmpq_numref(values + k)) +
                                  (double)fmpz_bits(fmpq_denref(values + k)));
  }
  flint_free(degrees);
  return bits;
}

/* The first `count` symbols take values; others are taken for 1. */
static void evaluate_polynomial(fmpq_t value, const fmpz_mpoly_t polynomial, const fmpq *values,
                                long count, const tp_field *field) {
  fmpq_t term, factor;
  slong *exponents = flint_malloc((size_t)field->symbol_count * sizeof *exponents);
  fmpq_init(term);
  fmpq_init(factor);
  fmpq_zero(value);
  for (slong t = 0; t < fmpz_mpoly_length(polynomial, field->ring); t++) {
    fmpq_one(term);
    fmpz_mpoly_get_term_coeff_fmpz(fmpq_numref(term), polynomial, t, field->ring);
    fmpz_mpoly_get_term_exp_si(exponents, polynomial, t, field->ring);
    for (long k = 0; k < count; k++) {
      if (exponents[k] == 0) continue;
      fmpq_pow_si(factor, values + k, exponents[k]);
      fmpq_mul(term, term, factor);
    }
    fmpq_add(value, value, term);
  }
  flint_free(exponents);
  fmpq_clear(term);
  fmpq_clear(factor);
}

static bool evaluate(fmpq_t value, const fmpz_mpoly_q_t formula, const fmpq *values, long count,
                     const tp_field *field) {
  const double bits = term_bits(fmpz_mpoly_q_numref(formula), values, count, field) +
                      term_bits(fmpz_mpoly_q_denref(formula), values, count, field);
  const double terms = (double)fmpz_mpoly_length(fmpz_mpoly_q_numref(formula), field->ring) +
                       (double)fmpz_mpoly_length(fmpz_mpoly_q_denref(formula), field->ring);
  const double words = 1 + (double)field->symbol_count / 32;
  if (bits > most_bits || !tp_field_spend(field, (2 + 0.1 * terms * (1 + bits / 64)) * words))
    return false;
  fmpq_t below;
  fmpq_init(below);
  evaluate_polynomial(value, fmpz_mpoly_q_numref(formula), values, count, field);
  evaluate_polynomial(below, fmpz_mpoly_q_denref(formula), values, count, field);
  const bool defined = !fmpq_is_zero(below);
  if (defined) fmpq_div(value, value, below);
  fmpq_clear(below);
  return defined;
}

bool tp_field_evaluate(fmpq_t value, const fmpz_mpoly_q_t formula, const tp_field *field) {
  return evaluate(value, formula, field->parameters->values, field->parameters->count, field);
}

bool tp_field_evaluate_at(fmpq_t value, const fmpz_mpoly_q_t formula, const fmpq *symbols,
                          const tp_field *field) {
  return evaluate(value, formula, symbols, field->symbol_count, field);
}

static void evaluate_polynomial_ball(arb_t value, const fmpz_mpoly_t polynomial, arb_srcptr symbols,
                                     const tp_field *field, long bits) {
  arb_t term, factor;
  fmpz_t coefficient;
  slong *exponents = flint_malloc((size_t)field->symbol_count * sizeof *exponents);
  arb_init(term);
  arb_init(factor);
  fmpz_init(coefficient);
  arb_zero(value);
  for (slong t = 0; t < fmpz_mpoly_length(polynomial, field->ring); t++) {
    fmpz_mpoly_get_term_coeff_fmpz(coefficient, polynomial, t, field->ring);
    arb_set_fmpz(term, coefficient);
    fmpz_mpoly_get_term_exp_si(exponents, polynomial, t, field->ring);
    for (long k = 0; k < field->symbol_count; k++) {
      if (exponents[k] == 0) continue;
      arb_pow_ui(factor, symbols + k, (ulong)exponents[k], bits);
      arb_mul(term, term, factor, bits);
    }
    arb_add(value, value, term, bits);
  }
  flint_free(exponents);
  arb_clear(term);
  arb_clear(factor);
  fmpz_clear(coefficient);
}

void tp_field_evaluate_ball(arb_t value, const fmpz_mpoly_q_t formula, arb_srcptr symbols,
                            const tp_field *field, long bits) {
  arb_t below;
  arb_init(below);
  evaluate_polynomial_ball(value, fmpz_mpoly_q_numref(formula), symbols, field, bits);
  evaluate_polynomial_ball(below, fmpz_mpoly_q_denref(formula), symbols, field, bits);
  arb_div(value, value, below, bits);
  arb_clear(below);
}

tp_bounded tp_field_angle(const fmpz_mpoly_q_t tangent, arb_srcptr symbols, const tp_field *field,
                          long bits) {
  arb_t angle, one;
  arb_init(angle);
  arb_init(one);
  tp_field_evaluate_ball(angle, tangent, symbols, field, bits);
  arb_one(one);
  tp_ball_atan2_degrees(angle, angle, one, bits);
  const tp_bounded result = tp_ball_bounded(angle);
  arb_clear(angle);
  arb_clear(one);
  return result;
}

int tp_field_sign_of_coefficients(const fmpz_mpoly_t polynomial, const tp_field *field) {
  fmpz_t coefficient;
  fmpz_init(coefficient);
  int sign = 0;
  bool mixed = false;
  for (slong t = 0; t < fmpz_mpoly_length(polynomial, field->ring) && !mixed; t++) {
    fmpz_mpoly_get_term_coeff_fmpz(coefficient, polynomial, t, field->ring);
    const int own = fmpz_sgn(coefficient);
    mixed = sign != 0 && own != sign;
    sign = own;
  }
  fmpz_clear(coefficient);
  return mixed ? 0 : sign;
}
