/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Distributions of one variable: against closed forms, against integrals of their densities by GSL,
 * and from 1e-12 to 1 - 1e-12 and back; truncated ones, also far out in a tail; what is no
 * distribution is refused in words. GSL's handler, which would end the process, fails the test. */

#include "sampling/distribution.h"
#include "suite.h"

#include <float.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <math.h>
#include <string.h>

static const double measured[] = {26.5, 28, 28, 29.25, 31, 33.5, 34};
enum { MEASURED = sizeof measured / sizeof measured[0] };

static void refuse(const char *reason, const char *file, int line, int number) {
  ck_abort_msg("%s:%d: GSL's handler was called: %s (%d)", file, line, reason, number);
}

/* All that have a density, ties apart. */
enum { SMOOTH = 20 };
static void all_smooth(tp_distribution d[SMOOTH]) {
  const tp_distribution phi = tp_distribution_normal(30, 2);
  const tp_distribution seismic = tp_distribution_triangular(0, 0.05, 0.2);
  const tp_distribution beta = tp_distribution_beta(2, 3, 10, 20);
  const tp_distribution cohesion = tp_distribution_lognormal(30, 10);
  const tp_distribution all[SMOOTH] = {
      tp_distribution_uniform(-2, 5),
      phi,
      tp_distribution_normal(-1e6, 1e-3),
      cohesion,
      tp_distribution_lognormal(2e-9, 5e-9),
      seismic,
      tp_distribution_triangular(1, 1, 3),
      tp_distribution_triangular(1, 3, 3),
      beta,
      tp_distribution_beta(0.5, 0.5, 0, 1),
      tp_distribution_beta(0.1, 40, 0, 1),
      tp_distribution_beta(800, 1.5, 0, 1),
      tp_distribution_beta(10000, 10000, -1, 1),
      tp_distribution_empirical(measured + 2, MEASURED - 2),
      tp_distribution_truncated(phi, 20, 40),
      tp_distribution_truncated(phi, 46, 47),
      tp_distribution_truncated(phi, -INFINITY, 13),
      tp_distribution_truncated(cohesion, 25, INFINITY),
      tp_distribution_truncated(seismic, 0.01, 0.15),
      tp_distribution_truncated(beta, 12, 14),
  };
  memcpy(d, all, sizeof all);
}

/* The probability at the quantile is right to the 1e-10 of GSL's continued fraction, and to as much
 * as it changes over a few roundings of the number. */
START_TEST(there_and_back) {
  static const double tails[] = {1e-12, 1e-9, 1e-6, 1e-3, 0.02, 0.2, 0.37, 0.5};
  tp_distribution all[SMOOTH];
  all_smooth(all);
  for (size_t k = 0; k < SMOOTH; k++) {
    const tp_distribution *d = all + k;
    ck_assert_int_eq(tp_distribution_check(d, "x", (tp_place){0}, NULL), TP_OK);
    for (size_t j = 0; j < 2 * sizeof tails / sizeof tails[0]; j++) {
      const double tail = tails[j / 2];
      const tp_tails asked = j % 2 == 0 ? (tp_tails){tail, 1 - tail} : (tp_tails){1 - tail, tail};
      const double x = tp_distribution_at(d, asked), ends = fabs(d->low) + fabs(d->high);
      const tp_tails own = tp_distribution_tails(d, x);
      const double step = 8 * DBL_EPSILON * (fabs(x) + ends + fabs(d->mean));
      const double room = 1e-10 * tail + step * tp_distribution_density(d, x) +
                          fabs(tp_distribution_cdf(d, x + step) - tp_distribution_cdf(d, x - step));
      ck_assert_msg(fabs(own.p - asked.p) <= room + DBL_EPSILON, "%zu: p %g at %.17g: %g", k,
                    asked.p, x, own.p);
      const double smaller = j % 2 == 0 ? own.p : own.q;
      const bool far = tp_distribution_density(d, x) * step < tail; /* else x has no such digits */
      ck_assert_msg(!far || fabs(smaller - tail) <= room, "%zu: %g at %.17g: %.17g", k, tail, x,
                    smaller);
    }
  }
}
END_TEST

static void near(double value, double truth, double part) {
  ck_assert_msg(fabs(value - truth) <= part * fabs(truth), "%.17g for %.17g", value, truth);
}

/* 1e-12 and 1 - 1e-12 of a standard normal variable, by Newton's method in 30 digits. */
START_TEST(normal_tails) {
  static const double far = 7.0344838253011319;
  const tp_distribution z = tp_distribution_normal(0, 1);
  near(tp_distribution_quantile(&z, 1e-12), -far, 1e-14);
  near(tp_distribution_at(&z, (tp_tails){1 - 1e-12, 1e-12}), far, 1e-14);
  near(tp_distribution_at_score(&z, 30), 30, DBL_EPSILON);
  const tp_distribution x = tp_distribution_lognormal(3, 4); /* spread^2 = ln(1 + 16 / 9) */
  const double spread = sqrt(log(25.0 / 9)), mean = log(3) - spread * spread / 2;
  near(tp_distribution_quantile(&x, 1e-12), exp(mean - far * spread), 1e-13);
  near(tp_distribution_at_score(&x, 12), exp(mean + 12 * spread), 1e-13);
}
END_TEST

/* I_x(2, 3) = 6 x^2 - 8 x^3 + 3 x^4; I_x(1/2, 1/2) = (2 / pi) asin sqrt x; I_x(a, 1) = x^a, also
 * where x is tiny; 1 - (1 - x)^b. */
START_TEST(beta_in_closed_form) {
  const tp_distribution d = tp_distribution_beta(2, 3, 0, 1);
  const tp_distribution arc = tp_distribution_beta(0.5, 0.5, 0, 1);
  for (int k = 1; k < 64; k++) {
    const double x = k / 64.0;
    near(tp_distribution_cdf(&d, x), x * x * (6 - 8 * x + 3 * x * x), 1e-13);
    near(tp_distribution_quantile(&d, x * x * (6 - 8 * x + 3 * x * x)), x, 1e-12);
    near(tp_distribution_cdf(&arc, x), 2 * asin(sqrt(x)) / acos(-1), 1e-13);
  }
  const tp_distribution steep = tp_distribution_beta(0.1, 1, 0, 1);
  near(tp_distribution_quantile(&steep, 1e-12), 1e-120, 1e-11);
  near(tp_distribution_quantile(&steep, 0.5), 0x1p-10, 1e-11);
  const tp_distribution late = tp_distribution_beta(1, 250, 0, 1);
  near(tp_distribution_quantile(&late, 1e-12), -expm1(log1p(-1e-12) / 250), 1e-11);
  near(tp_distribution_at(&late, (tp_tails){1 - 1e-12, 1e-12}), 1 - pow(1e-12, 1.0 / 250), 1e-12);
}
END_TEST

typedef struct integrand {
  const tp_distribution *d;
  double about;
  int power;
} integrand;

static double integrand_at(double x, void *context) {
  const integrand *f = context;
  return pow(x - f->about, f->power) * tp_distribution_density(f->d, x);
}

/* From quantile to quantile, between which all is smooth, but an empirical one at its values. */
static double integral(const tp_distribution *d, double about, int power) {
  static const double cuts[] = {1e-14, 1e-11, 1e-8, 1e-6, 1e-4, 1e-3, 0.01, 0.05, 0.25, 0.5};
  enum { CUTS = sizeof cuts / sizeof cuts[0], ROOM = 4000 };
  integrand own = {d, about, power};
  gsl_function f = {integrand_at, &own};
  gsl_integration_workspace *workspace = gsl_integration_workspace_alloc(ROOM);
  double sum = 0, from = tp_distribution_quantile(d, 1e-16);
  for (int k = 0; k < 2 * CUTS; k++) {
    const double tail = k < CUTS ? cuts[k] : cuts[2 * CUTS - 1 - k];
    const double to =
        tp_distribution_at(d, k < CUTS ? (tp_tails){tail, 1 - tail} : (tp_tails){1 - tail, tail});
    double part, error;
    if (to > from && gsl_integration_qag(&f, from, to, 1e-13, 1e-10, ROOM, GSL_INTEG_GAUSS61,
                                         workspace, &part, &error) == GSL_SUCCESS) {
      sum += part;
    }
    from = to;
  }
  gsl_integration_workspace_free(workspace);
  return sum;
}

/* The probability that is left out beyond the last cuts is 2e-14, but of what it is of the variance
 * a lognormal one of deviation 2.5 means has 1e-6 of it. */
START_TEST(integrals) {
  tp_distribution all[SMOOTH];
  all_smooth(all);
  for (size_t k = 0; k < SMOOTH; k++) {
    const tp_distribution *d = all + k;
    const bool singular = d->kind == TP_DISTRIBUTION_BETA && (d->a < 1 || d->b < 1);
    if (singular || d->deviation == 1e-3) continue; /* in closed form above; too few digits */
    const double mean = tp_distribution_mean(d), deviation = tp_distribution_deviation(d);
    const double room =
        d->kind == TP_DISTRIBUTION_LOGNORMAL && !(d->deviation < d->mean) ? 1e-4 : 1e-8;
    ck_assert_msg(fabs(integral(d, 0, 0) - 1) < 1e-9, "%zu: %.12g in all", k, integral(d, 0, 0));
    ck_assert_msg(fabs(integral(d, mean, 1)) < room * deviation, "%zu: mean %.12g is off by %g", k,
                  mean, integral(d, mean, 1));
    ck_assert_msg(fabs(integral(d, mean, 2) / deviation / deviation - 1) < room,
                  "%zu: deviation %.12g for %.12g", k, deviation, sqrt(integral(d, mean, 2)));
  }
}
END_TEST

/* Of a normal variable between a and b the mean is (phi(a) - phi(b)) / Z; the mean square beyond 10
 * is 1 + 10 phi(10) / Z. Far out, Z = Q(a) - Q(b) is of erfc alone. */
START_TEST(truncated_normal) {
  const double root = sqrt(2 * acos(-1));
  static const double ends[][2] = {{-1, 2}, {3, 4}, {8, 9}, {-30, -20}};
  const tp_distribution z = tp_distribution_normal(0, 1);
  for (size_t k = 0; k < sizeof ends / sizeof ends[0]; k++) {
    const bool mirrored = ends[k][0] < -5;
    const double a = mirrored ? -ends[k][1] : ends[k][0], b = mirrored ? -ends[k][0] : ends[k][1];
    const double between = (erfc(a / sqrt(2)) - erfc(b / sqrt(2))) / 2;
    const double mean = (exp(-a * a / 2) - exp(-b * b / 2)) / root / between;
    const tp_distribution d = tp_distribution_truncated(z, ends[k][0], ends[k][1]);
    near(tp_distribution_mean(&d), mirrored ? -mean : mean, 1e-12);
    const double square =
        1 + (a * exp(-a * a / 2) - b * exp(-b * b / 2)) / root / between - mean * mean;
    near(tp_distribution_deviation(&d), sqrt(square), 1e-16 * b * b * b * b / square + 1e-12);
    ck_assert_double_eq(tp_distribution_cdf(&d, ends[k][0] - 1), 0);
    ck_assert_double_eq(tp_distribution_cdf(&d, ends[k][1]), 1);
    ck_assert_double_eq(tp_distribution_density(&d, ends[k][1] + 1), 0);
  }
}
END_TEST

/* 26.5 28 28 29.25 31 33.5 34: a list has their numbers alone, an empirical one those between. */
START_TEST(listed_and_empirical) {
  const tp_distribution list = tp_distribution_list(measured, MEASURED);
  const tp_distribution some = tp_distribution_truncated(list, 28, 31);
  double sum = 0, squares = 0;
  for (size_t k = 0; k < MEASURED; k++) {
    sum += measured[k];
    squares += measured[k] * measured[k];
    ck_assert_double_eq(tp_distribution_quantile(&list, ((double)k + 0.5) / MEASURED), measured[k]);
  }
  near(tp_distribution_mean(&list), sum / MEASURED, 1e-15);
  near(tp_distribution_deviation(&list), sqrt(squares / MEASURED - pow(sum / MEASURED, 2)), 1e-12);
  near(tp_distribution_cdf(&list, 28), 3.0 / 7, 1e-15);
  near(tp_distribution_cdf(&some, 29), 0.5, 1e-15);
  near(tp_distribution_mean(&some), (28 + 28 + 29.25 + 31) / 4, 1e-15);
  ck_assert_double_eq(tp_distribution_quantile(&some, 1e-300), 28);
  ck_assert_double_eq(tp_distribution_quantile(&some, 0.51), 29.25);
  ck_assert_double_eq(tp_distribution_quantile(&some, 1 - 0x1p-53), 31);

  const tp_distribution curve = tp_distribution_empirical(measured, MEASURED);
  near(tp_distribution_quantile(&curve, 3.5 / 6), (29.25 + 31) / 2, 1e-15);
  ck_assert_double_eq(tp_distribution_quantile(&curve, 0.25), 28);
  near(tp_distribution_cdf(&curve, 28), 2.0 / 6, 1e-15);
  near(tp_distribution_cdf(&curve, 32.25), 4.5 / 6, 1e-15);
  near(tp_distribution_density(&curve, 32), 1 / (6 * 2.5), 1e-14);
  near(tp_distribution_mean(&curve), (sum - (26.5 + 34) / 2) / 6, 1e-15);
  const tp_distribution cut = tp_distribution_truncated(curve, 28, 33.5); /* both ties are left */
  near(tp_distribution_cdf(&cut, 28), 0.25, 1e-15);
  near(tp_distribution_mean(&cut), (28 + (28 + 29.25) / 2 + (29.25 + 31) / 2 + 64.5 / 2) / 4,
       1e-15);
}
END_TEST

START_TEST(none_is_refused) {
  static const double falling[] = {1, 3, 2}, equal[] = {4, 4}, unlimited[] = {1, INFINITY};
  const tp_distribution normal = tp_distribution_normal(30, 2);
  const struct {
    tp_distribution d;
    const char *said;
  } cases[] = {
      {tp_distribution_normal(30, 0), "'phi': a deviation of 0: give one above 0"},
      {tp_distribution_normal(30, -1), "a deviation of -1"},
      {tp_distribution_normal(NAN, 1), "must be finite"},
      {tp_distribution_normal(1e9, 1e-9), "lost in the roundings"},
      {tp_distribution_lognormal(-3, 1), "a lognormal variable has a mean above 0, not -3"},
      {tp_distribution_lognormal(0, 1), "a lognormal variable has a mean above 0, not 0"},
      {tp_distribution_lognormal(1, 101), "more than 100 means"},
      {tp_distribution_uniform(2, 2), "the low end must be below the high one"},
      {tp_distribution_uniform(-INFINITY, 2), "give two finite numbers"},
      {tp_distribution_uniform(-1.7e308, 1.7e308), "give two finite numbers"},
      {tp_distribution_triangular(1, 0, 2), "the mode 0 lies below the low end 1"},
      {tp_distribution_triangular(1, 3, 2), "the mode 3 lies above the high end 2"},
      {tp_distribution_triangular(1, NAN, 2), "the mode nan is not a number"},
      {tp_distribution_beta(0, 3, 0, 1), "the parameters a = 0 and b = 3 of beta"},
      {tp_distribution_beta(2, 1e5, 0, 1), "must lie from 0.1 to 10000"},
      {tp_distribution_beta(2, 3, 1, 0), "the low end must be below"},
      {tp_distribution_list(NULL, 0), "0 values, where there must be at least 1"},
      {tp_distribution_empirical(equal, 1), "1 values, where there must be at least 2"},
      {tp_distribution_list(falling, 3), "the values must rise: 2 comes after 3"},
      {tp_distribution_empirical(equal, 2), "there is no spread"},
      {tp_distribution_list(unlimited, 2), "value 2 is inf"},
      {tp_distribution_truncated(normal, 40, 20), "truncated to [40, 20]"},
      {tp_distribution_truncated(normal, 1000, 2000), "nothing of it lies within [1000, 2000]"},
      {tp_distribution_truncated(normal, NAN, 20), "truncated to [nan, 20]"},
      {tp_distribution_truncated(tp_distribution_list(measured, 3), 30, 40), "nothing of it lies"},
      {tp_distribution_truncated(tp_distribution_beta(-1, 3, 0, 1), 0, 1), "a = -1"},
  };
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    tp_message message = {.text = ""};
    ck_assert_int_eq(
        tp_distribution_check(&cases[k].d, "phi", (tp_place){"study.yaml", 3, 5}, &message),
        TP_BAD_INPUT);
    ck_assert_msg(strstr(message.text, cases[k].said) != NULL, "%zu: %s", k, message.text);
    ck_assert_ptr_eq(strstr(message.text, "study.yaml:3:5: "), message.text);
  }
}
END_TEST

SUITE(distribution) {
  gsl_set_error_handler(refuse);
  TCase *tests = tcase_create("distribution");
  tcase_set_timeout(tests, 120);
  tcase_add_test(tests, there_and_back);
  tcase_add_test(tests, normal_tails);
  tcase_add_test(tests, beta_in_closed_form);
  tcase_add_test(tests, integrals);
  tcase_add_test(tests, truncated_normal);
  tcase_add_test(tests, listed_and_empirical);
  tcase_add_test(tests, none_is_refused);
  Suite *suite = suite_create("distribution");
  suite_add_tcase(suite, tests);
  return suite;
}
