/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The zeros of a moment, and the tilt at which the block begins to move, against those of a
 * polynomial.
 *
 * With t = tan(a / 2), cos a = (1 - t^2) / (1 + t^2) and sin a = 2 t / (1 + t^2), the moment
 *     f(a) = A cos a + B sin a + C + D / cos a + E / cos^2 a,   times cos^2 a (1 + t^2)^3,
 * is a polynomial of degree 6 in t with whole coefficients, of f's sign where cos a > 0. Arb's
 * arb_fmpz_poly finds its real roots and tells them from others with certainty. */

#include "load/zeros.h"
#include "random_numbers.h"
#include "suite.h"

#include <arb_fmpz_poly.h>

enum { BITS = 192, ROUNDS = 4000, DEGREE = 6 };

static random_numbers state;

typedef struct moment {
  long of[TP_BASIS];
  fmpz_poly_t polynomial;
  long count;            /* of its real roots with cos a > 0 */
  arb_struct at[DEGREE]; /* tan(a / 2), ascending */
} moment;

/* (1 - t^2)^minus (1 + t^2)^plus (2 t)^twice factor, added */
static void add_term(fmpz_poly_t sum, long factor, int minus, int plus, int twice) {
  fmpz_poly_t term, base;
  fmpz_poly_init(term);
  fmpz_poly_init(base);
  fmpz_poly_set_si(term, factor);
  for (int k = 0; k < minus + plus; k++) {
    fmpz_poly_set_coeff_si(base, 0, 1);
    fmpz_poly_set_coeff_si(base, 2, k < minus ? -1 : 1);
    fmpz_poly_mul(term, term, base);
  }
  fmpz_poly_shift_left(term, term, twice);
  fmpz_poly_scalar_mul_si(term, term, 1L << twice);
  fmpz_poly_add(sum, sum, term);
  fmpz_poly_clear(term);
  fmpz_poly_clear(base);
}

static int compare_middles(const void *a, const void *b) {
  return arf_cmp(arb_midref((arb_srcptr)a), arb_midref((arb_srcptr)b));
}

/* False where a root is not simple. */
static bool find_roots(moment *m) {
  const long degree = fmpz_poly_degree(m->polynomial);
  m->count = 0;
  if (degree < 0) return false;
  fmpz_poly_t squarefree;
  fmpz_poly_init(squarefree);
  fmpz_poly_derivative(squarefree, m->polynomial);
  fmpz_poly_gcd(squarefree, squarefree, m->polynomial);
  const bool simple = fmpz_poly_degree(squarefree) <= 0;
  fmpz_poly_clear(squarefree);
  if (!simple) return false;
  acb_ptr roots = _acb_vec_init(degree);
  if (degree > 0) arb_fmpz_poly_complex_roots(roots, m->polynomial, 0, BITS);
  for (long k = 0; k < degree; k++) {
    arb_t square;
    arb_init(square);
    arb_mul(square, acb_realref(roots + k), acb_realref(roots + k), BITS);
    arb_sub_ui(square, square, 1, BITS);
    if (arb_is_zero(acb_imagref(roots + k)) && arb_is_negative(square)) {
      arb_set(m->at + m->count++, acb_realref(roots + k));
    }
    arb_clear(square);
  }
  _acb_vec_clear(roots, degree);
  qsort(m->at, (size_t)m->count, sizeof m->at[0], compare_middles);
  return true;
}

/* Coefficients from -most to most; `secants`: of the terms in 1 / cos too. (1 - t^2) is taken out
 * as often as all terms have it, as cos a = 0 is no zero. */
static bool moment_init(moment *m, long most, bool secants) {
  for (int k = 0; k < DEGREE; k++) arb_init(m->at + k);
  fmpz_poly_init(m->polynomial);
  for (int k = 0; k < TP_BASIS; k++) {
    m->of[k] = k < TP_SEC || secants ? draw_below(&state, 2 * most + 1) - most : 0;
  }
  if (draw_below(&state, 2) == 0) m->of[TP_SEC2] = 0;
  const bool second = m->of[TP_SEC2] != 0, first = second || m->of[TP_SEC] != 0;
  const int power = first + second; /* of cos a that f is taken times */
  add_term(m->polynomial, m->of[TP_COS], 1 + power, 0, 0);
  add_term(m->polynomial, m->of[TP_SIN], power, 0, 1);
  add_term(m->polynomial, m->of[TP_ONE], power, 1, 0);
  if (first) add_term(m->polynomial, m->of[TP_SEC], power - 1, 2, 0);
  if (second) add_term(m->polynomial, m->of[TP_SEC2], 0, 3, 0);
  return find_roots(m);
}

static void moment_clear(moment *m) {
  for (int k = 0; k < DEGREE; k++) arb_clear(m->at + k);
  fmpz_poly_clear(m->polynomial);
}

static void degrees_of(arb_t degrees, const arb_t half_tangent) {
  arb_t pi;
  arb_init(pi);
  arb_atan(degrees, half_tangent, BITS);
  arb_mul_ui(degrees, degrees, 360, BITS);
  arb_const_pi(pi, BITS);
  arb_div(degrees, degrees, pi, BITS);
  arb_clear(pi);
}

static bool rises(const moment *m, long k) {
  fmpz_poly_t slope;
  arb_t value;
  fmpz_poly_init(slope);
  arb_init(value);
  fmpz_poly_derivative(slope, m->polynomial);
  arb_fmpz_poly_evaluate_arb(value, slope, m->at + k, BITS);
  ck_assert(!arb_contains_zero(value));
  const bool up = arb_is_positive(value);
  arb_clear(value);
  fmpz_poly_clear(slope);
  return up;
}

static void set_trig(tp_trig *f, const moment *m) {
  for (int k = 0; k < TP_BASIS; k++) arb_set_si(f->of + k, m->of[k]);
}

static void check_zeros(const moment *m, const tp_roots *roots) {
  ck_assert_int_eq(roots->count, m->count);
  for (long k = 0; k < m->count; k++) {
    arb_t truth;
    arb_init(truth);
    degrees_of(truth, m->at + k);
    ck_assert(arb_overlaps(truth, roots->degrees + k));
    ck_assert_int_eq(roots->rising[k], rises(m, k));
    arb_clear(truth);
  }
}

/* The block is stable where f is below zero. Tilted from level ground it begins to move at the
 * first zero above, if it stands on level ground; if it does not, it would have to be tilted back
 * to the last zero below. */
static void check_critical(const moment *m, tp_roots *roots) {
  arb_t level, degrees, truth;
  arb_init(level);
  arb_init(degrees);
  arb_init(truth);
  const long sum = m->of[TP_COS] + m->of[TP_ONE] + m->of[TP_SEC] + m->of[TP_SEC2];
  if (sum != 0) { /* on level ground itself ties are told by other means */
    long at = -1;
    for (long k = 0; k < m->count; k++) {
      const bool above = arf_sgn(arb_midref(m->at + k)) > 0;
      if (sum < 0 ? above && at < 0 : !above) at = k;
    }
    arb_set_si(level, sum);
    bool always = false;
    const bool found = tp_roots_critical(degrees, &always, roots, level);
    ck_assert_int_eq(found, at >= 0);
    ck_assert_int_eq(always, sum > 0);
    if (found) degrees_of(truth, m->at + at);
    if (found) ck_assert(arb_overlaps(truth, degrees));
  }
  arb_clear(level);
  arb_clear(degrees);
  arb_clear(truth);
}

/* `counts`: how many had so many zeros. */
static void try_moments(long counts[DEGREE + 1], long most, bool secants) {
  long open = 0, tried = 0;
  for (int round = 0; round < ROUNDS; round++) {
    moment m;
    tp_trig f;
    tp_roots roots;
    tp_trig_init(&f);
    tp_roots_init(&roots);
    if (moment_init(&m, most, secants)) {
      set_trig(&f, &m);
      tp_roots_find(&roots, &f, BITS);
      tried++;
      if (roots.certain) {
        counts[m.count]++;
        check_zeros(&m, &roots);
        check_critical(&m, &roots);
      } else {
        open++;
      }
    }
    tp_roots_clear(&roots);
    tp_trig_clear(&f);
    moment_clear(&m);
  }
  ck_assert_int_gt(tried, ROUNDS * 9 / 10);
  ck_assert_int_le(open, tried / 50); /* with a zero at a right angle, which takes 1280 bits */
}

/* By the closed form psi +- acos(-C / R). */
START_TEST(zeros_of_turning_loads) {
  long counts[DEGREE + 1] = {0};
  state = random_numbers_from(61);
  try_moments(counts, 100, false);
  for (int k = 0; k <= 2; k++) ck_assert_int_gt(counts[k], 100);
}
END_TEST

/* By isolation: level water has moments in 1 / cos and 1 / cos^2. They go the same way at both
 * ends, so that the zeros are even in number. */
START_TEST(zeros_with_level_water) {
  long counts[DEGREE + 1] = {0};
  state = random_numbers_from(62);
  try_moments(counts, 20, true);
  for (int k = 0; k <= 4; k += 2) ck_assert_int_gt(counts[k], 10);
}
END_TEST

/* -A cos a + (A + 1) / cos a - 1 / cos^2 a has a double zero at level ground; with an uncertain
 * coefficient two, or none: open, and said so at once. Boxes that are settled by their values
 * alone, and not by slopes too, are millions then, which takes seconds each time. */
START_TEST(double_zeros_are_left_open_at_once) {
  enum { FEW_BITS = 64, UNCERTAIN = -36, WIDEST = 40 };
  for (long a = 1; a <= WIDEST; a++) {
    tp_trig f;
    tp_roots roots;
    tp_trig_init(&f);
    tp_roots_init(&roots);
    arb_set_si(f.of + TP_COS, -a);
    arb_set_si(f.of + TP_SEC, a + 1);
    arb_set_si(f.of + TP_SEC2, -1);
    mag_set_ui_2exp_si(arb_radref(f.of + TP_SEC), 1, UNCERTAIN);
    tp_roots_find(&roots, &f, FEW_BITS);
    ck_assert(!roots.certain);
    tp_roots_clear(&roots);
    tp_trig_clear(&f);
  }
}
END_TEST

SUITE(zeros) {
  Suite *suite = suite_create("zeros");
  TCase *cases = tcase_create("zeros");
  tcase_set_timeout(cases, 300);
  tcase_add_test(cases, zeros_of_turning_loads);
  tcase_add_test(cases, zeros_with_level_water);
  tcase_add_test(cases, double_zeros_are_left_open_at_once);
  suite_add_tcase(suite, cases);
  return suite;
}
