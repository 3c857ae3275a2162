/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "limit/extremes.h"

#include "limit/search.h"

#include <math.h>

/* R = sum f_k c_k by Cramer's rule. */
static tp_answer balance(const long basis[3], const tp_vector *wrench, const tp_limit_question *q) {
  const long bits = q->judge.precision;
  tp_vector columns[3], cross;
  arb_t volume, share;
  tp_vector_init(&cross);
  arb_init(volume);
  arb_init(share);
  for (int k = 0; k < 3; k++) {
    tp_vector_init(columns + k);
    tp_cones_column(columns[k].of, q->cones, basis[k], bits);
  }
  tp_vector_cross(&cross, columns + 1, columns + 2, bits);
  tp_vector_dot(volume, columns, &cross, bits);
  tp_answer answer = arb_contains_zero(volume) ? TP_OPEN : TP_YES;
  for (int k = 0; k < 3 && answer == TP_YES; k++) {
    tp_vector_cross(&cross, columns + (k + 1) % 3, columns + (k + 2) % 3, bits);
    tp_vector_dot(share, wrench, &cross, bits);
    arb_mul(share, share, volume, bits);
    if (!arb_is_nonpositive(share)) answer = arb_is_positive(share) ? TP_NO : TP_OPEN;
  }
  for (int k = 0; k < 3; k++) tp_vector_clear(columns + k);
  tp_vector_clear(&cross);
  arb_clear(volume);
  arb_clear(share);
  return answer;
}

tp_answer tp_extremes_interlocked(const tp_limit_question *q, tp_sketch *sketch) {
  static const double nowhere[3] = {0, 0, 0};
  if (!tp_search_is_linear(q)) return TP_YES; /* the search looked at every degree */
  tp_vector upright;
  double wrench[3], target[3];
  tp_vector_init(&upright);
  tp_search_load_term(&upright, q->load, TP_SIN);
  tp_sketch_wrench(wrench, sketch, &upright);
  for (int row = 0; row < 3; row++) target[row] = -wrench[row];
  const tp_simplex_answer found = tp_sketch_solve(sketch, nowhere, target);
  const tp_basis basis = tp_basis_of(&found);
  const tp_answer answer = found.outcome == TP_SIMPLEX_OPTIMAL && basis.count == 3
                               ? balance(basis.columns, &upright, q)
                               : TP_OPEN;
  tp_vector_clear(&upright);
  return answer;
}

/* With v_x fixed by omega so that F_s does no work, the power of a column is
 * v_y c_y + omega (c_m + h c_x), h = -F_s,m / F_s,x. The twist (., -1, omega) is admissible for
 * omega within an interval; an inner point of it is taken. */
static bool find_turn(double *omega, const tp_sketch *sketch, const double down[3],
                      const double across[3]) {
  if (across[0] == 0) return false;
  const double height = -across[2] / across[0];
  double least = -INFINITY, most = INFINITY;
  for (long k = 0; k < sketch->count; k++) {
    const double *c = sketch->columns[k];
    const double moment = c[2] + height * c[0];
    if (moment > 0) {
      least = fmax(least, c[1] / moment);
    } else if (moment < 0) {
      most = fmin(most, c[1] / moment);
    } else if (c[1] > 0) {
      return false;
    }
  }
  const double moment = down[2] + height * down[0]; /* the loads: -down_y + omega moment > 0 */
  if (moment > 0) least = fmax(least, down[1] / moment);
  if (moment < 0) most = fmin(most, down[1] / moment);
  if (!(least < most)) return false;
  if (isfinite(least) && isfinite(most)) {
    *omega = least + (most - least) / 2;
  } else if (isfinite(least)) {
    *omega = least + fabs(least) + 1;
  } else {
    *omega = isfinite(most) ? most - fabs(most) - 1 : 0;
  }
  return true;
}

/* (v_x, -1, omega), v_x such that F_s does no work. */
static void set_twist(tp_vector *twist, const tp_sketch *sketch, double omega,
                      const tp_vector *across, long bits) {
  arb_struct *v = twist->of;
  arb_set_si(v + 1, -1);
  arb_set_d(v + 2, omega);
  arb_mul_2exp_si(v + 2, v + 2, -sketch->length_exponent);
  arb_mul(v, v + 2, across->of + 2, bits);
  arb_div(v, v, across->of, bits);
  arb_neg(v, v);
}

static tp_answer prove_turn(tp_face *face, const tp_vector *down, const tp_limit_question *q) {
  long violated = -1;
  arb_t power;
  arb_init(power);
  face->motion = TP_MOTION_TURN;
  tp_vector_dot(power, &face->twist, down, q->judge.bits);
  const bool sinks = arb_is_positive(power) != 0;
  arb_clear(power);
  return sinks && tp_face_admit(face, q->cones, &q->judge, &violated) == TP_YES ? TP_YES : TP_OPEN;
}

tp_answer tp_extremes_nowhere(const tp_limit_question *q, tp_sketch *sketch) {
  if (!tp_search_is_linear(q)) return TP_YES; /* the search looked at every degree */
  tp_face face;
  if (!tp_face_init(&face, q->cones)) return TP_OPEN;
  tp_vector down, across;
  double sketched_down[3], sketched_across[3], omega = 0;
  tp_vector_init(&down);
  tp_vector_init(&across);
  tp_search_load_term(&down, q->load, TP_COS);
  tp_search_load_term(&across, q->load, TP_SIN);
  tp_sketch_wrench(sketched_down, sketch, &down);
  tp_sketch_wrench(sketched_across, sketch, &across);
  tp_answer answer = TP_OPEN;
  if (find_turn(&omega, sketch, sketched_down, sketched_across)) {
    set_twist(&face.twist, sketch, omega, &across, q->judge.bits);
    answer = prove_turn(&face, &down, q);
  }
  tp_vector_clear(&down);
  tp_vector_clear(&across);
  tp_face_clear(&face);
  return answer;
}
