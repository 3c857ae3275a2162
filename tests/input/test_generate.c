/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The room of generated profiles from within: its random numbers are the published ones, its sums
 * of waves those of GSL's transform, its powers those of the mathematical library, its coordinates
 * those of rationals. */

#include "generate/generate.h"
#include "generate/random.h"
#include "generate/ticks.h"
#include "generate/waves.h"
#include "random_numbers.h"
#include "suite.h"

#include <gsl/gsl_fft_complex.h>
#include <math.h>
#include <string.h>

enum { LONGEST = 4096, ROUNDS = 3000 };

/* What SplitMix64 gives from the state 0 on, as its authors' program prints it. */
START_TEST(numbers) {
  ck_assert(tp_random_bits(0, 0) == UINT64_C(0xe220a8397b1dcdaf));
  ck_assert(tp_random_bits(0, 1) == UINT64_C(0x6e789e6aa1b965f4));
  ck_assert(tp_random_bits(0, 2) == UINT64_C(0x06c45d188009454f));
  ck_assert_double_eq(tp_random_even(0), -1 + 0x1p-32);
  ck_assert_double_eq(tp_random_even(UINT32_MAX), 1 - 0x1p-32);
}
END_TEST

/* GSL's backward transform of a whole period, each wave with its conjugate. */
START_TEST(waves) {
  static tp_complex z[LONGEST / 2], room[LONGEST / 2], turns[LONGEST / 4 + 1];
  static double all[2 * LONGEST];
  for (long period = 4; period <= LONGEST; period *= 2) {
    double squares = 0;
    memset(all, 0, sizeof all);
    memset(z, 0, sizeof z);
    for (long k = 1; k < period / 2; k++) {
      const uint64_t bits = tp_random_bits(5, (uint64_t)(period + k));
      z[k] = (tp_complex){tp_random_even((uint32_t)bits), tp_random_even((uint32_t)(bits >> 32))};
      all[2 * k] = all[2 * (period - k)] = z[k].re;
      all[2 * k + 1] = z[k].im;
      all[2 * (period - k) + 1] = -z[k].im;
      squares += 2 * (z[k].re * z[k].re + z[k].im * z[k].im);
    }
    ck_assert_int_eq(gsl_fft_complex_radix2_backward(all, 1, (size_t)period), 0);
    tp_waves_turns(turns, period);
    tp_waves_sum(z, room, turns, period);
    for (long j = 0; j < period; j++) {
      const double own = j % 2 == 0 ? z[j / 2].re : z[j / 2].im;
      ck_assert_double_le(fabs(own - all[2 * j]), 1e-13 * (1 + sqrt(squares) * (double)period));
    }
  }
}
END_TEST

START_TEST(powers) {
  for (long k = 1; k < 100000; k += 1 + k / 7) {
    for (int part = 0; part < 14; part++) {
      const double exponent = 0.51 + 0.07 * part;
      const double truth = pow((double)k, -exponent);
      ck_assert_double_le(fabs(tp_waves_power(k, exponent) - truth), 1e-13 * truth);
    }
  }
}
END_TEST

/* origin + m unit, of decimals, of fractions, and of numbers that no word holds. */
START_TEST(coordinates) {
  random_numbers state = random_numbers_from(11);
  fmpq_t origin, unit, own, truth;
  fmpq_init(origin);
  fmpq_init(unit);
  fmpq_init(own);
  fmpq_init(truth);
  for (int round = 0; round < ROUNDS; round++) {
    static const long below[] = {1, 2, 1000, 10000000, 3, 7000, 12};
    fmpq_set_si(origin, draw_below(&state, 2001) - 1000, (ulong)below[draw_below(&state, 7)]);
    fmpq_set_si(unit, 1 + draw_below(&state, 50), (ulong)below[draw_below(&state, 7)]);
    if (round % 5 == 0) fmpq_div_2exp(unit, unit, 90);
    const long m = draw_below(&state, 2000001) - 1000000;
    tp_ticks ticks;
    tp_ticks_init(&ticks, origin, unit);
    tp_ticks_at(own, &ticks, m);
    fmpq_mul_si(truth, unit, m);
    fmpq_add(truth, truth, origin);
    ck_assert(fmpq_is_canonical(own));
    ck_assert(fmpq_equal(own, truth));
    tp_ticks_clear(&ticks);
  }
  fmpq_clear(origin);
  fmpq_clear(unit);
  fmpq_clear(own);
  fmpq_clear(truth);
}
END_TEST

/* The power of ten just below a millionth, and the nearest multiple, of two the greater. */
START_TEST(decimals) {
  static const struct {
    long above;
    ulong below;
    ulong tick; /* one over it */
  } sizes[] = {{1, 1, 1000000},     {9, 1, 1000000},  {10, 1, 100000},
               {99, 100, 10000000}, {1, 3, 10000000}, {999999, 1, 10}};
  fmpq_t size, unit, truth;
  fmpq_init(size);
  fmpq_init(unit);
  fmpq_init(truth);
  for (size_t k = 0; k < sizeof sizes / sizeof sizes[0]; k++) {
    fmpq_set_si(size, sizes[k].above, sizes[k].below);
    tp_ticks_millionth(unit, size);
    fmpq_set_si(truth, 1, sizes[k].tick);
    ck_assert(fmpq_equal(unit, truth));
  }
  fmpq_set_si(unit, 1, 10);
  static const long rounded[][2] = {{25, 3}, {-25, -2}, {24, 2}, {-26, -3}, {30, 3}};
  for (size_t k = 0; k < sizeof rounded / sizeof rounded[0]; k++) {
    fmpq_set_si(size, rounded[k][0], 100);
    tp_ticks_round(size, unit);
    fmpq_set_si(truth, rounded[k][1], 10);
    ck_assert(fmpq_equal(size, truth));
  }
  fmpq_clear(size);
  fmpq_clear(unit);
  fmpq_clear(truth);
}
END_TEST

SUITE(generate) {
  Suite *suite = suite_create("generate");
  TCase *cases = tcase_create("generate");
  tcase_set_timeout(cases, 60);
  tcase_add_test(cases, numbers);
  tcase_add_test(cases, waves);
  tcase_add_test(cases, powers);
  tcase_add_test(cases, coordinates);
  tcase_add_test(cases, decimals);
  suite_add_tcase(suite, cases);
  return suite;
}
