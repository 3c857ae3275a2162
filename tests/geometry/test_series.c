/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Series by the GNU Scientific Library: transforms of every power of two against waves that are
 * known, also where they are put together from shorter ones; lines and deviations in closed form;
 * and what GSL would answer by ending the process: here its handler fails the test. */

#include "number/series.h"
#include "suite.h"

#include <float.h>
#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>

static const double two_pi = 6.283185307179586;

static void refuse(const char *reason, const char *file, int line, int number) {
  ck_abort_msg("%s:%d: GSL's handler was called: %s (%d)", file, line, reason, number);
}

/* a cos(2 pi m k / n + phase), 0 < m < n / 2: |Y_m| = a n / 2, and nothing elsewhere; with a mean
 * c, |Y_0| = c n. An error of some log2(n) roundings of the largest amplitude is let pass. */
START_TEST(waves) {
  enum { LONGEST = 1 << 18 };
  double *values = malloc((LONGEST + LONGEST / 2 + 1) * sizeof *values);
  double *powers = values + LONGEST;
  ck_assert_ptr_nonnull(values);
  for (size_t count = 4; count <= LONGEST; count *= 2) {
    const size_t wave = count / 2 - 1 - (count / 7) % (count / 2 - 1);
    for (size_t k = 0; k < count; k++) {
      const double turns = (double)(wave * k % count) / (double)count;
      values[k] = 0.75 + 3 * cos(two_pi * turns + 0.4);
    }
    ck_assert(tp_series_powers(powers, values, count));
    const double n = (double)count, largest = 1.5 * n;
    const double room = 8 * log2(n) * DBL_EPSILON * largest;
    for (size_t j = 0; j <= count / 2; j++) {
      const double truth = j == 0 ? 0.75 * n : j == wave ? 1.5 * n : 0;
      ck_assert_msg(fabs(sqrt(powers[j]) - truth) <= room, "%zu: %zu: %g for %g", count, j,
                    sqrt(powers[j]), truth);
    }
  }
  free(values);
}
END_TEST

START_TEST(shortest) {
  double values[2] = {3, 1}, powers[2] = {-1, -1};
  ck_assert(tp_series_powers(powers, values, 2));
  ck_assert_double_eq(powers[0], 16);
  ck_assert_double_eq(powers[1], 4);
}
END_TEST

START_TEST(other_counts_are_refused) {
  double values[8] = {0}, powers[5] = {7, 7, 7, 7, 7};
  static const size_t counts[] = {0, 1, 3, 5, 6, 7};
  for (size_t k = 0; k < sizeof counts / sizeof counts[0]; k++) {
    ck_assert(!tp_series_powers(powers, values, counts[k]));
  }
  ck_assert_double_eq(powers[0], 7);
}
END_TEST

START_TEST(lines) {
  static const double x[] = {-2, 0, 1, 5}, y[] = {8, 2, -1, -13}, off[] = {9, 1, -1, -13};
  tp_series_line line = {.slope = 7};
  ck_assert(!tp_series_fit(&line, x, y, 1) && !tp_series_fit(&line, x, y, 0));
  static const double alike[] = {3, 3, 3};
  ck_assert(!tp_series_fit(&line, alike, y, 3));
  ck_assert_double_eq(line.slope, 7);
  ck_assert(tp_series_fit(&line, x, y, 4));
  ck_assert_double_eq_tol(line.slope, -3, 1e-14);
  ck_assert_double_eq_tol(line.at_zero, 2, 1e-14);
  ck_assert_double_eq_tol(line.spread_x, 26, 1e-13);
  ck_assert_double_eq_tol(line.residuals, 0, 1e-25);
  /* residuals 1, -1, 0, 0 of the same line: x about its mean times them is -2, over 26 */
  ck_assert(tp_series_fit(&line, x, off, 4));
  ck_assert_double_eq_tol(line.slope, -3 - 2.0 / 26, 1e-14);
  ck_assert_double_eq_tol(line.residuals, 2 - 4.0 / 26, 1e-13);
}
END_TEST

START_TEST(deviations) {
  static const double values[] = {1, 3, 1, 3};
  ck_assert_double_eq_tol(tp_series_deviation(values, 4), sqrt(4.0 / 3), 1e-15);
  ck_assert_double_eq_tol(tp_series_deviation(values, 2), sqrt(2), 1e-15);
}
END_TEST

SUITE(series) {
  gsl_set_error_handler(refuse);
  Suite *suite = suite_create("series");
  TCase *tests = tcase_create("series");
  tcase_set_timeout(tests, 600);
  tcase_add_test(tests, waves);
  tcase_add_test(tests, shortest);
  tcase_add_test(tests, other_counts_are_refused);
  tcase_add_test(tests, lines);
  tcase_add_test(tests, deviations);
  suite_add_tcase(suite, tests);
  return suite;
}
