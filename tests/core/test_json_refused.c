/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The writer of JSON: calls that would make none are refused, and print nothing. */

#include "json_stage.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void nothing(tp_json *j) {
  (void)j;
}

static void left_open(tp_json *j) {
  tp_json_object(j, NULL, TP_JSON_LINE);
}

static void closed_twice(tp_json *j) {
  tp_json_array(j, NULL, TP_JSON_LINE);
  tp_json_close(j);
  tp_json_close(j);
}

static void closed_unopened(tp_json *j) {
  tp_json_close(j);
}

static void member_without_key(tp_json *j) {
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_null(j, NULL);
  tp_json_close(j);
}

static void object_without_key(tp_json *j) {
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_close(j);
  tp_json_close(j);
}

static void key_in_array(tp_json *j) {
  tp_json_array(j, NULL, TP_JSON_LINE);
  tp_json_string(j, "key", "text");
  tp_json_close(j);
}

static void key_of_the_whole(tp_json *j) {
  tp_json_array(j, "key", TP_JSON_LINE);
  tp_json_close(j);
}

static void two_wholes(tp_json *j) {
  tp_json_null(j, NULL);
  tp_json_null(j, NULL);
}

static void too_deep(tp_json *j) {
  for (int k = 0; k <= TP_JSON_DEEPEST; k++) tp_json_array(j, NULL, TP_JSON_LINE);
  for (int k = 0; k <= TP_JSON_DEEPEST; k++) tp_json_close(j);
}

static void too_many_decimals(tp_json *j) {
  tp_json_fixed(j, NULL, 1, 5000);
}

START_TEST(wrong_calls_are_refused) {
  void (*const wrong[])(tp_json *) = {nothing,         left_open,          closed_twice,
                                      closed_unopened, member_without_key, object_without_key,
                                      key_in_array,    key_of_the_whole,   two_wholes,
                                      too_deep,        too_many_decimals};
  for (size_t k = 0; k < sizeof wrong / sizeof wrong[0]; k++) {
    tp_json j = {0};
    wrong[k](&j);
    is_refused(&j);
  }
}
END_TEST

/* They pass as they are, and only they. */
START_TEST(printed_numbers) {
  static const char *const numbers[] = {
      "0",    "-0",   "7.410",   "100",    "0.30000000000000004",
      "1e-7", "2E+5", "-12.5e3", "1.0e00", "123456789012345678901"};
  static const char *const others[] = {
      "",   "-",   "+1",   ".5",    "5.",  "01",  "1/3",  "1,5",  "1e",    "1e+", "0x1",   " 1",
      "1 ", "nan", "-inf", "1.5.2", "1 2", "--1", "1e5.", "null", "\"1\"", "1]",  "1.5, 2"};
  for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) {
    char expected[40];
    tp_json j = {0};
    tp_json_printed(&j, NULL, numbers[k]);
    snprintf(expected, sizeof expected, "%s\n", numbers[k]);
    prints(&j, expected);
  }
  for (size_t k = 0; k < sizeof others / sizeof others[0]; k++) {
    tp_json j = {0};
    tp_json_printed(&j, NULL, others[k]);
    is_refused(&j);
  }
}
END_TEST

SUITE(json_refused) {
  Suite *suite = suite_create("json_refused");
  TCase *tests = tcase_create("writer");
  tcase_add_test(tests, wrong_calls_are_refused);
  tcase_add_test(tests, printed_numbers);
  suite_add_tcase(suite, tests);
  return suite;
}
