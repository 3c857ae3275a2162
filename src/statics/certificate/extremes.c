/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The two cases without a limit, interlocked and held nowhere (docs/mechanics.md section 6): an
 * equilibrium of the upright load, or a twist in the plane v . F_s = 0, found as the middle of a
 * span of directions and proven in balls. */

#include "certificate/extremes.h"

#include "certificate/equilibrium.h"
#include "certificate/face.h"

#include <math.h>

tp_answer tp_extremes_interlocked(const tp_limit_question *q, tp_scaled *scaled,
                                  const tp_basis *growing) {
  static const double nowhere[3] = {0, 0, 0};
  tp_vector upright;
  double wrench[3], target[3];
  tp_vector_init(&upright);
  tp_question_load_term(&upright, q->load, TP_SIN);
  tp_scaled_wrench(wrench, scaled, &upright);
  for (int row = 0; row < 3; row++) target[row] = -wrench[row];
  const tp_simplex_answer found = tp_scaled_solve(scaled, nowhere, target);
  tp_basis basis = tp_basis_of(&found);
  tp_answer answer = TP_OPEN;
  if (found.outcome == TP_SIMPLEX_OPTIMAL) answer = tp_equilibrium_of(&basis, q, scaled, &upright);
  if (answer != TP_YES) {
    basis = *growing;
    answer = tp_equilibrium_of(&basis, q, scaled, &upright);
  }
  tp_vector_clear(&upright);
  return answer;
}

/* The twists on which F_s does no work, v . F_s = 0, are v = a u_0 + b u_1 with u_k = F_s x e, e
 * the unit vectors of the two rows other than that of the largest entry of F_s. */
typedef struct plane {
  int rows[2];
} plane;

static plane plane_across(const double across[3]) {
  int most = 0;
  for (int row = 1; row < 3; row++) most = fabs(across[row]) > fabs(across[most]) ? row : most;
  return (plane){{(most + 1) % 3, (most + 2) % 3}};
}

/* F_s x e = (F_s,y e_m - F_s,m e_y, ...): against a wrench c that is c . (F_s x e) = (c x F_s) . e
 */
static void powers_of(double own[2], const plane *p, const double c[3], const double across[3]) {
  for (int k = 0; k < 2; k++) {
    const int next = (p->rows[k] + 1) % 3, last = (p->rows[k] + 2) % 3;
    own[k] = c[next] * across[last] - c[last] * across[next];
  }
}

/* Every wrench, the loads at F_c and each column, allows the half of the plane on which its power
 * is above zero. Seen from the direction of the loads', the column's directions must span less than
 * a half turn: the middle of their span is inside all halves. */
static bool find_turn(double turn[2], const plane *p, const tp_scaled *scaled, const double down[3],
                      const double across[3]) {
  static const double rounding = 1e-13; /* of products of size 1 in doubles, with room */
  double loads[2], own[2], least = 0, most = 0;
  powers_of(loads, p, down, across);
  for (long k = 0; k < scaled->count; k++) {
    powers_of(own, p, scaled->columns[k], across);
    if (hypot(own[0], own[1]) < rounding) continue; /* along F_s: does no work either */
    const double angle =
        atan2(loads[0] * own[1] - loads[1] * own[0], loads[0] * own[0] + loads[1] * own[1]);
    least = fmin(least, angle);
    most = fmax(most, angle);
  }
  const double middle = (least + most) / 2;
  turn[0] = loads[0] * cos(middle) - loads[1] * sin(middle);
  turn[1] = loads[0] * sin(middle) + loads[1] * cos(middle);
  return most - least < M_PI && hypot(turn[0], turn[1]) > 0;
}

/* a u_0 + b u_1, in the units of the cones. */
static void set_twist(tp_vector *twist, const plane *p, const double turn[2],
                      const tp_scaled *scaled, const tp_vector *across, long bits) {
  tp_vector direction, unit, own;
  arb_t factor;
  tp_vector_init(&direction);
  tp_vector_init(&unit);
  tp_vector_init(&own);
  arb_init(factor);
  for (int row = 0; row < 3; row++) {
    arb_set(direction.of + row, across->of + row);
    arb_zero(twist->of + row);
  }
  arb_submul(direction.of + 2, scaled->x, across->of + 1,
             bits); /* about the scaled program's point */
  arb_addmul(direction.of + 2, scaled->y, across->of, bits);
  arb_mul_2exp_si(direction.of + 2, direction.of + 2, -scaled->length_exponent);
  for (int k = 0; k < 2; k++) {
    for (int row = 0; row < 3; row++) arb_set_si(unit.of + row, row == p->rows[k]);
    tp_vector_cross(&own, &direction, &unit, bits);
    arb_set_d(factor, turn[k]);
    for (int row = 0; row < 3; row++) arb_addmul(twist->of + row, own.of + row, factor, bits);
  }
  arb_mul_2exp_si(twist->of + 2, twist->of + 2, -scaled->length_exponent);
  arb_addmul(twist->of, twist->of + 2, scaled->y, bits); /* the velocity at the origin */
  arb_submul(twist->of + 1, twist->of + 2, scaled->x, bits);
  tp_vector_clear(&direction);
  tp_vector_clear(&unit);
  tp_vector_clear(&own);
  arb_clear(factor);
}

static tp_answer prove_turn(tp_face *face, const tp_vector *down, const tp_scaled *scaled,
                            const tp_limit_question *q) {
  long violated = -1;
  arb_t power;
  arb_init(power);
  face->motion = TP_MOTION_TURN;
  face->columns[0] = face->columns[1] = -1;
  tp_vector_dot(power, &face->twist, down, q->judge.precision);
  const bool sinks = arb_is_positive(power) != 0;
  arb_clear(power);
  return sinks && tp_face_admit(face, q->cones, scaled, &q->judge, &violated) == TP_YES ? TP_YES
                                                                                        : TP_OPEN;
}

tp_answer tp_extremes_nowhere(const tp_limit_question *q, tp_scaled *scaled) {
  tp_face face;
  if (!tp_face_init(&face, q->cones)) {
    scaled->out_of_memory = true;
    return TP_OPEN;
  }
  tp_vector down, across;
  double own_down[3], own_across[3], turn[2];
  tp_vector_init(&down);
  tp_vector_init(&across);
  tp_question_load_term(&down, q->load, TP_COS);
  tp_question_load_term(&across, q->load, TP_SIN);
  tp_scaled_wrench(own_down, scaled, &down);
  tp_scaled_wrench(own_across, scaled, &across);
  tp_answer answer = TP_OPEN;
  const plane p = plane_across(own_across);
  if (find_turn(turn, &p, scaled, own_down, own_across)) {
    set_twist(&face.twist, &p, turn, scaled, &across, q->judge.precision);
    answer = prove_turn(&face, &down, scaled, q);
  }
  tp_vector_clear(&down);
  tp_vector_clear(&across);
  tp_face_clear(&face);
  return answer;
}
