/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The rule that chooses the governing factor (verdict/safety.h), by itself.
 *
 * The factor of safety of a block once changed its definition without any test noticing. Hence the
 * rule is tested here on true factors that the test draws: whatever is known of them, by any bounds
 * that enclose them, the result must enclose the least of them, and a requirement is met or not met
 * only where the least true factor says so. */

#include "suite.h"
#include "verdict/safety.h"

#include <math.h>

static unsigned long long draw_state;

/* A number from 0 to below 1. */
static double draw(void) {
  draw_state = draw_state * 6364136223846793005ULL + 1442695040888963407ULL;
  return (double)(draw_state >> 11) * 0x1p-53;
}

static long draw_below(long n) {
  return (long)(draw() * (double)n);
}

enum { MOST_FACTORS = 4, MOST_STATES = 3 };

typedef struct drawn_state {
  tp_safety safety;
  double truth; /* the least true factor; infinite: unbounded */
} drawn_state;

/* A true factor on the side of 1 that the state is on, now and then unbounded, and bounds of it
 * that may be unknown, exact or wide. */
static double draw_factor(tp_factor_range *range, bool moves) {
  double truth = moves ? draw() : 1 + 3 * draw();
  if (!moves && draw_below(8) == 0) truth = INFINITY;
  range->definition = draw_below(2) == 0 ? TP_FOS_BY_DRIVING : TP_FOS_BY_REDUCTION;
  range->mechanism = TP_SLIDES;
  range->least = draw_below(4) == 0 ? 0 : isinf(truth) ? 1 + 9 * draw() : truth * (1 - draw() / 2);
  range->most = draw_below(4) == 0 ? INFINITY : truth * (1 + draw());
  if (draw_below(3) == 0) range->least = range->most = truth;
  return truth;
}

static drawn_state draw_safety(void) {
  tp_factor_range ranges[MOST_FACTORS];
  const bool moves = draw_below(3) == 0;
  const bool is_known = draw_below(4) != 0;
  drawn_state state = {.truth = INFINITY};
  const size_t count = 1 + (size_t)draw_below(MOST_FACTORS);
  for (size_t k = 0; k < count; k++)
    state.truth = fmin(state.truth, draw_factor(ranges + k, moves));
  const tp_motion_verdict verdict = !is_known ? TP_VERDICT_OPEN
                                    : !moves  ? TP_VERDICT_STANDS
                                              : (tp_motion_verdict)draw_below(2);
  state.safety = tp_safety_of(verdict, ranges, count);
  return state;
}

static void expect_enclosed(const tp_safety *s, double truth) {
  ck_assert_double_le(s->least, truth);
  ck_assert_double_le(truth, s->most);
  const tp_fos fos = tp_safety_fos(s);
  if (fos.state == TP_FOS_NUMBER) {
    ck_assert_double_le(fabs(fos.value.value - truth), fos.value.error);
  }
  if (fos.state == TP_FOS_NO_OVERTURNING) ck_assert(isinf(truth));
  const double required = 3 * draw();
  const tp_design met = tp_safety_meets(s, required);
  if (met == TP_DESIGN_MET) ck_assert_double_ge(truth, fmax(required, 1));
  if (met == TP_DESIGN_NOT_MET) ck_assert(truth < required || s->verdict < TP_VERDICT_OPEN);
}

START_TEST(encloses_least_of_true_factors) {
  draw_state = 20261128;
  for (long n = 0; n < rounds(20000, 2000000); n++) {
    drawn_state states[MOST_STATES];
    tp_safety known[MOST_STATES];
    double truth = INFINITY;
    const size_t count = 1 + (size_t)draw_below(MOST_STATES);
    for (size_t k = 0; k < count; k++) {
      states[k] = draw_safety();
      known[k] = states[k].safety;
      truth = fmin(truth, states[k].truth);
      expect_enclosed(known + k, states[k].truth);
    }
    const tp_safety all = tp_safety_of_all(known, count);
    expect_enclosed(&all, truth);
    for (size_t k = 0; k < count; k++) ck_assert_int_le(all.verdict, known[k].verdict);
  }
}
END_TEST

/* Bounds that determine the result exactly, so that a rule that is merely vague fails as well. */
START_TEST(keeps_what_is_known) {
  const tp_factor_range known = {TP_FOS_BY_REDUCTION, TP_TOPPLES, 2.04773, 2.04773};
  const tp_factor_range open = {TP_FOS_BY_DRIVING, TP_MECHANISM_UNDECIDED, 0, INFINITY};
  const tp_factor_range never = {TP_FOS_BY_DRIVING, TP_INTERLOCKED, INFINITY, INFINITY};
  const tp_factor_range both[] = {open, known}, bounded[] = {never, known};
  /* An unknown counterpart leaves the known factor as an upper bound; it is not discarded. */
  tp_safety s = tp_safety_of(TP_VERDICT_STANDS, both, 2);
  ck_assert_double_eq(s.least, 1);
  ck_assert_double_eq(s.most, 2.04773);
  ck_assert_uint_eq(s.factor, 1);
  ck_assert_int_eq(tp_safety_fos(&s).state, TP_FOS_UNDECIDED);
  ck_assert_int_eq(tp_safety_meets(&s, 2.3), TP_DESIGN_NOT_MET);
  ck_assert_int_eq(tp_safety_meets(&s, 1.5), TP_DESIGN_OPEN);
  /* An unbounded counterpart leaves the known factor as the result. */
  s = tp_safety_of(TP_VERDICT_STANDS, bounded, 2);
  ck_assert_int_eq(tp_safety_fos(&s).state, TP_FOS_NUMBER);
  ck_assert_double_eq(tp_safety_fos(&s).value.value, 2.04773);
  /* The direction with the greater known factor does not govern because this one is unknown. */
  const tp_factor_range other = {TP_FOS_BY_REDUCTION, TP_SLIDES, 2.6838, 2.6838};
  const tp_safety states[] = {tp_safety_of(TP_VERDICT_STANDS, &other, 1),
                              tp_safety_of(TP_VERDICT_STANDS, both, 2)};
  ck_assert_uint_eq(tp_safety_governing(states, 2), 1);
}
END_TEST

/* Where a motion can begin, no number above 1 is reported, and nothing is met. */
START_TEST(never_exceeds_verdict) {
  const tp_factor_range held = {TP_FOS_BY_REDUCTION, TP_SLIDES, 1.3137, 1.3137};
  for (int k = TP_VERDICT_COLLAPSES; k <= TP_VERDICT_CAN_MOVE; k++) {
    const tp_safety s = tp_safety_of((tp_motion_verdict)k, &held, 1);
    ck_assert_double_le(s.most, 1);
    ck_assert_int_eq(tp_safety_meets(&s, 0.5), TP_DESIGN_NOT_MET);
  }
  const tp_safety open = tp_safety_of(TP_VERDICT_OPEN, &held, 1);
  ck_assert_int_eq(tp_safety_meets(&open, 1.1), TP_DESIGN_OPEN);
  /* A state that fails at rest fails, whatever an earthquake adds. */
  const tp_factor_range rest = {TP_FOS_BY_DRIVING, TP_TOPPLES, 0.7, 0.7};
  const tp_safety states[] = {tp_safety_of(TP_VERDICT_STANDS, &held, 1),
                              tp_safety_of(TP_VERDICT_COLLAPSES, &rest, 1)};
  const tp_safety all = tp_safety_of_all(states, 2);
  ck_assert_double_eq(all.most, 0.7);
  ck_assert_int_eq(tp_safety_meets(&all, 0.5), TP_DESIGN_NOT_MET);
}
END_TEST

SUITE(safety) {
  Suite *suite = suite_create("safety");
  TCase *tests = tcase_create("rule");
  tcase_set_timeout(tests, 0);
  tcase_add_test(tests, encloses_least_of_true_factors);
  tcase_add_test(tests, keeps_what_is_known);
  tcase_add_test(tests, never_exceeds_verdict);
  suite_add_tcase(suite, tests);
  return suite;
}
