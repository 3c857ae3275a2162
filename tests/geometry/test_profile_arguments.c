/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Arguments of profiles that no call can do anything with (tests/library/test_arguments.c has those
 * of all others). */

#include "refused.h"

#include <math.h>
#include <stdlib.h>

static const double xy[] = {0, 0, 1, 1, 2, 0, 3, 1};

START_TEST(profiles) {
  const tp_coordinates points = tp_coordinates_of(xy, 4);
  tp_profile *profile = UNTOUCHED(tp_profile);
  const tp_profile_options options = tp_profile_options_default();
  tp_scene *scene = NULL;
  ck_assert_int_eq(tp_scene_read(&scene, EXAMPLE("slab_left.yaml"), &message), TP_OK);
  REFUSED(tp_profile_of_points(NULL, points, "mm", &options, &message), "'profile'");
  REFUSED(tp_profile_of_points(&profile, points, NULL, &options, &message), "'length_unit'");
  REFUSED(tp_profile_of_points(&profile, points, "mm", NULL, &message), "'options'");
  REFUSED(tp_profile_of_points(&profile, points, "ell", &options, &message), "length_unit");
  REFUSED(tp_profile_of_points(&profile, (tp_coordinates){.count = 4}, "mm", &options, &message),
          "points");
  REFUSED(tp_profile_of_file(NULL, "x", "mm", &options, &message), "'profile'");
  REFUSED(tp_profile_of_file(&profile, NULL, "mm", &options, &message), "'path'");
  REFUSED(tp_profile_of_file(&profile, "x", NULL, &options, &message), "'length_unit'");
  REFUSED(tp_profile_of_file(&profile, "x", "mm", NULL, &message), "'options'");
  REFUSED(tp_profile_of_scene(NULL, scene, &options, &message), "'profile'");
  REFUSED(tp_profile_of_scene(&profile, NULL, &options, &message), "'scene'");
  REFUSED(tp_profile_of_scene(&profile, scene, NULL, &message), "'options'");
  for (size_t k = 0; k < 2; k++) {
    const tp_profile_options sized = {.size = k == 0 ? 0 : 4096};
    REFUSED(tp_profile_of_points(&profile, points, "mm", &sized, &message), "the size");
    REFUSED(tp_profile_of_file(&profile, "x", "mm", &sized, &message), "the size");
    REFUSED(tp_profile_of_scene(&profile, scene, &sized, &message), "the size");
  }
  ck_assert_ptr_eq(profile, UNTOUCHED(tp_profile));
  tp_scene_free(scene);
}
END_TEST

START_TEST(strange_options) {
  const tp_coordinates points = tp_coordinates_of(xy, 4);
  tp_profile *profile = UNTOUCHED(tp_profile);
  tp_profile_options options;
  static const double strange[] = {-1, NAN, INFINITY, -INFINITY};
  for (size_t k = 0; k < sizeof strange / sizeof strange[0]; k++) {
    options = tp_profile_options_default();
    options.step = strange[k];
    REFUSED(tp_profile_of_points(&profile, points, "mm", &options, &message), "step");
    options = tp_profile_options_default();
    options.scale = strange[k];
    REFUSED(tp_profile_of_points(&profile, points, "mm", &options, &message), "scale");
    options = tp_profile_options_default();
    options.jcs_mpa = strange[k];
    REFUSED(tp_profile_of_points(&profile, points, "mm", &options, &message), "JCS");
    options = tp_profile_options_default();
    options.normal_stress_kpa = strange[k];
    REFUSED(tp_profile_of_points(&profile, points, "mm", &options, &message), "normal stress");
  }
  options = tp_profile_options_default();
  options.scale = 0;
  REFUSED(tp_profile_of_points(&profile, points, "mm", &options, &message), "scale");
  for (int k = -1; k <= 4; k += 5) {
    options = tp_profile_options_default();
    options.resampling = (tp_profile_resampling)k;
    REFUSED(tp_profile_of_points(&profile, points, "mm", &options, &message), "resampling");
    ck_assert_str_eq(tp_profile_resampling_name(options.resampling), "unknown");
    options = tp_profile_options_default();
    options.detrend = (tp_profile_detrend)k;
    REFUSED(tp_profile_of_points(&profile, points, "mm", &options, &message), "detrend");
    ck_assert_str_eq(tp_profile_detrend_name(options.detrend), "unknown");
    options = tp_profile_options_default();
    options.window = (tp_profile_window)k;
    REFUSED(tp_profile_of_points(&profile, points, "mm", &options, &message), "window");
    ck_assert_str_eq(tp_profile_window_name(options.window), "unknown");
  }
  ck_assert_ptr_eq(profile, UNTOUCHED(tp_profile));
}
END_TEST

START_TEST(names) {
  tp_profile_detrend detrend;
  ck_assert(!tp_profile_detrend_read(NULL, "line") && !tp_profile_detrend_read(&detrend, NULL));
  ck_assert(tp_profile_detrend_read(&detrend, "ends") && detrend == TP_DETREND_ENDS);
  ck_assert(tp_profile_detrend_read(&detrend, "turn") && detrend == TP_DETREND_TURN);
  tp_profile_resampling resampling;
  ck_assert(!tp_profile_resampling_read(NULL, "spline"));
  ck_assert(!tp_profile_resampling_read(&resampling, NULL));
  tp_profile_window window;
  ck_assert(!tp_profile_window_read(NULL, "hann") && !tp_profile_window_read(&window, "no"));
  ck_assert_str_eq(tp_jrc_state_name((tp_jrc_state)(TP_JRC_NO_NUMBER + 1)), "unknown");
}
END_TEST

START_TEST(reports) {
  tp_profile *own = NULL;
  tp_chart *chart = UNTOUCHED(tp_chart);
  const tp_profile_options options = tp_profile_options_default();
  char *text = &untouched;
  const tp_coordinates points = tp_coordinates_of(xy, 4);
  ck_assert_int_eq(tp_profile_of_points(&own, points, "mm", &options, NULL), TP_OK);
  REFUSED(tp_chart_profile(NULL, own, &message), "'chart'");
  REFUSED(tp_chart_profile(&chart, NULL, &message), "'profile'");
  UNWRITTEN(tp_report_profile(NULL, own));
  UNWRITTEN(tp_report_profile(&text, NULL));
  UNWRITTEN(tp_report_profile_json(NULL, own, true));
  UNWRITTEN(tp_report_profile_json(&text, NULL, false));
  UNWRITTEN(tp_report_profile_csv(NULL, own));
  UNWRITTEN(tp_report_profile_csv(&text, NULL));
  ck_assert_ptr_eq(text, &untouched);
  ck_assert_ptr_eq(chart, UNTOUCHED(tp_chart));
  tp_profile_free(NULL);
  tp_profile_free(own);
}
END_TEST

SUITE(profile_arguments) {
  Suite *suite = suite_create("arguments of profiles");
  TCase *tests = tcase_create("arguments of profiles");
  tcase_add_test(tests, profiles);
  tcase_add_test(tests, strange_options);
  tcase_add_test(tests, names);
  tcase_add_test(tests, reports);
  suite_add_tcase(suite, tests);
  return suite;
}
