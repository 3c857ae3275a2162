/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Stack of chosen signs, one for each irreducible factor whose sign is not known on the domain, and
 * the step to the next combination. */

#include "verify/branches.h"

#include "derive/field_work.h"
#include "number/ball.h"

#include <flint/fmpz_mpoly_factor.h>
#include <string.h>

static const fmpz_mpoly_ctx_struct *ring_of(const tp_branches *b) {
  return b->subject->field->ring;
}

void tp_branches_init(tp_branches *b, tp_subject *subject, const tp_claim_sample *sample) {
  memset(b, 0, sizeof *b);
  b->subject = subject;
  b->sample = sample;
}

static void keep(tp_branches *b, long count) {
  while (b->count > count) fmpz_mpoly_q_clear(b->items[--b->count].of, ring_of(b));
}

void tp_branches_clear(tp_branches *b) {
  keep(b, 0);
  while (b->divisor_count > 0) fmpz_mpoly_q_clear(b->divisors[--b->divisor_count], ring_of(b));
}

/* The sign at the sample; 0 where it is zero or not known. */
static int sign_at_sample(const fmpz_mpoly_q_t of, const tp_branches *b, bool *zero) {
  arb_t value;
  arb_init(value);
  int sign = 0;
  *zero = false;
  enum {
    FIRST_BITS = 128,
    MOST_BITS = 2048
  }; /* what these do not tell is left to the other samples */
  for (long bits = FIRST_BITS; bits <= MOST_BITS && sign == 0 && !*zero; bits *= 4) {
    tp_sample_evaluate(value, of, b->sample, b->subject, bits);
    sign = tp_ball_sign(value);
    *zero = arb_is_zero(value) != 0;
  }
  arb_clear(value);
  return sign;
}

static int add(tp_branches *b, const fmpz_mpoly_q_t of) {
  if (b->count == TP_MOST_BRANCH_SIGNS) {
    b->too_many = true;
    return 0;
  }
  bool zero = false;
  tp_branch_sign *own = b->items + b->count++;
  fmpz_mpoly_q_init(own->of, ring_of(b));
  fmpz_mpoly_q_set(own->of, of, ring_of(b));
  own->sign = sign_at_sample(of, b, &zero);
  own->turned = false;
  if (own->sign == 0) own->sign = 1;
  return own->sign;
}

/* The sign of one factor: known on the domain, chosen before, or to be chosen from now on. */
static int sign_of_factor(const fmpz_mpoly_q_t of, tp_subject *s) {
  const fmpz_mpoly_ctx_struct *ring = s->field->ring;
  tp_branches *b = s->branches;
  const int known = tp_domain_sign(of, s->domain, false);
  if (known != 0) return known;
  fmpz_mpoly_q_t negative;
  fmpz_mpoly_q_init(negative, ring);
  fmpz_mpoly_q_neg(negative, of, ring);
  int sign = 0;
  for (long k = 0; k < b->count && sign == 0; k++) {
    if (fmpz_mpoly_q_equal(b->items[k].of, of, ring)) sign = b->items[k].sign;
    if (fmpz_mpoly_q_equal(b->items[k].of, negative, ring)) sign = -b->items[k].sign;
  }
  fmpz_mpoly_q_clear(negative, ring);
  return sign != 0 ? sign : add(b, of);
}

/* The sign of a polynomial from those of its irreducible factors, which are independent. */
static int sign_of_factors(const fmpz_mpoly_t p, tp_subject *s) {
  const fmpz_mpoly_ctx_struct *ring = s->field->ring;
  fmpz_mpoly_factor_t factors;
  fmpz_mpoly_q_t factor;
  fmpz_mpoly_factor_init(factors, ring);
  fmpz_mpoly_q_init(factor, ring);
  int sign = 0;
  if (tp_field_spend(s->field, tp_field_factor_units(p, s->field)) &&
      tp_field_factor(factors, p, s->field)) {
    sign = fmpz_sgn(factors->constant);
    for (slong k = 0; k < factors->num && sign != 0; k++) {
      if (fmpz_is_even(factors->exp + k)) continue;
      fmpz_mpoly_set(fmpz_mpoly_q_numref(factor), factors->poly + k, ring);
      sign *= sign_of_factor(factor, s);
    }
  }
  fmpz_mpoly_q_clear(factor, ring);
  fmpz_mpoly_factor_clear(factors, ring);
  return sign;
}

int tp_branches_sign(const fmpz_mpoly_q_t of, tp_subject *s) {
  const fmpz_mpoly_ctx_struct *ring = s->field->ring;
  tp_branches *b = s->branches;
  if (fmpz_mpoly_q_is_zero(of, ring)) return 1;
  if (b != NULL && b->only_sample) {
    bool zero = false;
    const int sign = sign_at_sample(of, b, &zero);
    return zero ? 1 : sign;
  }
  const int known = s->domain != NULL ? tp_domain_sign(of, s->domain, false) : 0;
  if (known != 0 || b == NULL || s->domain == NULL) return known;
  const int top = sign_of_factors(fmpz_mpoly_q_numref(of), s);
  return top == 0 ? 0 : top * sign_of_factors(fmpz_mpoly_q_denref(of), s);
}

void tp_branches_divide(const fmpz_mpoly_q_t by, tp_subject *s) {
  const fmpz_mpoly_ctx_struct *ring = s->field->ring;
  tp_branches *b = s->branches;
  if (b == NULL || !b->gathers_divisors || fmpz_mpoly_q_is_fmpq(by, ring)) return;
  for (long k = 0; k < b->divisor_count; k++) {
    if (fmpz_mpoly_q_equal(b->divisors[k], by, ring)) return;
  }
  if (s->domain != NULL && tp_domain_sign(by, s->domain, true) != 0) return;
  if (b->divisor_count == TP_MOST_DIVISORS) {
    b->too_many = true;
    return;
  }
  fmpz_mpoly_q_init(b->divisors[b->divisor_count], ring);
  fmpz_mpoly_q_set(b->divisors[b->divisor_count++], by, ring);
}

bool tp_branches_next(tp_branches *b) {
  while (b->count > 0 && b->items[b->count - 1].turned) keep(b, b->count - 1);
  if (b->count == 0) return false;
  tp_branch_sign *last = b->items + b->count - 1;
  last->turned = true;
  last->sign = -last->sign;
  return true;
}

void tp_branches_use(tp_branches *branches, tp_subject *s) {
  s->branches = branches;
  for (long k = s->permanent; k < s->name_count; k++) {
    if (s->names[k].kind == TP_NAME_DEFINITION) s->names[k].ready = false;
  }
}
