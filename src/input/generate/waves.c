/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Stockham transform of radix 4 with a last step of radix 2; a real series is transformed as half
 * as many complex numbers. Rotations come from half-angle square roots. */

#include "generate/waves.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

static inline tp_complex product(tp_complex a, tp_complex b) {
  return (tp_complex){a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

static inline tp_complex sum(tp_complex a, tp_complex b) {
  return (tp_complex){a.re + b.re, a.im + b.im};
}

static inline tp_complex difference(tp_complex a, tp_complex b) {
  return (tp_complex){a.re - b.re, a.im - b.im};
}

static inline tp_complex quarter_turn(tp_complex a) {
  return (tp_complex){-a.im, a.re};
}

/* turns[p] = exp(2 pi i p / period), up to a quarter of the period: each half by the one turn that
 * parts it from what is known. */
void tp_waves_turns(tp_complex *turns, long period) {
  turns[0] = (tp_complex){1, 0};
  const long quarter = period / 4;
  tp_complex turn = {0, 1};
  turns[quarter] = turn;
  for (long p = quarter / 2; p >= 1; p /= 2) {
    const double half = sqrt((1 + turn.re) / 2);
    turn = (tp_complex){half, turn.im / (2 * half)};
    turns[p] = turn;
  }
  for (long p = 2; p < quarter; p *= 2) {
    for (long k = 1; k < p; k++) turns[p + k] = product(turns[p], turns[k]);
  }
}

/* One step: `count` numbers that are transformed, of which `beside` series lie side by side. */
static void step(tp_complex *to, const tp_complex *from, const tp_complex *turns, long count,
                 long beside, long stride) {
  const long quarter = count / 4;
  for (long p = 0; p < quarter; p++) {
    const tp_complex w = turns[p * stride], w2 = product(w, w), w3 = product(w2, w);
    const tp_complex *a = from + beside * p, *b = a + beside * quarter;
    const tp_complex *c = b + beside * quarter, *d = c + beside * quarter;
    tp_complex *out = to + 4 * beside * p;
    for (long q = 0; q < beside; q++) {
      const tp_complex even = sum(a[q], c[q]), odd = difference(a[q], c[q]);
      const tp_complex other = sum(b[q], d[q]), turned = quarter_turn(difference(b[q], d[q]));
      out[q] = sum(even, other);
      out[q + beside] = product(w, sum(odd, turned));
      out[q + 2 * beside] = product(w2, difference(even, other));
      out[q + 3 * beside] = product(w3, difference(odd, turned));
    }
  }
}

static void last_step(tp_complex *to, const tp_complex *from, long beside) {
  for (long q = 0; q < beside; q++) {
    to[q] = sum(from[q], from[q + beside]);
    to[q + beside] = difference(from[q], from[q + beside]);
  }
}

/* z[j] = sum of z[k] exp(2 pi i j k / count); `stride` of the turns makes theirs of its. */
static void transform(tp_complex *z, tp_complex *room, const tp_complex *turns, long count) {
  const long whole = count;
  tp_complex *from = z, *to = room;
  long beside = 1, stride = 2;
  while (count > 1) {
    if (count == 2) {
      last_step(to, from, beside);
      count = 1;
    } else {
      step(to, from, turns, count, beside, stride);
      count /= 4;
      beside *= 4;
      stride *= 4;
    }
    tp_complex *other = from;
    from = to;
    to = other;
  }
  if (from != z) memcpy(z, from, (size_t)whole * sizeof *z);
}

/* Points at even places become real parts, those at odd ones imaginary parts, of half as many
 * numbers: the transform of c_k + c'_k + i (c_k - c'_k) exp(2 pi i k / period), c'_k the conjugate
 * of c_(half - k). */
void tp_waves_sum(tp_complex *z, tp_complex *room, const tp_complex *turns, long period) {
  const long half = period / 2, quarter = period / 4;
  z[0] = (tp_complex){0, 0};
  for (long k = 1; k < quarter; k++) {
    const tp_complex low = z[k], high = z[half - k], turn = turns[k];
    const tp_complex even = {low.re + high.re, low.im - high.im};
    const tp_complex odd = product(turn, (tp_complex){low.re - high.re, low.im + high.im});
    z[k] = sum(even, quarter_turn(odd));
    z[half - k] = (tp_complex){even.re + odd.im, odd.re - even.im};
  }
  const tp_complex middle = z[quarter];
  z[quarter] = (tp_complex){2 * middle.re, -2 * middle.im};
  transform(z, room, turns, half);
}

/* ln m for m in [1/sqrt 2, sqrt 2]: 2 (s + s^3/3 + ...), s = (m - 1)/(m + 1), |s| < 0.172. */
static double logarithm(double m) {
  static const double terms[] = {1.0 / 19, 1.0 / 17, 1.0 / 15, 1.0 / 13, 1.0 / 11,
                                 1.0 / 9,  1.0 / 7,  1.0 / 5,  1.0 / 3,  1};
  const double s = (m - 1) / (m + 1), square = s * s;
  double sum_of_all = 0;
  for (size_t k = 0; k < sizeof terms / sizeof terms[0]; k++) {
    sum_of_all = sum_of_all * square + terms[k];
  }
  return 2 * s * sum_of_all;
}

/* exp(x), |x| <= 0.35, by its series: 1 / k! from k = 13 on downwards. */
static double exponential(double x) {
  static const double terms[] = {1.0 / 6227020800,
                                 1.0 / 479001600,
                                 1.0 / 39916800,
                                 1.0 / 3628800,
                                 1.0 / 362880,
                                 1.0 / 40320,
                                 1.0 / 5040,
                                 1.0 / 720,
                                 1.0 / 120,
                                 1.0 / 24,
                                 1.0 / 6,
                                 0.5,
                                 1,
                                 1};
  double sum_of_all = 0;
  for (size_t k = 0; k < sizeof terms / sizeof terms[0]; k++)
    sum_of_all = sum_of_all * x + terms[k];
  return sum_of_all;
}

double tp_waves_power(long k, double exponent) {
  static const double ln2 = 0.69314718055994531, least = 0.70710678118654752;
  int twos = 0;
  double m = frexp((double)k, &twos);
  if (m < least) {
    m *= 2;
    twos--;
  }
  const double log = -exponent * (twos * ln2 + logarithm(m));
  const double whole = floor(log / ln2 + 0.5);
  return ldexp(exponential(log - whole * ln2), (int)whole);
}
