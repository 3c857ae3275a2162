/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Every status has a meaning and an exit status of its own list, and a number that is none says so.
 */

#include "suite.h"
#include "topple.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

/* As many as the list has. */
enum {
#define COUNTED(name, number, exit_status, meaning) COUNTED_##name,
  TP_STATUS_LIST(COUNTED)
#undef COUNTED
      STATUSES
};

START_TEST(every_status_is_told) {
  static const struct {
    tp_status status;
    int exit_status;
  } all[] = {{TP_OK, 0},
             {TP_BAD_INPUT, 3},
             {TP_NO_ANSWER, 3},
             {TP_UNDECIDED, 4},
             {TP_OUT_OF_MEMORY, 5},
             {TP_SYSTEM_FAILED, 5},
             {TP_DEPENDENCY_FAILED, 5}};
  enum { COUNT = sizeof all / sizeof all[0] };
  ck_assert_int_eq(COUNT, STATUSES);
  for (int k = 0; k < COUNT; k++) {
    ck_assert_int_eq(tp_status_exit(all[k].status), all[k].exit_status);
    ck_assert_str_ne(tp_status_meaning(all[k].status), "");
    for (int other = 0; other < k; other++) {
      ck_assert_str_ne(tp_status_meaning(all[k].status), tp_status_meaning(all[other].status));
    }
  }
}
END_TEST

START_TEST(what_is_no_status) {
  const int none[] = {-1, TP_DEPENDENCY_FAILED + 1, 1000};
  for (size_t k = 0; k < sizeof none / sizeof none[0]; k++) {
    ck_assert_str_eq(tp_status_meaning((tp_status)none[k]), "unknown status");
    ck_assert_int_eq(tp_status_exit((tp_status)none[k]), tp_status_exit(TP_SYSTEM_FAILED));
  }
}
END_TEST

/* Text, number and parts are one version. */
START_TEST(the_version) {
  char text[32];
  snprintf(text, sizeof text, "%d.%d.%d", TP_VERSION_MAJOR, TP_VERSION_MINOR, TP_VERSION_PATCH);
  ck_assert_str_eq(TP_VERSION, text);
  ck_assert_str_eq(tp_version(), TP_VERSION);
  ck_assert_int_eq(tp_version_number(), TP_VERSION_NUMBER);
}
END_TEST

/* A program need not take a message apart to find the place. */
START_TEST(the_place_of_a_complaint) {
  tp_scene *scene = NULL;
  tp_message message;
  const char *text = "topple: 1\nlength_unit: furlong\n";
  ck_assert_int_eq(tp_scene_read_text(&scene, text, "block.yaml", &message), TP_BAD_INPUT);
  ck_assert_str_eq(message.file, "block.yaml");
  ck_assert_int_eq(message.line, 2);
  ck_assert_int_eq(message.column, 14);
  ck_assert_int_eq(message.system_error, 0);
  ck_assert_int_eq(tp_scene_read(&scene, "/no/such/scene.yaml", &message), TP_SYSTEM_FAILED);
  ck_assert_str_eq(message.file, "/no/such/scene.yaml");
  ck_assert_int_eq(message.line, 0);
  ck_assert_int_eq(message.system_error, ENOENT);
  char *report = NULL;
  ck_assert_int_eq(tp_report_terms(&report), TP_OK);
  tp_text_free(report);
  tp_text_free(NULL);
}
END_TEST

/* Which kind of input is wrong, for a program that reacts to it; none where something else is. */
START_TEST(the_kind_of_wrong_input) {
  static const struct {
    const char *text;
    tp_fault fault;
  } cases[] = {
      {"topple: [1\n", TP_FAULT_FORMAT},
      {"topple: 1\nlength_unit: m\nfrictoin: 30\n", TP_FAULT_KEY},
      {"topple: 1\nlength_unit: furlong\n", TP_FAULT_UNIT},
      {"topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 2}}\nfriction_angle_deg: 95\n",
       TP_FAULT_RANGE},
      {"topple: 1\nlength_unit: m\nblock: {outline: [[0, 0], [1, 1], [1, 0], [0, 1]]}\n",
       TP_FAULT_GEOMETRY},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    tp_scene *scene = NULL;
    tp_solution *solution = NULL;
    tp_message message = {.fault = TP_FAULT_NONE};
    const tp_solve_options options = tp_solve_options_default();
    tp_status status = tp_scene_read_text(&scene, cases[k].text, "scene.yaml", &message);
    if (status == TP_OK) status = tp_solve(&solution, scene, &options, &message);
    ck_assert_int_eq(status, TP_BAD_INPUT);
    ck_assert_msg(message.fault == cases[k].fault, "%s: %s", tp_fault_name(message.fault),
                  message.text);
    tp_scene_free(scene);
  }
  tp_message message;
  ck_assert_int_eq(tp_scene_read_text(NULL, "", "scene.yaml", &message), TP_BAD_INPUT);
  ck_assert_int_eq(message.fault, TP_FAULT_ARGUMENT);
  tp_scene *scene = NULL;
  ck_assert_int_eq(tp_scene_read(&scene, "/no/such/scene.yaml", &message), TP_SYSTEM_FAILED);
  ck_assert_int_eq(message.fault, TP_FAULT_NONE);
  ck_assert_str_eq(tp_fault_name(TP_FAULT_GEOMETRY), "geometry");
  ck_assert_str_eq(tp_fault_name((tp_fault)-1), "unknown");
}
END_TEST

SUITE(status) {
  Suite *suite = suite_create("status");
  TCase *statuses = tcase_create("status");
  tcase_add_test(statuses, every_status_is_told);
  tcase_add_test(statuses, what_is_no_status);
  tcase_add_test(statuses, the_version);
  tcase_add_test(statuses, the_place_of_a_complaint);
  tcase_add_test(statuses, the_kind_of_wrong_input);
  suite_add_tcase(suite, statuses);
  return suite;
}
