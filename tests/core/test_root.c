/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Zeros in doubles: functions whose zeros are known by other means, and everything that the GNU
 * Scientific Library would answer by ending the process: here its handler fails the test. */

#include "number/root.h"
#include "suite.h"

#include <float.h>
#include <gsl/gsl_errno.h>
#include <math.h>

static void refuse(const char *reason, const char *file, int line, int number) {
  ck_abort_msg("%s:%d: GSL's handler was called: %s (%d)", file, line, reason, number);
}

typedef struct curve {
  double zero, below, above; /* where it leaps, from which value to which */
  double bad_from, bad_to, bad;
  int count;
} curve;

static bool leap(double *value, void *context, double x) {
  curve *c = context;
  c->count++;
  *value = x < c->zero ? c->below : c->above;
  return true;
}

static bool cube(double *value, void *context, double x) {
  curve *c = context;
  c->count++;
  *value = x * x * x - 2;
  return true;
}

/* A line but for a stretch where it has another value, or none (`bad` 0). */
static bool broken(double *value, void *context, double x) {
  curve *c = context;
  c->count++;
  const bool is_bad = x >= c->bad_from && x <= c->bad_to;
  *value = is_bad ? c->bad : x - c->zero;
  return !(is_bad && c->bad == 0);
}

static tp_root_end end(tp_root_function value, curve *c, double x) {
  tp_root_end own = {.x = x};
  ck_assert(value(&own.value, c, x));
  c->count = 0;
  return own;
}

START_TEST(smooth_ones_take_few_values) {
  enum { FEW = 12 };
  curve c = {0};
  const tp_root_end low = end(cube, &c, 0), high = end(cube, &c, 2);
  const tp_root_search search = {.value = cube, .context = &c, .most = 100};
  tp_root root;
  ck_assert(tp_root_find(&root, &search, low, high));
  ck_assert_int_le(c.count, FEW);
  const double zero = cbrt(2);
  ck_assert(root.low <= nextafter(zero, 2) && root.high >= nextafter(zero, 0));
  ck_assert(root.flat || root.high == nextafter(root.low, 2));
}
END_TEST

/* To two doubles next to each other; halving takes up to 94. */
START_TEST(leaps_are_found_to_the_last_bit) {
  enum { MOST = 200 };
  static const double zeros[] = {0.3, 1e-9, 0.999999, 0.5, 1.0 / 3, -0.7, -1e-12};
  static const double above[] = {1, 1e-3, 1e-9, 1e3, 1e9, 1e150, 1e-150};
  for (size_t z = 0; z < sizeof zeros / sizeof *zeros; z++) {
    for (size_t k = 0; k < sizeof above / sizeof *above; k++) {
      for (int falls = 0; falls < 2; falls++) {
        curve c = {
            .zero = zeros[z], .below = falls ? 1 : -1, .above = falls ? -above[k] : above[k]};
        const tp_root_end low = end(leap, &c, -1), high = end(leap, &c, 1);
        const tp_root_search search = {.value = leap, .context = &c, .most = MOST};
        tp_root root;
        ck_assert_msg(tp_root_find(&root, &search, low, high), "%g to %g", zeros[z], above[k]);
        ck_assert(root.high == zeros[z] && root.low == nextafter(zeros[z], -1) && !root.flat);
      }
    }
  }
}
END_TEST

START_TEST(searches_end_where_enough_is_known) {
  curve c = {.zero = 0.3};
  const tp_root_end low = end(cube, &c, 0), high = end(cube, &c, 2);
  tp_root_search search = {.value = cube, .context = &c, .flat = 1e-3, .most = 100};
  tp_root root;
  ck_assert(tp_root_find(&root, &search, low, high));
  ck_assert(root.flat && root.low == root.high && fabs(pow(root.low, 3) - 2) <= 1e-3);
  ck_assert_int_le(c.count, 8);
  search.flat = 0;
  search.width = 0.1;
  ck_assert(tp_root_find(&root, &search, low, high));
  ck_assert(!root.flat && root.high - root.low <= 0.1 && root.low < cbrt(2) && root.high > cbrt(2));
  search = (tp_root_search){.value = leap, .context = &c, .flat = 2, .most = 0};
  ck_assert(tp_root_find(&root, &search, (tp_root_end){0, -5}, (tp_root_end){1, 2}));
  ck_assert(root.flat && root.low == 1 && root.high == 1);
}
END_TEST

/* Not found, with nothing written, and GSL never asked for what it refuses. */
START_TEST(what_gsl_refuses_never_reaches_it) {
  static const tp_root_end refused[][2] = {{{0, 1}, {1, 1}},
                                           {{0, -1}, {1, -2}},
                                           {{1, -1}, {0, 1}},
                                           {{0, -1}, {0, 1}},
                                           {{0, NAN}, {1, 1}},
                                           {{0, -1}, {1, NAN}},
                                           {{0, -INFINITY}, {1, 1}},
                                           {{0, -1}, {1, INFINITY}},
                                           {{-INFINITY, -1}, {1, 1}},
                                           {{0, -1}, {NAN, 1}},
                                           {{-DBL_MAX, -1}, {DBL_MAX, 1}}};
  curve c = {.zero = 0.3, .below = -1, .above = 1};
  tp_root_search search = {.value = leap, .context = &c, .most = 100};
  tp_root root = {7, 8, true};
  for (size_t k = 0; k < sizeof refused / sizeof *refused; k++) {
    ck_assert_msg(!tp_root_find(&root, &search, refused[k][0], refused[k][1]), "%zu", k);
  }
  ck_assert_int_eq(c.count, 0);
  static const double bad[] = {NAN, INFINITY, -INFINITY, 0};
  for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
    c = (curve){.zero = 0.3, .bad_from = 0.25, .bad_to = 0.35, .bad = bad[k]};
    search.value = broken;
    ck_assert(!tp_root_find(&root, &search, (tp_root_end){0, -0.3}, (tp_root_end){1, 0.7}));
    ck_assert_int_eq(c.count, 1);
  }
  c = (curve){.zero = 0.3, .below = -1, .above = 1};
  search = (tp_root_search){.value = leap, .context = &c, .most = 20};
  ck_assert(!tp_root_find(&root, &search, (tp_root_end){0, -1}, (tp_root_end){1, 1}));
  ck_assert_int_eq(c.count, 20);
  ck_assert(root.low == 7 && root.high == 8 && root.flat);
}
END_TEST

SUITE(root) {
  gsl_set_error_handler(refuse);
  Suite *suite = suite_create("root");
  TCase *tests = tcase_create("root");
  tcase_add_test(tests, smooth_ones_take_few_values);
  tcase_add_test(tests, leaps_are_found_to_the_last_bit);
  tcase_add_test(tests, searches_end_where_enough_is_known);
  tcase_add_test(tests, what_gsl_refuses_never_reaches_it);
  suite_add_tcase(suite, tests);
  return suite;
}
