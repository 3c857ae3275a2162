/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Balls: a function of a ball encloses its value at every number of the ball. Numbers are drawn out
 * of random balls as rationals, and their values taken from MPFR, at far more bits than the ball
 * has. */

#include "number/ball.h"
#include "number/binary.h"
#include "random_numbers.h"
#include "suite.h"

#include <arb.h>
#include <math.h>
#include <mpfr.h>

enum { RUNS = 20000, TRUTH_BITS = 600 };

typedef struct drawn {
  flint_rand_t state;
  long bits;
  arb_t ball[2];
  fmpq_t exact[2]; /* within */
  mpfr_t value[2], scale;
  arb_t result[2], truth;
} drawn;

static void drawn_init(drawn *d) {
  flint_randinit(d->state);
  for (int k = 0; k < 2; k++) {
    arb_init(d->ball[k]);
    arb_init(d->result[k]);
    fmpq_init(d->exact[k]);
    mpfr_init2(d->value[k], TRUTH_BITS);
  }
  mpfr_init2(d->scale, TRUTH_BITS);
  arb_init(d->truth);
}

static void drawn_clear(drawn *d) {
  flint_randclear(d->state);
  for (int k = 0; k < 2; k++) {
    arb_clear(d->ball[k]);
    arb_clear(d->result[k]);
    fmpq_clear(d->exact[k]);
    mpfr_clear(d->value[k]);
  }
  mpfr_clear(d->scale);
  arb_clear(d->truth);
}

/* Exact, narrow and wide balls of sizes within 2^-6 and 2^6, and a number out of each. */
static void draw_balls(drawn *d) {
  d->bits = 2 + (long)n_randint(d->state, 200);
  for (int k = 0; k < 2; k++) {
    arb_randtest(d->ball[k], d->state, 1 + (long)n_randint(d->state, 200), 3);
    arb_get_rand_fmpq(d->exact[k], d->state, d->ball[k], 1 + (long)n_randint(d->state, 200));
    fmpq_get_mpfr(d->value[k], d->exact[k], MPFR_RNDN);
  }
}

/* Does the ball enclose MPFR's value, which is off by some 2^-TRUTH_BITS of itself? */
static bool encloses(const arb_t ball, mpfr_t value, drawn *d) {
  arf_set_mpfr(arb_midref(d->truth), value);
  mag_zero(arb_radref(d->truth));
  if (!mpfr_zero_p(value)) arb_add_error_2exp_si(d->truth, mpfr_get_exp(value) - TRUTH_BITS + 20);
  return arb_overlaps(ball, d->truth);
}

/* It does; and moved by more than its width it does not, so that the check is one. */
static void check_encloses(const arb_t ball, mpfr_t value, drawn *d) {
  ck_assert(encloses(ball, value, d));
  if (!arb_is_finite(ball) || mag_cmp_2exp_si(arb_radref(ball), 100 - TRUTH_BITS) < 0) return;
  arb_t moved;
  arf_t width;
  arb_init(moved);
  arf_init(width);
  arf_set_mag(width, arb_radref(ball));
  arf_mul_ui(width, width, 3, ARF_PREC_EXACT, ARF_RND_DOWN);
  arb_add_arf(moved, ball, width, ARF_PREC_EXACT);
  ck_assert(!encloses(moved, value, d));
  arb_clear(moved);
  arf_clear(width);
}

START_TEST(angles_enclose) {
  drawn d;
  drawn_init(&d);
  for (int k = 0; k < RUNS; k++) {
    draw_balls(&d);
    tp_ball_atan2_degrees(d.result[0], d.ball[0], d.ball[1], d.bits);
    mpfr_atan2(d.value[0], d.value[0], d.value[1], MPFR_RNDN);
    mpfr_const_pi(d.scale, MPFR_RNDN);
    mpfr_div(d.value[0], d.value[0], d.scale, MPFR_RNDN);
    mpfr_mul_ui(d.value[0], d.value[0], 180, MPFR_RNDN);
    check_encloses(d.result[0], d.value[0], &d);
  }
  drawn_clear(&d);
}
END_TEST

START_TEST(sines_enclose) {
  drawn d;
  drawn_init(&d);
  for (int k = 0; k < RUNS; k++) {
    draw_balls(&d);
    if (k % 2 == 0) { /* of a ball */
      tp_ball_sin_cos(d.result[0], d.result[1], d.ball[0], d.bits);
    } else { /* of a number, some of them whole degrees */
      if (k % 3 == 0) fmpq_set_si(d.exact[0], (long)n_randint(d.state, 1000) - 500, 1);
      fmpq_get_mpfr(d.value[0], d.exact[0], MPFR_RNDN);
      tp_ball_sin_cos_degrees(d.result[0], d.result[1], d.exact[0], d.bits);
    }
    mpfr_const_pi(d.scale, MPFR_RNDN);
    mpfr_mul(d.value[0], d.value[0], d.scale, MPFR_RNDN);
    mpfr_div_ui(d.value[0], d.value[0], 180, MPFR_RNDN);
    mpfr_sin_cos(d.value[0], d.value[1], d.value[0], MPFR_RNDN);
    for (int of = 0; of < 2; of++) {
      if (arb_is_exact(d.result[of])) { /* 0, 1 or -1, which MPFR comes near */
        arb_add_error_2exp_si(d.result[of], 40 - TRUTH_BITS);
      }
      check_encloses(d.result[of], d.value[of], &d);
    }
  }
  drawn_clear(&d);
}
END_TEST

/* The way back to doubles encloses: for random balls, both ends lie within value +- error. The
 * comparison is exact (arf), so no tolerance is needed. */
START_TEST(balls_to_doubles_enclose) {
  flint_rand_t state;
  arb_t ball, around;
  flint_randinit(state);
  arb_init(ball);
  arb_init(around);
  for (int k = 0; k < 20000; k++) {
    arb_randtest(ball, state, 200, 8);
    const tp_bounded result = tp_ball_bounded(ball);
    if (!isfinite(result.error)) continue;
    arf_set_d(arb_midref(around), result.value);
    arf_t error;
    arf_init(error);
    arf_set_d(error, result.error);
    arb_set_arf(around, arb_midref(around));
    arb_add_error_arf(around, error);
    ck_assert(arb_contains(around, ball));
    arf_clear(error);
  }
  arb_clear(ball);
  arb_clear(around);
  flint_randclear(state);
}
END_TEST

/* What lies outside the range of a double says so instead of lying. */
START_TEST(out_of_range) {
  arb_t ball;
  arb_init(ball);
  arb_set_str(ball, "1e600", 100);
  ck_assert(isinf(tp_ball_bounded(ball).error));
  arb_set_str(ball, "1e-600", 100);
  const tp_bounded tiny = tp_ball_bounded(ball);
  ck_assert(tiny.value == 0 && tiny.error > 0 && tiny.error < 1e-300);
  arb_clear(ball);
}
END_TEST

/* Multiples of 45 degrees are exact in all octants, and one unit beside them they are not. */
START_TEST(exact_angles) {
  arb_t x, y, angle;
  arb_init(x);
  arb_init(y);
  arb_init(angle);
  static const int octants[8][3] = {{0, 3, 0},    {2, 2, 45},   {5, 0, 90},   {1, -1, 135},
                                    {0, -4, 180}, {-3, 3, -45}, {-1, 0, -90}, {-7, -7, -135}};
  for (int k = 0; k < 8; k++) {
    arb_set_si(y, octants[k][0]);
    arb_set_si(x, octants[k][1]);
    tp_ball_atan2_degrees(angle, y, x, 64);
    ck_assert(arb_is_exact(angle) && arb_equal_si(angle, octants[k][2]));
    arb_mul_2exp_si(x, x, 60);
    arb_mul_2exp_si(y, y, 60);
    arb_add_si(octants[k][0] == 0 ? y : x, octants[k][0] == 0 ? y : x, 1, ARF_PREC_EXACT);
    tp_ball_atan2_degrees(angle, y, x, 100);
    ck_assert(!arb_is_exact(angle) && !arb_contains_si(angle, octants[k][2]));
    arb_sub_si(angle, angle, octants[k][2], 100);
    ck_assert(mag_get_d(arb_radref(angle)) < 1e-20 && arf_cmpabs_d(arb_midref(angle), 1e-15) < 0);
  }
  arb_zero(x);
  arb_zero(y);
  tp_ball_atan2_degrees(angle, y, x, 64);
  ck_assert(arb_is_zero(angle));
  arb_set_si(y, 1);
  arb_set_si(x, 2);
  tp_ball_atan2_degrees(angle, y, x, 64);
  ck_assert(!arb_is_exact(angle) && tp_ball_certain(angle, 15));
  ck_assert(fabs(tp_ball_bounded(angle).value - 26.56505117707799) < 1e-13); /* atan(1/2) */
  arb_clear(x);
  arb_clear(y);
  arb_clear(angle);
}
END_TEST

/* sin and cos of rational degrees: exact at quarter turns, and sin^2 + cos^2 encloses 1. */
START_TEST(functions_of_degrees) {
  fmpq_t degrees;
  arb_t sine, cosine;
  fmpq_init(degrees);
  arb_init(sine);
  arb_init(cosine);
  for (long k = -720; k <= 720; k += 15) {
    fmpq_set_si(degrees, k, 1);
    tp_ball_sin_cos_degrees(sine, cosine, degrees, 100);
    ck_assert_int_eq(k % 90 == 0, arb_is_exact(sine) && arb_is_exact(cosine));
    arb_mul(sine, sine, sine, 100);
    arb_addmul(sine, cosine, cosine, 100);
    ck_assert(arb_contains_si(sine, 1) && tp_ball_certain(sine, 20));
  }
  fmpq_clear(degrees);
  arb_clear(sine);
  arb_clear(cosine);
}
END_TEST

static void expect_nearest(const arf_struct *number) {
  const double own = tp_ball_nearest(number), arb = arf_get_d(number, ARF_RND_NEAR);
  ck_assert_msg(own == arb && signbit(own) == signbit(arb), "%a instead of %a", own, arb);
}

/* As Arb rounds by way of MPFR: one word and more, ties with and without something below them, and
 * exponents in and beyond the range of doubles. */
START_TEST(doubles_of_balls_are_those_of_arb) {
  enum { ROUNDS = 20000 };
  random_numbers numbers = random_numbers_from(11);
  arf_t number, little;
  arf_init(number);
  arf_init(little);
  for (int round = 0; round < ROUNDS; round++) {
    arf_set_ui(number, draw(&numbers));
    if (round % 2 == 0) { /* beside half a unit of the last place, or on it */
      arf_set_ui(number, (draw(&numbers) | (uint64_t)1 << 63) & ~(uint64_t)0x3ff);
      arf_set_si_2exp_si(little, draw_below(&numbers, 3) - 1, -draw_below(&numbers, 200));
      arf_add(number, number, little, ARF_PREC_EXACT, ARF_RND_DOWN);
    }
    if (round % 3 == 0) arf_mul_2exp_si(number, number, draw_below(&numbers, 2400) - 1200);
    if (draw_below(&numbers, 2) == 0) arf_neg(number, number);
    expect_nearest(number);
  }
  arf_zero(number);
  expect_nearest(number);
  arf_neg_inf(number);
  expect_nearest(number);
  arf_clear(number);
  arf_clear(little);
}
END_TEST

START_TEST(powers_of_two_are_those_of_the_library) {
  for (int exponent = DBL_MIN_EXP - 1; exponent < DBL_MAX_EXP; exponent++) {
    int of_library = 0;
    const double power = ldexp(1, exponent), above = nextafter(power, INFINITY);
    ck_assert(tp_two_to(exponent) == power);
    (void)frexp(above, &of_library);
    ck_assert_int_eq(tp_binary_exponent(above), of_library);
    ck_assert_int_eq(tp_binary_exponent(power), of_library);
  }
  ck_assert(tp_larger(1, 2) == 2 && tp_larger(2, 1) == 2 && tp_larger(1, NAN) == 1);
}
END_TEST

SUITE(ball) {
  Suite *suite = suite_create("ball");
  TCase *balls = tcase_create("ball");
  tcase_add_test(balls, angles_enclose);
  tcase_add_test(balls, sines_enclose);
  tcase_add_test(balls, exact_angles);
  tcase_add_test(balls, functions_of_degrees);
  tcase_add_test(balls, balls_to_doubles_enclose);
  tcase_add_test(balls, out_of_range);
  tcase_add_test(balls, doubles_of_balls_are_those_of_arb);
  tcase_add_test(balls, powers_of_two_are_those_of_the_library);
  suite_add_tcase(suite, balls);
  return suite;
}
