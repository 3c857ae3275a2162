/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Equilibrium over an interval of tilts from three wrenches: its two ends and the apex of its
 * tangents, with 1 / cos and 1 / cos^2 enclosed by chords; an interval that fails is halved
 * (docs/mechanics.md section 6, step 2). */

#include "certificate/interval.h"

#include "number/ball.h"

/* Pieces of the interval that are tried; where so many are not enough the proof is given up. */
enum { MOST_SAMPLES = 256 };

tp_answer tp_interval_bears_at(const tp_limit_question *q, tp_scaled *scaled, const tp_vector *push,
                               const arb_t degrees) {
  tp_vector load;
  tp_vector_init(&load);
  tp_question_load_at_degrees(&load, q, degrees);
  const tp_answer answer = tp_equilibrium_bears(q, scaled, push, &load);
  tp_vector_clear(&load);
  return answer;
}

/* The five functions of the tilt at the apex of an interval. */
typedef struct apex {
  arb_struct of[TP_BASIS];
} apex;

/* +- max |f''| sin^2 r / cos r added to a value. */
static void widen(arb_t value, const arb_t most, const arb_t off) {
  mag_t width;
  arb_t product;
  mag_init(width);
  arb_init(product);
  arb_mul(product, most, off, 64);
  arb_get_mag(width, product);
  arb_add_error_mag(value, width);
  arb_clear(product);
  mag_clear(width);
}

/* 1 / cos and 1 / cos^2 on their chords between c_0 and c_1, at c = cos m / cos r:
 * (c_0 + c_1 - c) / (c_0 c_1), and 1 / c_0^2 - (c_0 + c_1) (c - c_0) / (c_0 c_1)^2. The second
 * derivatives, 2 / c^3 and 6 / c^4, are largest at the lesser of c_0 and c_1. */
static void set_secants(apex *a, const arb_t first, const arb_t second, const arb_t off,
                        long bits) {
  arb_t sum, product, least, most;
  arb_init(sum);
  arb_init(product);
  arb_init(least);
  arb_init(most);
  arb_add(sum, first, second, bits);
  arb_mul(product, first, second, bits);
  arb_sub(a->of + TP_SEC, sum, a->of + TP_COS, bits);
  arb_div(a->of + TP_SEC, a->of + TP_SEC, product, bits);
  arb_sub(most, first, a->of + TP_COS, bits);
  arb_mul(most, most, sum, bits);
  arb_div(most, most, product, bits);
  arb_div(a->of + TP_SEC2, most, product, bits);
  arb_inv(most, first, bits);
  arb_addmul(a->of + TP_SEC2, most, most, bits);
  arb_min(least, first, second, bits);
  arb_inv(least, least, bits);
  arb_pow_ui(most, least, 3, bits);
  arb_mul_ui(most, most, 2, bits);
  widen(a->of + TP_SEC, most, off);
  arb_mul(most, most, least, bits);
  arb_mul_ui(most, most, 3, bits);
  widen(a->of + TP_SEC2, most, off);
  arb_clear(sum);
  arb_clear(product);
  arb_clear(least);
  arb_clear(most);
}

static void set_apex(apex *a, const arb_t low, const arb_t high, long bits) {
  arb_t angle, sine, cosine, off, first, second;
  arb_init(angle);
  arb_init(sine);
  arb_init(cosine);
  arb_init(off);
  arb_init(first);
  arb_init(second);
  arb_add(angle, low, high, bits);
  arb_mul_2exp_si(angle, angle, -1);
  tp_ball_sin_cos(a->of + TP_SIN, a->of + TP_COS, angle, bits);
  arb_sub(angle, high, low, bits);
  arb_mul_2exp_si(angle, angle, -1);
  tp_ball_sin_cos(sine, cosine, angle, bits);
  arb_div(a->of + TP_COS, a->of + TP_COS, cosine, bits);
  arb_div(a->of + TP_SIN, a->of + TP_SIN, cosine, bits);
  arb_one(a->of + TP_ONE);
  arb_mul(off, sine, sine, bits);
  arb_div(off, off, cosine, bits);
  tp_ball_sin_cos(sine, first, low, bits);
  tp_ball_sin_cos(sine, second, high, bits);
  set_secants(a, first, second, off, bits);
  arb_clear(angle);
  arb_clear(sine);
  arb_clear(cosine);
  arb_clear(off);
  arb_clear(first);
  arb_clear(second);
}

static void load_at_apex(tp_vector *load, const tp_wrench *of, const apex *a, long bits) {
  const tp_trig *parts[3] = {&of->x, &of->y, &of->moment};
  for (int row = 0; row < 3; row++) {
    arb_zero(load->of + row);
    for (int basis = 0; basis < TP_BASIS; basis++) {
      if (arb_is_zero(parts[row]->of + basis)) continue; /* 1 / cos may be infinite */
      arb_addmul(load->of + row, parts[row]->of + basis, a->of + basis, bits);
    }
  }
}

static tp_answer bears_apex(const tp_limit_question *q, tp_scaled *scaled, const tp_vector *push,
                            const arb_t low, const arb_t high) {
  tp_vector load;
  apex a;
  tp_vector_init(&load);
  for (int k = 0; k < TP_BASIS; k++) arb_init(a.of + k);
  set_apex(&a, low, high, q->judge.bits);
  load_at_apex(&load, q->load, &a, q->judge.precision);
  bool finite = true;
  for (int row = 0; row < 3; row++) finite = finite && arb_is_finite(load.of + row);
  const tp_answer answer = finite ? tp_equilibrium_bears(q, scaled, push, &load) : TP_OPEN;
  tp_vector_clear(&load);
  for (int k = 0; k < TP_BASIS; k++) arb_clear(a.of + k);
  return answer;
}

static double middle_of(const arb_t ball) {
  return arf_get_d(arb_midref(ball), ARF_RND_NEAR);
}

/* An exact tilt between two; false where doubles know none. */
static bool set_between(arb_t middle, const arb_t low, const arb_t high) {
  arb_set_d(middle, (middle_of(low) + middle_of(high)) / 2);
  return arb_gt(middle, low) && arb_lt(middle, high);
}

/* What a proof over an interval goes by. */
typedef struct walk {
  const tp_limit_question *q;
  tp_scaled *scaled;
  const tp_vector *push;
  int samples;
  double held, lost;
} walk;

static tp_answer hold(walk *w, const arb_t low, const arb_t high) {
  if (--w->samples < 0) return TP_OPEN;
  if (bears_apex(w->q, w->scaled, w->push, low, high) == TP_YES) return TP_YES;
  arb_t middle;
  arb_init(middle);
  tp_answer answer = TP_OPEN;
  if (set_between(middle, low, high)) {
    answer = tp_interval_bears_at(w->q, w->scaled, w->push, middle);
    if (answer == TP_NO) {
      w->held = middle_of(low);
      w->lost = middle_of(middle);
    }
    if (answer == TP_YES) answer = hold(w, low, middle);
    if (answer == TP_YES) answer = hold(w, middle, high);
  }
  arb_clear(middle);
  return answer;
}

tp_answer tp_interval_holds(double *held, double *lost, const tp_limit_question *q,
                            tp_scaled *scaled, const tp_vector *push, const arb_t low,
                            const arb_t high) {
  walk w = {.q = q, .scaled = scaled, .push = push, .samples = MOST_SAMPLES};
  const tp_answer answer = hold(&w, low, high);
  if (answer == TP_NO) {
    *held = w.held;
    *lost = w.lost;
  }
  return answer;
}
