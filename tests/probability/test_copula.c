/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Correlated samples: scores and ranks correlate as asked for, by every method of drawing; factors
 * of correlations multiply to them, of singular ones too; and what is no correlation is refused in
 * words. */

#include "draws_stage.h"
#include "sampling/copula.h"
#include "suite.h"

#include <math.h>
#include <string.h>

/* The scores correlate as asked for, their ranks by (6 / pi) asin(r / 2): sums over n samples are
 * within 4 deviations, at most 1 / sqrt n each; strata and points are closer. */
START_TEST(correlated) {
  enum { SAMPLES = 100000, DIMENSIONS = 3 };
  for (size_t k = 0; k < METHODS; k++) {
    const tp_draws draws = {methods[k], 3, SAMPLES, 1, DIMENSIONS, correlation};
    double scores[9] = {0}, ranks[9] = {0};
    tp_draws_walk *in_scores = begun(&draws, 0), *walk = begun(&draws, 0);
    for (size_t j = 0; j < SAMPLES; j++) {
      double z[DIMENSIONS], u[DIMENSIONS];
      tp_draws_next_scores(in_scores, z);
      tp_draws_next(walk, u);
      for (size_t i = 0; i < 9; i++) {
        scores[i] += z[i / 3] * z[i % 3] / SAMPLES;
        ranks[i] += 12 * (u[i / 3] - 0.5) * (u[i % 3] - 0.5) / SAMPLES;
      }
    }
    tp_draws_end(walk);
    tp_draws_end(in_scores);
    for (size_t i = 0; i < 9; i++) {
      const double rank = 6 / acos(-1) * asin(correlation[i] / 2);
      ck_assert_msg(fabs(scores[i] - correlation[i]) < 6 / sqrt(SAMPLES), "%zu: %g", k, scores[i]);
      ck_assert_msg(fabs(ranks[i] - rank) < 4 / sqrt(SAMPLES), "%zu: %g", k, ranks[i]);
      ck_assert_double_eq_tol(tp_copula_rank(correlation[i]), rank, 1e-15);
      ck_assert_double_eq_tol(tp_copula_of_rank(rank), correlation[i], 1e-15);
    }
  }
}
END_TEST

/* R of random unit vectors, of fewer dimensions than there are variables too, so that it is
 * singular: L L' is R to what a singular one is let pass. */
START_TEST(factors) {
  enum { MOST = 12 };
  for (size_t n = 1; n <= MOST; n++) {
    for (size_t space = 1; space <= MOST; space++) {
      const tp_draws draws = {TP_DRAW_MONTE_CARLO, n * 100 + space, MOST, 1, space, NULL};
      double rows[MOST][MOST] = {{0}}, r[MOST * MOST], factor[MOST * MOST];
      tp_draws_walk *walk = begun(&draws, 0);
      for (size_t k = 0; k < n; k++) {
        double square = 0;
        tp_draws_next_scores(walk, rows[k]);
        for (size_t j = 0; j < space; j++) square += rows[k][j] * rows[k][j];
        for (size_t j = 0; j < space; j++) rows[k][j] /= sqrt(square);
      }
      tp_draws_end(walk);
      for (size_t k = 0; k < n * n; k++) {
        double sum = 0;
        for (size_t j = 0; j < space; j++) sum += rows[k / n][j] * rows[k % n][j];
        r[k] = k / n == k % n ? 1 : fmin(fmax(sum, -1), 1);
      }
      tp_message message = {.text = ""};
      ck_assert_msg(tp_copula_factor(factor, r, n, NULL, &message) == TP_OK, "%s", message.text);
      for (size_t k = 0; k < n * n; k++) {
        double sum = 0;
        for (size_t j = 0; j < n; j++) sum += factor[k / n * n + j] * factor[k % n * n + j];
        ck_assert_msg(fabs(sum - r[k]) < (space < n ? 2e-10 : 1e-13), "%zu of %zu: %g for %g", n,
                      space, sum, r[k]);
      }
    }
  }
}
END_TEST

START_TEST(no_correlation) {
  static const char *const names[] = {"friction_angle_deg", "cohesion", "x\033[31m"};
  static const struct {
    double r[9];
    const char *said;
  } cases[] = {
      {{1, 0.9, 0.9, 0.9, 1, -0.9, 0.9, -0.9, 1},
       "the correlation of 'cohesion' with 'x\\x1B[31m' is -0.9, but by the correlations before it "
       "lies from 0.62 to 1: change one of them"},
      {{1, 1.5, 0, 1.5, 1, 0, 0, 0, 1},
       "the correlation of 'friction_angle_deg' with 'cohesion' is 1.5: it must lie from -1 to 1"},
      {{1, 0.5, 0, 0.4, 1, 0, 0, 0, 1}, "is given as 0.4 and as 0.5: give it once"},
      {{2, 0, 0, 0, 1, 0, 0, 0, 1}, "'friction_angle_deg' with 'friction_angle_deg' itself must"},
      {{1, NAN, 0, NAN, 1, 0, 0, 0, 1}, "is given as nan and as nan"},
      {{1, 1, 0.5, 1, 1, 0.4, 0.5, 0.4, 1},
       "is 0.4, but by the correlations before it lies from 0."},
  };
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    const tp_draws draws = {TP_DRAW_MONTE_CARLO, 1, 10, 1, 3, cases[k].r};
    tp_draws_walk *walk = NULL;
    tp_message message = {.text = ""};
    ck_assert_int_eq(tp_draws_begin(&walk, &draws, 0, names, &message), TP_BAD_INPUT);
    ck_assert_msg(strstr(message.text, cases[k].said) != NULL, "%s", message.text);
    ck_assert_ptr_null(walk);
    ck_assert_int_eq(tp_draws_begin(&walk, &draws, 0, NULL, &message), TP_BAD_INPUT);
    ck_assert_ptr_nonnull(strstr(message.text, " of variable "));
  }
}
END_TEST

SUITE(copula) {
  TCase *tests = tcase_create("copula");
  tcase_set_timeout(tests, 120);
  tcase_add_test(tests, correlated);
  tcase_add_test(tests, factors);
  tcase_add_test(tests, no_correlation);
  Suite *suite = suite_create("copula");
  suite_add_tcase(suite, tests);
  return suite;
}
