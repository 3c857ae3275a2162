/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Arguments of charts, maps and surveys that no call can do anything with
 * (tests/library/test_arguments.c has those of all others). */

#include "refused.h"

#include <math.h>
#include <stdlib.h>

START_TEST(charts) {
  const tp_chart_fos_options fos = tp_chart_fos_options_default();
  const tp_chart_mechanisms_options mechanisms = tp_chart_mechanisms_options_default();
  tp_chart *chart = UNTOUCHED(tp_chart), *own = NULL;
  char *text = &untouched;
  REFUSED(tp_chart_fos(NULL, &fos, &message), "'chart'");
  REFUSED(tp_chart_fos(&chart, NULL, &message), "'options'");
  REFUSED(tp_chart_mechanisms(NULL, &mechanisms, &message), "'chart'");
  REFUSED(tp_chart_mechanisms(&chart, NULL, &message), "'options'");
  REFUSED(tp_chart_ranges(NULL, &message), "'chart'");
  ck_assert_int_eq(tp_chart_fos(&own, &fos, &message), TP_OK);
  UNWRITTEN(tp_report_chart_csv(NULL, own));
  UNWRITTEN(tp_report_chart_csv(&text, NULL));
  UNWRITTEN(tp_report_chart_json(NULL, own));
  UNWRITTEN(tp_report_chart_json(&text, NULL));
  REFUSED(tp_report_chart_file("/tmp/x.csv", NULL, TP_CHART_CSV, &message), "'chart'");
  REFUSED(tp_report_chart_file(NULL, own, TP_CHART_CSV, &message), "'path'");
  REFUSED(tp_report_chart_file("/tmp/x.csv", own, (tp_chart_format)4, &message), "format");
  REFUSED(tp_report_chart_file("/tmp/x.csv", own, (tp_chart_format)-1, &message), "format");
  tp_chart_format format = TP_CHART_SVG;
  ck_assert(!tp_chart_format_read(NULL, "x.svg") && !tp_chart_format_read(&format, NULL));
  ck_assert_ptr_eq(text, &untouched);
  ck_assert_ptr_eq(chart, UNTOUCHED(tp_chart));
  tp_chart_free(NULL);
  tp_chart_free(own);
}
END_TEST

START_TEST(surveys) {
  tp_batch_options options = tp_batch_options_default();
  tp_batch *batch = UNTOUCHED(tp_batch);
  const tp_batch own = {.row_count = 0};
  char *text = &untouched;
  REFUSED(tp_batch_solve(NULL, "survey.csv", &options, &message), "'batch'");
  REFUSED(tp_batch_solve(&batch, NULL, &options, &message), "'path'");
  REFUSED(tp_batch_solve(&batch, "survey.csv", NULL, &message), "'options'");
  REFUSED(tp_batch_solve_text(NULL, "a", "a", &options, &message), "'batch'");
  REFUSED(tp_batch_solve_text(&batch, NULL, "a", &options, &message), "'text'");
  REFUSED(tp_batch_solve_text(&batch, "a", NULL, &options, &message), "'name'");
  REFUSED(tp_batch_solve_text(&batch, "a", "a", NULL, &message), "'options'");
  options.size = 0;
  REFUSED(tp_batch_solve(&batch, "survey.csv", &options, &message), "size");
  UNWRITTEN(tp_report_batch(NULL, &own));
  UNWRITTEN(tp_report_batch(&text, NULL));
  UNWRITTEN(tp_report_batch_markdown(NULL, &own));
  UNWRITTEN(tp_report_batch_markdown(&text, NULL));
  UNWRITTEN(tp_report_batch_csv(NULL, &own));
  UNWRITTEN(tp_report_batch_csv(&text, NULL));
  UNWRITTEN(tp_report_batch_json(NULL, &own));
  UNWRITTEN(tp_report_batch_json(&text, NULL));
  REFUSED(tp_batch_write_file(NULL, &own, &message), "'path'");
  REFUSED(tp_batch_write_file("/tmp/x.csv", NULL, &message), "'batch'");
  REFUSED(tp_batch_write_file("/tmp/x.txt", &own, &message), ".csv");
  REFUSED(tp_report_sheet_batch(NULL, &own, 1, &message), "'path'");
  REFUSED(tp_report_sheet_batch("/tmp/x.html", NULL, 1, &message), "'batch'");
  REFUSED(tp_report_sheet_batch("/tmp/x.pdf", &own, 1, &message), ".html");
  REFUSED(tp_report_figures_batch(NULL, ".svg", &own, &message), "'folder'");
  REFUSED(tp_report_figures_batch("/tmp", NULL, &own, &message), "'ending'");
  REFUSED(tp_report_figures_batch("/tmp", ".svg", NULL, &message), "'batch'");
  REFUSED(tp_report_figures_batch("/tmp", ".txt", &own, &message), ".svg");
  ck_assert(!tp_batch_is_file_name(NULL) && !tp_batch_is_file_name("x.txt"));
  ck_assert_str_eq(tp_batch_standing_name((tp_batch_standing)TP_BATCH_STANDINGS), "unknown");
  ck_assert_ptr_eq(text, &untouched);
  ck_assert_ptr_eq(batch, UNTOUCHED(tp_batch));
  tp_batch_free(NULL);
}
END_TEST

/* A list of 7 was read past its end. */
START_TEST(lists_of_a_chart) {
  static const size_t counts[] = {TP_CHART_LIST_MAX + 1, 1000, SIZE_MAX};
  tp_chart *chart = UNTOUCHED(tp_chart);
  for (size_t k = 0; k < sizeof counts / sizeof counts[0]; k++) {
    for (int list = 0; list < 3; list++) {
      tp_chart_fos_options options = tp_chart_fos_options_default();
      tp_chart_list *own = list == 0   ? &options.inverse_slenderness
                           : list == 1 ? &options.amplitude
                                       : &options.sub_blocks;
      double values[TP_CHART_LIST_MAX];
      for (size_t v = 0; v < TP_CHART_LIST_MAX; v++) values[v] = list < 2 ? 0.25 : 2;
      *own = (tp_chart_list){counts[k], values};
      REFUSED(tp_chart_fos(&chart, &options, &message), "at most 6");
      *own = (tp_chart_list){1, NULL};
      REFUSED(tp_chart_fos(&chart, &options, &message), "NULL");
    }
  }
  for (int list = 0; list < 2; list++) {
    tp_chart_fos_options options = tp_chart_fos_options_default();
    (list == 0 ? &options.inverse_slenderness : &options.amplitude)->count = 0;
    REFUSED(tp_chart_fos(&chart, &options, &message), "at least");
  }
  static const double no_numbers[] = {NAN, INFINITY, -INFINITY, -1};
  for (size_t k = 0; k < sizeof no_numbers / sizeof no_numbers[0]; k++) {
    tp_chart_fos_options options = tp_chart_fos_options_default();
    options.amplitude.values = no_numbers + k;
    REFUSED(tp_chart_fos(&chart, &options, &message), "amplitude");
    options = tp_chart_fos_options_default();
    options.tilt_deg.from = no_numbers[k];
    REFUSED(tp_chart_fos(&chart, &options, &message), "tilt");
    tp_chart_mechanisms_options other = tp_chart_mechanisms_options_default();
    other.friction_deg = no_numbers[k];
    REFUSED(tp_chart_mechanisms(&chart, &other, &message), "friction");
    other = tp_chart_mechanisms_options_default();
    other.amplitude = no_numbers[k];
    REFUSED(tp_chart_mechanisms(&chart, &other, &message), "amplitude");
  }
  ck_assert_ptr_eq(chart, UNTOUCHED(tp_chart));
}
END_TEST

START_TEST(maps) {
  tp_scene *scene = NULL;
  ck_assert_int_eq(tp_scene_read(&scene, EXAMPLE("slab_left.yaml"), &message), TP_OK);
  const tp_chart_map_options good = {.size = sizeof good,
                                     .scene = scene,
                                     .x = {"block.slab.width", {20, 150}},
                                     .y = {"tilt", {0, 90}}};
  tp_chart_map_options bad = good;
  tp_chart *chart = UNTOUCHED(tp_chart);
  REFUSED(tp_chart_map(NULL, &good, &message), "'chart'");
  REFUSED(tp_chart_map(&chart, NULL, &message), "'options'");
  bad.scene = NULL;
  REFUSED(tp_chart_map(&chart, &bad, &message), "scene");
  bad = good;
  bad.x.key = NULL;
  REFUSED(tp_chart_map(&chart, &bad, &message), "x.key");
  bad = good;
  bad.y.key = NULL;
  REFUSED(tp_chart_map(&chart, &bad, &message), "y.key");
  bad = good;
  bad.y = (tp_chart_axis){"friction_angle_deg", {20, 40}};
  bad.levels = (tp_chart_list){1, NULL};
  REFUSED(tp_chart_map(&chart, &bad, &message), "values");
  bad.levels = (tp_chart_list){TP_CHART_LIST_MAX + 1, (const double[]){1}};
  REFUSED(tp_chart_map(&chart, &bad, &message), "levels");
  static const double no_numbers[] = {NAN, INFINITY, -INFINITY};
  for (size_t k = 0; k < 3; k++) {
    bad.levels = (tp_chart_list){1, no_numbers + k};
    REFUSED(tp_chart_map(&chart, &bad, &message), "levels are");
  }
  for (size_t k = 0; k < 3; k++) {
    bad = good;
    bad.x.range.to = no_numbers[k];
    REFUSED(tp_chart_map(&chart, &bad, &message), "range");
    bad = good;
    bad.x.range.from = no_numbers[k];
    REFUSED(tp_chart_map(&chart, &bad, &message), "range");
  }
  ck_assert_ptr_eq(chart, UNTOUCHED(tp_chart));
  tp_scene_free(scene);
}
END_TEST

SUITE(chart_arguments) {
  Suite *suite = suite_create("arguments of charts");
  TCase *tests = tcase_create("arguments of charts");
  tcase_set_timeout(tests, 600);
  tcase_add_test(tests, charts);
  tcase_add_test(tests, surveys);
  tcase_add_test(tests, lists_of_a_chart);
  tcase_add_test(tests, maps);
  suite_add_tcase(suite, tests);
  return suite;
}
