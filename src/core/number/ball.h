/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Balls (Arb) where a double is not enough, and their certified way back to doubles and decimals.
 *
 * Angles are in degrees. Multiples of 45 degrees are the only rational angles with a rational
 * tangent (Niven), so they are the only ones at which a comparison of a rational angle with
 * atan2 of rationals can tie; the functions here return them exactly. Every other comparison is
 * decided by enough precision. */

#ifndef TP_NUMBER_BALL_H
#define TP_NUMBER_BALL_H

#include "number/near.h"
#include "topple.h"

#include <arb.h>
#include <flint/fmpq.h>

/* Bits that tell so many decimal digits, a little more than it takes: 10 < 2^3.33. */
static inline double tp_digits_bits(int digits) {
  static const double bits_of_one = 3.33; /* log2(10) = 3.3219... */
  return bits_of_one * digits;
}

/* The other way: decimal digits of so many bits. */
static inline double tp_bits_digits(double bits) {
  static const double log10_of_2 = 0.30102999566398120;
  return log10_of_2 * bits;
}

/* 1 above zero, -1 below it; 0 where it is zero or not known. */
static inline int tp_ball_sign(const arb_t ball) {
  return arb_is_positive(ball) ? 1 : arb_is_negative(ball) ? -1 : 0;
}

/* The double nearest to a finite number, half to even; an infinity beyond all. */
double tp_ball_nearest(const arf_struct *number);

/* Enclosure of the ball by a double and a double bound, both rounded the safe way. */
tp_bounded tp_ball_bounded(const arb_t ball);

/* The same, less closely and for much less. */
tp_near tp_ball_near(const arb_t ball);

/* And of one number that is a double, exactly that. */
tp_near tp_ball_near_exact(const arb_t ball);

/* Of a whole number: exact up to 2^52. */
tp_near tp_near_whole(const fmpz_t number);

/* log2 of a magnitude, to some 1e-8; -INFINITY of 0. */
double tp_mag_log2(const mag_t size);

/* The least whole log2 above a size: exact, hence the same under a scaling by a power of two but
 * for that power. An infinity for 0 and for infinity, which FLINT takes for 2^(2^62). */
double tp_mag_log2_above(const mag_t size);

/* Likewise above the size of all of a ball. */
double tp_ball_log2_above(const arb_t ball);

/* Is the truth known to 10^-digits of its size? An exact zero is. */
bool tp_ball_certain(const arb_t ball, int digits);

/* value with |truth - value| <= error. */
void tp_ball_set_bounded(arb_t ball, double value, double error);

/* atan2(y, x) in degrees, in (-180, 180]; exact where y and x are exact and the angle is a multiple
 * of 45 degrees. (0, 0), exactly, gives 0. */
void tp_ball_atan2_degrees(arb_t angle, const arb_t y, const arb_t x, long bits);

/* Sine and cosine of an angle in degrees. */
void tp_ball_sin_cos(arb_t sine, arb_t cosine, const arb_t degrees, long bits);

/* The same of a rational angle; exact where they are 0 or 1. */
void tp_ball_sin_cos_degrees(arb_t sine, arb_t cosine, const fmpq_t degrees, long bits);

#endif
