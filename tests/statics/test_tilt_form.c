/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where level + t rise + s fixed, t = tan(tilt) and s = 1 / cos(tilt), changes its sign, against
 * its values in balls: the sign that is told holds on either side of the tilt that is told. Also
 * where its terms all but cancel, on level ground, upright, or as it turns in between. */

#include "random_numbers.h"
#include "suite.h"

#include "case_filter/tilt_form.h"

#include <arb.h>

enum { RUNS = 20000, PARTS = 12, BITS = 200 };

/* A number and a double that is off by no more than it says. */
static tp_near draw_near(double *truth, random_numbers *numbers) {
  *truth = 2 * draw_part(numbers) - 1;
  const double off = draw_below(numbers, 2) == 0 ? 0 : 1e-13 * (2 * draw_part(numbers) - 1);
  return (tp_near){*truth + off, fabs(off) * (1 + 0x1p-40) + fabs(*truth) * 0x1p-50};
}

/* Its sign at a tangent; over cos(tilt) upright, where that is infinite. */
static int sign_at(const double truth[3], double tangent) {
  arb_t value, t, s, c;
  arb_init(value);
  arb_init(t);
  arb_init(s);
  arb_init(c);
  arb_set_d(c, truth[2]);
  if (isinf(tangent)) {
    arb_set_d(value, truth[1]);
    arb_add(value, value, c, BITS);
  } else {
    arb_set_d(t, tangent);
    arb_mul(s, t, t, BITS);
    arb_add_ui(s, s, 1, BITS);
    arb_sqrt(s, s, BITS);
    arb_mul(value, s, c, BITS);
    arb_set_d(s, truth[0]);
    arb_add(value, value, s, BITS);
    arb_set_d(s, truth[1]);
    arb_addmul(value, s, t, BITS);
  }
  const int sign = arb_is_positive(value) ? 1 : arb_is_negative(value) ? -1 : 0;
  arb_clear(value);
  arb_clear(t);
  arb_clear(s);
  arb_clear(c);
  return sign;
}

/* On so many tilts from one to another, of the sign that is told or nothing. */
static void claim_side(const double truth[3], double low, double high, int sign) {
  for (int k = 0; k <= PARTS; k++) {
    const double tangent = low + (high - low) * k / PARTS;
    if (tangent < low || tangent > high) continue;
    ck_assert_msg(sign_at(truth, tangent) * sign >= 0, "%.17g + %.17g t + %.17g s at %.17g",
                  truth[0], truth[1], truth[2], tangent);
  }
}

/* Two terms but for a little the opposite of one another, or the square of the fixed one that of
 * the others. */
static void draw_cancelling(double truth[3], tp_near near[3], random_numbers *numbers) {
  const double little = ldexp(draw_part(numbers) - 0.5, -(int)draw_below(numbers, 50));
  const int which = (int)draw_below(numbers, 3);
  truth[2] =
      which == 2 ? copysign(hypot(truth[0], truth[1]), -truth[0]) + little : -truth[which] + little;
  near[2] = (tp_near){truth[2], fabs(truth[2]) * 0x1p-50};
}

START_TEST(signs_change_where_it_is_told) {
  random_numbers numbers = random_numbers_from(5);
  long told = 0, changes = 0;
  for (int run = 0; run < RUNS; run++) {
    double truth[3];
    tp_near near[3];
    for (int k = 0; k < 3; k++) near[k] = draw_near(truth + k, &numbers);
    if (run % 2 == 0) draw_cancelling(truth, near, &numbers);
    const tp_tilt_form form = {near[0], near[1], near[2]};
    tp_tilt_change change;
    if (!tp_tilt_form_change(&change, &form)) continue;
    told++;
    ck_assert_int_eq(change.level, sign_at(truth, 0));
    ck_assert_int_eq(change.upright, sign_at(truth, INFINITY));
    if (change.level == change.upright) {
      claim_side(truth, 0, 3, change.level);
      claim_side(truth, 3, 300, change.level);
      continue;
    }
    changes++;
    const double low = nextafter(change.tangent.value - change.tangent.error, 0);
    const double high = nextafter(change.tangent.value + change.tangent.error, INFINITY);
    claim_side(truth, 0, low, change.level);
    claim_side(truth, high, 2 * high, change.upright);
    claim_side(truth, 2 * high, 1000 * high, change.upright);
  }
  ck_assert_msg(told > RUNS * 3 / 4 && changes > RUNS / 4, "%ld told, %ld change", told, changes);
}
END_TEST

/* The secant of a tilt, and a form where it is given. */
START_TEST(values_of_a_form) {
  const tp_tilt_form form = {{3, 0}, {2, 0}, {-1, 0}};
  const tp_near tangent = {0.75, 0}, secant = tp_tilt_secant(tangent);
  ck_assert_double_le(fabs(secant.value - 1.25), secant.error);
  const tp_near value = tp_tilt_form_at(&form, tangent, secant);
  ck_assert_double_le(fabs(value.value - 3.25), value.error);
  ck_assert_double_le(value.error, 1e-14);
}
END_TEST

SUITE(tilt_form) {
  Suite *suite = suite_create("tilt_form");
  TCase *tests = tcase_create("tilt_form");
  tcase_set_timeout(tests, 0);
  tcase_add_test(tests, signs_change_where_it_is_told);
  tcase_add_test(tests, values_of_a_form);
  suite_add_tcase(suite, tests);
  return suite;
}
