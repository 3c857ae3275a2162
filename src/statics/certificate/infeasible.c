/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Proof that no forces hold the block: the dual of the linear program proposes two columns, their
 * twist is proven admissible, and the zeros of its excess v . F - K end the stretch of tilts that
 * it rules out (docs/mechanics.md section 6, step 3). */

#include "certificate/infeasible.h"

#include "certificate/excess.h"
#include "certificate/relax.h"
#include "load/zeros.h"
#include "number/ball.h"

#include <math.h>

/* Tilts at which a face is looked for, of one interval: each rules out a stretch of it, and where
 * that many do not cover it the proof is given up. */
enum { MOST_SAMPLES = 128 };

/* Work that doubles take for none, in the program's units: wide, since what it lets in only costs a
 * face that is refuted. */
static const double rounding = 1e-9;

/* Steps of the program that a look is counted for, about as many as it takes. */
enum { STEPS_IN_DOUBLES = 2, STEPS_IN_LONG_NUMBERS = 5 };

/* Of those against which the dual does no work, or of all, the column that spans the widest face
 * with the first. */
static bool span_widest(long columns[2], const tp_scaled *scaled, long count, const double *dual) {
  const double *a = scaled->columns[columns[0]];
  double most = 0;
  for (long k = 0; k < count; k++) {
    const double *b = scaled->columns[k];
    const double work = dual == NULL ? 0 : fabs(tp_double_dot(dual, b));
    double cross[3];
    tp_double_cross(cross, a, b);
    const double own = fabs(cross[0]) + fabs(cross[1]) + fabs(cross[2]);
    if (own <= most || work > rounding) continue;
    most = own;
    columns[1] = k;
  }
  return most > 0;
}

/* Where no push helps, because all forces lie in one plane: two edges against which the separating
 * twist does no work. */
static bool span_idle(long columns[2], const tp_simplex_answer *found, const tp_scaled *scaled,
                      long edges) {
  const double size = fabs(found->dual[0]) + fabs(found->dual[1]) + fabs(found->dual[2]);
  if (found->outcome != TP_SIMPLEX_INFEASIBLE || !(size > 0)) return false;
  const double dual[3] = {found->dual[0] / size, found->dual[1] / size, found->dual[2] / size};
  for (columns[0] = 0; columns[0] < edges; columns[0]++) {
    const double *a = scaled->columns[columns[0]];
    if (fabs(tp_double_dot(dual, a)) < rounding) break;
  }
  return columns[0] < edges && span_widest(columns, scaled, edges, dual);
}

/* Where there is but one column or the rest is artificial, the one that spans the widest face. */
static bool span(long columns[2], const tp_simplex_answer *found, const tp_scaled *scaled,
                 long edges) {
  if (span_idle(columns, found, scaled, edges)) return true;
  const tp_basis basis = tp_basis_of(found);
  if (basis.count == 0) return false;
  columns[0] = basis.columns[0];
  columns[1] = basis.columns[1];
  return basis.count > 1 || span_widest(columns, scaled, scaled->count, NULL);
}

static tp_simplex_answer solve_without(const tp_limit_question *q, tp_scaled *scaled,
                                       const tp_vector *load) {
  tp_near push[3], wrench[3];
  tp_equilibrium_push_near(push, q->cones, scaled);
  tp_scaled_wrench_near(wrench, scaled, load);
  return tp_equilibrium_solve_near(scaled, push, wrench);
}

/* The face through which the loads leave what the base bears, seen from the push. */
static tp_answer find_face(tp_face *face, const tp_limit_question *q, tp_scaled *scaled,
                           const tp_vector *push, const tp_vector *load) {
  tp_answer answer = TP_OPEN;
  for (int engine = 0; engine < (push == NULL ? 1 : 2) && answer != TP_YES; engine++) {
    if (!tp_work_spend(q->work, engine == 0 ? STEPS_IN_DOUBLES : STEPS_IN_LONG_NUMBERS,
                       scaled->count, q->judge.bits))
      return TP_OPEN;
    const tp_simplex_answer found = push == NULL ? solve_without(q, scaled, load)
                                    : engine == 0
                                        ? tp_equilibrium_solve(scaled, push, load)
                                        : tp_equilibrium_solve_precisely(q, scaled, push, load);
    long columns[2] = {-1, -1}, violated = -1;
    if (!span(columns, &found, scaled, 2 * q->cones->count)) continue;
    answer = tp_face_span(face, q->cones, columns[0], columns[1], load, &q->judge);
    if (answer == TP_YES) answer = tp_face_admit(face, q->cones, scaled, &q->judge, &violated);
    if (answer == TP_OPEN) answer = tp_relax(face, q, scaled);
  }
  return answer == TP_YES ? TP_YES : TP_OPEN;
}

/* The zeros of v . F - K about a tilt at which it is above zero: between them it stays so. */
typedef struct zeros {
  bool has_before, has_after;
  arb_t before, after;
} zeros;

static void zeros_init(zeros *z) {
  z->has_before = z->has_after = false;
  arb_init(z->before);
  arb_init(z->after);
}

static void zeros_clear(zeros *z) {
  arb_clear(z->before);
  arb_clear(z->after);
}

/* About `at`, in which `own` zeros lie. False where not all is certain. */
static bool find_zeros(zeros *z, const tp_trig *excess, const tp_limit_question *q, const arb_t at,
                       int own) {
  tp_roots roots;
  tp_roots_init(&roots);
  tp_roots_find(&roots, excess, q->judge.bits);
  for (long k = 0; k < roots.count; k++) {
    const arb_struct *zero = roots.degrees + k;
    if (arb_lt(zero, at)) {
      z->has_before = true;
      arb_set(z->before, zero);
    } else if (!arb_gt(zero, at)) {
      own--;
    } else if (!z->has_after) {
      z->has_after = true;
      arb_set(z->after, zero);
    }
  }
  const bool certain = roots.certain && own == 0;
  tp_roots_clear(&roots);
  return certain;
}

/* About `at`, the work of the loads being above what is held there. */
static tp_answer infeasible_about(zeros *z, const tp_limit_question *q, tp_scaled *scaled,
                                  const tp_vector *push, const arb_t at) {
  tp_face face;
  if (!tp_face_init(&face, q->cones)) {
    scaled->out_of_memory = true;
    return TP_OPEN;
  }
  tp_vector load;
  tp_trig excess;
  arb_t sine, cosine, above;
  tp_vector_init(&load);
  tp_trig_init(&excess);
  arb_init(sine);
  arb_init(cosine);
  arb_init(above);
  tp_ball_sin_cos(sine, cosine, at, q->judge.bits);
  tp_question_load_at(&load, q->load, sine, cosine, q->judge.precision);
  tp_answer answer = find_face(&face, q, scaled, push, &load);
  if (answer == TP_YES) {
    tp_excess_of(&excess, &face, q);
    tp_trig_evaluate(above, &excess, sine, cosine, q->judge.bits);
    const bool infeasible = arb_is_positive(above) && find_zeros(z, &excess, q, at, 0);
    answer = infeasible ? TP_YES : TP_OPEN;
  }
  tp_vector_clear(&load);
  tp_trig_clear(&excess);
  tp_face_clear(&face);
  arb_clear(sine);
  arb_clear(cosine);
  arb_clear(above);
  return answer;
}

tp_answer tp_infeasible_under(tp_face_motion *motion, const tp_limit_question *q, tp_scaled *scaled,
                              const tp_vector *push, const tp_vector *load) {
  tp_face face;
  if (!tp_face_init(&face, q->cones)) {
    scaled->out_of_memory = true;
    return TP_OPEN;
  }
  tp_answer answer = find_face(&face, q, scaled, push, load);
  if (answer == TP_YES) {
    arb_t above;
    arb_init(above);
    tp_vector_dot(above, &face.twist, load, q->judge.precision);
    arb_sub(above, above, face.resistance, q->judge.bits);
    answer = arb_is_positive(above) ? TP_YES : TP_OPEN;
    arb_clear(above);
  }
  if (answer == TP_YES && motion != NULL) *motion = tp_face_told_motion(&face, q->cones);
  tp_face_clear(&face);
  return answer;
}

tp_answer tp_infeasible_at(const tp_limit_question *q, tp_scaled *scaled, const tp_vector *push,
                           const arb_t degrees) {
  tp_vector load;
  tp_vector_init(&load);
  tp_question_load_at_degrees(&load, q, degrees);
  const tp_answer answer = tp_infeasible_under(NULL, q, scaled, push, &load);
  tp_vector_clear(&load);
  return answer;
}

typedef struct walk {
  const tp_limit_question *q;
  tp_scaled *scaled;
  const tp_vector *push;
  int samples;
} walk;

static tp_answer beat(walk *w, const arb_t low, const arb_t high) {
  if (--w->samples < 0) return TP_OPEN;
  zeros z;
  arb_t middle;
  zeros_init(&z);
  arb_init(middle);
  arb_add(middle, low, high, w->q->judge.bits);
  arb_mul_2exp_si(middle, middle, -1);
  arb_get_mid_arb(middle, middle);
  tp_answer answer = infeasible_about(&z, w->q, w->scaled, w->push, middle);
  if (answer == TP_YES && z.has_before && !arb_lt(z.before, low)) answer = beat(w, low, z.before);
  if (answer == TP_YES && z.has_after && !arb_gt(z.after, high)) answer = beat(w, z.after, high);
  zeros_clear(&z);
  arb_clear(middle);
  return answer;
}

tp_answer tp_infeasible(const tp_limit_question *q, tp_scaled *scaled, const tp_vector *push,
                        const arb_t low, const arb_t high) {
  walk w = {q, scaled, push, MOST_SAMPLES};
  return beat(&w, low, high);
}

tp_answer tp_infeasible_after(const tp_face *face, const tp_limit_question *q, tp_scaled *scaled,
                              const tp_vector *push, const arb_t degrees, const arb_t high) {
  tp_trig excess;
  zeros z;
  tp_trig_init(&excess);
  zeros_init(&z);
  tp_excess_of(&excess, face, q);
  tp_answer answer = find_zeros(&z, &excess, q, degrees, 1) ? TP_YES : TP_OPEN;
  if (answer == TP_YES && z.has_after && !arb_gt(z.after, high)) {
    answer = tp_infeasible(q, scaled, push, z.after, high);
  }
  tp_trig_clear(&excess);
  zeros_clear(&z);
  return answer;
}
