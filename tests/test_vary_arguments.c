/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Arguments of what asks for a number of a scene, and puts another in its place, that no call can
 * do anything with (tests/test_vary.c has wrong keys). */

#include "refused.h"

#include <math.h>

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
  ck_assert_ptr_eq(varied, UNTOUCHED(tp_scene));
  ck_assert_ptr_eq(text, &untouched);
  ck_assert(number.value == 7);
  tp_scene_free(scene);
}
END_TEST

int main(void) {
  Suite *suite = suite_create("vary_arguments");
  TCase *tests = tcase_create("vary_arguments");
  tcase_add_test(tests, numbers_by_keys);
  suite_add_tcase(suite, tests);
  return run_suite(suite);
}
