/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Design values in closed form: how large the mean of a friction angle must be that a slab slides
 * with a wanted probability, P(phi <= tilt) = Phi((tilt - mean) / deviation), by the first-order
 * method and by counts of the same samples; how steep a slope may be, where the probability rises.
 */

#include "sampling/draws.h"
#include "statistics/design_value.h"
#include "statistics/form.h"
#include "statistics/proportion.h"
#include "suite.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <string.h>

static const double tilt = 25, deviation = 2;

static tp_status margin(double *g, void *context, const double *x, size_t count,
                        tp_message *message) {
  const double *slope = context;
  (void)message;
  for (size_t k = 0; k < count; k++) g[k] = x[k] - *slope;
  return TP_OK;
}

static tp_status by_form(tp_estimate *probability, double mean, double slope, tp_message *message) {
  const tp_distribution phi = tp_distribution_normal(mean, deviation);
  const tp_reliability problem = {1, &phi, NULL, margin, &slope};
  const tp_form_options options = tp_form_options_default();
  tp_form form;
  const tp_status status = tp_form_find(&form, &problem, &options, message);
  if (status != TP_OK) return status;
  *probability = (tp_estimate){form.probability, form.probability, form.probability};
  tp_form_clear(&form);
  return TP_OK;
}

static tp_status of_mean(tp_estimate *probability, void *context, double mean,
                         tp_message *message) {
  (void)context;
  return by_form(probability, mean, tilt, message);
}

static tp_status of_slope(tp_estimate *probability, void *context, double slope,
                          tp_message *message) {
  (void)context;
  return by_form(probability, 30, slope, message);
}

enum { SAMPLES = 4000 };

static tp_status by_count(tp_estimate *probability, void *context, double mean,
                          tp_message *message) {
  const tp_draws draws = {TP_DRAW_MONTE_CARLO, 3, SAMPLES, 1, 1, NULL};
  tp_draws_walk *walk;
  uint64_t slides = 0;
  (void)context;
  const tp_status status = tp_draws_begin(&walk, &draws, 0, NULL, message);
  if (status != TP_OK) return status;
  for (int k = 0; k < SAMPLES; k++) {
    double z;
    tp_draws_next_scores(walk, &z);
    slides += mean + deviation * z <= tilt;
  }
  tp_draws_end(walk);
  *probability = tp_proportion(slides, SAMPLES, 0.95);
  return TP_OK;
}

static tp_estimate design(tp_design_search search) {
  tp_estimate own;
  tp_message message = {.text = ""};
  ck_assert_msg(tp_design_value(&own, &search, &message) == TP_OK, "%s", message.text);
  return own;
}

START_TEST(by_the_first_order_method) {
  for (int k = 1; k < 8; k++) {
    const double wanted = pow(10, -k), score = gsl_cdf_ugaussian_Pinv(wanted);
    const tp_estimate falls = design((tp_design_search){of_mean, NULL, wanted, 24, 45, 1e-9});
    const tp_estimate rises = design((tp_design_search){of_slope, NULL, wanted, 15, 31, 1e-9});
    ck_assert_double_eq_tol(falls.value, tilt - deviation * score, 1e-5);
    ck_assert_double_eq_tol(rises.value, 30 + deviation * score, 1e-5);
    ck_assert_double_eq_tol(falls.low, falls.value, 1e-8);
    ck_assert_double_eq_tol(rises.high, rises.value, 1e-8);
  }
}
END_TEST

/* A count of 2 % of 4000 is of a tail that lies within z 0.0022 of it; the ends are where Wilson's
 * interval has its own. Towards the end of the range one of them lies beyond. */
START_TEST(by_counting) {
  const double truth = tilt - deviation * gsl_cdf_ugaussian_Pinv(0.02);
  const tp_estimate own = design((tp_design_search){by_count, NULL, 0.02, 20, 40, 1e-6});
  ck_assert(own.low < own.value && own.value < own.high);
  ck_assert(own.low < truth && truth < own.high && own.high - own.low < 0.4);
  tp_estimate p;
  ck_assert_int_eq(by_count(&p, NULL, own.low, NULL), TP_OK);
  ck_assert_double_eq_tol(p.low, 0.02, 5e-4);
  ck_assert_int_eq(by_count(&p, NULL, own.high, NULL), TP_OK);
  ck_assert_double_eq_tol(p.high, 0.02, 5e-4);
  const double middle = own.value + (own.high - own.value) / 2;
  const tp_estimate cut = design((tp_design_search){by_count, NULL, 0.02, 20, middle, 1e-6});
  ck_assert(isinf(cut.high) && cut.high > 0 && fabs(cut.low - own.low) < 1e-5);
  const double before = own.low + (own.value - own.low) / 2;
  const tp_estimate late = design((tp_design_search){by_count, NULL, 0.02, before, 40, 1e-6});
  ck_assert(isinf(late.low) && late.low < 0 && fabs(late.high - own.high) < 1e-5);
}
END_TEST

static tp_status fails(tp_estimate *probability, void *context, double value, tp_message *message) {
  (void)probability, (void)context, (void)value;
  return tp_fail(message, TP_SYSTEM_FAILED, (tp_place){0}, "the disk is gone");
}

START_TEST(refused) {
  const struct {
    tp_design_search search;
    tp_status status;
    const char *said;
  } cases[] = {
      {{of_mean, NULL, 0, 24, 45, 1e-9}, TP_BAD_INPUT, "give a probability within (0, 1)"},
      {{of_mean, NULL, 0.1, 45, 24, 1e-9}, TP_BAD_INPUT, "a range"},
      {{of_mean, NULL, 0.1, 24, 45, 0}, TP_BAD_INPUT, "a width above 0"},
      {{of_mean, NULL, 0.1, 35, 45, 1e-9}, TP_NO_ANSWER, "that wanted, 0.1, not between them"},
      {{fails, NULL, 0.1, 35, 45, 1e-9}, TP_SYSTEM_FAILED, "the disk is gone"},
  };
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    tp_estimate own;
    tp_message message = {.text = ""};
    ck_assert_int_eq(tp_design_value(&own, &cases[k].search, &message), cases[k].status);
    ck_assert_msg(strstr(message.text, cases[k].said) != NULL, "%s", message.text);
  }
}
END_TEST

SUITE(design_value) {
  TCase *tests = tcase_create("design value");
  tcase_add_test(tests, by_the_first_order_method);
  tcase_add_test(tests, by_counting);
  tcase_add_test(tests, refused);
  Suite *suite = suite_create("design_value");
  suite_add_tcase(suite, tests);
  return suite;
}
