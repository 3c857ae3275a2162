/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A sum of waves at evenly spaced points by the fast Fourier transform, to the same bits on every
 * machine.
 *
 * GSL's transforms take their sines from the mathematical library, and compilers for some machines
 * contract their products and sums: last bits differ, and rounded coordinates with them. Here
 * cosines and sines come of square roots (half angles) and products, and all else of + - *, each
 * correctly rounded, in one order; contraction is off for all of Topple (meson.build). Radix 4 by
 * Stockham, which sorts as it goes (Van Loan, Computational Frameworks for the FFT, 1992, section
 * 1.7); its test compares with GSL. */

#ifndef TP_GENERATE_WAVES_H
#define TP_GENERATE_WAVES_H

#include <stdbool.h>

typedef struct tp_complex {
  double re, im;
} tp_complex;

/* z[j] = 2 Re sum over k = 1 ... period / 2 - 1 of c_k exp(2 pi i j k / period), j < period, read
 * as doubles one after the other; on entry z[k] is c_k, z[0] is not read. `period` is a power of
 * two of at least 4; z and `room` have period / 2 numbers each, `turns` period / 4 + 1, which
 * tp_waves_turns fills. Errs by some log2(period) roundings of the root of the sum of |c_k|^2. */
void tp_waves_turns(tp_complex *turns, long period);
void tp_waves_sum(tp_complex *z, tp_complex *room, const tp_complex *turns, long period);

/* k^-exponent, k >= 1, exponent in (0, 2), to some 1e-14, by + - * / alone. */
double tp_waves_power(long k, double exponent);

#endif
