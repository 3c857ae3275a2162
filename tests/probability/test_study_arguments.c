/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Arguments of studies that no call can do anything with (tests/library/test_arguments.c has those
 * of all others). */

#include "refused.h"

static tp_study *slab_study(void) {
  tp_study *study = NULL;
  ck_assert_int_eq(tp_study_read(&study, EXAMPLE("studies/slab_study.yaml"), &message), TP_OK);
  return study;
}

START_TEST(read) {
  tp_study *study = UNTOUCHED(tp_study);
  REFUSED(tp_study_read(NULL, EXAMPLE("studies/slab_study.yaml"), &message), "'study'");
  REFUSED(tp_study_read(&study, NULL, &message), "'path'");
  REFUSED(tp_study_read_text(NULL, "topple_study: 1", "a", &message), "'study'");
  REFUSED(tp_study_read_text(&study, NULL, "a", &message), "'text'");
  REFUSED(tp_study_read_text(&study, "topple_study: 1", NULL, &message), "'name'");
  REFUSED(tp_study_read_text(&study, "scene: a.yaml", "a", &message), "not a study");
  ck_assert_int_eq(tp_study_read(&study, EXAMPLE("studies/none.yaml"), &message), TP_SYSTEM_FAILED);
  ck_assert_ptr_nonnull(strstr(message.text, "opened"));
  REFUSED(tp_study_read(&study, EXAMPLE("slab.yaml"), &message), "not a study");
  ck_assert_ptr_eq(study, UNTOUCHED(tp_study));
  tp_study_free(NULL);
}
END_TEST

START_TEST(charts) {
  tp_study *study = slab_study();
  tp_study_result *result = NULL;
  tp_chart *chart = UNTOUCHED(tp_chart);
  const tp_study_options options = tp_study_options_default();
  ck_assert_int_eq(tp_study_run(&result, study, &options, &message), TP_OK);
  REFUSED(tp_chart_study(NULL, result, &message), "'chart'");
  REFUSED(tp_chart_study(&chart, NULL, &message), "'result'");
  REFUSED(tp_chart_study_scatter(NULL, result, &message), "'chart'");
  REFUSED(tp_chart_study_scatter(&chart, NULL, &message), "'result'");
  ck_assert_ptr_eq(chart, UNTOUCHED(tp_chart));
  const tp_sheet_options sheet = tp_sheet_options_default();
  const tp_sheet_options sized = {.size = 4096};
  REFUSED(tp_report_sheet_study(NULL, study, result, &sheet, &message), "'path'");
  REFUSED(tp_report_sheet_study("x.html", NULL, result, &sheet, &message), "'study'");
  REFUSED(tp_report_sheet_study("x.html", study, NULL, &sheet, &message), "'result'");
  REFUSED(tp_report_sheet_study("x.html", study, result, NULL, &message), "'options'");
  REFUSED(tp_report_sheet_study("x.html", study, result, &sized, &message), "the size");
  REFUSED(tp_report_sheet_study("x.svg", study, result, &sheet, &message), ".html, .md or .pdf");
  tp_study_result_free(result);
  tp_study_free(study);
}
END_TEST

START_TEST(run) {
  tp_study *study = slab_study();
  tp_study_result *result = UNTOUCHED(tp_study_result);
  const tp_study_options options = tp_study_options_default();
  REFUSED(tp_study_run(NULL, study, &options, &message), "'result'");
  REFUSED(tp_study_run(&result, NULL, &options, &message), "'study'");
  REFUSED(tp_study_run(&result, study, NULL, &message), "'options'");
  static const size_t shards[][2] = {{0, 1}, {2, 1}, {1, 0}, {1, (size_t)1 << 40}};
  for (size_t k = 0; k < sizeof shards / sizeof shards[0]; k++) {
    tp_study_options bad = options;
    bad.shard = shards[k][0];
    bad.shards = shards[k][1];
    REFUSED(tp_study_run(&result, study, &bad, &message), "shard");
  }
  const tp_study_ranks ranks[] = {{.rank = 0, .count = 0}, {.rank = 3, .count = 3}, {.count = 2}};
  for (size_t k = 0; k < sizeof ranks / sizeof ranks[0]; k++) {
    tp_study_options bad = options;
    bad.ranks = ranks + k;
    REFUSED(tp_study_run(&result, study, &bad, &message), "rank");
  }
  for (size_t k = 0; k < 2; k++) {
    const tp_study_options sized = {.size = k == 0 ? 0 : 4096};
    REFUSED(tp_study_run(&result, study, &sized, &message), "the size");
  }
  tp_study_options there = options;
  there.rows = EXAMPLE("studies/slab.yaml");
  REFUSED(tp_study_run(&result, study, &there, &message), "reads");
  there.restart = true;
  REFUSED(tp_study_run(&result, study, &there, &message), "reads");
  there.rows = "rows.h5";
  there.shards = 2;
  REFUSED(tp_study_run(&result, study, &there, &message), "a shard writes CSV");
  ck_assert_ptr_eq(result, UNTOUCHED(tp_study_result));
  tp_study_result_free(NULL);
  tp_study_free(study);
}
END_TEST

START_TEST(merge) {
  tp_study *study = slab_study();
  tp_study_result *result = UNTOUCHED(tp_study_result);
  const tp_study_options options = tp_study_options_default();
  const tp_study_options sized = {.size = 4096};
  const char *const none[] = {EXAMPLE("slab.yaml"), NULL};
  REFUSED(tp_study_merge(NULL, study, none, 1, &options, &message), "'result'");
  REFUSED(tp_study_merge(&result, NULL, none, 1, &options, &message), "'study'");
  REFUSED(tp_study_merge(&result, study, NULL, 1, &options, &message), "'shards'");
  REFUSED(tp_study_merge(&result, study, none, 2, &options, &message), "'shards[k]'");
  REFUSED(tp_study_merge(&result, study, none, 1, NULL, &message), "'options'");
  REFUSED(tp_study_merge(&result, study, none, 1, &sized, &message), "the size");
  REFUSED(tp_study_merge(&result, study, none, 1, &options, &message), "progress");
  REFUSED(tp_study_merge(&result, study, none, 0, &options, &message), "shards");
  ck_assert_ptr_eq(result, UNTOUCHED(tp_study_result));
  tp_study_free(study);
}
END_TEST

START_TEST(reports) {
  tp_study *study = slab_study();
  tp_study_result *result = NULL;
  const tp_study_options options = tp_study_options_default();
  char *text = &untouched;
  ck_assert_int_eq(tp_study_run(&result, study, &options, NULL), TP_OK);
  UNWRITTEN(tp_report_study(NULL, result));
  UNWRITTEN(tp_report_study(&text, NULL));
  UNWRITTEN(tp_report_study_json(NULL, result));
  UNWRITTEN(tp_report_study_json(&text, NULL));
  ck_assert_ptr_eq(text, &untouched);
  ck_assert_str_eq(tp_study_outcome_name((tp_study_outcome)TP_STUDY_OUTCOMES), "unknown");
  ck_assert_str_eq(tp_study_quantity_name((tp_study_quantity)TP_STUDY_QUANTITIES), "unknown");
  tp_study_result_free(result);
  tp_study_free(study);
}
END_TEST

SUITE(study_arguments) {
  Suite *suite = suite_create("arguments of studies");
  TCase *tests = tcase_create("arguments of studies");
  tcase_add_test(tests, read);
  tcase_add_test(tests, run);
  tcase_add_test(tests, charts);
  tcase_add_test(tests, merge);
  tcase_add_test(tests, reports);
  suite_add_tcase(suite, tests);
  return suite;
}
