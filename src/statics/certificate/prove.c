/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Duality in balls: the twist of two columns is admissible, and both forces at the zero of its
 * excess are not negative (docs/mechanics.md section 6). Where one force is zero the neighbouring
 * face ties with the first, and the hull of both tilts is the answer. */

#include "certificate/prove.h"

#include "certificate/excess.h"
#include "number/ball.h"

#include <math.h>

typedef struct proof {
  tp_limit_answer *answer;
  const tp_limit_question *question;
  const tp_scaled *scaled;
  const tp_vector *drive;
  double near_degrees;
} proof;

/* Forces on facets at a right angle to each other can be parallel, at 45 degrees of friction: the
 * block then slides along both by one twist. */
static tp_answer slide_alike(const tp_face *a, const tp_face *b, const tp_judge *judge) {
  const arb_struct *v = a->twist.of, *w = b->twist.of;
  const bool exact =
      arb_is_exact(v) && arb_is_exact(v + 1) && arb_is_exact(w) && arb_is_exact(w + 1);
  const long bits = exact ? ARF_PREC_EXACT : judge->precision;
  arb_t cross;
  arb_init(cross);
  arb_mul(cross, v, w + 1, bits);
  arb_submul(cross, v + 1, w, bits);
  const int sign = tp_vector_judge(judge, cross, &a->twist, &b->twist);
  arb_clear(cross);
  return sign == 0 ? TP_YES : sign > 1 ? TP_OPEN : TP_NO;
}

static tp_answer same_mechanism(const tp_face *a, const tp_face *b, const tp_limit_question *q) {
  if (a->motion != b->motion) return TP_NO;
  if (a->motion == TP_MOTION_TURN_AT_SITE) return a->site == b->site ? TP_YES : TP_NO;
  if (a->motion != TP_MOTION_SLIDE) return TP_NO;
  if (tp_cones_are_parallel(q->cones, a->columns[0], b->columns[0])) return TP_YES;
  return slide_alike(a, b, &q->judge);
}

static tp_answer span_and_admit(const proof *p, tp_face *face, long first, long second,
                                long *violated) {
  const tp_limit_question *q = p->question;
  const tp_answer spans = tp_face_span(face, q->cones, first, second, p->drive, &q->judge);
  return spans == TP_YES ? tp_face_admit(face, q->cones, p->scaled, &q->judge, violated) : spans;
}

/* One force alone holds the block, the other one at an end of what it may be: the other face beside
 * the first is a mechanism at the same tilt. The loads leave the cone through the one or the other,
 * and the hull of both tilts encloses where. */
static tp_answer find_tie(const proof *p, int at_end, bool full) {
  tp_limit_answer *a = p->answer;
  const long shared = a->face.columns[1 - at_end];
  long column = tp_basis_across(p->scaled, shared, a->face.columns[at_end], full);
  tp_answer answer = TP_NO;
  for (int tries = 0; tries < 3 && column >= 0 && answer == TP_NO; tries++) {
    long violated = -1;
    answer = span_and_admit(p, &a->other, shared, column, &violated);
    column = violated;
  }
  if (answer == TP_OPEN || (answer == TP_NO && column >= 0)) return TP_OPEN;
  /* where the cone is flat, or both faces are one, there is one mechanism only */
  if (answer == TP_NO) return TP_YES;
  const tp_answer same = same_mechanism(&a->face, &a->other, p->question);
  if (same != TP_NO) return same;
  a->tie = true;
  arb_t degrees, sine, cosine; /* the forces are those at this sine and cosine */
  arb_init(degrees);
  arb_init(sine);
  arb_init(cosine);
  arb_swap(degrees, a->degrees);
  arb_swap(sine, a->sine);
  arb_swap(cosine, a->cosine);
  answer = tp_excess_tilt(a, &a->other, p->question, p->near_degrees);
  if (!arb_equal(degrees, a->degrees)) {
    arb_union(a->degrees, a->degrees, degrees, p->question->judge.bits);
  }
  arb_swap(sine, a->sine);
  arb_swap(cosine, a->cosine);
  arb_clear(degrees);
  arb_clear(sine);
  arb_clear(cosine);
  return answer;
}

/* log2 of the size of force k as the other one would have it. */
static double force_scale(const tp_limit_answer *a, const tp_cones *cones, int k, long bits) {
  double scale = 0;
  tp_vector column;
  tp_vector_init(&column);
  for (int j = 0; j < 2; j++) {
    tp_cones_column(column.of, cones, a->face.columns[j], bits);
    scale += (j == k ? -1 : 1) * tp_vector_log2_size(&column);
  }
  scale += tp_ball_log2_above(a->forces + (1 - k));
  tp_vector_clear(&column);
  return scale;
}

static void find_forces(const proof *p) {
  const tp_limit_question *q = p->question;
  tp_limit_answer *a = p->answer;
  tp_vector wrench;
  tp_vector_init(&wrench);
  tp_question_load_at(&wrench, q->load, a->sine, a->cosine, q->judge.precision);
  tp_face_forces(a->forces, &a->face, q->cones, &wrench, &q->judge);
  tp_vector_clear(&wrench);
}

static int sign_of_force(const proof *p, int k) {
  const tp_limit_question *q = p->question;
  const arb_struct *force = p->answer->forces + k;
  const bool asks = tp_judge_asks_scale(&q->judge, force);
  return tp_judge_sign(&q->judge, force,
                       asks ? force_scale(p->answer, q->cones, k, q->judge.bits) : 0);
}

/* Sign of what column k of the face could bear besides its force; 1 where it has no bound. */
static int sign_of_rest(const proof *p, int k) {
  const tp_limit_question *q = p->question;
  const long column = p->answer->face.columns[k];
  if (tp_cones_is_edge(q->cones, column)) return 1;
  double scale = force_scale(p->answer, q->cones, k, q->judge.bits);
  arb_t rest;
  arb_init(rest);
  tp_cones_bound(rest, q->cones, column);
  scale = fmax(scale, tp_ball_log2_above(rest));
  arb_sub(rest, rest, p->answer->forces + k, q->judge.bits);
  const int sign = tp_judge_sign(&q->judge, rest, scale);
  arb_clear(rest);
  return sign;
}

static tp_answer check_forces(const proof *p) {
  int at_end = -1;
  bool full = false;
  for (int k = 0; k < 2; k++) {
    const int sign = sign_of_force(p, k);
    if (sign < 0) return TP_NO;
    if (sign > 1) return TP_OPEN;
    const int rest = sign_of_rest(p, k);
    if (rest < 0) return TP_NO;
    if (rest > 1) return TP_OPEN;
    if (sign > 0 && rest > 0) continue;
    at_end = k;
    full = rest == 0;
  }
  return at_end < 0 ? TP_YES : find_tie(p, at_end, full);
}

/* Do doubles tell that both forces are above zero, neither of a column with a bound? As find_forces
 * has them, in the scaled program's units. */
static bool are_forces_told(const proof *p) {
  const tp_limit_question *q = p->question;
  const tp_limit_answer *a = p->answer;
  if (q->cones->capacity_count > 0) return false;
  tp_near columns[2][3], rest[3], normal[3], cross[3];
  tp_vector wrench;
  tp_vector_init(&wrench);
  tp_question_load_at(&wrench, q->load, a->sine, a->cosine, q->judge.bits);
  tp_scaled_wrench_near(rest, p->scaled, &wrench);
  tp_vector_clear(&wrench);
  for (int row = 0; row < 3; row++) {
    for (int k = 0; k < 2; k++) {
      columns[k][row] = (tp_near){p->scaled->columns[a->face.columns[k]][row], p->scaled->error};
    }
    rest[row] = tp_near_neg(rest[row]);
  }
  tp_near_cross(normal, columns[0], columns[1]);
  tp_near_cross(cross, rest, columns[1]);
  if (tp_near_sign(tp_near_dot(cross, normal)) <= 0) return false;
  tp_near_cross(cross, columns[0], rest);
  return tp_near_sign(tp_near_dot(cross, normal)) > 0;
}

tp_answer tp_prove_limit(tp_limit_answer *answer, const tp_limit_question *question,
                         const tp_scaled *scaled, const tp_basis *basis, const tp_vector *drive,
                         double near_degrees) {
  const proof p = {answer, question, scaled, drive, near_degrees};
  answer->kind = TP_LIMIT_AT_ANGLE;
  answer->tie = false;
  answer->violated = -1;
  if (basis->count != 2) return TP_NO;
  tp_answer done =
      span_and_admit(&p, &answer->face, basis->columns[0], basis->columns[1], &answer->violated);
  if (done == TP_YES) done = tp_excess_tilt(answer, &answer->face, question, near_degrees);
  if (done != TP_YES) return done;
  if (scaled->at_most != NULL) {
    tp_face_settle_capacities(&answer->face, question->cones, scaled->at_most, &question->judge);
  }
  if (question->without_forces && are_forces_told(&p)) return TP_YES;
  find_forces(&p);
  return check_forces(&p);
}
