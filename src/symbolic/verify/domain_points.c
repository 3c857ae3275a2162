/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Pseudorandom rational points of a domain, some near the claim's values, the others anywhere
 * between the bounds. */

#include "verify/domain.h"

#include <stdint.h>

static uint64_t next(uint64_t *state) {
  *state ^= *state << 13; /* xorshift64, Marsaglia (2003) */
  *state ^= *state >> 7;
  *state ^= *state << 17;
  return *state;
}

/* Points are drawn in thousandths, some near the claim's values, the others anywhere. */
enum {
  THOUSAND = 1000,
  NEAR_LEAST = 850, /* near: from 0.85 to 1.15 times the value */
  NEAR_STEPS = 301,
  FAR_STEPS = 997,  /* else from 1 to 2 times, ... */
  MOST_SHIFT = 8,   /* ... times a power of two up to 2^8 either way */
  ANGLE_STEPS = 997 /* of a degree: a prime, so that no angle is a round one by chance */
};

static void set_factor(fmpq_t factor, uint64_t random, bool near) {
  const uint64_t step = random % (near ? NEAR_STEPS : FAR_STEPS);
  fmpq_set_si(factor, (near ? NEAR_LEAST : THOUSAND) + (long)step, THOUSAND);
}

static void shift(fmpq_t value, uint64_t random) {
  const long by = (long)((random >> 32) % (2 * MOST_SHIFT + 1)) - MOST_SHIFT;
  if (by > 0) fmpq_mul_2exp(value, value, (ulong)by);
  if (by < 0) fmpq_div_2exp(value, value, (ulong)-by);
}

/* A symbol between its bounds. */
static bool place_between(fmpq_t value, const tp_domain *d, const tp_domain_bounds *b,
                          const tp_claim_sample *sample, uint64_t random, bool near) {
  fmpq_t low, high, part;
  fmpq_init(low);
  fmpq_init(high);
  fmpq_init(part);
  bool known = true;
  if (b->has_low) known = known && tp_domain_bound_at(low, b->low, d, sample);
  if (b->has_high) known = known && tp_domain_bound_at(high, b->high, d, sample);
  if (known && b->has_low && b->has_high) {
    fmpq_set_si(part, 1 + (long)(random % (THOUSAND - 1)), THOUSAND);
    fmpq_sub(high, high, low);
    known = fmpq_sgn(high) > 0;
    fmpq_mul(high, high, part);
    fmpq_add(value, low, high);
  } else if (known) { /* as far from the end as the value is, and further or nearer */
    const fmpq *end = b->has_low ? low : high;
    fmpq_sub(part, sample->values + b->symbol, end);
    if (fmpq_is_zero(part)) fmpq_set_si(part, b->has_low ? 1 : -1, 1);
    set_factor(high, random, near);
    fmpq_mul(part, part, high);
    if (!near) shift(part, random);
    if (b->has_low == (fmpq_sgn(part) < 0)) fmpq_neg(part, part);
    fmpq_add(value, end, part);
  }
  fmpq_clear(low);
  fmpq_clear(high);
  fmpq_clear(part);
  return known;
}

/* A symbol without bounds of its own. */
static void move(fmpq_t value, bool angle, bool is_free, uint64_t random, bool near) {
  fmpq_t factor;
  fmpq_init(factor);
  if (near) {
    set_factor(factor, random, true);
    fmpq_mul(value, value, factor);
    if (angle && !is_free && fmpq_cmp_si(value, 90) > 0) fmpq_div(value, value, factor);
  } else if (angle) {
    const long range = is_free ? 359 : 90, least = is_free ? -179 : 0;
    const uint64_t steps = (uint64_t)(range * ANGLE_STEPS - 1);
    fmpq_set_si(value, least * ANGLE_STEPS + 1 + (long)(random % steps), ANGLE_STEPS);
  } else {
    set_factor(factor, random, false);
    if (fmpq_is_zero(value)) fmpq_one(value);
    fmpq_mul(value, value, factor);
    shift(value, random);
    if (is_free && (random >> 60) % 2 == 0) fmpq_neg(value, value);
  }
  fmpq_clear(factor);
}

bool tp_domain_scatter(tp_claim_sample *sample, const tp_domain *d, unsigned seed) {
  uint64_t state = 88172645463325252ULL + seed;
  const bool near = seed < TP_DOMAIN_NEAR;
  const long count = d->subject->field->parameters->count; /* a count stays one */
  for (long k = 0; k < sample->count; k++) {
    const uint64_t random = next(&state);
    if (k == count || tp_domain_bounds_of(d, k) != NULL) continue;
    move(sample->values + k, tp_domain_angle_of(d, k) != NULL, d->images.free[k], random, near);
  }
  bool inside_all = true;
  for (long k = 0; k < d->bounds_count && inside_all; k++) {
    const tp_domain_bounds *b = d->bounds + k;
    inside_all = place_between(sample->values + b->symbol, d, b, sample, next(&state), near);
  }
  return inside_all && tp_domain_holds(d, sample);
}
