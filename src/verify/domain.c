/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The domain of a claim. */

#include "verify/domain.h"

#include "derive/field_work.h"
#include "number/ball.h"

#include <stdlib.h>

void tp_domain_free(tp_domain *d) {
  if (d == NULL) return;
  const fmpz_mpoly_ctx_struct *ring = d->subject->field->ring;
  for (long k = 0; d->images != NULL && k < d->symbol_count; k++) {
    fmpz_mpoly_q_clear(d->images + k, ring);
  }
  for (long k = 0; k < d->bounds_count; k++) {
    fmpz_mpoly_q_clear(d->bounds[k].low, ring);
    fmpz_mpoly_q_clear(d->bounds[k].high, ring);
  }
  free(d->bounds);
  free(d->images);
  free(d->free);
  free(d->signs);
  free(d);
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
  arb_set_fmpq(turn, degrees, 128);
  arb_div_ui(turn, turn, 360, 128);
  arb_tan_pi(turn, turn, 128);
  arb_mul_2exp_si(turn, turn, 40);
  arf_get_fmpz(rounded, arb_midref(turn), ARF_RND_FLOOR);
  fmpz_add_si(rounded, rounded, upwards ? 2 : -1);
  fmpq_set_fmpz(tangent, rounded);
  fmpq_div_2exp(tangent, tangent, 40);
  arb_clear(turn);
  fmpz_clear(rounded);
}

/* Sine and cosine of an angle between two in [-180, 180), 180: by t, for which the sine stands. */
static void set_angle(tp_domain *d, const tp_angle *angle, const fmpq_t low, const fmpq_t high) {
  const tp_field *field = d->subject->field;
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
  tp_field_div(d->images + angle->cosine, one, n, field);
  tp_field_add(t, t, t, field);
  tp_field_div(d->images + angle->sine, t, n, field);
  d->free[angle->sine] = d->free[angle->cosine] = false;
  fmpz_mpoly_q_clear(t, ring);
  fmpz_mpoly_q_clear(n, ring);
  fmpz_mpoly_q_clear(one, ring);
  fmpq_clear(first);
  fmpq_clear(last);
}

static bool within_right_angle(const fmpq_t value) {
  return fmpq_sgn(value) >= 0 && fmpq_cmp_si(value, 90) <= 0;
}

tp_domain *tp_domain_new(const tp_subject *s, const tp_sample *sample) {
  const fmpz_mpoly_ctx_struct *ring = s->field->ring;
  tp_domain *d = calloc(1, sizeof *d);
  if (d == NULL) return NULL;
  d->subject = s;
  d->symbol_count = s->field->symbol_count;
  d->free = calloc((size_t)d->symbol_count, sizeof *d->free);
  d->images = calloc((size_t)d->symbol_count, sizeof *d->images);
  d->signs = calloc((size_t)d->symbol_count, sizeof *d->signs);
  if (d->free == NULL || d->images == NULL || d->signs == NULL) {
    free(d->images);
    d->images = NULL;
    tp_domain_free(d);
    return NULL;
  }
  for (long k = 0; k < d->symbol_count; k++) {
    const int sign = fmpq_sgn(sample->values + k);
    fmpz_mpoly_q_init(d->images + k, ring);
    fmpz_mpoly_q_gen(d->images + k, k, ring);
    if (sign < 0) fmpz_mpoly_q_neg(d->images + k, d->images + k, ring);
    d->free[k] = sign == 0;
    d->signs[k] = sign;
  }
  fmpq_t low, high;
  fmpq_init(low);
  fmpq_init(high);
  fmpq_set_si(high, 90, 1);
  for (long k = 0; k < s->angle_count; k++) {
    const tp_angle *a = s->angles + k;
    d->free[a->degrees] = !within_right_angle(sample->values + a->degrees);
    if (!d->free[a->degrees]) fmpz_mpoly_q_gen(d->images + a->degrees, a->degrees, ring);
    if (!d->free[a->degrees]) set_angle(d, a, low, high);
  }
  fmpq_clear(low);
  fmpq_clear(high);
  return d;
}

const tp_angle *tp_domain_angle_of(const tp_domain *d, long symbol) {
  for (long k = 0; k < d->subject->angle_count; k++) {
    if (d->subject->angles[k].degrees == symbol) return d->subject->angles + k;
  }
  return NULL;
}

bool tp_domain_bound_at(fmpq_t value, const fmpz_mpoly_q_t bound, const tp_domain *d,
                        const tp_sample *sample) {
  return tp_field_evaluate_at(value, bound, sample->values, d->subject->field);
}

/* Does the symbol lie within these bounds, its ends included with `closed`? */
static bool inside(const tp_domain *d, const tp_bounds *b, const tp_sample *sample, bool closed) {
  fmpq_t end;
  fmpq_init(end);
  const fmpq *own = sample->values + b->symbol;
  bool holds = true;
  if (b->has_low) {
    holds = tp_domain_bound_at(end, b->low, d, sample) && fmpq_cmp(own, end) >= (closed ? 0 : 1);
  }
  if (b->has_high && holds) {
    holds = tp_domain_bound_at(end, b->high, d, sample) && fmpq_cmp(own, end) <= (closed ? 0 : -1);
  }
  fmpq_clear(end);
  return holds;
}

/* A bound in terms of the t of the symbols in it. */
static bool in_images(fmpz_mpoly_q_t value, const fmpz_mpoly_q_t bound, const tp_domain *d) {
  const tp_field *field = d->subject->field;
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
      for (long k = 0; k < d->symbol_count; k++) {
        const slong exponent = fmpz_mpoly_get_term_var_exp_si(p, t, k, ring);
        if (exponent > 0 && d->free[k]) known = false;
        for (slong j = 0; j < exponent && known; j++) {
          tp_field_mul(term, term, d->images + k, field);
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

/* The symbol in terms of its own t. Where a denominator may not be positive the symbol is free:
 * nothing is then proven about it, and points alone tell. */
static void set_image(tp_domain *d, const tp_bounds *b) {
  const tp_field *field = d->subject->field;
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  fmpz_mpoly_q_t t, low, high;
  fmpz_mpoly_q_init(t, ring);
  fmpz_mpoly_q_init(low, ring);
  fmpz_mpoly_q_init(high, ring);
  bool known = b->has_low || b->has_high;
  if (b->has_low) known = known && in_images(low, b->low, d);
  if (b->has_high) known = known && in_images(high, b->high, d);
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
  d->free[b->symbol] = !known;
  fmpz_mpoly_q_swap(d->images + b->symbol, t, ring);
  fmpz_mpoly_q_clear(t, ring);
  fmpz_mpoly_q_clear(low, ring);
  fmpz_mpoly_q_clear(high, ring);
}

/* An angle's bounds are numbers. */
static bool bound_angle(tp_domain *d, const tp_bounds *b, const tp_angle *angle) {
  const fmpz_mpoly_ctx_struct *ring = d->subject->field->ring;
  fmpq_t low, high;
  fmpq_init(low);
  fmpq_init(high);
  bool known = b->has_low && b->has_high && fmpz_mpoly_q_is_fmpq(b->low, ring) &&
               fmpz_mpoly_q_is_fmpq(b->high, ring) &&
               tp_field_evaluate_at(low, b->low, d->subject->values, d->subject->field) &&
               tp_field_evaluate_at(high, b->high, d->subject->values, d->subject->field) &&
               fmpq_cmp_si(low, -179) >= 0 && fmpq_cmp_si(high, 179) <= 0 &&
               fmpq_cmp(low, high) < 0;
  if (known) set_angle(d, angle, low, high);
  fmpq_clear(low);
  fmpq_clear(high);
  return known;
}

tp_status tp_domain_bound(tp_domain *d, const tp_bounds *bounds, const tp_sample *sample,
                          tp_place place, tp_message *message) {
  if (d->bounds_count == d->bounds_capacity) {
    const long capacity = 2 * d->bounds_capacity + 8;
    tp_bounds *all = realloc(d->bounds, (size_t)capacity * sizeof *all);
    if (all == NULL) return tp_fail_memory(message, "a domain");
    d->bounds = all;
    d->bounds_capacity = capacity;
  }
  const fmpz_mpoly_ctx_struct *ring = d->subject->field->ring;
  tp_bounds *own = d->bounds + d->bounds_count++;
  *own = (tp_bounds){
      .symbol = bounds->symbol, .has_low = bounds->has_low, .has_high = bounds->has_high};
  fmpz_mpoly_q_init(own->low, ring);
  fmpz_mpoly_q_init(own->high, ring);
  fmpz_mpoly_q_set(own->low, bounds->low, ring);
  fmpz_mpoly_q_set(own->high, bounds->high, ring);
  if (!inside(d, own, sample, true)) {
    return tp_fail(message, TP_BAD_INPUT, place,
                   "the claim's own value of '%.40s' lies outside this domain",
                   d->subject->field->names[own->symbol]);
  }
  const tp_angle *angle = tp_domain_angle_of(d, own->symbol);
  if (angle != NULL && !bound_angle(d, own, angle)) {
    return tp_fail(message, TP_BAD_INPUT, place,
                   "the domain of an angle is two numbers of degrees between -179 and 179");
  }
  set_image(d, own);
  return tp_field_check(d->subject->field, place, message);
}

const tp_bounds *tp_domain_bounds_of(const tp_domain *d, long symbol) {
  for (long k = d->bounds_count - 1; k >= 0; k--) {
    if (d->bounds[k].symbol == symbol) return d->bounds + k;
  }
  return NULL;
}

bool tp_domain_angle(double *low, double *high, const tp_domain *d, long angle) {
  const long symbol = d->subject->angles[angle].degrees;
  const tp_bounds *b = tp_domain_bounds_of(d, symbol);
  if (d->free[symbol] && b == NULL) return false;
  *low = 0;
  *high = 90;
  if (b == NULL) return true;
  fmpq_t end;
  fmpq_init(end);
  bool known = tp_field_evaluate_at(end, b->low, d->subject->values, d->subject->field);
  *low = fmpq_get_d(end);
  known = known && tp_field_evaluate_at(end, b->high, d->subject->values, d->subject->field);
  *high = fmpq_get_d(end);
  fmpq_clear(end);
  return known;
}

bool tp_domain_holds(const tp_domain *d, const tp_sample *sample) {
  for (long k = 0; k < d->symbol_count; k++) {
    const fmpq *value = sample->values + k;
    const int sign = d->signs[k];
    const tp_bounds *bounds = tp_domain_bounds_of(d, k);
    if (bounds != NULL) {
      if (!inside(d, bounds, sample, true)) return false;
    } else if (tp_domain_angle_of(d, k) != NULL) {
      if (!d->free[k] && !within_right_angle(value)) return false;
    } else if (!d->free[k] && sign != 0 && fmpq_sgn(value) != sign) {
      return false;
    }
  }
  return true;
}
