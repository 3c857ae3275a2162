/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Conversions between balls and doubles with proven bounds, by the words of the midpoint where
 * possible; sines, cosines and arctangents in degrees, exact at multiples of 45 (docs/mechanics.md
 * section 10). */

#include "number/ball.h"

#include "number/binary.h"
#include "number/word.h"

#include <float.h>
#include <math.h>

/* Well within the range of doubles, and no pointer. */
static bool is_moderate(fmpz exponent) {
  enum { MOST = 900 };
  return exponent < MOST && exponent > -MOST;
}

/* By hand, as arf_get_d goes by way of MPFR. */
double tp_ball_nearest(const arf_struct *number) {
  enum { LOST_BITS = 64 - DBL_MANT_DIG };
  mp_srcptr words;
  mp_size_t count;
  if (arf_is_special(number) || !is_moderate(ARF_EXP(number))) {
    return arf_get_d(number, ARF_RND_NEAR);
  }
  ARF_GET_MPN_READONLY(words, count, number);
  const uint64_t top = tp_word_top(words, count), half = (uint64_t)1 << (LOST_BITS - 1);
  const uint64_t lost = top & (2 * half - 1);
  uint64_t kept = top >> LOST_BITS;
  /* the lowest word is not zero: where there is one below the top, something is lost in it */
  if (lost > half || (lost == half && (count > TP_WORD_LIMBS || (kept & 1) != 0))) kept++;
  const double size = (double)kept * tp_two_to(ARF_EXP(number) - DBL_MANT_DIG);
  return ARF_SGNBIT(number) ? -size : size;
}

/* Its 30 bits are a double. */
static double above(const mag_t size) {
  if (is_moderate(MAG_EXP(size)))
    return (double)MAG_MAN(size) * tp_two_to(MAG_EXP(size) - MAG_BITS);
  arf_t exact;
  arf_init(exact);
  arf_set_mag(exact, size);
  const double result = arf_get_d(exact, ARF_RND_UP);
  arf_clear(exact);
  return result;
}

/* What the nearest double leaves out of a number of 64 bits, as arf_get_mag bounds it; false for
 * any other number. */
static bool rest_of_word(mag_t rest, const arf_struct *number) {
  mp_srcptr words;
  mp_size_t count;
  if (arf_is_special(number) || !is_moderate(ARF_EXP(number))) return false;
  ARF_GET_MPN_READONLY(words, count, number);
  if (count > TP_WORD_LIMBS) return false;
  const uint64_t unit = (uint64_t)1 << (64 - DBL_MANT_DIG);
  const uint64_t lost = tp_word_top(words, count) & (unit - 1);
  const uint64_t size = lost > unit / 2 ? unit - lost : lost;
  if (size == 0) {
    mag_zero(rest);
    return true;
  }
  const int zeros = __builtin_clzll(size);
  MAG_MAN(rest) = (mp_limb_t)((size << zeros) >> (64 - MAG_BITS)) + 1;
  fmpz_set_si(MAG_EXPREF(rest), ARF_EXP(number) - zeros);
  return true;
}

tp_bounded tp_ball_bounded(const arb_t ball) {
  if (!arb_is_finite(ball)) return (tp_bounded){.error = INFINITY};
  tp_bounded result = {.value = tp_ball_nearest(arb_midref(ball))};
  if (!isfinite(result.value)) {
    return (tp_bounded){.value = copysign(DBL_MAX, result.value), .error = INFINITY};
  }
  mag_t error;
  mag_init(error);
  if (!rest_of_word(error, arb_midref(ball))) {
    arf_t rest;
    arf_init(rest);
    arf_set_d(rest, result.value);
    arf_sub(rest, rest, arb_midref(ball), ARF_PREC_EXACT, ARF_RND_UP);
    arf_get_mag(error, rest);
    arf_clear(rest);
  }
  mag_add(error, error, arb_radref(ball));
  result.error = above(error);
  mag_clear(error);
  return result;
}

tp_near tp_ball_near(const arb_t ball) {
  if (!arb_is_finite(ball)) return (tp_near){.error = INFINITY};
  const double value = tp_ball_nearest(arb_midref(ball));
  const double radius = mag_is_zero(arb_radref(ball)) ? 0 : above(arb_radref(ball));
  return tp_near_of(value, radius + fabs(value) * DBL_EPSILON);
}

tp_near tp_ball_near_exact(const arb_t ball) {
  if (arb_is_exact(ball) && arb_is_finite(ball)) {
    const double value = tp_ball_nearest(arb_midref(ball));
    if (arf_cmp_d(arb_midref(ball), value) == 0) return (tp_near){value, 0};
  }
  return tp_ball_near(ball);
}

tp_near tp_near_whole(const fmpz_t number) {
  const double value = tp_word_is_small(number) ? (double)tp_word_get(number) : fmpz_get_d(number);
  const bool exact = fabs(value) < 1 / DBL_EPSILON;
  return (tp_near){value, exact ? 0 : fabs(value) * DBL_EPSILON};
}

double tp_mag_log2(const mag_t size) {
  if (mag_is_zero(size)) return -INFINITY;
  return log2((double)MAG_MAN(size)) - MAG_BITS + fmpz_get_d(MAG_EXPREF(size));
}

double tp_mag_log2_above(const mag_t size) {
  if (mag_is_inf(size)) return INFINITY;
  return mag_is_zero(size) ? -INFINITY : fmpz_get_d(MAG_EXPREF(size));
}

double tp_ball_log2_above(const arb_t ball) {
  mag_t size;
  mag_init(size);
  arb_get_mag(size, ball);
  const double log2_size = tp_mag_log2_above(size);
  mag_clear(size);
  return log2_size;
}

bool tp_ball_certain(const arb_t ball, int digits) {
  if (arb_is_exact(ball)) return arb_is_finite(ball);
  /* arb_rel_accuracy_bits is -log2 of twice the relative radius. */
  return arb_rel_accuracy_bits(ball) > (slong)tp_digits_bits(digits) + 2;
}

void tp_ball_set_bounded(arb_t ball, double value, double error) {
  arf_set_d(arb_midref(ball), value);
  mag_set_d(arb_radref(ball), error); /* an upper bound */
}

/* k with angle = 45 k degrees where y and x are exact and it is one; 8 otherwise. */
static int octant(const arb_t y, const arb_t x) {
  const int none = 8;
  if (!arb_is_exact(y) || !arb_is_exact(x)) return none;
  const int side_y = arf_sgn(arb_midref(y)), side_x = arf_sgn(arb_midref(x));
  if (side_y == 0) return side_x > 0 ? 0 : side_x < 0 ? 4 : none;
  if (side_x == 0) return 2 * side_y;
  if (arf_cmpabs(arb_midref(y), arb_midref(x)) != 0) return none;
  return side_y * (side_x > 0 ? 1 : 3);
}

void tp_ball_atan2_degrees(arb_t angle, const arb_t y, const arb_t x, long bits) {
  const int eighths = octant(y, x);
  if (eighths < 8) {
    arb_set_si(angle, 45L * eighths);
    return;
  }
  arb_t pi;
  arb_init(pi);
  arb_atan2(angle, y, x, bits);
  arb_const_pi(pi, bits);
  arb_mul_ui(angle, angle, 180, bits);
  arb_div(angle, angle, pi, bits);
  arb_clear(pi);
}

void tp_ball_sin_cos(arb_t sine, arb_t cosine, const arb_t degrees, long bits) {
  arb_t turn;
  arb_init(turn);
  arb_div_ui(turn, degrees, 180, bits);
  arb_sin_cos_pi(sine, cosine, turn, bits);
  arb_clear(turn);
}

void tp_ball_sin_cos_degrees(arb_t sine, arb_t cosine, const fmpq_t degrees, long bits) {
  fmpq_t turn;
  fmpz_t quarters;
  fmpq_init(turn);
  fmpz_init_set_ui(quarters, 180);
  fmpq_div_fmpz(turn, degrees, quarters);
  arb_sin_cos_pi_fmpq(sine, cosine, turn, bits);
  fmpz_set_ui(quarters, 90);
  fmpq_div_fmpz(turn, degrees, quarters);
  if (fmpz_is_one(fmpq_denref(turn))) {
    static const int sines[4] = {0, 1, 0, -1};
    const unsigned long quarter = fmpz_fdiv_ui(fmpq_numref(turn), 4);
    arb_set_si(sine, sines[quarter]);
    arb_set_si(cosine, sines[(quarter + 1) % 4]);
  }
  fmpq_clear(turn);
  fmpz_clear(quarters);
}
