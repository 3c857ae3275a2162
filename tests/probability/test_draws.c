/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Samples: the same numbers wherever one begins; distributed as they should be, by the test of
 * Kolmogorov and Smirnov at the level 1e-3 and fixed seeds; independent of each other; and what is
 * no plan refused in words. */

#include "draws_stage.h"
#include "sampling/distribution.h"
#include "suite.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Also past the last sample, where it begins anew. */
START_TEST(wherever_one_begins) {
  enum { SAMPLES = 50, DIMENSIONS = 3 };
  for (size_t k = 0; k < 2 * METHODS; k++) {
    const tp_draws draws = {.method = methods[k / 2],
                            .seed = 7 + k,
                            .samples = SAMPLES,
                            .replicates = 3,
                            .dimensions = DIMENSIONS,
                            .correlation = k % 2 == 0 ? NULL : correlation};
    double all[SAMPLES][DIMENSIONS], own[DIMENSIONS];
    tp_draws_walk *whole = begun(&draws, 0);
    for (size_t j = 0; j < SAMPLES; j++) tp_draws_next(whole, all[j]);
    tp_draws_end(whole);
    for (size_t first = 0; first <= SAMPLES; first++) {
      tp_draws_walk *walk = begun(&draws, first);
      for (size_t j = 0; j < SAMPLES; j++) {
        tp_draws_next(walk, own);
        ck_assert_mem_eq(own, all[(first + j) % SAMPLES], sizeof own);
      }
      tp_draws_end(walk);
    }
  }
  tp_draws_end(NULL);
}
END_TEST

/* The numbers of a seed are part of what a study promises: those of samples 777 and 778 of 1000
 * have been these from the start, on every machine. */
START_TEST(of_a_seed) {
  static const double pinned[METHODS][2][3] = {
      {{0x1.d035bf02ce13bp-1, 0x1.2e347da0f9834p-3, 0x1.9eddbc426744p-7},
       {0x1.348df39f2c891p-1, 0x1.22e78343d8604p-3, 0x1.41d1b557d0da5p-1}},
      {{0x1.7f2228e591d25p-2, 0x1.edb783175ba3ap-1, 0x1.023df67933d7ep-1},
       {0x1.ea5a89ff92f2p-1, 0x1.7c9f6dba0e44ap-5, 0x1.12dc082a0f5f2p-2}},
      {{0x1.e014ec95dfbdep-2, 0x1.d393e728edca9p-1, 0x1.400bb7f88b7b4p-3},
       {0x1.e778976cb0e82p-2, 0x1.b7b648ea6f51fp-1, 0x1.17cda26720f5ep-2}},
  };
  for (size_t k = 0; k < METHODS; k++) {
    const tp_draws draws = {methods[k], 12345, 1000, 2, 3, NULL};
    tp_draws_walk *walk = begun(&draws, 777);
    for (size_t j = 0; j < 2; j++) {
      double u[3];
      tp_draws_next(walk, u);
      ck_assert_mem_eq(u, pinned[k][j], sizeof u);
    }
    tp_draws_end(walk);
  }
}
END_TEST

static int compare(const void *left, const void *right) {
  const double a = *(const double *)left, b = *(const double *)right;
  return (a > b) - (a < b);
}

/* The largest distance of the empirical distribution function from u, times sqrt n; beyond 1.95 by
 * chance once in 1000, 2 exp(-2 x^2) (Kolmogorov 1933). The values are lost. */
static double distance(double *u, size_t count) {
  double most = 0;
  qsort(u, count, sizeof *u, compare);
  for (size_t k = 0; k < count; k++) {
    most = fmax(most, u[k] - (double)k / (double)count);
    most = fmax(most, (double)(k + 1) / (double)count - u[k]);
  }
  return most * sqrt((double)count);
}

START_TEST(as_distributed) {
  enum { SAMPLES = 4000, DIMENSIONS = 3 };
  static const double measured[] = {1, 2, 3, 5, 8};
  const tp_distribution kinds[] = {
      tp_distribution_uniform(2, 3),
      tp_distribution_normal(30, 2),
      tp_distribution_lognormal(30, 10),
      tp_distribution_triangular(0, 0.05, 0.2),
      tp_distribution_beta(0.5, 4, 1, 2),
      tp_distribution_empirical(measured, 5),
      tp_distribution_truncated(tp_distribution_normal(30, 2), 33, 40),
  };
  const size_t count = sizeof kinds / sizeof kinds[0];
  double *u = calloc(SAMPLES * (count + 1), sizeof *u);
  for (size_t k = 0; k < 2 * METHODS; k++) {
    const bool dependent = k % 2 == 1;
    const tp_draws draws = {
        methods[k / 2], 11, SAMPLES, 1, DIMENSIONS, dependent ? correlation : NULL};
    for (size_t dimension = 0; dimension < DIMENSIONS; dimension++) {
      tp_draws_walk *walk = begun(&draws, 0);
      for (size_t j = 0; j < SAMPLES; j++) {
        double sample[DIMENSIONS];
        tp_draws_next(walk, sample);
        u[j] = sample[dimension];
        if (!(u[j] > 0 && u[j] < 1)) ck_abort_msg("%g", u[j]);
        for (size_t i = 0; i < count; i++) {
          const double x = tp_distribution_quantile(kinds + i, u[j]);
          u[(i + 1) * SAMPLES + j] = tp_distribution_cdf(kinds + i, x);
        }
      }
      tp_draws_end(walk);
      for (size_t i = 0; i <= count; i++) {
        const double own = distance(u + i * SAMPLES, SAMPLES);
        ck_assert_msg(own < 1.95, "method %zu, variable %zu: %g", k / 2, dimension, own);
        /* strata of each are far closer than chance: within one of them, but for the copula */
        ck_assert(k < 2 || dependent || own < 2 / sqrt(SAMPLES) + 1e-9);
      }
    }
  }
  free(u);
}
END_TEST

/* No two variables, nor neighbouring samples, have to do with each other: correlations stay within
 * 4 of their deviations 1 / sqrt n, of 4 variables and 3 lags. */
START_TEST(independent) {
  enum { SAMPLES = 100000, DIMENSIONS = 4, LAGS = 3 };
  double(*u)[DIMENSIONS] = calloc(SAMPLES + LAGS, sizeof *u);
  for (size_t k = 0; k < 2; k++) {
    const tp_draws draws = {methods[k], 5, SAMPLES, 1, DIMENSIONS, NULL};
    tp_draws_walk *walk = begun(&draws, 0);
    for (size_t j = 0; j < SAMPLES + LAGS; j++) tp_draws_next(walk, u[j]);
    tp_draws_end(walk);
    for (size_t i = 0; i < DIMENSIONS * DIMENSIONS * (LAGS + 1); i++) {
      const size_t a = i % DIMENSIONS, b = i / DIMENSIONS % DIMENSIONS;
      const size_t lag = i / DIMENSIONS / DIMENSIONS;
      double sum = 0;
      for (size_t j = 0; j < SAMPLES; j++) sum += 12 * (u[j][a] - 0.5) * (u[j + lag][b] - 0.5);
      const double truth = lag == 0 && a == b ? SAMPLES : 0;
      ck_assert_msg(fabs(sum - truth) < 4 * sqrt(SAMPLES), "%zu: %zu, %zu, lag %zu: %g", k, a, b,
                    lag, sum / SAMPLES);
    }
  }
  free(u);
}
END_TEST

START_TEST(no_plan) {
  static const struct {
    tp_draws draws;
    uint64_t first;
    const char *said;
  } cases[] = {
      {{TP_DRAW_MONTE_CARLO, 1, 0, 1, 1, NULL}, 0, "0 samples: there can be from 1"},
      {{TP_DRAW_MONTE_CARLO, 1, UINT64_MAX, 1, 1, NULL}, 0, "samples: there can be from 1 to 281"},
      {{TP_DRAW_MONTE_CARLO, 1, 10, 1, 1, NULL}, 11, "sample 11 of 10: there is none"},
      {{TP_DRAW_MONTE_CARLO, 1, 10, 1, 0, NULL}, 0, "0 variables: there can be from 1"},
      {{TP_DRAW_MONTE_CARLO, 1, 10, 1, 1001, NULL}, 0, "1001 variables"},
      {{TP_DRAW_SOBOL, 1, 10, 1, 41, NULL}, 0, "have 40 at most: draw a Latin hypercube"},
      {{(tp_draw_method)9, 1, 10, 1, 1, NULL}, 0, "9 is not a method"},
  };
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    tp_draws_walk *walk = NULL;
    tp_message message = {.text = ""};
    ck_assert_int_eq(tp_draws_begin(&walk, &cases[k].draws, cases[k].first, NULL, &message),
                     TP_BAD_INPUT);
    ck_assert_msg(strstr(message.text, cases[k].said) != NULL, "%s", message.text);
  }
}
END_TEST

SUITE(draws) {
  TCase *tests = tcase_create("draws");
  tcase_set_timeout(tests, 120);
  tcase_add_test(tests, wherever_one_begins);
  tcase_add_test(tests, of_a_seed);
  tcase_add_test(tests, as_distributed);
  tcase_add_test(tests, independent);
  tcase_add_test(tests, no_plan);
  Suite *suite = suite_create("draws");
  suite_add_tcase(suite, tests);
  return suite;
}
