/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The substitutions of the head of domain.h: t, low + t, (low + high t)/(1 + t) for a symbol; for
 * an angle tan(angle/2) so, with ends that are rounded outwards by 2^-40, and sine and cosine from
 * that. */

#include "verify/domain_images.h"

#include "derive/field_work.h"

#include <stdlib.h>

bool tp_images_init(tp_images *images, const tp_field *field) {
  const size_t count = (size_t)field->symbol_count;
  *images = (tp_images){.field = field,
                        .free = calloc(count, sizeof *images->free),
                        .of = calloc(count, sizeof *images->of)};
  if (images->free == NULL || images->of == NULL) {
    free(images->free);
    free(images->of);
    *images = (tp_images){0};
    return false;
  }
  for (long k = 0; k < field->symbol_count; k++) {
    fmpz_mpoly_q_init(images->of + k, field->ring);
    fmpz_mpoly_q_gen(images->of + k, k, field->ring);
  }
  return true;
}

void tp_images_clear(tp_images *images) {
  for (long k = 0; images->of != NULL && k < images->field->symbol_count; k++) {
    fmpz_mpoly_q_clear(images->of + k, images->field->ring);
  }
  free(images->of);
  free(images->free);
}

/* tan(degrees / 2) as a rational number, outwards by 2^-40 where it is none. */
static void half_tangent(fmpq_t tangent, const fmpq_t degrees, bool upwards) {
  if (fmpq_is_zero(degrees) || fmpq_cmp_si(degrees, 90) == 0) {
    fmpq_set_si(tangent, fmpq_is_zero(degrees) ? 0 : 1, 1);
    return;
  }
  arb_t turn;
  fmpz_t rounded;
  arb_init(turn);
  fmpz_init(rounded);
  enum { BITS = 128, GRID = 40 }; /* multiples of 2^-40, outwards by one and more */
  arb_set_fmpq(turn, degrees, BITS);
  arb_div_ui(turn, turn, 360, BITS);
  arb_tan_pi(turn, turn, BITS);
  arb_mul_2exp_si(turn, turn, GRID);
  arf_get_fmpz(rounded, arb_midref(turn), ARF_RND_FLOOR);
  fmpz_add_si(rounded, rounded, upwards ? 2 : -1);
  fmpq_set_fmpz(tangent, rounded);
  fmpq_div_2exp(tangent, tangent, GRID);
  arb_clear(turn);
  fmpz_clear(rounded);
}

void tp_images_set_angle(tp_images *images, const tp_angle *angle, const fmpq_t low,
                         const fmpq_t high) {
  const tp_field *field = images->field;
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  fmpq_t first, last;
  fmpz_mpoly_q_t t, n, one;
  fmpq_init(first);
  fmpq_init(last);
  fmpz_mpoly_q_init(t, ring);
  fmpz_mpoly_q_init(n, ring);
  fmpz_mpoly_q_init(one, ring);
  half_tangent(first, low, false);
  half_tangent(last, high, true);
  fmpz_mpoly_q_gen(t, angle->sine, ring);
  fmpz_mpoly_q_mul_fmpq(n, t, last, ring);
  fmpz_mpoly_q_add_fmpq(n, n, first, ring);
  fmpz_mpoly_q_add_si(t, t, 1, ring);
  tp_field_div(t, n, t, field); /* u */
  tp_field_mul(n, t, t, field);
  fmpz_mpoly_q_one(one, ring);
  tp_field_sub(one, one, n, field);
  fmpz_mpoly_q_add_si(n, n, 1, ring);
  tp_field_div(images->of + angle->cosine, one, n, field);
  tp_field_add(t, t, t, field);
  tp_field_div(images->of + angle->sine, t, n, field);
  images->free[angle->sine] = images->free[angle->cosine] = false;
  fmpz_mpoly_q_clear(t, ring);
  fmpz_mpoly_q_clear(n, ring);
  fmpz_mpoly_q_clear(one, ring);
  fmpq_clear(first);
  fmpq_clear(last);
}

/* A bound in terms of the t of the symbols in it. */
static bool in_images(fmpz_mpoly_q_t value, const fmpz_mpoly_q_t bound, const tp_images *images) {
  const tp_field *field = images->field;
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  fmpz_mpoly_q_t halves[2], term;
  fmpz_mpoly_q_init(term, ring);
  bool known = true;
  for (int h = 0; h < 2; h++) {
    const fmpz_mpoly_struct *p = h == 0 ? fmpz_mpoly_q_numref(bound) : fmpz_mpoly_q_denref(bound);
    fmpz_mpoly_q_init(halves[h], ring);
    for (slong t = 0; t < p->length; t++) {
      fmpz_t coefficient;
      fmpz_init(coefficient);
      fmpz_mpoly_get_term_coeff_fmpz(coefficient, p, t, ring);
      fmpz_mpoly_q_set_fmpz(term, coefficient, ring);
      fmpz_clear(coefficient);
      for (long k = 0; k < field->symbol_count; k++) {
        const slong exponent = fmpz_mpoly_get_term_var_exp_si(p, t, k, ring);
        if (exponent > 0 && images->free[k]) known = false;
        for (slong j = 0; j < exponent && known; j++) {
          tp_field_mul(term, term, images->of + k, field);
          known = tp_field_problem(field) == NULL;
        }
      }
      tp_field_add(halves[h], halves[h], term, field);
    }
  }
  known = known && tp_field_problem(field) == NULL && !fmpz_mpoly_q_is_zero(halves[1], ring);
  if (known) tp_field_div(value, halves[0], halves[1], field);
  fmpz_mpoly_q_clear(halves[0], ring);
  fmpz_mpoly_q_clear(halves[1], ring);
  fmpz_mpoly_q_clear(term, ring);
  return known;
}

void tp_images_set_symbol(tp_images *images, const tp_domain_bounds *b) {
  const tp_field *field = images->field;
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  fmpz_mpoly_q_t t, low, high;
  fmpz_mpoly_q_init(t, ring);
  fmpz_mpoly_q_init(low, ring);
  fmpz_mpoly_q_init(high, ring);
  bool known = b->has_low || b->has_high;
  if (b->has_low) known = known && in_images(low, b->low, images);
  if (b->has_high) known = known && in_images(high, b->high, images);
  fmpz_mpoly_q_gen(t, b->symbol, ring);
  if (b->has_low && b->has_high) {
    tp_field_mul(high, high, t, field);
    tp_field_add(low, low, high, field);
    fmpz_mpoly_q_add_si(t, t, 1, ring);
    tp_field_div(t, low, t, field);
  } else if (b->has_low) {
    tp_field_add(t, t, low, field);
  } else {
    tp_field_sub(t, high, t, field);
  }
  const fmpz_mpoly_struct *below = fmpz_mpoly_q_denref(t);
  for (slong k = 0; k < below->length && known; k++) {
    fmpz_t coefficient;
    fmpz_init(coefficient);
    fmpz_mpoly_get_term_coeff_fmpz(coefficient, below, k, ring);
    known = fmpz_sgn(coefficient) > 0;
    fmpz_clear(coefficient);
  }
  images->free[b->symbol] = !known;
  fmpz_mpoly_q_swap(images->of + b->symbol, t, ring);
  fmpz_mpoly_q_clear(t, ring);
  fmpz_mpoly_q_clear(low, ring);
  fmpz_mpoly_q_clear(high, ring);
}
