/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Arguments that no analysis can do anything with, as in test_arguments.c: back-analysis, formulas,
 * claims and accuracy. */

#include "example_scene.h"
#include "refused.h"

#include <math.h>

START_TEST(back_analysis) {
  const tp_find_options good = {.size = sizeof good,
                                .key = "block.slab.width",
                                .target = TP_FIND_CRITICAL_ANGLE,
                                .value = 20};
  tp_scene *scene = example_scene();
  tp_find_options bad = good;
  tp_found *found = UNTOUCHED(tp_found), *own = NULL;
  char *text = &untouched;
  REFUSED(tp_find(NULL, scene, &good, &message), "'found'");
  REFUSED(tp_find(&found, NULL, &good, &message), "'scene'");
  REFUSED(tp_find(&found, scene, NULL, &message), "'options'");
  bad.key = NULL;
  REFUSED(tp_find(&found, scene, &bad, &message), "key");
  for (int k = -1; k <= TP_FIND_ACCELERATION + 1; k += TP_FIND_ACCELERATION + 2) {
    bad = good;
    bad.target = (tp_find_target)k;
    REFUSED(tp_find(&found, scene, &bad, &message), "result");
    ck_assert_str_eq(tp_find_target_name(bad.target), "unknown");
  }
  static const double no_numbers[] = {NAN, INFINITY, -INFINITY};
  for (size_t k = 0; k < 3; k++) {
    bad = good;
    bad.value = no_numbers[k];
    REFUSED(tp_find(&found, scene, &bad, &message), "finite");
    bad = (tp_find_options){
        .size = sizeof bad, .key = good.key, .value = 20, .has_high = true, .high = no_numbers[k]};
    REFUSED(tp_find(&found, scene, &bad, &message), "finite");
    bad.low = no_numbers[k];
    bad.has_low = true;
    REFUSED(tp_find(&found, scene, &bad, &message), "finite");
  }
  ck_assert_ptr_eq(found, UNTOUCHED(tp_found));
  tp_find_target target = TP_FIND_FOS;
  ck_assert(!tp_find_target_read(NULL, "fos") && !tp_find_target_read(&target, NULL));
  tp_solution *solution = example_solution(scene);
  ck_assert_int_eq(tp_find(&own, scene, &good, &message), TP_OK);
  UNWRITTEN(tp_report_found(NULL, own, &good));
  UNWRITTEN(tp_report_found(&text, NULL, &good));
  UNWRITTEN(tp_report_found(&text, own, NULL));
  UNWRITTEN(tp_report_found_json(NULL, own, solution));
  UNWRITTEN(tp_report_found_json(&text, NULL, solution));
  UNWRITTEN(tp_report_found_json(&text, own, NULL));
  ck_assert_ptr_eq(text, &untouched);
  tp_found_free(NULL);
  tp_found_free(own);
  tp_solution_free(solution);
  tp_scene_free(scene);
}
END_TEST

START_TEST(formulas) {
  tp_scene *scene = example_scene();
  tp_derivation *derivation = UNTOUCHED(tp_derivation), *own = NULL;
  tp_family *family = UNTOUCHED(tp_family);
  tp_derive_options options = tp_derive_options_default();
  char *text = &untouched;
  REFUSED(tp_derive(NULL, scene, &options, &message), "'derivation'");
  REFUSED(tp_derive(&derivation, NULL, &options, &message), "'scene'");
  REFUSED(tp_derive(&derivation, scene, NULL, &message), "'options'");
  REFUSED(tp_derive_family(NULL, scene, TP_NOTATION_TEXT, &message), "'family'");
  REFUSED(tp_derive_family(&family, NULL, TP_NOTATION_TEXT, &message), "'scene'");
  ck_assert_int_eq(tp_derive(&own, scene, &options, &message), TP_OK);
  options.notation = (tp_notation)3;
  REFUSED(tp_derive(&derivation, scene, &options, &message), "notation");
  REFUSED(tp_derive_family(&family, scene, (tp_notation)-1, &message), "notation");
  ck_assert_ptr_eq(derivation, UNTOUCHED(tp_derivation));
  ck_assert_ptr_eq(family, UNTOUCHED(tp_family));
  UNWRITTEN(tp_report_derivation(NULL, own));
  UNWRITTEN(tp_report_derivation(&text, NULL));
  UNWRITTEN(tp_report_derivation_json(NULL, own));
  UNWRITTEN(tp_report_derivation_json(&text, NULL));
  UNWRITTEN(tp_report_family(&text, NULL));
  UNWRITTEN(tp_report_family_json(&text, NULL));
  const tp_family empty = {0};
  UNWRITTEN(tp_report_family(NULL, &empty));
  UNWRITTEN(tp_report_family_json(NULL, &empty));
  ck_assert_ptr_eq(text, &untouched);
  tp_derivation_free(NULL);
  tp_family_free(NULL);
  tp_derivation_free(own);
  tp_scene_free(scene);
}
END_TEST

START_TEST(verdicts) {
  tp_verification *verification = UNTOUCHED(tp_verification);
  const tp_verification empty = {0};
  char *text = &untouched;
  REFUSED(tp_verify(NULL, "x", &message), "'verification'");
  REFUSED(tp_verify(&verification, NULL, &message), "'path'");
  REFUSED(tp_verify_text(NULL, "x", "x", &message), "'verification'");
  REFUSED(tp_verify_text(&verification, NULL, "x", &message), "'text'");
  REFUSED(tp_verify_text(&verification, "x", NULL, &message), "'name'");
  ck_assert_ptr_eq(verification, UNTOUCHED(tp_verification));
  ck_assert(tp_verification_objects(NULL));
  ck_assert_str_eq(tp_verdict_name((tp_verdict)TP_VERDICTS), "unknown");
  ck_assert_str_eq(tp_verdict_name((tp_verdict)-1), "unknown");
  UNWRITTEN(tp_report_verification(NULL, &empty));
  UNWRITTEN(tp_report_verification(&text, NULL));
  UNWRITTEN(tp_report_verification_json(NULL, &empty));
  UNWRITTEN(tp_report_verification_json(&text, NULL));
  UNWRITTEN(tp_report_verification_markdown(NULL, &empty));
  UNWRITTEN(tp_report_verification_markdown(&text, NULL));
  ck_assert_ptr_eq(text, &untouched);
  tp_verification_free(NULL);
}
END_TEST

START_TEST(accuracy) {
  tp_accuracy *measured = UNTOUCHED(tp_accuracy);
  tp_chart *chart = UNTOUCHED(tp_chart);
  const tp_accuracy empty = {0};
  char *text = &untouched;
  tp_scene *scene = example_scene();
  REFUSED(tp_accuracy_of_scene(NULL, scene, &message), "'accuracy'");
  REFUSED(tp_accuracy_of_scene(&measured, NULL, &message), "'scene'");
  REFUSED(tp_accuracy_sweep(NULL, 10, 10, &message), "'accuracy'");
  static const size_t sizes[][2] = {{0, 10}, {10, 0}, {100, 10}, {10, SIZE_MAX}, {SIZE_MAX, 10}};
  for (size_t k = 0; k < sizeof sizes / sizeof sizes[0]; k++) {
    REFUSED(tp_accuracy_sweep(&measured, sizes[k][0], sizes[k][1], &message), "sweep");
  }
  REFUSED(tp_chart_accuracy(NULL, &empty, &message), "'chart'");
  REFUSED(tp_chart_accuracy(&chart, NULL, &message), "'accuracy'");
  ck_assert_ptr_eq(measured, UNTOUCHED(tp_accuracy));
  ck_assert_ptr_eq(chart, UNTOUCHED(tp_chart));
  ck_assert_str_eq(tp_accuracy_method_name((tp_accuracy_method)TP_ACCURACY_METHODS), "unknown");
  UNWRITTEN(tp_report_accuracy(NULL, &empty));
  UNWRITTEN(tp_report_accuracy(&text, NULL));
  UNWRITTEN(tp_report_accuracy_json(NULL, &empty));
  UNWRITTEN(tp_report_accuracy_json(&text, NULL));
  ck_assert_ptr_eq(text, &untouched);
  tp_accuracy_free(NULL);
  tp_scene_free(scene);
}
END_TEST

START_TEST(words) {
  char *text = &untouched;
  REFUSED(tp_report_explained(NULL, "tilt", &message), "'text'");
  REFUSED(tp_report_explained(&text, NULL, &message), "'word'");
  UNWRITTEN(tp_report_terms(NULL));
  ck_assert_int_eq(tp_report_explained(&text, "", &message), TP_NO_ANSWER);
  ck_assert_int_eq(tp_report_explained(&text, "[]- _", &message), TP_NO_ANSWER);
  ck_assert_ptr_eq(text, &untouched);
}
END_TEST

SUITE(analysis_arguments) {
  Suite *suite = suite_create("analysis_arguments");
  TCase *tests = tcase_create("arguments");
  tcase_set_timeout(tests, 600);
  tcase_add_test(tests, back_analysis);
  tcase_add_test(tests, formulas);
  tcase_add_test(tests, verdicts);
  tcase_add_test(tests, accuracy);
  tcase_add_test(tests, words);
  suite_add_tcase(suite, tests);
  return suite;
}
