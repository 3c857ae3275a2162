/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Bounded simplex method with three rows in floating point of any precision: pricing, ratio test
 * and update of the basis; numbers below 2^-(bits - 24) count as zero. */

#include "linear_program/precise_step.h"

enum {
  ARTIFICIAL = TP_SIMPLEX_NONE,
  MOST_STEPS = 1000, /* as in doubles (simplex.c) */
  GUARD = 24         /* bits lost to roundings: smaller numbers count as zero */
};

void tp_precise_share(tp_precise *p) {
  arf_struct *next = p->scratch;
  arf_struct **threes[] = {&p->direction, &p->target, &p->values, &p->prices, &p->step, &p->rest};
  for (size_t k = 0; k < sizeof threes / sizeof threes[0]; k++, next += 3) *threes[k] = next;
  p->inverse = next;
  next += 9;
  arf_struct **ones[] = {&p->size, &p->far, &p->own, &p->term, &p->best, &p->least};
  for (size_t k = 0; k < sizeof ones / sizeof ones[0]; k++, next++) *ones[k] = next;
}

static void dot(arf_struct *sum, const arf_struct *a, const arf_struct *b, long bits) {
  arf_mul(sum, a, b, bits, ARF_RND_NEAR);
  arf_addmul(sum, a + 1, b + 1, bits, ARF_RND_NEAR);
  arf_addmul(sum, a + 2, b + 2, bits, ARF_RND_NEAR);
}

static bool is_artificial(long variable) {
  return variable <= ARTIFICIAL;
}

static bool in_basis(const tp_precise *p, long k) {
  return p->basis[0] == k || p->basis[1] == k || p->basis[2] == k;
}

static bool is_bounded(const tp_precise *p, long k) {
  return k >= p->first_bounded && arf_is_finite(p->most + k);
}

static bool is_high(const tp_precise *p, long k) {
  return k >= p->first_bounded && p->at_most[k];
}

static int cost(const tp_precise *p, long variable) {
  if (is_artificial(variable)) return p->first_phase ? 1 : 0;
  return variable == TP_SIMPLEX_T && !p->first_phase ? -1 : 0;
}

/* Also the least gain that counts, in `least`. */
static void find_prices(tp_precise *p) {
  arf_zero(p->least);
  for (int c = 0; c < 3; c++) {
    arf_zero(p->prices + c);
    for (int r = 0; r < 3; r++) {
      arf_mul_si(p->term, p->inverse + 3 * r + c, cost(p, p->basis[r]), p->bits, ARF_RND_NEAR);
      arf_add(p->prices + c, p->prices + c, p->term, p->bits, ARF_RND_NEAR);
    }
    arf_abs(p->term, p->prices + c);
    arf_add(p->least, p->least, p->term, p->bits, ARF_RND_NEAR);
  }
  arf_mul_2exp_si(p->least, p->least, GUARD - p->bits);
}

/* What the column gains as it moves off its bound, in `own`. */
static void find_gain(tp_precise *p, long k) {
  dot(p->own, p->prices, p->columns + 3 * k, p->bits);
  if (is_high(p, k)) arf_neg(p->own, p->own);
}

static long find_entering(tp_precise *p, int *way) {
  find_prices(p);
  if (p->has_t && !in_basis(p, TP_SIMPLEX_T)) {
    dot(p->own, p->prices, p->direction, p->bits);
    arf_neg(p->own, p->own);
    arf_add_si(p->own, p->own, cost(p, TP_SIMPLEX_T), p->bits, ARF_RND_NEAR);
    *way = arf_sgn(p->own) < 0 ? 1 : -1;
    if (arf_cmpabs(p->own, p->least) > 0) return TP_SIMPLEX_T; /* it never leaves */
  }
  long entering = ARTIFICIAL;
  arf_set(p->best, p->least);
  for (long k = 0; k < p->count; k++) {
    find_gain(p, k);
    if (arf_cmp(p->own, p->best) <= 0 || in_basis(p, k)) continue;
    arf_set(p->best, p->own);
    entering = k;
    *way = is_high(p, k) ? -1 : 1;
  }
  return entering;
}

/* How far row r lets the entering variable go, in `own`; false where it does not matter. */
static bool find_far(tp_precise *p, int r, int way, bool *falls) {
  const long variable = p->basis[r];
  if (variable == TP_SIMPLEX_T || arf_is_zero(p->step + r)) return false;
  if (arf_cmpabs_2exp_si(p->step + r, GUARD - p->bits) < 0) return false;
  *falls = arf_sgn(p->step + r) * way > 0;
  arf_zero(p->own);
  if (!*falls && is_artificial(variable)) return !p->first_phase; /* what is zero stays zero */
  if (*falls) {
    arf_set(p->own, p->values + r);
  } else {
    if (variable < 0 || !is_bounded(p, variable)) return false;
    arf_sub(p->own, p->most + variable, p->values + r, p->bits, ARF_RND_NEAR);
  }
  if (arf_sgn(p->own) < 0) arf_zero(p->own);
  arf_abs(p->term, p->step + r);
  arf_div(p->own, p->own, p->term, p->bits, ARF_RND_NEAR);
  return true;
}

/* The row that stops it, -1 for its own bound; how far it goes in `far`. */
static int find_leaving(tp_precise *p, long entering, int way, bool *to_bound) {
  int leaving = -1;
  *to_bound = false;
  if (entering >= 0 && is_bounded(p, entering)) {
    arf_set(p->far, p->most + entering);
  } else {
    arf_pos_inf(p->far);
  }
  for (int r = 0; r < 3; r++) {
    bool falls = false;
    if (!find_far(p, r, way, &falls)) continue;
    const int order = arf_cmp(p->own, p->far);
    const bool wider = leaving >= 0 && arf_cmpabs(p->step + r, p->step + leaving) > 0;
    if (order > 0 || (order == 0 && !wider)) continue;
    arf_set(p->far, p->own);
    leaving = r;
    *to_bound = !falls && !is_artificial(p->basis[r]);
  }
  return leaving;
}

static void replace(tp_precise *p, int row, long entering) {
  arf_struct *own = p->inverse + 3 * row;
  for (int c = 0; c < 3; c++) arf_div(own + c, own + c, p->step + row, p->bits, ARF_RND_NEAR);
  for (int r = 0; r < 3; r++) {
    for (int c = 0; c < 3 && r != row; c++) {
      arf_submul(p->inverse + 3 * r + c, p->step + r, own + c, p->bits, ARF_RND_NEAR);
    }
  }
  p->basis[row] = entering;
}

/* Move the entering variable; false where nothing stops it. */
static bool enter(tp_precise *p, long entering, int way) {
  const arf_struct *column = entering == TP_SIMPLEX_T ? p->direction : p->columns + 3 * entering;
  for (int r = 0; r < 3; r++) dot(p->step + r, p->inverse + 3 * r, column, p->bits);
  bool to_bound = false;
  const int leaving = find_leaving(p, entering, way, &to_bound);
  if (!arf_is_finite(p->far)) return false;
  if (way < 0) arf_neg(p->far, p->far);
  for (int r = 0; r < 3; r++) {
    arf_submul(p->values + r, p->far, p->step + r, p->bits, ARF_RND_NEAR);
  }
  const bool was_high = way < 0 && entering >= 0;
  if (leaving < 0) {
    p->at_most[entering] = !was_high;
    return true;
  }
  const long out = p->basis[leaving];
  if (out >= p->first_bounded) p->at_most[out] = to_bound;
  if (was_high) {
    p->at_most[entering] = false;
    arf_add(p->far, p->far, p->most + entering, p->bits, ARF_RND_NEAR);
  }
  replace(p, leaving, entering);
  arf_set(p->values + leaving, p->far);
  return true;
}

/* What is left of the target for the basis, in `rest`; the size of its terms in `size`. */
static void find_rest(tp_precise *p) {
  arf_zero(p->size);
  for (int r = 0; r < 3; r++) {
    arf_set(p->rest + r, p->target + r);
    if (arf_cmpabs(p->target + r, p->size) > 0) arf_abs(p->size, p->target + r);
  }
  for (long k = p->first_bounded; k < p->count; k++) {
    if (!p->at_most[k]) continue;
    for (int r = 0; r < 3; r++) {
      arf_mul(p->term, p->most + k, p->columns + 3 * k + r, p->bits, ARF_RND_NEAR);
      arf_sub(p->rest + r, p->rest + r, p->term, p->bits, ARF_RND_NEAR);
      if (arf_cmpabs(p->term, p->size) > 0) arf_abs(p->size, p->term);
    }
  }
}

/* As in simplex.c: each bounded column that gains moves at once. */
static bool sweep(tp_precise *p) {
  find_prices(p);
  for (long k = p->first_bounded; k < p->count; k++) {
    if (in_basis(p, k) || !is_bounded(p, k)) continue;
    find_gain(p, k);
    if (arf_cmp(p->own, p->least) <= 0) continue;
    if (!enter(p, k, p->at_most[k] ? -1 : 1)) return false;
    find_prices(p);
  }
  find_rest(p);
  for (int r = 0; r < 3; r++) dot(p->values + r, p->inverse + 3 * r, p->rest, p->bits);
  return true;
}

static bool advance(tp_precise *p, tp_simplex_outcome *outcome) {
  int way = 1;
  const long entering = find_entering(p, &way);
  *outcome = entering == ARTIFICIAL ? TP_SIMPLEX_OPTIMAL : TP_SIMPLEX_UNBOUNDED;
  if (entering == ARTIFICIAL || !enter(p, entering, way)) return false;
  return entering < 0 || !is_bounded(p, entering) || sweep(p);
}

static void begin(tp_precise *p) {
  p->first_bounded = p->count;
  for (long k = p->count - 1; k >= 0 && p->at_most != NULL; k--) {
    if (arf_is_finite(p->most + k)) {
      p->first_bounded = k;
    } else {
      p->at_most[k] = false;
    }
  }
  find_rest(p);
  for (int r = 0; r < 3; r++) {
    p->sign[r] = arf_sgn(p->rest + r) < 0 ? -1 : 1;
    p->basis[r] = ARTIFICIAL - r;
    for (int c = 0; c < 3; c++) arf_set_si(p->inverse + 3 * r + c, r == c ? p->sign[r] : 0);
    arf_abs(p->values + r, p->rest + r);
  }
  p->has_t = false;
  for (int r = 0; r < 3; r++) p->has_t = p->has_t || !arf_is_zero(p->direction + r);
}

static bool is_feasible(tp_precise *p) {
  arf_zero(p->own);
  for (int r = 0; r < 3; r++) {
    if (!is_artificial(p->basis[r])) continue;
    arf_abs(p->term, p->values + r);
    arf_add(p->own, p->own, p->term, p->bits, ARF_RND_NEAR);
  }
  arf_mul_2exp_si(p->term, p->size, GUARD - p->bits);
  return arf_cmp(p->own, p->term) <= 0;
}

tp_simplex_outcome tp_precise_run(tp_precise *p) {
  tp_simplex_outcome outcome = TP_SIMPLEX_OPTIMAL;
  begin(p);
  int steps = 0;
  for (int phase = 0; phase < 2; phase++) {
    p->first_phase = phase == 0;
    while (steps < MOST_STEPS && advance(p, &outcome)) {
      if (!tp_work_spend(p->work, 3, p->count, p->bits)) return TP_SIMPLEX_STUCK;
      steps++;
    }
    if (steps == MOST_STEPS) return TP_SIMPLEX_STUCK;
    if (phase == 0 && !is_feasible(p)) return TP_SIMPLEX_INFEASIBLE;
  }
  return outcome;
}
