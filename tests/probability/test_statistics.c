/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What samples tell: Wilson's intervals as published and by their definition, Student's t as in
 * tables, intervals of quantiles by binomial probabilities of GSL, running estimates against those
 * of all samples at once, rank correlations against sums over ranks. */

#include "statistics/convergence.h"
#include "statistics/proportion.h"
#include "statistics/quantiles.h"
#include "statistics/rank_correlation.h"
#include "statistics/score.h"
#include "suite.h"

#include <gsl/gsl_cdf.h>
#include <math.h>

static void near(double value, double truth, double room) {
  ck_assert_msg(fabs(value - truth) <= room, "%.17g for %.17g", value, truth);
}

/* Newcombe, Statistics in Medicine 17 (1998) 857-872, table I, the score method. */
START_TEST(wilson_as_published) {
  static const struct {
    uint64_t count, samples;
    double low, high;
  } rows[] = {{81, 263, 0.2553, 0.3662},
              {15, 148, 0.0624, 0.1605},
              {0, 20, 0, 0.1611},
              {1, 29, 0.0061, 0.1718}};
  for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
    const tp_estimate e = tp_proportion(rows[k].count, rows[k].samples, 0.95);
    near(e.low, rows[k].low, 5e-5);
    near(e.high, rows[k].high, 5e-5);
    near(e.value, (double)rows[k].count / (double)rows[k].samples, 1e-16);
  }
}
END_TEST

/* At an end the count is z deviations off. */
START_TEST(wilson_as_defined) {
  static const uint64_t samples[] = {1, 2, 10, 1000, 1000000007};
  static const double confidences[] = {0.5, 0.9, 0.95, 0.999};
  for (size_t j = 0; j < 20; j++) {
    const uint64_t all = samples[j / 4];
    const double n = (double)all, z = -gsl_cdf_ugaussian_Pinv((1 - confidences[j % 4]) / 2);
    for (int part = 0; part <= 10; part++) {
      const uint64_t count = all * (uint64_t)part / 10;
      const tp_estimate e = tp_proportion(count, all, confidences[j % 4]);
      ck_assert(e.low >= 0 && e.low <= e.value && e.value <= e.high && e.high <= 1);
      const double low = ((double)count - n * e.low) / sqrt(n * e.low * (1 - e.low));
      const double high = (n * e.high - (double)count) / sqrt(n * e.high * (1 - e.high));
      if (count > 0) near(low, z, 1e-6);
      if (count < all) near(high, z, 1e-6);
      if (count == 0) ck_assert(e.low == 0);
      if (count == all) ck_assert(e.high == 1);
    }
  }
  const tp_estimate none = tp_proportion(0, 0, 0.95);
  ck_assert(isnan(none.value) && none.low == 0 && none.high == 1);
}
END_TEST

/* All together the confidence of 0.95 takes 0.99 for each of five. */
START_TEST(several_categories) {
  static const uint64_t counts[] = {700, 200, 90, 10, 0};
  tp_estimate own[5];
  tp_proportions(own, counts, 5, 1000, 0.95);
  for (size_t k = 0; k < 5; k++) {
    const tp_estimate alone = tp_proportion(counts[k], 1000, 0.99);
    near(own[k].low, alone.low, 1e-14);
    near(own[k].high, alone.high, 1e-14);
  }
  const uint64_t wanted = tp_proportion_samples(200, 1000, 0.95, 0.01);
  const tp_estimate then = tp_proportion(wanted / 5, wanted, 0.95);
  near((then.high - then.low) / 2, 0.01, 1e-4);
}
END_TEST

START_TEST(student) {
  static const double table[][2] = {{1, 12.706204736174694},
                                    {4, 2.7764451051977934},
                                    {30, 2.0422724563012373},
                                    {1000, 1.9623390808264074}};
  for (size_t k = 0; k < 4; k++) near(tp_student_score(0.95, table[k][0]), table[k][1], 1e-11);
  near(tp_student_score(0.99, 2), 9.9248432009182928, 1e-11);
  near(tp_student_score(0.95, 1e6), 1.9599639845400542, 1e-4);
  static const double values[] = {0.2, 0.3, 0.25, 0.35};
  const tp_estimate e = tp_mean_of_replicates(values, 4, 0.95);
  near(e.value, 0.275, 1e-15);
  near(e.high, 0.275 + 3.182446305284263 * sqrt(0.0125 / 3 / 4), 1e-12);
}
END_TEST

/* The ranks are the innermost whose tails have no more than asked for. */
START_TEST(quantile_intervals) {
  enum { MOST = 2000 };
  static double values[MOST];
  static const double probabilities[] = {0.01, 0.25, 0.5, 0.9};
  for (int k = 0; k < MOST; k++) values[k] = k + 1;
  const tp_estimate median = tp_column_quantile(values, 10, 0.5, 0.95);
  ck_assert(median.value == 5.5 && median.low == 2 && median.high == 9);
  for (unsigned n = 1; n <= MOST; n = n < 40 ? n + 1 : 2 * n) {
    for (size_t k = 0; k < 4; k++) {
      const double p = probabilities[k];
      const tp_estimate e = tp_column_quantile(values, n, p, 0.9);
      near(e.value, 1 + p * (n - 1), 1e-12 * n);
      ck_assert(e.low <= e.value && e.value <= e.high);
      if (isfinite(e.low) && e.low < e.value) {
        const unsigned low = (unsigned)e.low;
        ck_assert(gsl_cdf_binomial_P(low - 1, p, n) <= 0.05);
        ck_assert(gsl_cdf_binomial_P(low, p, n) > 0.05 || low + 1 > e.value);
      } else if (isinf(e.low)) {
        ck_assert(gsl_cdf_binomial_P(0, p, n) > 0.05);
      }
      if (isfinite(e.high) && e.high > e.value) {
        const unsigned high = (unsigned)e.high;
        ck_assert(gsl_cdf_binomial_Q(high - 1, p, n) <= 0.05);
        ck_assert(gsl_cdf_binomial_Q(high - 2, p, n) > 0.05 || high - 1 < e.value);
      } else if (isinf(e.high)) {
        ck_assert(gsl_cdf_binomial_Q(n - 1, p, n) > 0.05);
      }
    }
  }
  double column[] = {3, -1, INFINITY, 2, -1};
  tp_column_sort(column, 5);
  ck_assert(column[0] == -1 && column[1] == -1 && column[2] == 2 && column[4] == INFINITY);
  ck_assert_double_eq(tp_column_quantile(column, 5, 0.75, 0.9).value, 3);
  ck_assert_double_eq(tp_column_quantile(column, 5, 0.8, 0.9).value, INFINITY);
  static const double sides[] = {-INFINITY, INFINITY};
  ck_assert_double_eq(tp_column_quantile(sides, 2, 0.4, 0.9).value, -INFINITY);
  ck_assert_double_eq(tp_column_quantile(sides, 2, 0.6, 0.9).value, INFINITY);
}
END_TEST

START_TEST(settling) {
  tp_convergence hits = tp_convergence_begin(true, 0.95), mean = tp_convergence_begin(false, 0.9);
  enum { SAMPLES = 1000 };
  double values[SAMPLES];
  for (int k = 0; k < SAMPLES; k++) {
    values[k] = 1e6 + k * 37 % 101;
    tp_convergence_add(&hits, k % 3 == 0 ? 1 : 0);
    tp_convergence_add(&mean, values[k]);
  }
  ck_assert_uint_eq(hits.count, 10);
  for (size_t k = 0; k < 10; k++) {
    const uint64_t n = UINT64_C(1) << k;
    ck_assert_uint_eq(hits.points[k].samples, n);
    const tp_estimate wilson = tp_proportion((n + 2) / 3, n, 0.95), own = mean.points[k].estimate;
    ck_assert_mem_eq(&wilson, &hits.points[k].estimate, sizeof wilson);
    double sum = 0, squares = 0;
    for (size_t j = 0; j < n; j++) sum += values[j] - 1e6;
    for (size_t j = 0; j < n; j++) squares += pow(values[j] - 1e6 - sum / (double)n, 2);
    near(own.value, 1e6 + sum / (double)n, 1e-8);
    if (n == 1) ck_assert(isinf(own.high));
    if (n < 2) continue;
    const double deviation = sqrt(squares / (double)(n - 1) / (double)n);
    near(own.high - own.value, tp_student_score(0.9, (double)n - 1) * deviation, 1e-7);
  }
}
END_TEST

/* 1 - 6 sum d^2 / n (n^2 - 1) where no two are equal. */
START_TEST(rank_correlations) {
  enum { COUNT = 200 };
  double x[COUNT], y[COUNT], of_x[COUNT], of_y[COUNT], squares = 0;
  for (int k = 0; k < COUNT; k++) {
    x[k] = exp(k * 73 % 211);
    y[k] = -1.0 / (1 + (k * 91 + 7) % 223) + 1e-3 * k;
  }
  ck_assert_int_eq(tp_ranks(of_x, x, COUNT, NULL), TP_OK);
  ck_assert_int_eq(tp_ranks(of_y, y, COUNT, NULL), TP_OK);
  for (int k = 0; k < COUNT; k++) {
    int below = 0;
    for (int j = 0; j < COUNT; j++) below += x[j] < x[k];
    ck_assert_double_eq(of_x[k], below + 1);
    squares += (of_x[k] - of_y[k]) * (of_x[k] - of_y[k]);
  }
  const double r = 1 - 6 * squares / (COUNT * (COUNT * COUNT - 1.0));
  const tp_estimate e = tp_rank_correlation(of_x, of_y, COUNT, 0.95);
  near(e.value, r, 1e-14);
  const double half = (atanh(e.high) - atanh(e.low)) / 2;
  near(half, 1.9599639845400545 * sqrt((1 + r * r / 2) / (COUNT - 3)), 1e-12);
  near(tp_rank_correlation(of_x, of_x, COUNT, 0.95).value, 1, 1e-15);

  static const double ties[] = {2, 1, 2, INFINITY, -INFINITY, 2};
  static const double shared[] = {4, 2, 4, 6, 1, 4}, equal[] = {3.5, 3.5, 3.5, 3.5, 3.5, 3.5};
  ck_assert_int_eq(tp_ranks(of_x, ties, 6, NULL), TP_OK);
  for (size_t k = 0; k < 6; k++) ck_assert_double_eq(of_x[k], shared[k]);
  ck_assert(isnan(tp_rank_correlation(of_x, equal, 6, 0.95).value));
}
END_TEST

SUITE(statistics) {
  TCase *tests = tcase_create("statistics");
  tcase_add_test(tests, wilson_as_published);
  tcase_add_test(tests, wilson_as_defined);
  tcase_add_test(tests, several_categories);
  tcase_add_test(tests, student);
  tcase_add_test(tests, quantile_intervals);
  tcase_add_test(tests, settling);
  tcase_add_test(tests, rank_correlations);
  Suite *suite = suite_create("statistics");
  suite_add_tcase(suite, tests);
  return suite;
}
