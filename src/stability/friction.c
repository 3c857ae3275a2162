/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "stability/friction.h"

#include "number/ball.h"

#include <math.h>

bool tp_friction_is_load_dependent(const tp_evaluation *e) {
  return e->problem->scene->friction.load_dependent;
}

/* log10(JCS / sigma), sigma in Pa. */
static void log_strength(arb_t value, const arb_t sigma, const tp_evaluation *e) {
  const long bits = e->rung.bits;
  arb_t ten;
  arb_init(ten);
  arb_set_fmpq(value, e->problem->scene->friction.jcs_mpa.value, bits);
  arb_mul_ui(value, value, 1000000, bits);
  arb_div(value, value, sigma, bits);
  arb_log(value, value, bits);
  arb_const_log10(ten, bits);
  arb_div(value, value, ten, bits);
  arb_clear(ten);
}

/* Given, by Eq. (9), or by Eq. (10) at the stress on level ground. */
static void set_jrc(arb_t jrc, const tp_evaluation *e) {
  const tp_scene *scene = e->problem->scene;
  const tp_friction_description *f = &scene->friction;
  const long bits = e->rung.bits;
  if (f->jrc.given) {
    arb_set_fmpq(jrc, f->jrc.value, bits);
    return;
  }
  arb_t sigma, divisor;
  arb_init(sigma);
  arb_init(divisor);
  if (f->roughness_angle_deg.given) {
    arb_set(sigma, e->weight_per_area_pa);
    arb_set_fmpq(jrc, f->roughness_angle_deg.value, bits);
  } else {
    fmpq_t angle;
    fmpq_init(angle);
    fmpq_sub(angle, f->test_angle_deg.value, scene->friction_angle_deg.value);
    arb_set_fmpq(jrc, angle, bits);
    fmpq_clear(angle);
    arb_set_fmpq(sigma, f->test_stress_kpa.value, bits);
    arb_mul_ui(sigma, sigma, 1000, bits);
  }
  log_strength(divisor, sigma, e);
  arb_div(jrc, jrc, divisor, bits);
  arb_clear(sigma);
  arb_clear(divisor);
}

/* The mean normal stress over that of the weight on level ground: cos(alpha), or what the loads
 * make of it. */
static void stress_ratio(arb_t ratio, const tp_evaluation *e, const arb_t tilt) {
  const long bits = e->rung.bits;
  arb_t sine, cosine;
  arb_init(sine);
  arb_init(cosine);
  tp_ball_sin_cos(sine, cosine, tilt, bits);
  if (e->loaded == NULL) {
    arb_set(ratio, cosine);
  } else {
    tp_trig_evaluate(ratio, &e->loaded->sum.y, sine, cosine, bits);
    arb_div(ratio, ratio, e->loaded->items[0].wrench.y.of + TP_COS, bits); /* both downwards */
  }
  arb_clear(sine);
  arb_clear(cosine);
}

enum { MOST_DEGREES = 70 };

/* phi_r + JRC log10(JCS / sigma), within [0, 70]: stresses above JCS would take friction away. */
static void barton_pressed(arb_t degrees, const arb_t sigma, const tp_evaluation *e) {
  const long bits = e->rung.bits;
  arb_t roughness, log, end;
  arb_init(roughness);
  arb_init(log);
  arb_init(end);
  log_strength(log, sigma, e);
  set_jrc(roughness, e);
  arb_set_fmpq(degrees, e->problem->scene->friction_angle_deg.value, bits);
  arb_addmul(degrees, roughness, log, bits);
  arb_max(degrees, degrees, end, bits);
  arb_set_ui(end, MOST_DEGREES);
  arb_min(degrees, degrees, end, bits);
  if (!arb_is_finite(degrees)) { /* a JRC over log10(1): all that is known is the range */
    arb_set_ui(degrees, MOST_DEGREES / 2);
    mag_set_ui(arb_radref(degrees), MOST_DEGREES / 2);
  }
  arb_clear(roughness);
  arb_clear(log);
  arb_clear(end);
}

/* The most friction where nothing presses; where that is not known, all from what the largest
 * stress gives to that. */
static void barton(arb_t degrees, const arb_t sigma, const tp_evaluation *e) {
  if (arb_is_positive(sigma)) {
    barton_pressed(degrees, sigma, e);
    return;
  }
  arb_set_ui(degrees, MOST_DEGREES);
  if (arb_is_nonpositive(sigma)) return;
  const long bits = e->rung.bits;
  arb_t most, least;
  arf_t end;
  arb_init(most);
  arb_init(least);
  arf_init(end);
  arb_get_ubound_arf(end, sigma, bits);
  arb_set_arf(most, end);
  barton_pressed(least, most, e);
  arb_union(degrees, degrees, least, bits);
  arb_clear(most);
  arb_clear(least);
  arf_clear(end);
}

void tp_friction_at(arb_t degrees, const tp_evaluation *e, const arb_t tilt) {
  const long bits = e->rung.bits;
  if (!tp_friction_is_load_dependent(e)) {
    arb_set_fmpq(degrees, e->problem->scene->friction_angle_deg.value, bits);
    return;
  }
  arb_t sigma, ratio;
  arb_init(sigma);
  arb_init(ratio);
  stress_ratio(ratio, e, tilt);
  arb_mul(sigma, e->weight_per_area_pa, ratio, bits);
  barton(degrees, sigma, e);
  arb_clear(sigma);
  arb_clear(ratio);
}

void tp_friction_tangent(arb_t tangent, const arb_t degrees, long bits) {
  if (arb_is_zero(degrees) || arb_equal_si(degrees, 45)) {
    arb_set_si(tangent, arb_is_zero(degrees) ? 0 : 1);
    return;
  }
  arb_div_ui(tangent, degrees, 180, bits);
  arb_tan_pi(tangent, tangent, bits);
}

/* By turns friction from tilt and tilt from friction: the tilt depends on friction less than
 * friction does on stress, so the steps shrink; or, where the tilt leaps, they go round for ever:
 * through one that was marked, the marks being twice as far apart each time (Brent). */
static bool iterate(double *tilt, const tp_evaluation *e, tp_friction_limit limit, void *context,
                    bool back) {
  enum { MOST_STEPS = 200 };
  static const double near_enough = 1e-14;
  arb_t angle, next;
  arb_init(angle);
  arb_init(next);
  *tilt = 0;
  bool found = false, failed = false;
  double mark = NAN;
  for (int step = 0, next_mark = 1; step < MOST_STEPS && !found && !failed; step++) {
    arb_set_d(next, back ? -*tilt : *tilt);
    tp_friction_at(angle, e, next);
    failed = !limit(next, context, angle, true);
    if (failed) break;
    const double own = arf_get_d(arb_midref(next), ARF_RND_NEAR);
    found = fabs(own - *tilt) <= near_enough * fabs(own);
    failed = !found && own == mark;
    *tilt = own;
    if (step == next_mark) {
      mark = own;
      next_mark *= 2;
    }
  }
  arb_clear(angle);
  arb_clear(next);
  return found;
}

/* From doubles to 10^-digits degrees, by secants of image less tilt. Search alone: the proof comes
 * after it. */
static void refine(arf_t tilt, const tp_evaluation *e, tp_friction_limit limit, void *context,
                   bool back, int digits) {
  enum { MOST_STEPS = 64 };
  const long bits = e->rung.bits;
  arb_t angle, image;
  arf_t step, value, before;
  arb_init(angle);
  arb_init(image);
  arf_init(step);
  arf_init(value);
  arf_init(before);
  for (int k = 0; k < MOST_STEPS; k++) {
    arb_set_arf(image, tilt);
    if (back) arb_neg(image, image);
    tp_friction_at(angle, e, image);
    if (!limit(image, context, angle, false)) break;
    arf_swap(before, value);
    arf_sub(value, arb_midref(image), tilt, bits, ARF_RND_NEAR);
    if (k == 0) {
      arf_set(step, value);
    } else { /* - value (last step) / (value - before) */
      arf_sub(before, before, value, bits, ARF_RND_NEAR);
      if (arf_is_zero(before)) break;
      arf_mul(step, step, value, bits, ARF_RND_NEAR);
      arf_div(step, step, before, bits, ARF_RND_NEAR);
    }
    if (arf_cmpabs_2exp_si(step, -(slong)(3.33 * digits)) < 0) break;
    arf_add(tilt, tilt, step, bits, ARF_RND_NEAR);
  }
  arb_clear(angle);
  arb_clear(image);
  arf_clear(step);
  arf_clear(value);
  arf_clear(before);
}

/* As many as are asked for; on the higher rungs more, for what is left of an angle when another one
 * close to it is taken away. */
static int wanted_digits(const tp_evaluation *e) {
  enum { HIGH_BITS = 160, BITS_FOR_ONE_MORE = 16 };
  return e->digits + (e->rung.bits < HIGH_BITS ? 0 : (int)(e->rung.bits / BITS_FOR_ONE_MORE));
}

/* Widths in degrees to either side of the estimate: from what doubles tell apart to 10^-9, or, for
 * more digits than that, from some more than are asked for. */
bool tp_friction_meet(arb_t degrees, const tp_evaluation *e, tp_friction_limit limit, void *context,
                      bool back) {
  enum { NARROWEST = 46, WIDEST = 30, DIGITS_OF_DOUBLE = 11, SPARE = 5 }; /* 2^-46 is 1.4e-14 */
  double start = 0;
  if (!iterate(&start, e, limit, context, back)) return false;
  const int digits = wanted_digits(e);
  const bool many = digits > DIGITS_OF_DOUBLE;
  const slong widest = many ? (slong)(3.33 * (digits + SPARE)) : WIDEST;
  const slong narrowest = many ? widest + (slong)(3.33 * SPARE) : NARROWEST;
  arf_t estimate;
  arb_t interval, image;
  arf_init(estimate);
  arb_init(interval);
  arb_init(image);
  arf_set_d(estimate, start);
  if (many) refine(estimate, e, limit, context, back, digits + 3 * SPARE);
  bool found = false;
  for (slong places = narrowest; places >= widest && !found; places -= 3) {
    arb_set_arf(interval, estimate);
    if (back) arb_neg(interval, interval);
    mag_set_ui_2exp_si(arb_radref(interval), 1, -places);
    tp_friction_at(degrees, e, interval);
    if (back) arb_neg(interval, interval);
    found = limit(image, context, degrees, false) && arb_contains(interval, image);
  }
  arf_clear(estimate);
  arb_clear(interval);
  arb_clear(image);
  return found;
}
