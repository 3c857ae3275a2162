/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Powers of two and the larger of two doubles without a call: for loops over all columns of a
 * base, where ldexp, frexp and fmax of the C library take as long as the sums. */

#ifndef TP_NUMBER_BINARY_H
#define TP_NUMBER_BINARY_H

#include <float.h>
#include <stdint.h>
#include <string.h>

enum { TP_BINARY_BIAS = DBL_MAX_EXP - 1, TP_BINARY_PLACES = DBL_MANT_DIG - 1 };

/* 2^exponent, a normal number: an exponent from DBL_MIN_EXP - 1 to DBL_MAX_EXP - 1. */
static inline double tp_two_to(long exponent) {
  const uint64_t bits = (uint64_t)(exponent + TP_BINARY_BIAS) << TP_BINARY_PLACES;
  double power;
  memcpy(&power, &bits, sizeof power);
  return power;
}

/* The exponent that frexp gives: size = f 2^exponent, 1/2 <= f < 1; of a normal number above 0. */
static inline long tp_binary_exponent(double size) {
  uint64_t bits;
  memcpy(&bits, &size, sizeof bits);
  return (long)(bits >> TP_BINARY_PLACES) - TP_BINARY_BIAS + 1;
}

/* The larger; `held` where the other is no number. */
static inline double tp_larger(double held, double other) {
  return other > held ? other : held;
}

#endif
