/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The arctangent in degrees against Arb's. */

#include "random_runs.h"
#include "suite.h"

#include "number/arctangent.h"
#include "number/ball.h"

#include <math.h>

/* Within 2^-49 of Arb's, in all quadrants and on both sides of every sixteenth. */
START_TEST(arctangents) {
  random_numbers state = random_numbers_from(random_seed());
  arb_t y, x, truth, error;
  arb_init(y);
  arb_init(x);
  arb_init(truth);
  arb_init(error);
  for (int k = 0; k < 20000; k++) {
    const double sixteenth = (double)draw_below(&state, 18) / 16 + (draw_part(&state) - 0.5) / 8;
    double up = k % 3 == 0    ? sixteenth
                : k % 50 == 1 ? 0
                              : ldexp(1 + draw_part(&state), k % 890 - 445);
    double along = k % 3 == 0 ? 1 : k % 50 == 4 ? 0 : ldexp(1 + draw_part(&state), k % 700 - 350);
    if (up == 0 && along == 0) continue;
    if (draw_once_in(&state, 2)) up = -up;
    if (draw_once_in(&state, 2)) along = -along;
    if (draw_once_in(&state, 2)) {
      const double held = up;
      up = along;
      along = held;
    }
    const double own = tp_arctangent_degrees(up, along);
    arb_set_d(y, up);
    arb_set_d(x, along);
    tp_ball_atan2_degrees(truth, y, x, 200);
    arb_set_d(error, own);
    arb_sub(error, error, truth, 200);
    arb_abs(error, error);
    arb_abs(truth, truth);
    arb_mul_2exp_si(truth, truth, -49);
    ck_assert_msg(arb_le(error, truth) || up == 0, "atan2(%a, %a) is not %a", up, along, own);
    if (up == 0) ck_assert_double_eq(fabs(own), along > 0 ? 0 : 180);
  }
  arb_clear(y);
  arb_clear(x);
  arb_clear(truth);
  arb_clear(error);
}
END_TEST

SUITE(arctangent) {
  Suite *suite = suite_create("arctangent");
  TCase *tests = tcase_create("arctangent");
  tcase_set_timeout(tests, 0);
  tcase_add_test(tests, arctangents);
  suite_add_tcase(suite, tests);
  return suite;
}
