/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Loads of a question as wrenches at a tilt, and the test for loads that turn with the tilt as the
 * weight does, for which the limit is one linear program. */

#include "certificate/question.h"

#include "number/ball.h"

static bool is_homogeneous(const tp_trig *f) {
  return arb_is_zero(f->of + TP_ONE) && arb_is_zero(f->of + TP_SEC) && arb_is_zero(f->of + TP_SEC2);
}

bool tp_question_is_linear(const tp_limit_question *q) {
  return q->cones->capacity_count == 0 && is_homogeneous(&q->load->x) &&
         is_homogeneous(&q->load->y) && is_homogeneous(&q->load->moment);
}

void tp_question_load_term(tp_vector *term, const tp_wrench *load, int basis) {
  arb_set(term->of, load->x.of + basis);
  arb_set(term->of + 1, load->y.of + basis);
  arb_set(term->of + 2, load->moment.of + basis);
}

void tp_question_load_at(tp_vector *wrench, const tp_wrench *load, const arb_t sine,
                         const arb_t cosine, long bits) {
  tp_trig_evaluate(wrench->of, &load->x, sine, cosine, bits);
  tp_trig_evaluate(wrench->of + 1, &load->y, sine, cosine, bits);
  tp_trig_evaluate(wrench->of + 2, &load->moment, sine, cosine, bits);
}

void tp_question_load_at_degrees(tp_vector *wrench, const tp_limit_question *q,
                                 const arb_t degrees) {
  arb_t sine, cosine;
  arb_init(sine);
  arb_init(cosine);
  tp_ball_sin_cos(sine, cosine, degrees, q->judge.bits);
  tp_question_load_at(wrench, q->load, sine, cosine, q->judge.precision);
  arb_clear(sine);
  arb_clear(cosine);
}
