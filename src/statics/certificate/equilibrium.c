/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Proof of equilibrium: the simplex method proposes three columns, Cramer's rule in balls gives
 * their forces, and each must lie within its bounds (docs/mechanics.md section 6). Wrenches on the
 * border of what the base bears are approached by a small push into its interior. */

#include "certificate/equilibrium.h"

#include "linear_program/precise.h"
#include "number/ball.h"

#include <math.h>

/* Three columns that balance a wrench, and how much each may bear: most < 0 for without bound. */
typedef struct triple {
  tp_vector columns[3], rest; /* the wrench and the capacities at their bound */
  arb_struct most[3];
  double log2_size; /* of the terms of the rest */
} triple;

static void triple_init(triple *t, const tp_vector *wrench) {
  tp_vector_init(&t->rest);
  for (int k = 0; k < 3; k++) {
    tp_vector_init(t->columns + k);
    arb_init(t->most + k);
    arb_set_si(t->most + k, -1);
    arb_set(t->rest.of + k, wrench->of + k);
  }
  t->log2_size = tp_vector_log2_size(wrench);
}

static void triple_clear(triple *t) {
  tp_vector_clear(&t->rest);
  for (int k = 0; k < 3; k++) {
    tp_vector_clear(t->columns + k);
    arb_clear(t->most + k);
  }
}

static void triple_set(triple *t, int at, const tp_cones *cones, long column, long bits) {
  tp_cones_column(t->columns[at].of, cones, column, bits);
  if (!tp_cones_is_edge(cones, column)) tp_cones_bound(t->most + at, cones, column);
}

static void add_full(triple *t, const tp_limit_question *q, const tp_scaled *scaled,
                     const tp_basis *basis) {
  if (scaled->at_most == NULL) return;
  tp_vector column;
  arb_t most;
  tp_vector_init(&column);
  arb_init(most);
  for (long k = 2 * q->cones->count; k < scaled->count; k++) {
    const long *own = basis->columns;
    if (!scaled->at_most[k] || k == own[0] || k == own[1] || k == own[2]) continue;
    tp_cones_column(column.of, q->cones, k, q->judge.precision);
    tp_cones_bound(most, q->cones, k);
    for (int row = 0; row < 3; row++) {
      arb_mul(column.of + row, column.of + row, most, q->judge.bits);
      arb_add(t->rest.of + row, t->rest.of + row, column.of + row, q->judge.bits);
    }
    t->log2_size = fmax(t->log2_size, tp_vector_log2_size(&column));
  }
  tp_vector_clear(&column);
  arb_clear(most);
}

/* f = -share / volume with share = rest . cross: is it in 0 ... most? */
static tp_answer judge_share(arb_t share, const triple *t, int k, const tp_vector *cross,
                             const arb_t volume, const tp_judge *judge) {
  const bool up = arb_is_positive(volume) != 0;
  double size = judge->settled ? t->log2_size + tp_vector_log2_size(cross) : 0; /* else unasked */
  int sign = tp_judge_sign(judge, share, size);
  if (sign > 1) return TP_OPEN;
  if (sign != 0 && (sign > 0) == up) return TP_NO;
  if (arb_is_negative(t->most + k)) return TP_YES;
  size = fmax(size, tp_ball_log2_above(t->most + k) + tp_ball_log2_above(volume));
  arb_addmul(share, t->most + k, volume, judge->precision);
  sign = tp_judge_sign(judge, share, size);
  if (sign > 1) return TP_OPEN;
  return sign == 0 || (sign > 0) == up ? TP_YES : TP_NO;
}

/* R = -sum f_k c_k by Cramer's rule. */
static tp_answer triple_judge(const triple *t, const tp_judge *judge) {
  tp_vector cross;
  arb_t volume, share;
  tp_vector_init(&cross);
  arb_init(volume);
  arb_init(share);
  tp_vector_cross(&cross, t->columns + 1, t->columns + 2, judge->precision);
  tp_vector_dot(volume, t->columns, &cross, judge->precision);
  tp_answer answer = arb_contains_zero(volume) ? TP_OPEN : TP_YES;
  for (int k = 0; k < 3 && answer == TP_YES; k++) {
    tp_vector_cross(&cross, t->columns + (k + 1) % 3, t->columns + (k + 2) % 3, judge->precision);
    tp_vector_dot(share, &t->rest, &cross, judge->precision);
    answer = judge_share(share, t, k, &cross, volume, judge);
  }
  tp_vector_clear(&cross);
  arb_clear(volume);
  arb_clear(share);
  return answer;
}

/* Of two columns the area, of three the volume. */
static double extent(const double *a, const double *b, const double *c) {
  double cross[3];
  tp_double_cross(cross, a, b);
  if (c == NULL) return fabs(cross[0]) + fabs(cross[1]) + fabs(cross[2]);
  return fabs(tp_double_dot(cross, c));
}

static void complete(tp_basis *basis, const tp_scaled *scaled) {
  if (basis->count == 0 || scaled->columns == NULL) return;
  while (basis->count < 3) {
    const double *a = scaled->columns[basis->columns[0]];
    const double *b = basis->count == 2 ? scaled->columns[basis->columns[1]] : NULL;
    double most = 0;
    long widest = -1;
    for (long k = 0; k < scaled->count; k++) {
      if (scaled->at_most != NULL && scaled->at_most[k]) continue;
      const double own =
          b == NULL ? extent(a, scaled->columns[k], NULL) : extent(a, b, scaled->columns[k]);
      if (own <= most) continue;
      most = own;
      widest = k;
    }
    if (widest < 0) return;
    basis->columns[basis->count++] = widest;
  }
}

tp_answer tp_equilibrium_of(tp_basis *basis, const tp_limit_question *q, const tp_scaled *scaled,
                            const tp_vector *wrench) {
  complete(basis, scaled);
  if (basis->count != 3) return TP_OPEN;
  triple t;
  triple_init(&t, wrench);
  for (int k = 0; k < 3; k++) triple_set(&t, k, q->cones, basis->columns[k], q->judge.precision);
  add_full(&t, q, scaled, basis);
  const tp_answer answer = triple_judge(&t, &q->judge);
  triple_clear(&t);
  return answer;
}

const double tp_equilibrium_push_weights[TP_PUSH_EDGES] = {1, 1.3125, 1.6875, 2.125};

long tp_equilibrium_push_edge(const tp_cones *cones, int k) {
  return k < 2 ? k : 2 * cones->count - 4 + k;
}

void tp_equilibrium_push(tp_vector *push, const tp_limit_question *q, const tp_scaled *scaled) {
  tp_vector column, force;
  arb_t factor;
  tp_vector_init(&column);
  tp_vector_init(&force);
  arb_init(factor);
  for (int row = 0; row < 3; row++) arb_zero(push->of + row);
  for (int k = 0; k < TP_PUSH_EDGES; k++) {
    tp_cones_column(column.of, q->cones, tp_equilibrium_push_edge(q->cones, k), q->judge.precision);
    arb_get_mid_arb(force.of, column.of);
    arb_get_mid_arb(force.of + 1, column.of + 1);
    const double size = tp_vector_log2_size(&force);
    arb_set_d(factor, tp_equilibrium_push_weights[k]);
    arb_mul_2exp_si(factor, factor, scaled->force_exponent - (isfinite(size) ? (slong)size : 0));
    for (int row = 0; row < 3; row++) {
      arb_addmul(push->of + row, column.of + row, factor, q->judge.precision);
    }
  }
  tp_vector_clear(&column);
  tp_vector_clear(&force);
  arb_clear(factor);
}

/* With a share of the push. */
static tp_answer bears_with(const tp_basis *basis, const tp_limit_question *q,
                            const tp_scaled *scaled, const tp_vector *push,
                            const tp_vector *wrench) {
  triple t;
  triple_init(&t, wrench);
  for (int k = 0; k < 2; k++) triple_set(&t, k, q->cones, basis->columns[k], q->judge.precision);
  for (int row = 0; row < 3; row++) arb_set(t.columns[2].of + row, push->of + row);
  add_full(&t, q, scaled, basis);
  const tp_answer answer = triple_judge(&t, &q->judge);
  triple_clear(&t);
  return answer;
}

void tp_equilibrium_push_near(tp_near push[3], const tp_cones *cones, const tp_scaled *scaled) {
  for (int row = 0; row < 3; row++) push[row] = (tp_near){.error = 0};
  for (int k = 0; k < TP_PUSH_EDGES; k++) {
    const double *edge = scaled->columns[tp_equilibrium_push_edge(cones, k)];
    const tp_near weight = {tp_equilibrium_push_weights[k], 0};
    for (int row = 0; row < 3; row++) {
      const tp_near own = {edge[row], scaled->error};
      push[row] = tp_near_add(push[row], tp_near_mul(weight, own));
    }
  }
}

/* By Cramer's rule, as in triple_judge: all shares above zero. */
bool tp_equilibrium_is_told(const tp_simplex_answer *found, const tp_scaled *scaled,
                            const tp_near push[3], const tp_near wrench[3]) {
  const tp_basis basis = tp_basis_of(found);
  if (scaled->at_most != NULL || found->outcome != TP_SIMPLEX_OPTIMAL || basis.count != 2) {
    return false;
  }
  tp_near columns[3][3], cross[3];
  for (int row = 0; row < 3; row++) {
    for (int k = 0; k < 2; k++) {
      columns[k][row] = (tp_near){scaled->columns[basis.columns[k]][row], scaled->error};
    }
    columns[2][row] = push[row];
  }
  int volume = 0;
  for (int k = 0; k < 3; k++) {
    tp_near_cross(cross, columns[(k + 1) % 3], columns[(k + 2) % 3]);
    if (k == 0) volume = tp_near_sign(tp_near_dot(columns[0], cross));
    const int share = tp_near_sign(tp_near_dot(wrench, cross));
    if (volume == 0 || share != -volume) return false;
  }
  return true;
}

tp_simplex_answer tp_equilibrium_solve_near(tp_scaled *scaled, const tp_near push[3],
                                            const tp_near wrench[3]) {
  const double direction[3] = {push[0].value, push[1].value, push[2].value};
  const double target[3] = {-wrench[0].value, -wrench[1].value, -wrench[2].value};
  return tp_scaled_solve(scaled, direction, target);
}

tp_simplex_answer tp_equilibrium_solve(tp_scaled *scaled, const tp_vector *push,
                                       const tp_vector *wrench) {
  tp_near direction[3], target[3];
  tp_scaled_wrench_near(direction, scaled, push);
  tp_scaled_wrench_near(target, scaled, wrench);
  return tp_equilibrium_solve_near(scaled, direction, target);
}

tp_simplex_answer tp_equilibrium_solve_precisely(const tp_limit_question *q, tp_scaled *scaled,
                                                 const tp_vector *push, const tp_vector *wrench) {
  if (q->judge.bits < TP_PRECISE_BITS) return (tp_simplex_answer){.outcome = TP_SIMPLEX_STUCK};
  tp_vector target;
  tp_vector_init(&target);
  for (int row = 0; row < 3; row++) arb_neg(target.of + row, wrench->of + row);
  const tp_simplex_answer found =
      tp_precise_solve(scaled, q->cones, push, &target, q->work, q->judge.bits);
  tp_vector_clear(&target);
  return found;
}

/* Without a push: any three columns that balance it. */
static tp_answer bears_without(const tp_limit_question *q, tp_scaled *scaled,
                               const tp_vector *wrench, bool precisely) {
  tp_vector none;
  tp_vector_init(&none);
  const tp_simplex_answer found = precisely
                                      ? tp_equilibrium_solve_precisely(q, scaled, &none, wrench)
                                      : tp_equilibrium_solve(scaled, &none, wrench);
  tp_vector_clear(&none);
  if (found.outcome == TP_SIMPLEX_INFEASIBLE) return TP_NO;
  if (found.outcome != TP_SIMPLEX_OPTIMAL) return TP_OPEN;
  tp_basis basis = tp_basis_of(&found);
  return tp_equilibrium_of(&basis, q, scaled, wrench) == TP_YES ? TP_YES : TP_OPEN;
}

/* With all of the push, where any share of it can be borne: flanks that grip bear any wrench. Three
 * columns rarely balance the sum with nothing on one of them, as they may the wrench itself. */
static tp_answer bears_beside(const tp_limit_question *q, tp_scaled *scaled, const tp_vector *push,
                              const tp_vector *wrench, bool precisely) {
  tp_vector sum;
  tp_vector_init(&sum);
  for (int row = 0; row < 3; row++) {
    arb_add(sum.of + row, wrench->of + row, push->of + row, q->judge.precision);
  }
  const tp_answer answer = bears_without(q, scaled, &sum, precisely);
  tp_vector_clear(&sum);
  return answer;
}

tp_answer tp_equilibrium_bears(const tp_limit_question *q, tp_scaled *scaled, const tp_vector *push,
                               const tp_vector *wrench) {
  tp_near near_push[3], near_wrench[3];
  tp_scaled_wrench_near(near_push, scaled, push);
  tp_scaled_wrench_near(near_wrench, scaled, wrench);
  for (int engine = 0; engine < 2; engine++) {
    if (!tp_work_spend(q->work, engine == 0 ? 1 : 4, scaled->count, q->judge.bits)) return TP_OPEN;
    const tp_simplex_answer found = engine == 0
                                        ? tp_equilibrium_solve_near(scaled, near_push, near_wrench)
                                        : tp_equilibrium_solve_precisely(q, scaled, push, wrench);
    if (tp_equilibrium_is_told(&found, scaled, near_push, near_wrench)) return TP_YES;
    const tp_basis basis = tp_basis_of(&found);
    if (found.outcome == TP_SIMPLEX_OPTIMAL && basis.count == 2 && found.t > 0 &&
        bears_with(&basis, q, scaled, push, wrench) == TP_YES) {
      return TP_YES;
    }
    if (found.outcome == TP_SIMPLEX_UNBOUNDED &&
        bears_beside(q, scaled, push, wrench, engine == 1) == TP_YES) {
      return TP_YES;
    }
  }
  return bears_without(q, scaled, wrench, false);
}
