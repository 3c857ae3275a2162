/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sines, cosines and tangents of sums of angles, as rational functions of the sines and cosines of
 * the angles.
 *
 * For an angle n_1 t_1 + … + 90 m degrees with whole n and m, cos + i sin is the product of the
 * (cos t_k + i sin t_k)^n_k and of i^m. The tangent needs only twice the angle to be of that form:
 * tan x = sin 2x / (1 + cos 2x). */

#include "verify/angles.h"

#include "derive/field_work.h"

#include <stdlib.h>

/* sin(40 x) is a polynomial of degree 40 in sin x and cos x; larger multiples, and quarter turns of
 * more than MOST_BITS, are left to balls. */
enum { MOST_MULTIPLE = 40, MOST_BITS = 11 };

typedef struct complex_formula {
  fmpz_mpoly_q_t re, im;
} complex_formula;

static void complex_init(complex_formula *z, const fmpz_mpoly_ctx_t ring) {
  fmpz_mpoly_q_init(z->re, ring);
  fmpz_mpoly_q_init(z->im, ring);
}

static void complex_clear(complex_formula *z, const fmpz_mpoly_ctx_t ring) {
  fmpz_mpoly_q_clear(z->re, ring);
  fmpz_mpoly_q_clear(z->im, ring);
}

/* z = z w, in normal form. */
static void complex_multiply(complex_formula *z, const complex_formula *w, const tp_subject *s) {
  const tp_field *field = s->field;
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  complex_formula product;
  fmpz_mpoly_q_t term;
  complex_init(&product, ring);
  fmpz_mpoly_q_init(term, ring);
  tp_field_mul(product.re, z->re, w->re, field);
  tp_field_mul(term, z->im, w->im, field);
  tp_field_sub(product.re, product.re, term, field);
  tp_field_mul(product.im, z->re, w->im, field);
  tp_field_mul(term, z->im, w->re, field);
  tp_field_add(product.im, product.im, term, field);
  tp_subject_reduce(product.re, s);
  tp_subject_reduce(product.im, s);
  fmpz_mpoly_q_swap(z->re, product.re, ring);
  fmpz_mpoly_q_swap(z->im, product.im, ring);
  fmpz_mpoly_q_clear(term, ring);
  complex_clear(&product, ring);
}

/* The multiples of each angle, and of a right angle, that `scale` times the formula is; false where
 * it is no such sum. */
static bool split(long *multiples, long *quarters, const fmpz_mpoly_q_t angle, long scale,
                  const tp_subject *s) {
  const fmpz_mpoly_ctx_struct *ring = s->field->ring;
  const fmpz_mpoly_struct *top = fmpz_mpoly_q_numref(angle), *below = fmpz_mpoly_q_denref(angle);
  if (!fmpz_mpoly_is_fmpz(below, ring)) return false;
  fmpq_t coefficient;
  fmpz_t divisor;
  fmpq_init(coefficient);
  fmpz_init(divisor);
  fmpz_mpoly_get_fmpz(divisor, below, ring);
  bool fits = true;
  *quarters = 0;
  for (long k = 0; k < s->angle_count; k++) multiples[k] = 0;
  for (slong t = 0; t < fmpz_mpoly_length(top, ring) && fits; t++) {
    fmpz_mpoly_t monomial;
    long own = -1;
    fmpz_mpoly_init(monomial, ring);
    fmpz_mpoly_get_term_monomial(monomial, top, t, ring);
    const bool constant = fmpz_mpoly_is_one(monomial, ring) != 0;
    for (long k = 0; k < s->angle_count && !constant; k++) {
      if (fmpz_mpoly_is_gen(monomial, s->angles[k].degrees, ring)) own = k;
    }
    fmpz_mpoly_clear(monomial, ring);
    fmpz_mpoly_get_term_coeff_fmpz(fmpq_numref(coefficient), top, t, ring);
    fmpz_mul_si(fmpq_numref(coefficient), fmpq_numref(coefficient), scale);
    fmpz_set(fmpq_denref(coefficient), divisor);
    if (constant) fmpz_mul_ui(fmpq_denref(coefficient), fmpq_denref(coefficient), 90);
    fmpq_canonicalise(coefficient);
    fits = (constant || own >= 0) && fmpz_is_one(fmpq_denref(coefficient)) &&
           fmpz_bits(fmpq_numref(coefficient)) <= MOST_BITS;
    const long whole = fits ? fmpz_get_si(fmpq_numref(coefficient)) : 0;
    fits = fits && (constant || labs(whole) <= MOST_MULTIPLE);
    if (fits) *(constant ? quarters : multiples + own) = whole;
  }
  fmpq_clear(coefficient);
  fmpz_clear(divisor);
  return fits;
}

/* Sine and cosine of scale times the angle. */
static bool multiple(fmpz_mpoly_q_t sine, fmpz_mpoly_q_t cosine, const fmpz_mpoly_q_t angle,
                     long scale, const tp_subject *s) {
  const fmpz_mpoly_ctx_struct *ring = s->field->ring;
  enum { MOST_ANGLES = 64 };
  long multiples[MOST_ANGLES], quarters = 0;
  if (s->angle_count > MOST_ANGLES || !split(multiples, &quarters, angle, scale, s)) return false;
  static const int cosines[4] = {1, 0, -1, 0};
  const long quarter = ((quarters % 4) + 4) % 4;
  complex_formula z, factor;
  complex_init(&z, ring);
  complex_init(&factor, ring);
  fmpz_mpoly_q_set_si(z.re, cosines[quarter], ring);
  fmpz_mpoly_q_set_si(z.im, cosines[(quarter + 3) % 4], ring);
  for (long k = 0; k < s->angle_count; k++) {
    fmpz_mpoly_q_gen(factor.re, s->angles[k].cosine, ring);
    fmpz_mpoly_q_gen(factor.im, s->angles[k].sine, ring);
    if (multiples[k] < 0) fmpz_mpoly_q_neg(factor.im, factor.im, ring);
    for (long j = 0; j < labs(multiples[k]); j++) complex_multiply(&z, &factor, s);
  }
  fmpz_mpoly_q_swap(cosine, z.re, ring);
  fmpz_mpoly_q_swap(sine, z.im, ring);
  complex_clear(&z, ring);
  complex_clear(&factor, ring);
  return true;
}

bool tp_angle_sine_cosine(fmpz_mpoly_q_t sine, fmpz_mpoly_q_t cosine, const fmpz_mpoly_q_t angle,
                          const tp_subject *s) {
  return multiple(sine, cosine, angle, 1, s);
}

bool tp_angle_tangent(fmpz_mpoly_q_t tangent, bool *infinite, const fmpz_mpoly_q_t angle,
                      const tp_subject *s) {
  const tp_field *field = s->field;
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  fmpz_mpoly_q_t cosine;
  fmpz_mpoly_q_init(cosine, ring);
  bool known = multiple(tangent, cosine, angle, 1, s);
  if (!known) {
    known = multiple(tangent, cosine, angle, 2, s);
    fmpz_mpoly_q_add_si(cosine, cosine, 1, ring);
  }
  *infinite = known && fmpz_mpoly_q_is_zero(cosine, ring) != 0;
  if (known && !*infinite) {
    tp_field_div(tangent, tangent, cosine, field);
    tp_subject_reduce(tangent, s);
  }
  fmpz_mpoly_q_clear(cosine, ring);
  return known;
}
