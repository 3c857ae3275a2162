/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Signs of polynomials on a domain.
 *
 * Each factor is written in the numbers t > 0 of the domain and multiplied by its denominators,
 * which are positive. If its coefficients have one sign, so has it; if not, it is multiplied by
 * 1 + the sum of the t, or by the sum alone, some times: by Polya's theorem the coefficients of a
 * polynomial that is positive for all t get there in the end. */

#include "verify/domain.h"

#include "derive/field_work.h"

#include <flint/fmpz_mpoly_factor.h>
#include <stdlib.h>

enum { MULTIPLICATIONS = 8, MOST_TERMS = 2000 };
static const double most_units = 20000; /* for one polynomial */

/* value = value top^exponent below^(degree - exponent) of an image. */
static void multiply_image(fmpz_mpoly_q_t value, const fmpz_mpoly_q_struct *image, slong exponent,
                           slong degree, const tp_field *field) {
  fmpz_mpoly_q_t factor;
  fmpz_mpoly_q_init(factor, field->ring);
  fmpz_mpoly_q_one(factor, field->ring);
  for (slong k = 0; k < degree && tp_field_problem(field) == NULL; k++) {
    fmpz_mpoly_set(fmpz_mpoly_q_numref(factor),
                   k < exponent ? fmpz_mpoly_q_numref(image) : fmpz_mpoly_q_denref(image),
                   field->ring);
    tp_field_mul(value, value, factor, field);
  }
  fmpz_mpoly_q_clear(factor, field->ring);
}

/* The polynomial in t, times a positive one; false where a symbol in it takes any value, or where
 * the work is too dear. */
static bool substitute(fmpz_mpoly_q_t value, const fmpz_mpoly_t p, const tp_domain *domain) {
  const tp_field *field = domain->subject->field;
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  const long count = domain->symbol_count;
  slong *degrees = calloc(2 * (size_t)count, sizeof *degrees);
  if (degrees == NULL) return false;
  slong *exponents = degrees + count;
  fmpz_mpoly_degrees_si(degrees, p, ring);
  bool known = p->length <= MOST_TERMS;
  for (long k = 0; k < count; k++) known = known && (degrees[k] == 0 || !domain->images.free[k]);
  fmpz_mpoly_q_t term;
  fmpz_mpoly_q_init(term, ring);
  fmpz_mpoly_q_zero(value, ring);
  for (slong t = 0; known && t < p->length; t++) {
    fmpz_mpoly_q_one(term, ring);
    fmpz_mpoly_get_term_exp_si(exponents, p, t, ring);
    for (long k = 0; k < count; k++) {
      if (degrees[k] > 0)
        multiply_image(term, domain->images.of + k, exponents[k], degrees[k], field);
    }
    fmpz_t coefficient;
    fmpz_init(coefficient);
    fmpz_mpoly_get_term_coeff_fmpz(coefficient, p, t, ring);
    fmpz_mpoly_q_mul_fmpz(term, term, coefficient, ring);
    fmpz_clear(coefficient);
    tp_field_add(value, value, term, field);
    known = tp_field_problem(field) == NULL;
  }
  fmpz_mpoly_q_clear(term, ring);
  free(degrees);
  return known;
}

/* The sum of the symbols in use, and 1 unless all terms have one degree. */
static void set_multiplier(fmpz_mpoly_q_t sum, const fmpz_mpoly_t p, const tp_field *field) {
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  fmpz_mpoly_q_t symbol;
  fmpz_mpoly_q_init(symbol, ring);
  fmpz_mpoly_q_zero(sum, ring);
  for (long k = 0; k < field->symbol_count; k++) {
    if (fmpz_mpoly_degree_si(p, k, ring) <= 0) continue;
    fmpz_mpoly_q_gen(symbol, k, ring);
    tp_field_add(sum, sum, symbol, field);
  }
  fmpz_mpoly_q_clear(symbol, ring);
  fmpz_t degree, own;
  fmpz_init(degree);
  fmpz_init(own);
  fmpz_mpoly_total_degree_fmpz(degree, p, ring);
  bool same = true;
  fmpz_mpoly_t term;
  fmpz_mpoly_init(term, ring);
  for (slong t = 0; t < p->length && same; t++) {
    fmpz_mpoly_get_term(term, p, t, ring);
    fmpz_mpoly_total_degree_fmpz(own, term, ring);
    same = fmpz_equal(own, degree) != 0;
  }
  fmpz_mpoly_clear(term, ring);
  fmpz_clear(degree);
  fmpz_clear(own);
  if (!same) fmpz_mpoly_q_add_si(sum, sum, 1, ring);
}

static int sign_of_factor(const fmpz_mpoly_t p, const tp_domain *domain) {
  const tp_field *field = domain->subject->field;
  fmpz_mpoly_q_t value, multiplier;
  fmpz_mpoly_q_init(value, field->ring);
  fmpz_mpoly_q_init(multiplier, field->ring);
  int sign = 0;
  if (substitute(value, p, domain)) {
    const fmpz_mpoly_struct *top = fmpz_mpoly_q_numref(value);
    sign = tp_field_sign_of_coefficients(top, field);
    set_multiplier(multiplier, top, field);
    for (int k = 0; k < MULTIPLICATIONS && sign == 0 && top->length < MOST_TERMS; k++) {
      tp_field_mul(value, value, multiplier, field);
      if (tp_field_problem(field) != NULL) break;
      sign = tp_field_sign_of_coefficients(top, field);
    }
  }
  fmpz_mpoly_q_clear(value, field->ring);
  fmpz_mpoly_q_clear(multiplier, field->ring);
  tp_field_forgive(field);
  return sign;
}

static int sign_of_polynomial(const fmpz_mpoly_t p, const tp_domain *domain, bool strict) {
  const tp_field *field = domain->subject->field;
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  if (fmpz_mpoly_is_zero(p, ring)) return strict ? 0 : 1;
  const double units = tp_field_factor_units(p, field);
  fmpz_mpoly_factor_t factors;
  fmpz_mpoly_factor_init(factors, ring);
  int sign = 0;
  if (units > most_units || !tp_field_spend(field, units) || !tp_field_factor(factors, p, field)) {
    sign = sign_of_factor(p, domain);
  } else {
    sign = fmpz_sgn(factors->constant);
    for (slong k = 0; k < factors->num && sign != 0; k++) {
      const bool even = fmpz_is_even(factors->exp + k) != 0;
      if (even && !strict) continue;
      const int own = sign_of_factor(factors->poly + k, domain);
      sign = own == 0 ? 0 : even ? sign : sign * own;
    }
  }
  fmpz_mpoly_factor_clear(factors, ring);
  return sign;
}

int tp_domain_sign(const fmpz_mpoly_q_t formula, const tp_domain *domain, bool strict) {
  const int below = sign_of_polynomial(fmpz_mpoly_q_denref(formula), domain, true);
  const int top = sign_of_polynomial(fmpz_mpoly_q_numref(formula), domain, strict);
  return below == 0 ? 0 : top * below;
}
