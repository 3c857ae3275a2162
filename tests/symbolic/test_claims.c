/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Claims from within: the verdict on a formula about a slab that is right, wrong by a factor, right
 * at the claim's own values alone, or not rational. */

#include "suite.h"
#include "verify/decide.h"
#include "verify/domain.h"
#include "verify_bench.h"

#include <stdlib.h>
#include <string.h>

/* The verdict on a printed formula. The caller frees what the result holds. */
static tp_claim_result decide(bench *b, const char *quantity, const char *text) {
  tp_formula formulas[2];
  tp_claim_result result = {.is_formula = true};
  read_claim_formula(formulas, b, quantity);
  read_claim_formula(formulas + 1, b, text);
  b->subject.domain = tp_domain_new(&b->subject, &b->sample);
  ck_assert_ptr_nonnull(b->subject.domain);
  const tp_question question = {.subject = &b->subject,
                                .quantity = formulas,
                                .printed = formulas + 1,
                                .number = text,
                                .sample = &b->sample,
                                .message = &b->message};
  ck_assert_msg(tp_decide_formula(&result, &question) == TP_OK, "%s", b->message.text);
  tp_domain_free(b->subject.domain);
  b->subject.domain = NULL;
  tp_subject_forget(&b->subject);
  tp_formula_clear(formulas);
  tp_formula_clear(formulas + 1);
  return result;
}

static void drop(tp_claim_result *result) {
  free(result->computed);
  free(result->difference);
  free(result->mend);
  free(result->change);
  free(result->condition);
  free(result->at);
}

/* Right: proven, and nothing to add. Angles are compared by their tangents. */
START_TEST(a_right_formula_is_proven) {
  static const char *const cases[][2] = {{"area", "wh"},
                                         {"fos", "(w/h) cot α"},
                                         {"fos", "w/(h tan α)"},
                                         {"critical_angle", "tan^-1(w/h)"},
                                         {"x_arm^2 + y_arm^2", "(w^2 + h^2)/4"},
                                         {"block_width", "sqrt(w^2)"},
                                         {"sin^2 psi + cos^2 psi", "m/5*5/m"}};
  bench b;
  bench_init(&b);
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    tp_claim_result result = decide(&b, cases[k][0], cases[k][1]);
    ck_assert_msg(result.verdict == TP_VERDICT_PROVEN, "%s: %s", cases[k][1],
                  tp_verdict_name(result.verdict));
    ck_assert_ptr_nonnull(result.computed);
    ck_assert_ptr_null(result.mend);
    ck_assert_ptr_null(result.difference);
    ck_assert_ptr_null(result.condition);
    drop(&result);
  }
  bench_clear(&b);
}
END_TEST

/* Wrong by a factor, a sign, an exponent or a name: refuted, with values at which both sides
 * differ, and the mend is proven when it is asked about. */
START_TEST(a_wrong_formula_is_mended) {
  static const char *const cases[][2] = {{"area", "2wh"},
                                         {"area", "wh/3"},
                                         {"x_arm", "w/3"},
                                         {"x_arm^2 + y_arm^2", "(w^2 - h^2)/4"},
                                         {"area*h", "w h^3"},
                                         {"fos", "w/(w tan α)"},
                                         {"critical_angle", "atan(w/(2h))"},
                                         {"sin(psi)^3", "sin^2 psi"}};
  bench b;
  bench_init(&b);
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    tp_claim_result result = decide(&b, cases[k][0], cases[k][1]);
    ck_assert_msg(result.verdict == TP_VERDICT_REFUTED, "%s: %s", cases[k][1],
                  tp_verdict_name(result.verdict));
    ck_assert_ptr_nonnull(result.difference);
    ck_assert_msg(result.mend != NULL && result.change != NULL, "%s", cases[k][1]);
    ck_assert(result.has_values);
    ck_assert_double_gt(fabs(result.printed_there.value - result.computed_there.value),
                        result.printed_there.error + result.computed_there.error);
    tp_claim_result again = decide(&b, cases[k][0], result.mend);
    ck_assert_msg(again.verdict == TP_VERDICT_PROVEN, "%s", result.mend);
    drop(&again);
    drop(&result);
  }
  bench_clear(&b);
}
END_TEST

/* w + 4 is the area where w = 2 and h = 3: it takes other values to tell them apart. */
START_TEST(right_at_a_point_is_refuted) {
  bench b;
  bench_init(&b);
  ck_assert_double_eq(value_of(&b, "area - (w + 4)"), 0);
  tp_claim_result result = decide(&b, "area", "w + 4");
  ck_assert_int_eq(result.verdict, TP_VERDICT_REFUTED);
  ck_assert(result.has_values);
  ck_assert_double_gt(fabs(result.printed_there.value - result.computed_there.value), 0);
  ck_assert_ptr_null(strstr(result.at, "w = 2, h = 3"));
  drop(&result);
  bench_clear(&b);
}
END_TEST

/* What is no rational function agrees at points, which is no proof, or is refuted by one. */
START_TEST(points_are_no_proof) {
  bench b;
  bench_init(&b);
  tp_claim_result result = decide(&b, "log10(area)", "log10 w + log10 h");
  ck_assert_int_eq(result.verdict, TP_VERDICT_AGREES);
  ck_assert_int_ge(result.points, 20);
  ck_assert_int_ge(result.digits, 60);
  drop(&result);
  result = decide(&b, "90 - critical_angle", "90 - atan(w/h)"); /* angles in a sum */
  ck_assert_int_eq(result.verdict, TP_VERDICT_AGREES);
  drop(&result);
  result = decide(&b, "log10(area)", "log10(w + 4)"); /* right at the claim's own values */
  ck_assert_int_eq(result.verdict, TP_VERDICT_REFUTED);
  drop(&result);
  bench_clear(&b);
}
END_TEST

SUITE(claims) {
  Suite *suite = suite_create("claims");
  TCase *tests = tcase_create("claims");
  tcase_set_timeout(tests, 300);
  tcase_add_test(tests, a_right_formula_is_proven);
  tcase_add_test(tests, a_wrong_formula_is_mended);
  tcase_add_test(tests, right_at_a_point_is_refuted);
  tcase_add_test(tests, points_are_no_proof);
  suite_add_tcase(suite, tests);
  return suite;
}
