/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The function v . F(alpha) - K of a mechanism in the five functions of the tilt (docs/mechanics.md
 * section 5), and its zero: an arctangent, or the rising zero nearest to a tilt found in
 * doubles. */

#include "certificate/excess.h"

#include "load/zeros.h"
#include "number/ball.h"

#include <math.h>

void tp_excess_of(tp_trig *excess, const tp_face *face, const tp_limit_question *q) {
  tp_vector term;
  tp_vector_init(&term);
  for (int basis = 0; basis < TP_BASIS; basis++) {
    tp_question_load_term(&term, q->load, basis);
    if (arb_is_zero(term.of) && arb_is_zero(term.of + 1) && arb_is_zero(term.of + 2)) {
      arb_zero(excess->of + basis);
      continue;
    }
    tp_vector_dot(excess->of + basis, &face->twist, &term, q->judge.precision);
  }
  arb_sub(excess->of + TP_ONE, excess->of + TP_ONE, face->resistance, q->judge.bits);
  tp_vector_clear(&term);
}

/* A cos a + B sin a = 0 with B > 0: the direction (B, -A) of (cosine, sine), exact where A, B are.
 */
static tp_answer linear_tilt(tp_limit_answer *a, const tp_trig *excess, long bits) {
  arb_neg(a->sine, excess->of + TP_COS);
  arb_set(a->cosine, excess->of + TP_SIN);
  tp_ball_atan2_degrees(a->degrees, a->sine, a->cosine, bits);
  return arb_is_positive(a->cosine) ? TP_YES : TP_OPEN;
}

static tp_answer nearest_root(tp_limit_answer *a, const tp_trig *excess, const tp_limit_question *q,
                              double near_degrees) {
  static const double near_enough = 1e-3; /* degrees; what doubles find is far nearer */
  tp_roots roots;
  tp_roots_init(&roots);
  tp_roots_find(&roots, excess, q->judge.bits);
  double least = near_enough;
  long nearest = -1;
  for (long k = 0; k < roots.count; k++) {
    const double off = fabs(arf_get_d(arb_midref(roots.degrees + k), ARF_RND_NEAR) - near_degrees);
    if (!roots.rising[k] || off > least) continue;
    least = off;
    nearest = k;
  }
  if (nearest >= 0) {
    arb_set(a->degrees, roots.degrees + nearest);
    tp_ball_sin_cos(a->sine, a->cosine, a->degrees, q->judge.bits);
  }
  const bool certain = roots.certain;
  tp_roots_clear(&roots);
  return nearest >= 0 && certain ? TP_YES : TP_OPEN;
}

tp_answer tp_excess_tilt(tp_limit_answer *answer, const tp_face *face, const tp_limit_question *q,
                         double near_degrees) {
  tp_trig excess;
  tp_trig_init(&excess);
  tp_excess_of(&excess, face, q);
  const tp_answer found = tp_question_is_linear(q) ? linear_tilt(answer, &excess, q->judge.bits)
                                                   : nearest_root(answer, &excess, q, near_degrees);
  tp_trig_clear(&excess);
  return found;
}
