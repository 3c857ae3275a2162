/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* As in assemblage/load_bracket.c: forces in their cones that balance all blocks at a load prove
 * that it is held; twists that open all contacts that none above a bound is. */

#include "assemblage/exact_bracket.h"

#include "assemblage/exact_simplex.h"

#include <arb.h>
#include <flint/fmpq_vec.h>
#include <math.h>

static double rounded(const fmpq_t number, arf_rnd_t how) {
  enum { BITS = 53 };
  arf_t own;
  arf_init(own);
  arf_fmpz_div_fmpz(own, fmpq_numref(number), fmpq_denref(number), BITS, how);
  const double value = arf_get_d(own, how);
  arf_clear(own);
  return value;
}

/* ---- proofs ------------------------------------------------------------------------------------
 */

/* A f + s w1 = -w0, 0 <= f <= most. */
static bool proves_held(const tp_exact_program *p, const tp_exact_answer *x) {
  const long rows = p->forces->rows, count = p->forces->count;
  bool proves = true;
  for (long k = 0; k < count && proves; k++) {
    const fmpq *own = x->factors + k;
    proves = fmpq_sgn(own) >= 0 && (p->most[k] == NULL || fmpq_cmp(own, p->most[k]) <= 0);
  }
  fmpq_t sum;
  fmpq_init(sum);
  for (long r = 0; r < rows && proves; r++) {
    fmpq_mul(sum, &x->load, p->live + r);
    for (long k = 0; k < count; k++) fmpq_addmul(sum, x->factors + k, p->columns + k * rows + r);
    proves = fmpq_equal(sum, p->target + r) != 0;
  }
  fmpq_clear(sum);
  return proves;
}

/* s (y . w1) = y . (-w0) - f . A^T y <= y . (-w0) + sum over what is bounded of most max(0, -a .
 * y).
 */
static bool bounds(double *bound, const tp_exact_program *p, const tp_exact_answer *x) {
  const long rows = p->forces->rows;
  fmpq_t live, most, own;
  fmpq_init(live);
  fmpq_init(most);
  fmpq_init(own);
  _fmpq_vec_dot(live, x->multipliers, p->live, rows);
  _fmpq_vec_dot(most, x->multipliers, p->target, rows);
  bool proves = true;
  for (long k = 0; k < p->forces->count && proves; k++) {
    _fmpq_vec_dot(own, x->multipliers, p->columns + k * rows, rows);
    if (fmpq_sgn(own) >= 0) continue;
    proves = p->most[k] != NULL;
    if (proves) fmpq_submul(most, own, p->most[k]);
  }
  if (proves && fmpq_sgn(live) > 0) {
    fmpq_div(most, most, live);
    *bound = rounded(most, ARF_RND_CEIL);
  } else {
    proves = proves && fmpq_is_zero(live) && fmpq_sgn(most) < 0;
    *bound = -INFINITY;
  }
  fmpq_clear(live);
  fmpq_clear(most);
  fmpq_clear(own);
  return proves;
}

/* ---- in doubles --------------------------------------------------------------------------------
 */

static void take_held(tp_load_bracket *b, const tp_exact_program *p, const tp_exact_answer *x) {
  const double load = rounded(&x->load, ARF_RND_FLOOR);
  if (b->is_held && b->held >= load) return;
  b->is_held = true;
  b->held = load;
  for (long k = 0; k < p->forces->count; k++) {
    b->forces[k] = ldexp(fmpq_get_d(x->factors + k), (int)p->exponents[k]);
  }
}

/* Against the motion, the greatest of them one; turns in a unit of length. */
static void take_bound(tp_load_bracket *b, const tp_exact_program *p, const tp_exact_answer *x,
                       double bound) {
  if (b->is_bounded && b->bound <= bound) return;
  b->is_bounded = true;
  b->bound = bound;
  const tp_force_program *forces = p->forces;
  fmpq_t most, own;
  fmpq_init(most);
  fmpq_init(own);
  for (int pass = 0; pass < 2; pass++) {
    for (long r = 0; r < forces->rows; r++) {
      fmpq_neg(own, x->multipliers + r);
      if (r % 3 == 2) fmpq_mul_2exp(own, own, (ulong)forces->assemblage->length_exponent);
      if (pass == 1) {
        fmpq_div(own, own, most);
        b->twists[r] = fmpq_get_d(own);
      } else {
        fmpq_abs(own, own);
        if (fmpq_cmp(own, most) > 0) fmpq_set(most, own);
      }
    }
  }
  fmpq_clear(most);
  fmpq_clear(own);
}

/* ---- both --------------------------------------------------------------------------------------
 */

static tp_status narrow(tp_load_bracket *b, const tp_exact_program *p, tp_message *message) {
  tp_exact_answer x;
  double bound = 0;
  const tp_status status = tp_exact_simplex(&x, p, b->forces, message);
  if (status != TP_OK) return status;
  if (p->greatest) {
    if (x.outcome != TP_EXACT_OPEN && bounds(&bound, p, &x)) take_bound(b, p, &x, bound);
  } else {
    if (x.outcome == TP_EXACT_LIMIT && proves_held(p, &x)) take_held(b, p, &x);
  }
  tp_exact_answer_clear(&x, p);
  return TP_OK;
}

bool tp_exact_bracket_is_quick(const tp_assemblage *a) {
  enum { MOST_BLOCKS = 16, MOST_BITS = 160 }; /* of each, at so many blocks */
  return a->free_count <= MOST_BLOCKS && a->free_count * a->lattice.bits <= MOST_BLOCKS * MOST_BITS;
}

tp_status tp_exact_bracket_narrow(tp_load_bracket *b, const tp_force_program *forces,
                                  const tp_contact_strength *strengths,
                                  const tp_weight_loads *loads, tp_message *message) {
  tp_status status = TP_OK;
  for (int greatest = 0; greatest < 2 && status == TP_OK; greatest++) {
    tp_exact_program p;
    bool made = false;
    status = tp_exact_program_init(&made, &p, forces, strengths, loads, greatest == 1, message);
    if (status == TP_OK && made) status = narrow(b, &p, message);
    if (made) tp_exact_program_clear(&p);
  }
  return status;
}
