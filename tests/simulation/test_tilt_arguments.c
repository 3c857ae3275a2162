/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the calls of tilt tests refuse: each names itself and the argument, and leaves the scene as
 * it was. What needs several calls is told by the one that runs the test. */

#include "refused_scene.h"

#include <math.h>

static const double record[] = {0, 0, 0.1, 0.2, 0.2, -0.1};
#define RECORD tp_coordinates_of(record, 3)

static void refuse_all(tp_scene *own, const char *why) {
  REFUSED(tp_scene_set_tilt_test(own, TP_TILT_PATH, TP_TILT_RAMP, false, &message), why);
  REFUSED(tp_scene_set_tilt_test_stiffness_gpa_m(own, E(1), E(1), &message), why);
  REFUSED(tp_scene_add_tilt_test_traction(own, 1, E(1), E(1), E(1), &message), why);
  REFUSED(tp_scene_set_shaking_pulse(own, TP_SHAKES_HORIZONTALLY, TP_PULSE_HALF_SINE, E(1), E(1),
                                     &message),
          why);
  REFUSED(tp_scene_set_shaking_record(own, TP_SHAKES_VERTICALLY, RECORD, E(1), &message), why);
}

START_TEST(scenes) {
  refuse_all(NULL, "'scene' must not be NULL");
  tp_scene *read = NULL;
  DO(tp_scene_read_text(&read, "topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 2}}\n",
                        "x", &message));
  refuse_all(read, "this scene was read from a file");
  tp_scene_free(read);
}
END_TEST

START_TEST(numbers) {
  char *before = solve();
  REFUSED(tp_scene_set_tilt_test(scene, (tp_tilt_engine)3, TP_TILT_RAMP, false, &message),
          "tp_scene_set_tilt_test: 'engine'");
  REFUSED(tp_scene_set_tilt_test(scene, TP_TILT_PATH, (tp_tilt_protocol)-1, false, &message),
          "'protocol'");
  REFUSED(tp_scene_set_number(scene, "tilt_test.speed_deg_min", E(0), &message),
          "tilt_test.speed_deg_min: speed_deg_min must be above zero");
  REFUSED(tp_scene_set_number(scene, "tilt_test.until_deg", E(91), &message),
          "until_deg must lie in");
  REFUSED(tp_scene_set_number(scene, "tilt_test.tolerance_deg", E(0), &message),
          "tolerance_deg must be");
  REFUSED(tp_scene_set_number(scene, "tilt_test.duration_s", E(-1), &message),
          "duration_s must be above");
  REFUSED(tp_scene_set_tilt_test_stiffness_gpa_m(scene, E(0), E(1), &message),
          "normal_gpa_m must be above zero, not 0");
  REFUSED(tp_scene_set_tilt_test_stiffness_gpa_m(scene, E(1), E(-1), &message),
          "shear_gpa_m must be above zero, not -1");
  REFUSED(tp_scene_set_number(scene, "tilt_test.damping", E(1.5), &message),
          "damping must lie in [0, 1]");
  REFUSED(tp_scene_set_number(scene, "tilt_test.rounding", E(0), &message),
          "rounding must be above zero");
  REFUSED(tp_scene_set_number(scene, "tilt_test.time_step_s", E(NAN), &message), "time_step_s");
  REFUSED(tp_scene_set_number(scene, "tilt_test.restitution", E(-0.5), &message),
          "restitution must lie in");
  REFUSED(tp_scene_add_tilt_test_traction(scene, 0, E(1), E(1), E(1), &message),
          "tp_scene_add_tilt_test_traction: facets of the base are counted from 1");
  REFUSED(tp_scene_add_tilt_test_traction(scene, 1, E(1), E(NAN), E(1), &message), "last_kpa");
  char *after = solve();
  ck_assert_str_eq(before, after);
  free(before);
  free(after);
}
END_TEST

START_TEST(shaking) {
  const double gap[] = {0, 0, 0.1, 0.2, 0.2, -0.1, 0.5, 0}, back[] = {0, 0, 0, 1},
               uneven[] = {0, 0, 0.1, 1, 0.24, 1};
#define RECORDED(array, count)                                                                     \
  tp_scene_set_shaking_record(scene, TP_SHAKES_HORIZONTALLY, tp_coordinates_of(array, count),      \
                              E(1), &message)
  REFUSED(tp_scene_set_shaking_pulse(scene, (tp_shaking_axis)2, TP_PULSE_HALF_SINE, E(1), E(1),
                                     &message),
          "'axis'");
  REFUSED(tp_scene_set_shaking_pulse(scene, TP_SHAKES_HORIZONTALLY, (tp_pulse_shape)2, E(1), E(1),
                                     &message),
          "'shape'");
  REFUSED(tp_scene_set_shaking_pulse(scene, TP_SHAKES_HORIZONTALLY, TP_PULSE_FULL_SINE, E(1), E(0),
                                     &message),
          "frequency_hz must be above zero");
  REFUSED(RECORDED(record, 1), "two samples at least");
  REFUSED(RECORDED(gap, 4), "a gap in the accelerogram: 0.3 s without a sample after 0.2 s");
  REFUSED(RECORDED(back, 2), "time does not go on");
  REFUSED(RECORDED(uneven, 3), "an uneven step: 0.14 s after 0.1 s");
  REFUSED(RECORDED(NULL, 3), "must not be NULL");
}
END_TEST

/* What stands in the scene together. */
START_TEST(together) {
  tp_tilt_test *test = UNTOUCHED(tp_tilt_test);
  tp_tilt_options options = tp_tilt_options_default();
#define RUN tp_tilt_test_run(&test, scene, &options, &message)
  REFUSED(RUN, "the scene calls for no simulation");
  DO(tp_scene_set_tilt_test(scene, TP_TILT_SPRINGS, TP_TILT_STEPS, true, &message));
  REFUSED(RUN, "need both 'normal_stiffness_gpa_m' and 'shear_stiffness_gpa_m'");
  DO(tp_scene_set_tilt_test_stiffness_gpa_m(scene, E(1000), E(10), &message));
  DO(tp_scene_set_number(scene, "tilt_test.time_step_s", E(1), &message));
  REFUSED(RUN, "tilt_test.time_step_s: steps of 1 s are not stable");
  DO(tp_scene_set_tilt_test(scene, TP_TILT_PATH, TP_TILT_RAMP, false, &message));
  REFUSED(RUN, "'time_step_s' belongs to 'engine: dynamics' by 'method: springs'");
  options.moments = 1;
  REFUSED(RUN, "moments must lie between 2 and 1000000");
  options = tp_tilt_options_default();
  options.size = 4096;
  REFUSED(RUN, "the size");
  options = tp_tilt_options_default();
  REFUSED(tp_tilt_test_run(NULL, scene, &options, &message), "'test'");
  REFUSED(tp_tilt_test_run(&test, NULL, &options, &message), "'scene'");
  REFUSED(tp_tilt_test_run(&test, scene, NULL, &message), "'options'");
  ck_assert_ptr_eq(test, UNTOUCHED(tp_tilt_test));
  tp_tilt_test_free(NULL);
}
END_TEST

START_TEST(shaken) {
  tp_tilt_test *test = NULL;
  tp_tilt_options options = tp_tilt_options_default();
  static const double grids[][3] = {{1, 2, 1}, {2, 1, 3},        {0, 1, 3},  {1, 2, 100001},
                                    {1, 2, 0}, {1, INFINITY, 3}, {NAN, 1, 3}};
  DO(tp_scene_set_shaking_pulse(scene, TP_SHAKES_HORIZONTALLY, TP_PULSE_HALF_SINE, E(0.4), E(2),
                                &message));
  DO(tp_scene_set_tilt_test(scene, TP_TILT_PATH, TP_TILT_RAMP, false, &message));
  REFUSED(RUN, "quasi-static and does not model shaking");
  DO(tp_scene_set_tilt_test(scene, TP_TILT_RIGID, TP_TILT_RAMP, false, &message));
  REFUSED(RUN, "held at its tilt while its base shakes");
  DO(tp_scene_set_tilt_test(scene, TP_TILT_RIGID, TP_TILT_RELEASE, true, &message));
  options.overturning = true;
  for (size_t k = 0; k < sizeof grids / sizeof grids[0]; k++) {
    options.overturning_from = grids[k][0];
    options.overturning_to = grids[k][1];
    options.overturning_count = (size_t)grids[k][2];
    REFUSED(RUN, "the factors on the shaking are 2 to 100000, from one above 0");
  }
  options = tp_tilt_options_default();
  const double still[] = {0, 0, 1, 0};
  DO(tp_scene_set_shaking_record(scene, TP_SHAKES_HORIZONTALLY, tp_coordinates_of(still, 2), E(1),
                                 &message));
  REFUSED(RUN, "zero throughout");
}
END_TEST

START_TEST(convergence) {
  tp_tilt_convergence *of = UNTOUCHED(tp_tilt_convergence);
  tp_chart *chart = UNTOUCHED(tp_chart);
  char *text = UNTOUCHED(char);
  tp_tilt_options options = tp_tilt_options_default();
  const tp_tilt_convergence *none = NULL;
  const tp_tilt_convergence empty = {.asked = 1};
  REFUSED(tp_tilt_converge(NULL, scene, &options, &message), "'convergence'");
  REFUSED(tp_tilt_converge(&of, NULL, &options, &message), "'scene'");
  REFUSED(tp_tilt_converge(&of, scene, NULL, &message), "'options'");
  REFUSED(tp_tilt_converge(&of, scene, &options, &message), "the scene calls for no simulation");
  DO(tp_scene_set_tilt_test(scene, TP_TILT_RIGID, TP_TILT_RELEASE, true, &message));
  DO(tp_scene_set_tilt_angle_deg(scene, E(10), &message));
  REFUSED(tp_tilt_converge(&of, scene, &options, &message), "has no critical angle");
  options.size = 4096;
  REFUSED(tp_tilt_converge(&of, scene, &options, &message), "the size");
  UNWRITTEN(tp_report_tilt_convergence(&text, none));
  UNWRITTEN(tp_report_tilt_convergence_json(&text, none));
  UNWRITTEN(tp_report_tilt_convergence(NULL, &empty));
  UNWRITTEN(tp_report_tilt_convergence_json(NULL, &empty));
  REFUSED(tp_chart_tilt_convergence(NULL, &empty, &message), "'chart'");
  REFUSED(tp_chart_tilt_convergence(&chart, none, &message), "'convergence'");
  ck_assert_int_eq(tp_chart_tilt_convergence(&chart, &empty, &message), TP_NO_ANSWER);
  ck_assert_ptr_eq(of, UNTOUCHED(tp_tilt_convergence));
  ck_assert_ptr_eq(chart, UNTOUCHED(tp_chart));
  ck_assert_str_eq(tp_converge_setting_name((tp_converge_setting)-1), "unknown");
  ck_assert_str_eq(tp_converge_quantity_name((tp_converge_quantity)9), "unknown");
  ck_assert_str_eq(tp_converge_verdict_name((tp_converge_verdict)9), "unknown");
  tp_tilt_convergence_free(NULL);
}
END_TEST

START_TEST(reports) {
  char *text = UNTOUCHED(char);
  const tp_tilt_test *none = NULL;
  UNWRITTEN(tp_report_tilt(&text, none));
  UNWRITTEN(tp_report_tilt_json(&text, none));
  UNWRITTEN(tp_report_tilt_csv(&text, none));
  UNWRITTEN(tp_report_tilt_frames(&text, none));
  UNWRITTEN(tp_report_tilt_animation(&text, none));
  const tp_tilt_test empty = {.length_unit = "m", .metres_per_unit = 1};
  UNWRITTEN(tp_report_tilt(NULL, &empty));
  UNWRITTEN(tp_report_tilt_json(NULL, &empty));
  UNWRITTEN(tp_report_tilt_csv(NULL, &empty));
  UNWRITTEN(tp_report_tilt_frames(NULL, &empty));
  UNWRITTEN(tp_report_tilt_animation(NULL, &empty));
  REFUSED(tp_report_tilt_file("x.svg", none, false, &message), "'test'");
  REFUSED(tp_report_tilt_file(NULL, &empty, false, &message), "'path'");
  REFUSED(tp_report_tilt_file("x.png", &empty, true, &message), "ends in .svg, .webm or .gif");
  REFUSED(tp_report_tilt_file("x.gif", &empty, false, &message), "ends in .svg");
  ck_assert_int_eq(tp_report_tilt_file("x.gif", &empty, true, &message), TP_NO_ANSWER);
  const tp_sheet_options sheet = tp_sheet_options_default();
  const tp_sheet_options sized = {.size = 4096};
  REFUSED(tp_report_sheet_tilt(NULL, scene, &empty, &sheet, &message), "'path'");
  REFUSED(tp_report_sheet_tilt("x.html", NULL, &empty, &sheet, &message), "'scene'");
  REFUSED(tp_report_sheet_tilt("x.html", scene, none, &sheet, &message), "'test'");
  REFUSED(tp_report_sheet_tilt("x.html", scene, &empty, NULL, &message), "'options'");
  REFUSED(tp_report_sheet_tilt("x.html", scene, &empty, &sized, &message), "the size");
  REFUSED(tp_report_sheet_tilt("x.svg", scene, &empty, &sheet, &message), ".html, .md or .pdf");
  ck_assert_ptr_eq(text, UNTOUCHED(char));
  ck_assert_str_eq(tp_tilt_end_name((tp_tilt_end)-1), "unknown");
  ck_assert_str_eq(tp_tilt_engine_name((tp_tilt_engine)7), "unknown");
  ck_assert_str_eq(tp_tilt_protocol_name((tp_tilt_protocol)7), "unknown");
  ck_assert_str_eq(tp_tilt_event_name((tp_tilt_event_kind)99), "unknown");
}
END_TEST

/* Charts refuse what is not there, and a test that has nothing to draw. */
START_TEST(charts) {
  tp_chart *chart = UNTOUCHED(tp_chart);
  const tp_tilt_test *none = NULL;
  const tp_tilt_test empty = {.length_unit = "m", .metres_per_unit = 1};
  const tp_tilt_test of_path = {.settings = {.engine = TP_TILT_PATH}},
                     of_dynamics = {.settings = {.engine = TP_TILT_RIGID}};
  REFUSED(tp_chart_tilt_reactions(&chart, none, &message), "'test'");
  REFUSED(tp_chart_tilt_reactions(NULL, &empty, &message), "'chart'");
  REFUSED(tp_chart_tilt_phase(&chart, none, &message), "'test'");
  REFUSED(tp_chart_tilt_phase(NULL, &empty, &message), "'chart'");
  ck_assert_int_eq(tp_chart_tilt_reactions(&chart, &empty, &message), TP_NO_ANSWER);
  ck_assert_ptr_nonnull(strstr(message.text, "no reactions to draw"));
  ck_assert_int_eq(tp_chart_tilt_phase(&chart, &of_path, &message), TP_NO_ANSWER);
  ck_assert_ptr_nonnull(strstr(message.text, "a path simulates no motion"));
  ck_assert_int_eq(tp_chart_tilt_phase(&chart, &of_dynamics, &message), TP_NO_ANSWER);
  ck_assert_ptr_nonnull(strstr(message.text, "nothing moves"));
  ck_assert_ptr_eq(chart, UNTOUCHED(tp_chart));
}
END_TEST

/* The spectrum refuses what gives none, before anything is run. */
START_TEST(spectra) {
  tp_chart *chart = UNTOUCHED(tp_chart);
  tp_overturning_options options = tp_overturning_options_default();
#define SPECTRUM tp_chart_overturning(&chart, scene, &options, &message)
  REFUSED(tp_chart_overturning(NULL, scene, &options, &message), "'chart'");
  REFUSED(tp_chart_overturning(&chart, NULL, &options, &message), "'scene'");
  REFUSED(tp_chart_overturning(&chart, scene, NULL, &message), "'options'");
  REFUSED(SPECTRUM, "needs a base that shakes");
  DO(tp_scene_set_shaking_pulse(scene, TP_SHAKES_VERTICALLY, TP_PULSE_HALF_SINE, E(0.4), E(2),
                                &message));
  REFUSED(SPECTRUM, "needs a base that shakes");
  DO(tp_scene_set_shaking_pulse(scene, TP_SHAKES_HORIZONTALLY, TP_PULSE_HALF_SINE, E(0.4), E(2),
                                &message));
  options.from = 2;
  options.to = 1;
  REFUSED(SPECTRUM, "from one above 0 to a larger one");
  options = tp_overturning_options_default();
  options.count = 1;
  REFUSED(SPECTRUM, "2 to 200 frequencies");
  options = tp_overturning_options_default();
  options.tolerance = NAN;
  REFUSED(SPECTRUM, "between 1e-6 and 0.1");
  options = tp_overturning_options_default();
  options.size = 4096;
  REFUSED(SPECTRUM, "the size");
  ck_assert_ptr_eq(chart, UNTOUCHED(tp_chart));
}
END_TEST

SUITE(tilt_arguments) {
  Suite *suite = suite_create("arguments of tilt tests");
  TCase *tests = tcase_create("arguments of tilt tests");
  tcase_add_checked_fixture(tests, set_up, tear_down);
  tcase_add_test(tests, scenes);
  tcase_add_test(tests, numbers);
  tcase_add_test(tests, shaking);
  tcase_add_test(tests, together);
  tcase_add_test(tests, shaken);
  tcase_add_test(tests, convergence);
  tcase_add_test(tests, reports);
  tcase_add_test(tests, charts);
  tcase_add_test(tests, spectra);
  suite_add_tcase(suite, tests);
  return suite;
}
