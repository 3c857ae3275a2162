/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* In balls. A force whose product with y may be zero can be in the span of the basic ones, which
 * are whole numbers: then it is zero. */

#include "solid_contacts/mode_claim.h"

#include <arb_mat.h>
#include <flint/fmpz_mat.h>

typedef struct proof {
  const tp_mode_claim *claim;
  arb_struct sum[TP_WRENCH]; /* w + sum of z rows */
  arb_struct y[TP_WRENCH];   /* C times that */
  bool is_close;             /* what failed may be zero */
} proof;

bool tp_mode_claim_has_basic(const tp_mode_claim *claim, const tp_mode_vector *force) {
  for (long k = 0; k < claim->basic_count; k++) {
    if (claim->basic[k] == force) return true;
  }
  return false;
}

/* sum += z row */
static void add_multiple(proof *f, const tp_mode_vector *row, const arb_t z) {
  for (int i = 0; i < TP_WRENCH; i++) arb_addmul(f->sum + i, row->at + i, z, TP_MODE_BITS);
}

static void start(proof *f) {
  const tp_mode_claim *c = f->claim;
  arb_t price;
  arb_init(price);
  for (int k = 0; k < TP_WRENCH; k++) {
    arb_init(f->y + k);
    arb_init(f->sum + k);
    arb_set(f->sum + k, c->modes->loads[c->target].at + k);
  }
  for (long r = 0; r < c->priced_count; r++) {
    arb_set_si(price, c->priced[r].sign);
    arb_mul_2exp_si(price, price, c->price_bits);
    add_multiple(f, c->priced[r].vector, price);
  }
  tp_mode_cones_turn(f->y, c->modes, f->sum);
  arb_clear(price);
}

/* Is a share of a row that is to be above zero so for certain? */
static bool has_sign(const tp_mode_claim_row *row, const arb_t z) {
  return row->sign == 0  ? true
         : row->sign > 0 ? arb_is_nonnegative(z) != 0
                         : arb_is_nonpositive(z) != 0;
}

/* With y . f = 0 for all basic forces. False: they do not decide it, or a sign is not certain. */
static bool solve(proof *f) {
  const tp_mode_claim *c = f->claim;
  const long count = c->unknown_count;
  if (count == 0) return true;
  arb_mat_t left, right, z;
  arb_mat_init(left, count, count);
  arb_mat_init(right, count, 1);
  arb_mat_init(z, count, 1);
  for (long i = 0; i < count; i++) {
    const tp_mode_vector *force = c->basic[i];
    arb_struct *entry = arb_mat_entry(right, i, 0);
    tp_mode_add_product(entry, f->y, force->at);
    arb_neg(entry, entry);
    for (long k = 0; k < count; k++) {
      tp_mode_add_product(arb_mat_entry(left, i, k), c->unknown[k].vector->turned, force->at);
    }
  }
  bool solved = arb_mat_solve(z, left, right, TP_MODE_BITS) != 0;
  for (long k = 0; k < count && solved; k++) {
    const arb_struct *own = arb_mat_entry(z, k, 0);
    solved = has_sign(c->unknown + k, own);
    f->is_close = !solved && arb_contains_zero(own);
    add_multiple(f, c->unknown[k].vector, own);
  }
  arb_mat_clear(left);
  arb_mat_clear(right);
  arb_mat_clear(z);
  return solved;
}

/* The whole numbers of which a vector is a power of two. */
static void set_whole(fmpz_mat_t matrix, long row, const tp_mode_vector *v) {
  arb_t whole;
  arb_init(whole);
  for (int k = 0; k < TP_WRENCH; k++) {
    arb_mul_2exp_si(whole, v->at + k, v->exponent);
    (void)arb_get_unique_fmpz(fmpz_mat_entry(matrix, row, k), whole);
  }
  arb_clear(whole);
}

long tp_mode_rank(const tp_mode_vector *const *vectors, long count) {
  fmpz_mat_t rows;
  fmpz_mat_init(rows, count, TP_WRENCH);
  for (long k = 0; k < count; k++) set_whole(rows, k, vectors[k]);
  const long rank = fmpz_mat_rank(rows);
  fmpz_mat_clear(rows);
  return rank;
}

/* Is a force a sum of basic ones? */
static bool is_in_span(const tp_mode_claim *c, const tp_mode_vector *force) {
  const tp_mode_vector *vectors[TP_WRENCH + 1];
  const long count = c->basic_count - (c->change != NULL ? 1 : 0);
  for (long k = 0; k < count; k++) vectors[k] = c->basic[k];
  vectors[count] = force;
  return tp_mode_rank(vectors, count + 1) == tp_mode_rank(vectors, count);
}

static bool is_resisted(proof *f, const tp_mode_vector *wrench, bool is_force) {
  arb_t sum;
  arb_init(sum);
  tp_mode_add_product(sum, f->y, wrench->at);
  const bool is_close = arb_contains_zero(sum) != 0;
  const bool is = arb_is_nonpositive(sum) || (is_close && is_force && is_in_span(f->claim, wrench));
  f->is_close = !is && is_close;
  arb_clear(sum);
  return is;
}

static bool resists_all(proof *f) {
  const tp_mode_claim *c = f->claim;
  tp_mode_cones_turn(f->y, c->modes, f->sum);
  bool resists =
      is_resisted(f, c->modes->loads, false) && is_resisted(f, c->modes->loads + 1, false);
  for (long g = 0; g < c->force_count && resists; g++) {
    resists = tp_mode_claim_has_basic(c, c->forces[g]) || is_resisted(f, c->forces[g], true);
  }
  return resists;
}

bool tp_mode_claim_holds(bool *is_close, const tp_mode_claim *c) {
  *is_close = false;
  if (c->unknown_count != c->basic_count || c->basic_count > TP_WRENCH) return false;
  proof f = {.claim = c};
  start(&f);
  const bool holds = solve(&f) && (c->basic_count == TP_WRENCH || resists_all(&f));
  for (int k = 0; k < TP_WRENCH; k++) {
    arb_clear(f.y + k);
    arb_clear(f.sum + k);
  }
  *is_close = f.is_close;
  return holds;
}
