/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Factors of numerator and denominator by FLINT, each turned to its sign at the scene's values and
 * kept once; factors that positive parameters settle are left out. */

#include "derive/conditions.h"

#include "common/grow.h"
#include "derive/field_work.h"

#include <flint/fmpz_mpoly_factor.h>
#include <stdlib.h>

void tp_conditions_clear(tp_conditions *c) {
  for (long k = 0; k < c->count; k++) fmpz_mpoly_q_clear(c->items + k, c->field->ring);
  free(c->items);
  c->items = NULL;
  c->count = c->capacity = 0;
}

void tp_conditions_forget(tp_conditions *c, long count) {
  while (c->count > count) fmpz_mpoly_q_clear(c->items + --c->count, c->field->ring);
}

long tp_conditions_length(const tp_conditions *c, long first) {
  long terms = 0;
  for (long k = first; k < c->count; k++) {
    terms += fmpz_mpoly_length(fmpz_mpoly_q_numref(c->items + k), c->field->ring);
  }
  return terms;
}

/* Turn it so that it is not below zero at the values. */
static void orient(fmpz_mpoly_q_t value, const tp_conditions *c) {
  arb_t ball;
  arb_init(ball);
  tp_field_evaluate_ball(ball, value, c->at, c->field, c->bits);
  if (arb_is_negative(ball)) fmpz_mpoly_q_neg(value, value, c->field->ring);
  arb_clear(ball);
}

static bool is_known(const tp_conditions *c, const fmpz_mpoly_q_t value) {
  for (long k = 0; k < c->count; k++) {
    if (fmpz_mpoly_q_equal(c->items + k, value, c->field->ring)) return true;
  }
  return false;
}

static void append(tp_conditions *c, const fmpz_mpoly_q_t value) {
  fmpz_mpoly_q_struct *more = tp_grow(c->items, c->count, &c->capacity, sizeof *more);
  if (more == NULL) {
    c->failed = true;
    return;
  }
  c->items = more;
  fmpz_mpoly_q_init(c->items + c->count, c->field->ring);
  fmpz_mpoly_q_set(c->items + c->count++, value, c->field->ring);
}

static void add_factor(tp_conditions *c, const fmpz_mpoly_t factor) {
  const fmpz_mpoly_ctx_struct *ring = c->field->ring;
  if (fmpz_mpoly_is_fmpz(factor, ring)) return;
  if (c->positive && tp_field_sign_of_coefficients(factor, c->field) != 0) return;
  fmpz_mpoly_q_t condition;
  fmpz_mpoly_q_init(condition, ring);
  fmpz_mpoly_set(fmpz_mpoly_q_numref(condition), factor, ring);
  fmpz_mpoly_one(fmpz_mpoly_q_denref(condition), ring);
  orient(condition, c);
  if (!is_known(c, condition)) append(c, condition);
  fmpz_mpoly_q_clear(condition, ring);
}

static void add_polynomial(tp_conditions *c, const fmpz_mpoly_t polynomial) {
  const fmpz_mpoly_ctx_struct *ring = c->field->ring;
  fmpz_mpoly_factor_t factors;
  fmpz_mpoly_t factor;
  fmpz_mpoly_factor_init(factors, ring);
  fmpz_mpoly_init(factor, ring);
  const bool spare = tp_field_spend(c->field, tp_field_factor_units(polynomial, c->field));
  if (spare && tp_field_factor(factors, polynomial, c->field)) {
    for (slong k = 0; k < fmpz_mpoly_factor_length(factors, ring); k++) {
      if (fmpz_mpoly_factor_get_exp_si(factors, k, ring) % 2 == 0) continue;
      fmpz_mpoly_factor_get_base(factor, factors, k, ring);
      add_factor(c, factor);
    }
  } else {
    add_factor(c, polynomial);
  }
  fmpz_mpoly_factor_clear(factors, ring);
  fmpz_mpoly_clear(factor, ring);
}

void tp_conditions_add(tp_conditions *c, const fmpz_mpoly_q_t value) {
  if (fmpz_mpoly_q_is_zero(value, c->field->ring)) return;
  add_polynomial(c, fmpz_mpoly_q_numref(value));
  add_polynomial(c, fmpz_mpoly_q_denref(value));
}

void tp_conditions_add_above(tp_conditions *c, const fmpz_mpoly_q_t value) {
  const fmpz_mpoly_ctx_struct *ring = c->field->ring;
  fmpz_mpoly_q_t below, product;
  fmpz_mpoly_q_init(below, ring);
  fmpz_mpoly_q_init(product, ring);
  fmpz_mpoly_set(fmpz_mpoly_q_numref(below), fmpz_mpoly_q_denref(value), ring);
  fmpz_mpoly_one(fmpz_mpoly_q_denref(below), ring);
  tp_field_mul(product, below, below, c->field); /* value times the square of its denominator */
  tp_field_mul(product, product, value, c->field);
  if (!is_known(c, product)) append(c, product);
  fmpz_mpoly_q_clear(below, ring);
  fmpz_mpoly_q_clear(product, ring);
}
