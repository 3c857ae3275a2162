/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sine, cosine and arctangent in doubles with bounds, against Arb's. */

#include "random_runs.h"
#include "suite.h"

#include "number/ball.h"
#include "number/near_angle.h"

#include <math.h>

/* Does the double with its bound hold the truth, and is it as narrow as `most` of its size? */
static void check(tp_near own, const arb_t truth, double most, double degrees) {
  arb_t apart;
  arb_init(apart);
  arb_set_d(apart, own.value);
  arb_sub(apart, apart, truth, 200);
  arb_abs(apart, apart);
  arb_t error;
  arb_init(error);
  arb_set_d(error, own.error);
  ck_assert_msg(arb_le(apart, error), "at %a: %a +- %a", degrees, own.value, own.error);
  ck_assert_msg(own.error <= most * fabs(own.value), "at %a: %a +- %a", degrees, own.value,
                own.error);
  arb_clear(apart);
  arb_clear(error);
}

/* All angles up to 90 degrees, exact ones and such as are known to a bound: then each end of it. */
START_TEST(sines_and_cosines) {
  random_numbers state = random_numbers_from(random_seed());
  arb_t angle, sine, cosine;
  arb_init(angle);
  arb_init(sine);
  arb_init(cosine);
  for (int k = 0; k < 20000; k++) {
    const double degrees =
        (k % 3 == 0 ? 45 + (draw_part(&state) - 0.5) * 1e-9 : 89.9 * draw_part(&state) + 0.01) *
        (draw_once_in(&state, 2) ? -1 : 1);
    const double error = k % 2 == 0 ? 0 : ldexp(draw_part(&state), -40);
    for (int end = -1; end <= 1; end++) {
      tp_near own_sine, own_cosine;
      tp_near_sin_cos(&own_sine, &own_cosine, (tp_near){degrees, error});
      arb_set_d(angle, error);
      arb_mul_si(angle, angle, end, 200);
      arb_t middle;
      arb_init(middle);
      arb_set_d(middle, degrees);
      arb_add(angle, angle, middle, 200);
      arb_clear(middle);
      tp_ball_sin_cos(sine, cosine, angle, 200);
      const double most = error == 0 ? 0x1p-40 : 0x1p-20;
      check(own_sine, sine, most, degrees);
      check(own_cosine, cosine, most, degrees);
    }
  }
  arb_clear(angle);
  arb_clear(sine);
  arb_clear(cosine);
}
END_TEST

/* The degrees of a tangent that is known to a bound, at either end of it. */
START_TEST(arctangents) {
  random_numbers state = random_numbers_from(random_seed());
  arb_t tangent, one, degrees;
  arb_init(tangent);
  arb_init(one);
  arb_init(degrees);
  arb_one(one);
  for (int k = 0; k < 20000; k++) {
    const double value = ldexp(draw_part(&state) - 0.5, k % 20 - 10);
    const double error = k % 2 == 0 ? 0 : fabs(value) * ldexp(draw_part(&state), -30);
    const tp_near own = tp_near_arctangent((tp_near){value, error});
    for (int end = -1; end <= 1; end++) {
      arb_set_d(tangent, value);
      arb_set_d(degrees, error);
      arb_mul_si(degrees, degrees, end, 200);
      arb_add(tangent, tangent, degrees, 200);
      tp_ball_atan2_degrees(degrees, tangent, one, 200);
      check(own, degrees, error == 0 ? 0x1p-45 : 0x1p-25, value);
    }
  }
  const tp_near none = tp_near_arctangent((tp_near){0, 0});
  ck_assert(none.value == 0 && none.error == 0);
  arb_clear(tangent);
  arb_clear(one);
  arb_clear(degrees);
}
END_TEST

/* Beyond 90 degrees, and of what is not known, nothing is told. */
START_TEST(nothing_beyond) {
  const tp_near open[] = {{90.5, 0}, {-91, 0}, {10, 2}, {NAN, 0}, {10, NAN}};
  for (size_t k = 0; k < sizeof open / sizeof open[0]; k++) {
    tp_near sine, cosine;
    tp_near_sin_cos(&sine, &cosine, open[k]);
    ck_assert_int_eq(tp_near_sign(sine), 0);
    ck_assert_int_eq(tp_near_sign(cosine), 0);
  }
  ck_assert_int_eq(tp_near_sign(tp_near_arctangent((tp_near){1, INFINITY})), 0);
  ck_assert_int_eq(tp_near_sign(tp_near_arctangent((tp_near){NAN, 0})), 0);
}
END_TEST

SUITE(near_angle) {
  Suite *suite = suite_create("near_angle");
  TCase *tests = tcase_create("near_angle");
  tcase_set_timeout(tests, 0);
  tcase_add_test(tests, sines_and_cosines);
  tcase_add_test(tests, arctangents);
  tcase_add_test(tests, nothing_beyond);
  suite_add_tcase(suite, tests);
  return suite;
}
