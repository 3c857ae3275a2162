/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The tilt at which a block begins to move with the friction that it has there, and that friction:
 * a search in doubles, and its proof. */

#include "evaluation/friction.h"
#include "number/ball.h"
#include "number/judge.h"
#include "number/root.h"

#include <math.h>

typedef struct meeting {
  const tp_evaluation *e;
  tp_friction_limit limit;
  void *context;
  bool back;
} meeting;

/* The friction at a tilt, or at those of a ball, and the tilt at which the block begins to move
 * with it.
 */
static bool image_of(arb_t image, arb_t friction, const meeting *m, const arb_t tilt,
                     bool estimate) {
  arb_set(image, tilt);
  if (m->back) arb_neg(image, image);
  tp_friction_at(friction, m->e, image);
  return m->limit(image, m->context, friction, estimate);
}

static bool estimate_image(double *image, const meeting *m, double tilt) {
  arb_t at, friction, own;
  arb_init(at);
  arb_init(friction);
  arb_init(own);
  arb_set_d(at, tilt);
  const bool found = image_of(own, friction, m, at, true);
  if (found) *image = arf_get_d(arb_midref(own), ARF_RND_NEAR);
  arb_clear(at);
  arb_clear(friction);
  arb_clear(own);
  return found;
}

/* By how much the image lies above the tilt. */
static bool rise_at(double *rise, void *context, double tilt) {
  double image = 0;
  if (!estimate_image(&image, context, tilt)) return false;
  *rise = image - tilt;
  return true;
}

/* Between two tilts, the one below its image, the other above, until doubles do not tell more. */
static bool meet_between(double *tilt, meeting *m, tp_root_end one, tp_root_end other) {
  enum { MOST_VALUES = 400 };
  const tp_root_search search = {.value = rise_at, .context = m, .most = MOST_VALUES};
  const bool ordered = one.x < other.x;
  tp_root root;
  if (!tp_root_find(&root, &search, ordered ? one : other, ordered ? other : one)) return false;
  *tilt = root.low + (root.high - root.low) / 2;
  return true;
}

/* Where the friction that it has level does not hold it there: at a tilt below level, and at no
 * other above it, though friction grows as the stress falls and might hold it again at one. */
static bool meet_below(double *tilt, meeting *m, double image_level) {
  static const double steepest = 90;
  double image = 0;
  if (!estimate_image(&image, m, -steepest)) return false;
  *tilt = -steepest;
  if (image <= -steepest) return true;
  return meet_between(tilt, m, (tp_root_end){-steepest, image + steepest},
                      (tp_root_end){0, image_level});
}

/* By turns friction from tilt and tilt from friction: where the tilt depends on friction less than
 * friction does on stress, the steps shrink. Else they go to and fro about it, and the two last
 * tilts have it between them; or go round without that for ever: through one that was marked, the
 * marks being twice as far apart each time (Brent). */
static bool iterate(double *tilt, meeting *m) {
  enum { MOST_STEPS = 200, PATIENCE = 24 };
  static const double near_enough = 1e-14;
  tp_root_end before = {0, 0};
  double mark = NAN;
  *tilt = 0;
  for (int k = 0, next_mark = 1; k < MOST_STEPS; k++) {
    double image = 0;
    if (!estimate_image(&image, m, *tilt)) return false;
    const tp_root_end own = {*tilt, image - *tilt};
    if (k == 0 && image < 0) return meet_below(tilt, m, image);
    if (k >= PATIENCE && own.value * before.value < 0) return meet_between(tilt, m, before, own);
    *tilt = image;
    if (fabs(own.value) <= near_enough * fabs(image)) return true;
    if (image == mark) return false;
    if (k == next_mark) {
      mark = image;
      next_mark *= 2;
    }
    before = own;
  }
  return false;
}

/* From doubles to 10^-digits degrees, by secants of image less tilt: it has no derivative, as
 * Newton's method of arb_calc would want it. Search alone: the proof comes after it. */
static void refine(arf_t tilt, const meeting *m, int digits) {
  enum { MOST_STEPS = 64 };
  const long bits = m->e->rung.bits;
  arb_t at, friction, image;
  arf_t step, value, before;
  arb_init(at);
  arb_init(friction);
  arb_init(image);
  arf_init(step);
  arf_init(value);
  arf_init(before);
  for (int k = 0; k < MOST_STEPS; k++) {
    arb_set_arf(at, tilt);
    if (!image_of(image, friction, m, at, false)) break;
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
    if (arf_cmpabs_2exp_si(step, -(slong)tp_digits_bits(digits)) < 0) break;
    arf_add(tilt, tilt, step, bits, ARF_RND_NEAR);
  }
  arb_clear(at);
  arb_clear(friction);
  arb_clear(image);
  arf_clear(step);
  arf_clear(value);
  arf_clear(before);
}

/* Sign of image less tilt at an end of the interval: above zero, the block holds there. */
static int sign_at_end(const meeting *m, const arb_t interval, bool upper) {
  const long bits = m->e->rung.bits;
  arf_t end;
  arb_t at, friction, image;
  arf_init(end);
  arb_init(at);
  arb_init(friction);
  arb_init(image);
  arf_set_mag(end, arb_radref(interval));
  if (!upper) arf_neg(end, end);
  arf_add(end, arb_midref(interval), end, ARF_PREC_EXACT, ARF_RND_DOWN);
  arb_set_arf(at, end);
  int sign = 0;
  if (image_of(image, friction, m, at, false)) {
    arb_sub(image, image, at, bits);
    sign = tp_ball_sign(image);
  }
  arf_clear(end);
  arb_clear(at);
  arb_clear(friction);
  arb_clear(image);
  return sign;
}

/* Is it within the interval? The friction there is left in `degrees`, and what the limit leaves is
 * of that. Open where the limit does not tell, nor would with a wider one. */
static tp_answer lies_within(arb_t degrees, const meeting *m, const arb_t interval) {
  arb_t image;
  arb_init(image);
  tp_answer within = TP_OPEN;
  if (image_of(image, degrees, m, interval, false)) {
    within = arb_contains(interval, image) ? TP_YES : TP_NO;
    if (within == TP_NO && sign_at_end(m, interval, false) > 0 &&
        sign_at_end(m, interval, true) < 0) {
      within = image_of(image, degrees, m, interval, false) ? TP_YES : TP_OPEN;
    }
  }
  arb_clear(image);
  return within;
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
  meeting m = {e, limit, context, back};
  double start = 0;
  if (!iterate(&start, &m)) return false;
  const int digits = wanted_digits(e);
  const bool many = digits > DIGITS_OF_DOUBLE;
  const slong widest = many ? (slong)tp_digits_bits(digits + SPARE) : WIDEST;
  const slong narrowest = many ? widest + (slong)tp_digits_bits(SPARE) : NARROWEST;
  arf_t estimate;
  arb_t interval;
  arf_init(estimate);
  arb_init(interval);
  arf_set_d(estimate, start);
  if (many) refine(estimate, &m, digits + 3 * SPARE);
  tp_answer found = TP_NO;
  for (slong exponent = narrowest; exponent >= widest && found == TP_NO; exponent -= 3) {
    arb_set_arf(interval, estimate);
    mag_set_ui_2exp_si(arb_radref(interval), 1, -exponent);
    found = lies_within(degrees, &m, interval);
  }
  arf_clear(estimate);
  arb_clear(interval);
  return found == TP_YES;
}
