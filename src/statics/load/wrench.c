/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sums, values and moments of the functions A cos + B sin + C + D / cos + E / cos^2 of the tilt
 * (docs/mechanics.md section 5). */

#include "load/wrench.h"

#include "number/ball.h"

#include <math.h>

void tp_trig_init(tp_trig *f) {
  for (int k = 0; k < TP_BASIS; k++) arb_init(f->of + k);
}

void tp_trig_clear(tp_trig *f) {
  for (int k = 0; k < TP_BASIS; k++) arb_clear(f->of + k);
}

void tp_trig_add(tp_trig *sum, const tp_trig *f, long bits) {
  for (int k = 0; k < TP_BASIS; k++) arb_add(sum->of + k, sum->of + k, f->of + k, bits);
}

void tp_trig_addmul(tp_trig *sum, const tp_trig *f, const arb_t factor, long bits) {
  for (int k = 0; k < TP_BASIS; k++) arb_addmul(sum->of + k, f->of + k, factor, bits);
}

void tp_trig_submul(tp_trig *sum, const tp_trig *f, const arb_t factor, long bits) {
  for (int k = 0; k < TP_BASIS; k++) arb_submul(sum->of + k, f->of + k, factor, bits);
}

void tp_trig_evaluate(arb_t value, const tp_trig *f, const arb_t sine, const arb_t cosine,
                      long bits) {
  arb_t term;
  arb_init(term);
  if (arb_is_zero(f->of + TP_COS)) {
    arb_zero(value);
  } else {
    arb_mul(value, f->of + TP_COS, cosine, bits);
  }
  if (!arb_is_zero(f->of + TP_SIN)) arb_addmul(value, f->of + TP_SIN, sine, bits);
  if (!arb_is_zero(f->of + TP_ONE)) arb_add(value, value, f->of + TP_ONE, bits);
  if (!arb_is_zero(f->of + TP_SEC)) {
    arb_div(term, f->of + TP_SEC, cosine, bits);
    arb_add(value, value, term, bits);
  }
  if (!arb_is_zero(f->of + TP_SEC2)) {
    arb_div(term, f->of + TP_SEC2, cosine, bits);
    arb_div(term, term, cosine, bits);
    arb_add(value, value, term, bits);
  }
  arb_clear(term);
}

void tp_wrench_init(tp_wrench *wrench) {
  tp_trig_init(&wrench->x);
  tp_trig_init(&wrench->y);
  tp_trig_init(&wrench->moment);
}

void tp_wrench_clear(tp_wrench *wrench) {
  tp_trig_clear(&wrench->x);
  tp_trig_clear(&wrench->y);
  tp_trig_clear(&wrench->moment);
}

void tp_wrench_add_force(tp_wrench *wrench, const tp_trig *fx, const tp_trig *fy, const arb_t x,
                         const arb_t y, long bits) {
  tp_trig_add(&wrench->x, fx, bits);
  tp_trig_add(&wrench->y, fy, bits);
  tp_trig_addmul(&wrench->moment, fy, x, bits);
  tp_trig_submul(&wrench->moment, fx, y, bits);
}

void tp_wrench_moment(tp_trig *moment, const tp_wrench *wrench, const arb_t x, const arb_t y,
                      long bits) {
  for (int k = 0; k < TP_BASIS; k++) arb_set(moment->of + k, wrench->moment.of + k);
  tp_trig_submul(moment, &wrench->y, x, bits);
  tp_trig_addmul(moment, &wrench->x, y, bits);
}

double tp_wrench_force_log2(const tp_wrench *w) {
  double most = -INFINITY;
  for (int k = 0; k < TP_BASIS; k++) {
    most = fmax(most, fmax(tp_ball_log2_above(w->x.of + k), tp_ball_log2_above(w->y.of + k)));
  }
  return most;
}
