/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Bounds of each symbol and angle of a claim, and the test of a sample against them. */

#include "verify/domain.h"

#include "derive/field_work.h"

#include <stdlib.h>

void tp_domain_free(tp_domain *d) {
  if (d == NULL) return;
  const fmpz_mpoly_ctx_struct *ring = d->subject->field->ring;
  for (long k = 0; k < d->bounds_count; k++) {
    fmpz_mpoly_q_clear(d->bounds[k].low, ring);
    fmpz_mpoly_q_clear(d->bounds[k].high, ring);
  }
  tp_images_clear(&d->images);
  free(d->bounds);
  free(d->signs);
  free(d);
}

static bool within_right_angle(const fmpq_t value) {
  return fmpq_sgn(value) >= 0 && fmpq_cmp_si(value, 90) <= 0;
}

tp_domain *tp_domain_new(const tp_subject *s, const tp_claim_sample *sample) {
  const fmpz_mpoly_ctx_struct *ring = s->field->ring;
  tp_domain *d = calloc(1, sizeof *d);
  if (d == NULL) return NULL;
  d->subject = s;
  d->symbol_count = s->field->symbol_count;
  d->signs = calloc((size_t)d->symbol_count, sizeof *d->signs);
  if (d->signs == NULL || !tp_images_init(&d->images, s->field)) {
    tp_domain_free(d);
    return NULL;
  }
  for (long k = 0; k < d->symbol_count; k++) {
    const int sign = fmpq_sgn(sample->values + k);
    fmpz_mpoly_q_struct *image = d->images.of + k;
    if (sign < 0) fmpz_mpoly_q_neg(image, image, ring);
    d->images.free[k] = sign == 0;
    d->signs[k] = sign;
  }
  fmpq_t low, high;
  fmpq_init(low);
  fmpq_init(high);
  fmpq_set_si(high, 90, 1);
  for (long k = 0; k < s->angle_count; k++) {
    const tp_angle *a = s->angles + k;
    d->images.free[a->degrees] = !within_right_angle(sample->values + a->degrees);
    if (!d->images.free[a->degrees]) fmpz_mpoly_q_gen(d->images.of + a->degrees, a->degrees, ring);
    if (!d->images.free[a->degrees]) tp_images_set_angle(&d->images, a, low, high);
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
                        const tp_claim_sample *sample) {
  return tp_field_evaluate_at(value, bound, sample->values, d->subject->field);
}

/* Does the symbol lie within these bounds, its ends included with `closed`? */
static bool inside(const tp_domain *d, const tp_domain_bounds *b, const tp_claim_sample *sample,
                   bool closed) {
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

/* An angle's bounds are numbers. */
static bool bound_angle(tp_domain *d, const tp_domain_bounds *b, const tp_angle *angle) {
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
  if (known) tp_images_set_angle(&d->images, angle, low, high);
  fmpq_clear(low);
  fmpq_clear(high);
  return known;
}

tp_status tp_domain_bound(tp_domain *d, const tp_domain_bounds *bounds,
                          const tp_claim_sample *sample, tp_place place, tp_message *message) {
  if (d->bounds_count == d->bounds_capacity) {
    const long capacity = 2 * d->bounds_capacity + 8;
    tp_domain_bounds *all = realloc(d->bounds, (size_t)capacity * sizeof *all);
    if (all == NULL) return tp_fail_memory(message, "a domain");
    d->bounds = all;
    d->bounds_capacity = capacity;
  }
  const fmpz_mpoly_ctx_struct *ring = d->subject->field->ring;
  tp_domain_bounds *own = d->bounds + d->bounds_count++;
  *own = (tp_domain_bounds){
      .symbol = bounds->symbol, .has_low = bounds->has_low, .has_high = bounds->has_high};
  fmpz_mpoly_q_init(own->low, ring);
  fmpz_mpoly_q_init(own->high, ring);
  fmpz_mpoly_q_set(own->low, bounds->low, ring);
  fmpz_mpoly_q_set(own->high, bounds->high, ring);
  if (!inside(d, own, sample, true)) {
    return tp_refuse(message, TP_FAULT_RANGE, place,
                     "the claim's value of '%.40s' lies outside this domain",
                     d->subject->field->names[own->symbol]);
  }
  const tp_angle *angle = tp_domain_angle_of(d, own->symbol);
  if (angle != NULL && !bound_angle(d, own, angle)) {
    return tp_refuse(message, TP_FAULT_RANGE, place,
                     "the domain of an angle is two numbers of degrees between -179 and 179");
  }
  tp_images_set_symbol(&d->images, own);
  return tp_field_check(d->subject->field, place, message);
}

const tp_domain_bounds *tp_domain_bounds_of(const tp_domain *d, long symbol) {
  for (long k = d->bounds_count - 1; k >= 0; k--) {
    if (d->bounds[k].symbol == symbol) return d->bounds + k;
  }
  return NULL;
}

bool tp_domain_angle(double *low, double *high, const tp_domain *d, long angle) {
  const long symbol = d->subject->angles[angle].degrees;
  const tp_domain_bounds *b = tp_domain_bounds_of(d, symbol);
  if (d->images.free[symbol] && b == NULL) return false;
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

bool tp_domain_holds(const tp_domain *d, const tp_claim_sample *sample) {
  for (long k = 0; k < d->symbol_count; k++) {
    const fmpq *value = sample->values + k;
    const int sign = d->signs[k];
    const tp_domain_bounds *bounds = tp_domain_bounds_of(d, k);
    if (bounds != NULL) {
      if (!inside(d, bounds, sample, true)) return false;
    } else if (tp_domain_angle_of(d, k) != NULL) {
      if (!d->images.free[k] && !within_right_angle(value)) return false;
    } else if (!d->images.free[k] && sign != 0 && fmpq_sgn(value) != sign) {
      return false;
    }
  }
  return true;
}
