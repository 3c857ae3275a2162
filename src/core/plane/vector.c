/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Cross and dot products of triples of balls, and the sign of a product. */

#include "plane/vector.h"

#include "number/ball.h"

#include <math.h>

void tp_vector_init(tp_vector *v) {
  for (int k = 0; k < 3; k++) arb_init(v->of + k);
}

void tp_vector_clear(tp_vector *v) {
  for (int k = 0; k < 3; k++) arb_clear(v->of + k);
}

void tp_vector_cross(tp_vector *product, const tp_vector *a, const tp_vector *b, long bits) {
  tp_ball_cross(product->of, a->of, b->of, bits);
}

void tp_vector_dot(arb_t product, const tp_vector *a, const tp_vector *b, long bits) {
  tp_ball_set_dot(product, a->of, b->of, bits);
}

void tp_vector_neg(tp_vector *v) {
  for (int k = 0; k < 3; k++) arb_neg(v->of + k, v->of + k);
}

double tp_vector_log2_size(const tp_vector *v) {
  double most = -INFINITY;
  for (int k = 0; k < 3; k++) most = fmax(most, tp_ball_log2_above(v->of + k));
  return most;
}

int tp_vector_judge(const tp_judge *judge, const arb_t of, const tp_vector *a, const tp_vector *b) {
  const bool asks = tp_judge_asks_scale(judge, of);
  return tp_judge_sign(judge, of, asks ? tp_vector_log2_size(a) + tp_vector_log2_size(b) : 0);
}
