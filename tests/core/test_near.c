/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Doubles with a bound (number/near.h): what is computed with them stays within its bound of the
 * same expression in rationals, and a sign that is told is that of the rational. Numbers of all
 * sizes, and sums that cancel down to a rounding. */

#include "number/ball.h"
#include "plane/contact_rows.h"
#include "random_numbers.h"
#include "suite.h"

#include <flint/fmpq.h>
#include <math.h>

enum { RUNS = 20000, NUMBERS = 9 };

/* A number of both kinds. */
typedef struct both {
  tp_near near;
  fmpq_t exact;
} both;

static double draw_size(random_numbers *numbers) {
  const double mantissa = (double)draw_below(numbers, 1L << 53) - (double)(1L << 52);
  return ldexp(mantissa, (int)draw_below(numbers, 120) - 100);
}

/* A double that is off by no more than it says. */
static void draw_both(both *b, random_numbers *numbers) {
  arf_t exact;
  arf_init(exact);
  const double truth = draw_size(numbers);
  const double off =
      draw_below(numbers, 3) == 0 ? 0 : truth * ldexp(1, -(int)draw_below(numbers, 50) - 3);
  arf_set_d(exact, truth);
  arf_get_fmpq(b->exact, exact);
  b->near = (tp_near){truth + off, fabs(off) * (1 + 0x1p-40) + fabs(truth) * 0x1p-50};
  arf_clear(exact);
}

static void check_within(const both *b) {
  arf_t own;
  fmpq_t gap, bound;
  arf_init(own);
  fmpq_init(gap);
  fmpq_init(bound);
  if (isfinite(b->near.value) && isfinite(b->near.error)) {
    arf_set_d(own, b->near.value);
    arf_get_fmpq(gap, own);
    fmpq_sub(gap, gap, b->exact);
    fmpq_abs(gap, gap);
    arf_set_d(own, b->near.error);
    arf_get_fmpq(bound, own);
    ck_assert(fmpq_cmp(gap, bound) <= 0);
  }
  const int sign = tp_near_sign(b->near);
  ck_assert(sign == 0 || sign == fmpq_sgn(b->exact));
  arf_clear(own);
  fmpq_clear(gap);
  fmpq_clear(bound);
}

static void cross_exactly(fmpq_t component, const both *a, const both *b, int k) {
  fmpq_t term;
  fmpq_init(term);
  fmpq_mul(component, a[(k + 1) % 3].exact, b[(k + 2) % 3].exact);
  fmpq_mul(term, a[(k + 2) % 3].exact, b[(k + 1) % 3].exact);
  fmpq_sub(component, component, term);
  fmpq_clear(term);
}

START_TEST(products_of_triples_stay_within_their_bounds) {
  random_numbers numbers = random_numbers_from(15);
  both n[NUMBERS], cross[3], volume;
  for (int k = 0; k < NUMBERS; k++) fmpq_init(n[k].exact);
  for (int k = 0; k < 3; k++) fmpq_init(cross[k].exact);
  fmpq_init(volume.exact);
  long told = 0;
  for (int run = 0; run < RUNS; run++) {
    for (int k = 0; k < NUMBERS; k++) draw_both(n + k, &numbers);
    if (run % 2 == 0) { /* the third but for a rounding in the plane of the others */
      for (int k = 0; k < 3; k++) {
        n[6 + k].near = tp_near_add(n[k].near, n[3 + k].near);
        fmpq_add(n[6 + k].exact, n[k].exact, n[3 + k].exact);
      }
    }
    tp_near of[3][3], product[3];
    for (int k = 0; k < NUMBERS; k++) of[k / 3][k % 3] = n[k].near;
    tp_near_cross(product, of[0], of[1]);
    fmpq_zero(volume.exact);
    for (int k = 0; k < 3; k++) {
      cross[k].near = product[k];
      cross_exactly(cross[k].exact, n, n + 3, k);
      check_within(cross + k);
      fmpq_addmul(volume.exact, cross[k].exact, n[6 + k].exact);
    }
    volume.near = tp_near_dot(product, of[2]);
    check_within(&volume);
    if (run % 2 == 0) ck_assert_int_eq(tp_near_sign(volume.near), 0);
    told += tp_near_sign(volume.near) != 0;
  }
  ck_assert_int_gt(told, RUNS / 4); /* it does tell */
  for (int k = 0; k < NUMBERS; k++) fmpq_clear(n[k].exact);
  for (int k = 0; k < 3; k++) fmpq_clear(cross[k].exact);
  fmpq_clear(volume.exact);
}
END_TEST

START_TEST(quotients_stay_within_their_bounds) {
  random_numbers numbers = random_numbers_from(16);
  both a, b, quotient;
  fmpq_init(a.exact);
  fmpq_init(b.exact);
  fmpq_init(quotient.exact);
  for (int run = 0; run < RUNS; run++) {
    draw_both(&a, &numbers);
    draw_both(&b, &numbers);
    if (tp_near_sign(b.near) == 0) continue;
    quotient.near = tp_near_div(a.near, b.near);
    fmpq_div(quotient.exact, a.exact, b.exact);
    check_within(&quotient);
  }
  fmpq_clear(a.exact);
  fmpq_clear(b.exact);
  fmpq_clear(quotient.exact);
}
END_TEST

/* Of the square of a number. */
START_TEST(roots_stay_within_their_bounds) {
  random_numbers numbers = random_numbers_from(17);
  both root, square;
  long told = 0;
  fmpq_init(root.exact);
  fmpq_init(square.exact);
  for (int run = 0; run < RUNS; run++) {
    draw_both(&root, &numbers);
    square.near = tp_near_mul(root.near, root.near);
    fmpq_abs(root.exact, root.exact);
    root.near = tp_near_sqrt(square.near);
    told += isfinite(root.near.error);
    check_within(&root);
    ck_assert(!isfinite(tp_near_sqrt(tp_near_neg(square.near)).error));
  }
  ck_assert_int_gt(told, RUNS / 2);
  fmpq_clear(root.exact);
  fmpq_clear(square.exact);
}
END_TEST

START_TEST(balls_and_whole_numbers_lie_within) {
  both own;
  fmpq_init(own.exact);
  flint_rand_t state;
  arb_t ball;
  flint_randinit(state);
  arb_init(ball);
  for (int run = 0; run < RUNS; run++) {
    arb_randtest(ball, state, 1 + (long)n_randint(state, 200), 12);
    own.near = tp_ball_near(ball);
    arb_get_rand_fmpq(own.exact, state, ball, 1 + (long)n_randint(state, 100));
    check_within(&own);
    fmpq_one(own.exact);
    fmpz_randtest(fmpq_numref(own.exact), state, 1 + (flint_bitcnt_t)n_randint(state, 1500));
    own.near = tp_near_whole(fmpq_numref(own.exact));
    check_within(&own);
  }
  arb_clear(ball);
  flint_randclear(state);
  fmpq_clear(own.exact);
}
END_TEST

START_TEST(what_is_no_number_tells_nothing) {
  const tp_near one = {1, 0}, huge = {1e300, 0}, infinite = {0, INFINITY};
  ck_assert_int_eq(tp_near_sign(tp_near_mul(huge, huge)), 0);
  ck_assert_int_eq(tp_near_sign(tp_near_mul(infinite, one)), 0);
  ck_assert_int_eq(tp_near_sign(tp_near_sub(tp_near_mul(huge, huge), one)), 0);
  ck_assert_int_eq(tp_near_sign(tp_near_mul(one, (tp_near){NAN, 0})), 0);
  ck_assert_int_eq(tp_near_sign(tp_near_mul((tp_near){0x1p-600, 0}, (tp_near){0x1p-600, 0})), 0);
  arb_t ball;
  arb_init(ball);
  arb_indeterminate(ball);
  ck_assert_int_eq(tp_near_sign(tp_ball_near(ball)), 0);
  arb_one(ball);
  arb_mul_2exp_si(ball, ball, 5000);
  ck_assert_int_eq(tp_near_sign(tp_ball_near(ball)), 0);
  arb_clear(ball);
}
END_TEST

SUITE(near) {
  Suite *suite = suite_create("near");
  TCase *nears = tcase_create("near");
  tcase_add_test(nears, products_of_triples_stay_within_their_bounds);
  tcase_add_test(nears, quotients_stay_within_their_bounds);
  tcase_add_test(nears, roots_stay_within_their_bounds);
  tcase_add_test(nears, balls_and_whole_numbers_lie_within);
  tcase_add_test(nears, what_is_no_number_tells_nothing);
  suite_add_tcase(suite, nears);
  return suite;
}
