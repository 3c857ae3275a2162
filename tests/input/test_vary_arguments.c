/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Arguments of what asks for a number of a scene, and puts another in its place, that no call can
 * do anything with (tests/input/test_vary.c has wrong keys). */

#include "refused.h"

#include <math.h>

START_TEST(load_cases) {
  const tp_solve_options options = tp_solve_options_default();
  tp_scene *plain = NULL, *scene = NULL, *own = UNTOUCHED(tp_scene);
  tp_load_cases *cases = UNTOUCHED(tp_load_cases);
  char *text = &untouched;
  ck_assert_int_eq(tp_scene_read(&plain, EXAMPLE("slab_left.yaml"), &message), TP_OK);
  ck_assert_int_eq(tp_scene_read(&scene, EXAMPLE("slope/design_cases.yaml"), &message), TP_OK);
  REFUSED(tp_scene_load_case(NULL, scene, "wet", &message), "'own' must not be NULL");
  REFUSED(tp_scene_load_case(&own, NULL, "wet", &message), "'scene'");
  REFUSED(tp_scene_load_case(&own, scene, NULL, &message), "'name'");
  REFUSED(tp_scene_load_case(&own, scene, "dry", &message), "its cases are static, wet");
  REFUSED(tp_scene_load_case(&own, plain, "wet", &message), "has no cases");
  REFUSED(tp_solve_load_cases(NULL, scene, NULL, 0, &options, &message), "'cases'");
  REFUSED(tp_solve_load_cases(&cases, NULL, NULL, 0, &options, &message), "'scene'");
  REFUSED(tp_solve_load_cases(&cases, scene, NULL, 1, &options, &message), "'settings'");
  REFUSED(tp_solve_load_cases(&cases, scene, NULL, 0, NULL, &message), "'options'");
  REFUSED(tp_solve_load_cases(&cases, plain, NULL, 0, &options, &message), "has no cases");
  ck_assert_int_eq(tp_report_load_cases(&text, NULL), TP_BAD_INPUT);
  ck_assert_int_eq(tp_report_load_cases_json(&text, NULL, TP_PIVOTS_ALL), TP_BAD_INPUT);
  ck_assert_uint_eq(tp_scene_load_case_count(NULL) + tp_scene_load_case_count(plain), 0);
  ck_assert_uint_eq(tp_scene_load_case_count(scene), 7);
  ck_assert_ptr_null(tp_scene_load_case_name(scene, 7));
  ck_assert_str_eq(tp_scene_load_case_name(scene, 3), "wet and earthquake");
  ck_assert_int_eq(tp_load_cases_meet(NULL), TP_DESIGN_OPEN);
  tp_load_cases_free(NULL);
  tp_scene_free(plain);
  tp_scene_free(scene);
}
END_TEST

START_TEST(block_systems) {
  const tp_solve_options options = tp_solve_options_default();
  tp_scene *plain = NULL, *scene = NULL;
  tp_block_system *system = UNTOUCHED(tp_block_system);
  tp_solution *solution = UNTOUCHED(tp_solution);
  char *text = &untouched;
  ck_assert_int_eq(tp_scene_read(&plain, EXAMPLE("slab_left.yaml"), &message), TP_OK);
  ck_assert_int_eq(tp_scene_read(&scene, EXAMPLE("blocks/toppling_slope.yaml"), &message), TP_OK);
  REFUSED(tp_solve_block_system(NULL, scene, &options, &message), "'system' must not be NULL");
  REFUSED(tp_solve_block_system(&system, NULL, &options, &message), "'scene'");
  REFUSED(tp_solve_block_system(&system, scene, NULL, &message), "'options'");
  REFUSED(tp_solve_block_system(&system, plain, &options, &message), "tp_solve takes it");
  REFUSED(tp_solve(&solution, scene, &options, &message), "many blocks");
  ck_assert_int_eq(tp_report_block_system(&text, NULL), TP_BAD_INPUT);
  ck_assert_int_eq(tp_report_block_system_json(&text, NULL), TP_BAD_INPUT);
  ck_assert_int_eq(tp_report_block_system_csv(&text, NULL), TP_BAD_INPUT);
  ck_assert_int_eq(tp_report_block_systems_csv(&text, NULL, 0), TP_BAD_INPUT);
  ck_assert_int_eq(tp_report_block_systems_table(&text, NULL, 0), TP_BAD_INPUT);
  const tp_block_system *const none[] = {NULL};
  ck_assert_int_eq(tp_report_block_systems_csv(&text, none, 1), TP_BAD_INPUT);
  ck_assert_int_eq(tp_report_block_systems_table(&text, none, 1), TP_BAD_INPUT);
  ck_assert_int_eq(tp_report_found_block_system_json(&text, NULL, none[0]), TP_BAD_INPUT);
  REFUSED(tp_report_block_system_animation(&text, scene, NULL, &message), "'system'");
  REFUSED(tp_report_block_system_animation(&text, NULL, NULL, &message), "'scene'");
  REFUSED(tp_report_block_system_json_outlines(NULL, scene, NULL, &message), "'text'");
  REFUSED(tp_report_block_system_json_outlines(&text, NULL, NULL, &message), "'scene'");
  REFUSED(tp_report_block_system_json_outlines(&text, scene, NULL, &message), "'system'");
  REFUSED(tp_report_block_system_animation_file(NULL, scene, NULL, &message), "'path'");
  REFUSED(tp_report_block_system_animation_file("a.svg", scene, NULL, &message), "'system'");
  ck_assert_uint_eq(tp_scene_block_count(NULL) + tp_scene_block_count(plain), 0);
  ck_assert_uint_eq(tp_scene_block_count(scene), 17);
  ck_assert(tp_block_system_is_undecided(NULL));
  ck_assert_int_eq(tp_block_system_meets(NULL, 1), TP_DESIGN_OPEN);
  ck_assert_int_eq(tp_system_case_meets(NULL, 1), TP_DESIGN_OPEN);
  ck_assert_str_eq(tp_system_verdict_name((tp_system_verdict)99), "unknown");
  ck_assert_str_eq(tp_joint_state_name((tp_joint_state)99), "unknown");
  ck_assert_str_eq(tp_touch_state_name((tp_touch_state)99), "unknown");
  ck_assert_str_eq(tp_column_state_name((tp_column_state)99), "unknown");
  ck_assert_str_eq(tp_system_load_kind_name((tp_system_load_kind)99), "unknown");
  tp_block_system_free(NULL);
  tp_scene_free(plain);
  tp_scene_free(scene);
}
END_TEST

START_TEST(numbers_by_keys) {
  const char *key = "friction_angle_deg", *none = NULL;
  const tp_exact value = tp_exact_of(20);
  tp_bounded number = {.value = 7};
  char *text = &untouched;
  tp_scene *scene = NULL, *varied = UNTOUCHED(tp_scene);
  ck_assert_int_eq(tp_scene_read(&scene, EXAMPLE("slab_left.yaml"), &message), TP_OK);
  REFUSED(tp_scene_number(NULL, scene, key, &message), "'number' must not be NULL");
  REFUSED(tp_scene_number(&number, NULL, key, &message), "'scene'");
  REFUSED(tp_scene_number(&number, scene, NULL, &message), "'key'");
  REFUSED(tp_scene_number_text(NULL, scene, key, &message), "'text'");
  REFUSED(tp_scene_number_text(&text, NULL, key, &message), "'scene'");
  REFUSED(tp_scene_number_text(&text, scene, NULL, &message), "'key'");
  REFUSED(tp_scene_with(NULL, scene, key, value, &message), "'varied'");
  REFUSED(tp_scene_with(&varied, NULL, key, value, &message), "'scene'");
  REFUSED(tp_scene_with(&varied, scene, NULL, value, &message), "'key'");
  REFUSED(tp_scene_with(&varied, scene, key, tp_exact_of(NAN), &message), "finite");
  REFUSED(tp_scene_with_numbers(NULL, scene, &key, &value, 1, &message), "'varied'");
  REFUSED(tp_scene_with_numbers(&varied, NULL, &key, &value, 1, &message), "'scene'");
  REFUSED(tp_scene_with_numbers(&varied, scene, NULL, &value, 1, &message), "'keys'");
  REFUSED(tp_scene_with_numbers(&varied, scene, &key, NULL, 1, &message), "'values'");
  REFUSED(tp_scene_with_numbers(&varied, scene, &none, &value, 1, &message), "key 1");
  REFUSED(tp_scene_with_numbers(&varied, scene, &key, &value, (size_t)-1, &message), "at most");
  const char *setting = "friction_angle_deg=20", *no_value = "friction_angle_deg=", *no_key = "=2";
  REFUSED(tp_scene_with_settings(NULL, scene, &setting, 1, &message), "'varied'");
  REFUSED(tp_scene_with_settings(&varied, NULL, &setting, 1, &message), "'scene'");
  REFUSED(tp_scene_with_settings(&varied, scene, NULL, 1, &message), "'settings'");
  REFUSED(tp_scene_with_settings(&varied, scene, &none, 1, &message), "setting 1");
  REFUSED(tp_scene_with_settings(&varied, scene, &key, 1, &message), "KEY=VALUE");
  REFUSED(tp_scene_with_settings(&varied, scene, &no_key, 1, &message), "KEY=VALUE");
  REFUSED(tp_scene_with_settings(&varied, scene, &no_value, 1, &message), "a number");
  REFUSED(tp_scene_with_settings(&varied, scene, &setting, (size_t)-1, &message), "at most");
  ck_assert_ptr_eq(varied, UNTOUCHED(tp_scene));
  ck_assert_ptr_eq(text, &untouched);
  ck_assert(number.value == 7);
  tp_scene_free(scene);
}
END_TEST

static bool take_point(void *context, const tp_sweep_point *point) {
  (void)point;
  return context == NULL;
}

static bool take_text(void *context, const char *text) {
  (void)text;
  return context == NULL;
}

START_TEST(sweeps) {
  const tp_sweep_sink points = {take_point, NULL}, no_points = {NULL, NULL};
  const tp_text_sink texts = {take_text, NULL}, no_texts = {NULL, NULL};
  const char *path = "/nowhere/at/all.csv";
  tp_sweep_summary sum = {.count = 7};
  tp_sweep_options o = tp_sweep_options_default(), none = o, strange = o;
  tp_scene *scene = NULL;
  ck_assert_int_eq(tp_scene_read(&scene, EXAMPLE("slab_left.yaml"), &message), TP_OK);
  o.x = "friction_angle_deg=20,30";
  strange.x = "friction_angle_deg";
  REFUSED(tp_sweep(NULL, scene, &o, points, &message), "'summary' must not be NULL");
  REFUSED(tp_sweep(&sum, NULL, &o, points, &message), "'scene'");
  REFUSED(tp_sweep(&sum, scene, NULL, points, &message), "'options'");
  REFUSED(tp_sweep(&sum, scene, &o, no_points, &message), "'sink.take'");
  REFUSED(tp_sweep(&sum, scene, &none, points, &message), "'options->x'");
  REFUSED(tp_sweep(&sum, scene, &strange, points, &message), "KEY=FIRST:LAST:STEP");
  REFUSED(tp_sweep_write(NULL, scene, &o, TP_SWEEP_CSV, texts, &message), "'summary'");
  REFUSED(tp_sweep_write(&sum, scene, &o, (tp_sweep_format)9, texts, &message), "no such format");
  REFUSED(tp_sweep_write(&sum, scene, &o, TP_SWEEP_CSV, no_texts, &message), "'sink.take'");
  REFUSED(tp_sweep_write_file(NULL, path, scene, &o, TP_SWEEP_CSV, &message), "'summary'");
  REFUSED(tp_sweep_write_file(&sum, NULL, scene, &o, TP_SWEEP_CSV, &message), "'path'");
  ck_assert_int_eq(tp_sweep_write_file(&sum, path, scene, &o, TP_SWEEP_CSV, &message),
                   TP_SYSTEM_FAILED);
  tp_sweep_options_init(NULL, sizeof o);
  ck_assert_uint_eq(sum.count, 7);
  tp_scene_free(scene);
}
END_TEST

SUITE(vary_arguments) {
  Suite *suite = suite_create("vary_arguments");
  TCase *tests = tcase_create("vary_arguments");
  tcase_add_test(tests, numbers_by_keys);
  tcase_add_test(tests, sweeps);
  tcase_add_test(tests, load_cases);
  tcase_add_test(tests, block_systems);
  suite_add_tcase(suite, tests);
  return suite;
}
