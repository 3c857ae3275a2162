/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Arithmetic of rational functions within bounds.
 *
 * Products take a unit for some sixty pairs of terms. What is dear is the greatest common divisor
 * that brings a quotient to lowest terms: it is interpolated, at points that the degrees count, in
 * every pair of variables. Its price is fitted to FLINT 2.9 on products of random polynomials in
 * 1 to 100 variables with degrees up to 6000; it errs upwards. */

#include "derive/field_work.h"

#include <math.h>
#include <stdlib.h>

enum { MOST_TERMS = 1000000, MOST_PAIRS = 20000000, MOST_BITS = 100000, MOST_DEGREE = 100000 };
static const double most_memory = 4e8; /* bits of all terms of a polynomial */
static const char too_large[] =
    "the formula grows beyond what can be derived here: 1000000 terms, degree 100000 and numbers "
    "of "
    "100000 bits; give numbers for some of the parameters, or have fewer different divisors";
static const char too_dear[] =
    "the formulas take more work than is allowed; give numbers, or expressions in other "
    "parameters, for some of the parameters, have fewer different divisors, or put claims into "
    "separate files";

typedef struct size {
  double terms, bits, degree;
} size;

static size size_of(const fmpz_mpoly_struct *p, const tp_field *field) {
  size s = {(double)p->length, 0, 0};
  if (p->length == 0) return s;
  s.bits = (double)labs(fmpz_mpoly_max_bits(p));
  if (p->bits > 16) { /* exponents in fewer bits are below the bound without a count */
    s.degree = fmpz_mpoly_total_degree_fits_si(p, field->ring)
                   ? (double)fmpz_mpoly_total_degree_si(p, field->ring)
                   : INFINITY;
  }
  return s;
}

/* Terms that a product can have: one for each pair, or for each point of the box of its degrees. */
static double product_terms(const fmpz_mpoly_struct *a, const fmpz_mpoly_struct *b,
                            const tp_field *field) {
  const double pairs = (double)a->length * (double)b->length;
  if (pairs <= MOST_TERMS) return pairs;
  double box = 1;
  for (long k = 0; k < field->symbol_count && box < pairs; k++) {
    const slong one = fmpz_mpoly_degree_si(a, k, field->ring);
    const slong other = fmpz_mpoly_degree_si(b, k, field->ring);
    box *= 1 + (double)one + (double)other;
  }
  return box < pairs ? box : pairs;
}

/* The product of two polynomials: what it takes, or infinity where it may not be formed. */
static double product_units(const fmpz_mpoly_struct *p, const fmpz_mpoly_struct *q,
                            const tp_field *field) {
  const size a = size_of(p, field), b = size_of(q, field);
  const double pairs = a.terms * b.terms, bits = a.bits + b.bits;
  const double exponents = 8 * (double)field->symbol_count;
  if (pairs > MOST_PAIRS || bits > MOST_BITS || a.degree + b.degree > MOST_DEGREE) return INFINITY;
  const double terms = product_terms(p, q, field);
  if (terms > MOST_TERMS || terms * (bits + exponents) > most_memory) return INFINITY;
  return 0.015 * pairs * (1 + a.bits / 64) * (1 + b.bits / 64) * (1 + exponents / 256);
}

double tp_field_gcd_units(const fmpz_mpoly_t a, const fmpz_mpoly_t b, const tp_field *field) {
  const double terms = (double)a->length + (double)b->length;
  if (a->length <= 1 || b->length <= 1) return 0.05 * terms;
  const long count = field->symbol_count;
  double first = 1, second = 1, shared = 0;
  slong *degrees = flint_calloc(2 * (size_t)count, sizeof *degrees); /* ends as FLINT's own do */
  fmpz_mpoly_degrees_si(degrees, a, field->ring);
  fmpz_mpoly_degrees_si(degrees + count, b, field->ring);
  for (long k = 0; k < count; k++) {
    const slong least = degrees[k] < degrees[count + k] ? degrees[k] : degrees[count + k];
    if (least <= 0) continue;
    shared++;
    const double degree = (double)least;
    if (degree > first) {
      second = first;
      first = degree;
    } else if (degree > second) {
      second = degree;
    }
  }
  flint_free(degrees);
  const double bits = (double)labs(fmpz_mpoly_max_bits(a)) + (double)labs(fmpz_mpoly_max_bits(b));
  return terms * (1 + (double)count / 64) * (1 + bits / 128) +
         first * second * shared * shared * (1 + bits / 128);
}

double tp_field_factor_units(const fmpz_mpoly_t p, const tp_field *field) {
  const double count = (double)field->symbol_count;
  double used = 4;
  for (long k = 0; k < field->symbol_count; k++)
    used += fmpz_mpoly_degree_si(p, k, field->ring) > 0;
  /* with itself for the square-free part, and as much again for each lifting of a factor; besides,
   * every symbol in use is looked for among all pairs */
  return 20 * tp_field_gcd_units(p, p, field) + 0.01 * used * count * count;
}

bool tp_field_factor(fmpz_mpoly_factor_t factors, const fmpz_mpoly_t p, const tp_field *field) {
  if (fmpz_mpoly_factor(factors, p, field->ring) == 0) return false;
  fmpz_mpoly_t product;
  fmpz_mpoly_init(product, field->ring);
  const bool is = fmpz_mpoly_factor_expand(product, factors, field->ring) != 0 &&
                  fmpz_mpoly_equal(product, p, field->ring) != 0;
  fmpz_mpoly_clear(product, field->ring);
  return is;
}

bool tp_field_spend(const tp_field *field, double units) {
  tp_field_work *work = field->work;
  if (work->problem != NULL) return false;
  work->spent += units;
  if (work->spent > work->budget) work->problem = too_dear;
  return work->problem == NULL;
}

const char *tp_field_problem(const tp_field *field) {
  return field->work->problem;
}

tp_status tp_field_check(const tp_field *field, tp_place place, tp_message *message) {
  if (field->work->problem == NULL) return TP_OK;
  return tp_fail(message, TP_NO_ANSWER, place, "%s", field->work->problem);
}

void tp_field_forgive(const tp_field *field) {
  if (field->work->spent <= field->work->budget) field->work->problem = NULL;
}

/* May an operation of these units be done? */
static bool admit(const tp_field *field, double units) {
  if (field->work->problem != NULL) return false;
  const double each = 2 + (double)field->symbol_count / 8; /* of any operation */
  if (isfinite(units)) return tp_field_spend(field, units + each);
  field->work->problem = too_large;
  return false;
}

static const fmpz_mpoly_struct *top(const fmpz_mpoly_q_struct *q) {
  return fmpz_mpoly_q_numref(q);
}

static const fmpz_mpoly_struct *below(const fmpz_mpoly_q_struct *q) {
  return fmpz_mpoly_q_denref(q);
}

/* p / q times r / s: the products, and the common divisors of p, s and of r, q. */
static double times_units(const fmpz_mpoly_struct *p, const fmpz_mpoly_struct *q,
                          const fmpz_mpoly_struct *r, const fmpz_mpoly_struct *s,
                          const tp_field *field) {
  const double products = product_units(p, r, field) + product_units(q, s, field);
  if (!isfinite(products)) return INFINITY;
  return products + tp_field_gcd_units(p, s, field) + tp_field_gcd_units(r, q, field);
}

/* A sum of two polynomials. */
static double sum_units(const fmpz_mpoly_struct *p, const fmpz_mpoly_struct *q,
                        const tp_field *field) {
  const size a = size_of(p, field), b = size_of(q, field);
  const double terms = a.terms + b.terms, bits = fmax(a.bits, b.bits) + 1;
  const bool fits = terms <= MOST_TERMS && bits <= MOST_BITS && terms * bits <= most_memory;
  const double words = 1 + bits / 64 + (double)field->symbol_count / 8;
  return fits ? 0.1 * terms * words : INFINITY;
}

/* p / q plus r / s. The common divisor of the new numerator and the denominators is priced by that
 * of the denominators, whose degrees bound it. */
static double plus_units(const fmpz_mpoly_q_struct *one, const fmpz_mpoly_q_struct *other,
                         const tp_field *field) {
  const fmpz_mpoly_struct *p = top(one), *q = below(one), *r = top(other), *s = below(other);
  if (fmpz_mpoly_equal(q, s, field->ring)) {
    const double gcd = fmpz_mpoly_is_fmpz(q, field->ring) ? 0 : tp_field_gcd_units(q, q, field);
    return sum_units(p, r, field) + 2 * gcd;
  }
  const double products =
      product_units(p, s, field) + product_units(r, q, field) + product_units(q, s, field);
  if (!isfinite(products)) return INFINITY;
  const double terms = product_terms(p, s, field) + product_terms(r, q, field);
  if (terms > MOST_TERMS) return INFINITY;
  const bool whole = fmpz_mpoly_is_fmpz(q, field->ring) && fmpz_mpoly_is_fmpz(s, field->ring);
  return products + 0.1 * terms + (whole ? 0 : 2 * tp_field_gcd_units(q, s, field));
}

void tp_field_add(fmpz_mpoly_q_t value, const fmpz_mpoly_q_t a, const fmpz_mpoly_q_t b,
                  const tp_field *field) {
  if (admit(field, plus_units(a, b, field))) {
    fmpz_mpoly_q_add(value, a, b, field->ring);
  } else {
    fmpz_mpoly_q_zero(value, field->ring);
  }
}

void tp_field_sub(fmpz_mpoly_q_t value, const fmpz_mpoly_q_t a, const fmpz_mpoly_q_t b,
                  const tp_field *field) {
  if (admit(field, plus_units(a, b, field))) {
    fmpz_mpoly_q_sub(value, a, b, field->ring);
  } else {
    fmpz_mpoly_q_zero(value, field->ring);
  }
}

void tp_field_mul(fmpz_mpoly_q_t value, const fmpz_mpoly_q_t a, const fmpz_mpoly_q_t b,
                  const tp_field *field) {
  if (admit(field, times_units(top(a), below(a), top(b), below(b), field))) {
    fmpz_mpoly_q_mul(value, a, b, field->ring);
  } else {
    fmpz_mpoly_q_zero(value, field->ring);
  }
}

void tp_field_div(fmpz_mpoly_q_t value, const fmpz_mpoly_q_t a, const fmpz_mpoly_q_t b,
                  const tp_field *field) {
  if (admit(field, times_units(top(a), below(a), below(b), top(b), field))) {
    fmpz_mpoly_q_div(value, a, b, field->ring);
  } else {
    fmpz_mpoly_q_zero(value, field->ring);
  }
}

void tp_field_addmul(fmpz_mpoly_q_t value, const fmpz_mpoly_q_t a, const fmpz_mpoly_q_t b,
                     const tp_field *field) {
  fmpz_mpoly_q_t product;
  fmpz_mpoly_q_init(product, field->ring);
  tp_field_mul(product, a, b, field);
  tp_field_add(value, value, product, field);
  fmpz_mpoly_q_clear(product, field->ring);
}

void tp_field_submul(fmpz_mpoly_q_t value, const fmpz_mpoly_q_t a, const fmpz_mpoly_q_t b,
                     const tp_field *field) {
  fmpz_mpoly_q_t product;
  fmpz_mpoly_q_init(product, field->ring);
  tp_field_mul(product, a, b, field);
  tp_field_sub(value, value, product, field);
  fmpz_mpoly_q_clear(product, field->ring);
}
