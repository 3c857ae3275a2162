/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A strictly admissible twist from one that is admissible only up to rounding: a small share of a
 * twist on which every column does positive work, found by the perceptron rule, is added. */

#include "certificate/relax.h"

#include <math.h>

static double size_of(const double c[3]) {
  return sqrt(tp_double_dot(c, c));
}

/* The edge against which the twist does least, over the edge's size. */
static long find_least(double *least, const double twist[3], const tp_scaled *s, long edges) {
  long found = 0;
  *least = INFINITY;
  for (long k = 0; k < edges; k++) {
    const double own = tp_double_dot(twist, s->columns[k]) / size_of(s->columns[k]);
    if (own >= *least) continue;
    *least = own;
    found = k;
  }
  return found;
}

/* Perceptron: from the sum of all edges, whichever does least is added until all do work. */
static bool find_inner(double twist[3], const tp_scaled *s, long edges) {
  /* a perceptron that separates with a margin m ends within 1 / m^2 steps: m above 0.02 is found,
   * and one that grew to `enough` is not improved on */
  enum { MOST_STEPS = 2000 };
  static const double enough = 1e-4;
  double least = 0;
  for (int row = 0; row < 3; row++) twist[row] = 0;
  for (long k = 0; k < edges; k++) {
    const double size = size_of(s->columns[k]);
    for (int row = 0; row < 3; row++) twist[row] += s->columns[k][row] / size / (double)edges;
  }
  for (int step = 0; step < MOST_STEPS; step++) {
    const long worst = find_least(&least, twist, s, edges);
    if (least > enough * size_of(twist)) break;
    const double size = size_of(s->columns[worst]);
    for (int row = 0; row < 3; row++) twist[row] += s->columns[worst][row] / size;
  }
  const double size = size_of(twist);
  for (int row = 0; row < 3; row++) twist[row] /= size;
  return least > 0;
}

tp_answer tp_relax(tp_face *face, const tp_limit_question *q, const tp_scaled *scaled) {
  double inner[3];
  if (!find_inner(inner, scaled, 2 * q->cones->count)) return TP_OPEN;
  tp_vector own;
  arb_t share;
  tp_vector_init(&own);
  arb_init(share);
  tp_scaled_twist(&own, scaled, &face->twist);
  const double size = tp_vector_log2_size(&own);
  for (int row = 0; row < 3; row++) {
    arb_set_d(share, inner[row]);
    arb_mul_2exp_si(share, share, (isfinite(size) ? (slong)size : 0) - 3 * q->judge.bits / 4);
    arb_add(own.of + row, own.of + row, share, q->judge.precision);
    arb_get_mid_arb(own.of + row, own.of + row);
  }
  tp_scaled_untwist(&face->twist, scaled, &own);
  for (int row = 0; row < 3; row++) arb_get_mid_arb(face->twist.of + row, face->twist.of + row);
  face->columns[0] = face->columns[1] = -1;
  face->motion = TP_MOTION_TURN;
  long violated = -1;
  const tp_answer answer = tp_face_admit(face, q->cones, scaled, &q->judge, &violated);
  tp_vector_clear(&own);
  arb_clear(share);
  return answer == TP_YES ? TP_YES : TP_OPEN;
}
