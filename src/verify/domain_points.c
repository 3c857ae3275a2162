/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Points of a domain. */

#include "verify/domain.h"

#include <stdint.h>

static uint64_t next(uint64_t *state) {
  *state ^= *state << 13; /* xorshift64, Marsaglia (2003) */
  *state ^= *state >> 7;
  *state ^= *state << 17;
  return *state;
}

/* A symbol between its bounds. */
static bool place_between(fmpq_t value, const tp_domain *d, const tp_bounds *b,
                          const tp_sample *sample, uint64_t random, bool near) {
  fmpq_t low, high, part;
  fmpq_init(low);
  fmpq_init(high);
  fmpq_init(part);
  bool known = true;
  if (b->has_low) known = known && tp_domain_bound_at(low, b->low, d, sample);
  if (b->has_high) known = known && tp_domain_bound_at(high, b->high, d, sample);
  if (known && b->has_low && b->has_high) {
    fmpq_set_si(part, 1 + (long)(random % 999), 1000);
    fmpq_sub(high, high, low);
    known = fmpq_sgn(high) > 0;
    fmpq_mul(high, high, part);
    fmpq_add(value, low, high);
  } else if (known) { /* as far from the end as the value is, and further or nearer */
    const fmpq *end = b->has_low ? low : high;
    fmpq_sub(part, sample->values + b->symbol, end);
    if (fmpq_is_zero(part)) fmpq_set_si(part, b->has_low ? 1 : -1, 1);
    fmpq_set_si(high, near ? 850 + (long)(random % 301) : 1000 + (long)(random % 997), 1000);
    fmpq_mul(part, part, high);
    const long shift = near ? 0 : (long)((random >> 32) % 17) - 8;
    if (shift > 0) fmpq_mul_2exp(part, part, (ulong)shift);
    if (shift < 0) fmpq_div_2exp(part, part, (ulong)-shift);
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
    fmpq_set_si(factor, 850 + (long)(random % 301), 1000);
    fmpq_mul(value, value, factor);
    if (angle && !is_free && fmpq_cmp_si(value, 90) > 0) fmpq_div(value, value, factor);
  } else if (angle) {
    const long range = is_free ? 359 : 90, least = is_free ? -179 : 0;
    fmpq_set_si(value, least * 997 + 1 + (long)(random % (uint64_t)(range * 997 - 1)), 997);
  } else {
    fmpq_set_si(factor, 1000 + (long)(random % 997), 1000);
    const long shift = (long)((random >> 32) % 17) - 8;
    if (fmpq_is_zero(value)) fmpq_one(value);
    fmpq_mul(value, value, factor);
    if (shift > 0) fmpq_mul_2exp(value, value, (ulong)shift);
    if (shift < 0) fmpq_div_2exp(value, value, (ulong)-shift);
    if (is_free && (random >> 60) % 2 == 0) fmpq_neg(value, value);
  }
  fmpq_clear(factor);
}

bool tp_domain_scatter(tp_sample *sample, const tp_domain *d, unsigned seed) {
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
    const tp_bounds *b = d->bounds + k;
    inside_all = place_between(sample->values + b->symbol, d, b, sample, next(&state), near);
  }
  return inside_all && tp_domain_holds(d, sample);
}
