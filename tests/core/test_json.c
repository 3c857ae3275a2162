/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The writer of JSON: what it prints in each layout, byte by byte, and that its
 * numbers are JSON's in a program that has set a decimal comma. */

#define _GNU_SOURCE
#include "comma_locale.h"
#include "json_stage.h"

#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *folder;

START_TEST(values_of_every_kind) {
  tp_json j = {0};
  tp_json_array(&j, NULL, TP_JSON_LINE);
  tp_json_string(&j, NULL, "text");
  tp_json_string(&j, NULL, NULL);
  tp_json_truth(&j, NULL, true);
  tp_json_truth(&j, NULL, false);
  tp_json_null(&j, NULL);
  tp_json_count(&j, NULL, 4000000000);
  tp_json_integer(&j, NULL, -7);
  tp_json_double(&j, NULL, 0.1);
  tp_json_significant(&j, NULL, 1234.5678, 6);
  tp_json_fixed(&j, NULL, 1.0 / 3, 9);
  tp_json_close(&j);
  prints(&j, "[\"text\", null, true, false, null, 4000000000, -7, 0.10000000000000001, "
             "1234.57, 0.333333333]\n");
}
END_TEST

/* An object and an array of each layout within a block, each with a line asked for. */
static void write_in(tp_json *j, tp_json_layout layout) {
  tp_json_object(j, "o", layout);
  tp_json_count(j, "a", 1);
  tp_json_break(j);
  tp_json_array(j, "b", layout);
  tp_json_count(j, NULL, 2);
  tp_json_beside(j);
  tp_json_count(j, NULL, 3);
  tp_json_break(j);
  tp_json_count(j, NULL, 4);
  tp_json_close(j);
  tp_json_close(j);
}

START_TEST(every_layout) {
  static const char *const expected[] = {[TP_JSON_LINE] = "{\n"
                                                          "  \"o\": {\"a\": 1,\n"
                                                          "    \"b\": [2, 3,\n"
                                                          "      4]}\n"
                                                          "}\n",
                                         [TP_JSON_ALIGNED] = "{\n"
                                                             "  \"o\": {\"a\": 1,\n"
                                                             "   \"b\": [2, 3,\n"
                                                             "    4]}\n"
                                                             "}\n",
                                         [TP_JSON_FLUSH] = "{\n"
                                                           "  \"o\": {\"a\": 1,\n"
                                                           "  \"b\": [2, 3,\n"
                                                           "  4]}\n"
                                                           "}\n",
                                         [TP_JSON_LIST] = "{\n"
                                                          "  \"o\": {\n"
                                                          "    \"a\": 1,\n"
                                                          "    \"b\": [\n"
                                                          "      2, 3,\n"
                                                          "      4]}\n"
                                                          "}\n",
                                         [TP_JSON_BLOCK] = "{\n"
                                                           "  \"o\": {\n"
                                                           "    \"a\": 1,\n"
                                                           "    \"b\": [\n"
                                                           "      2, 3,\n"
                                                           "      4\n"
                                                           "    ]\n"
                                                           "  }\n"
                                                           "}\n"};
  for (size_t k = 0; k < sizeof expected / sizeof expected[0]; k++) {
    tp_json j = {0};
    tp_json_object(&j, NULL, TP_JSON_BLOCK);
    write_in(&j, (tp_json_layout)k);
    tp_json_close(&j);
    prints(&j, expected[k]);
  }
}
END_TEST

START_TEST(empty_containers) {
  static const char *const expected[] = {[TP_JSON_LINE] = "{\"o\": {}, \"a\": []}\n",
                                         [TP_JSON_BLOCK] =
                                             "{\n  \"o\": {\n  },\n  \"a\": [\n  ]\n}\n"};
  const tp_json_layout layouts[] = {TP_JSON_LINE, TP_JSON_BLOCK};
  for (int k = 0; k < 2; k++) {
    tp_json j = {0};
    tp_json_object(&j, NULL, layouts[k]);
    tp_json_object(&j, "o", layouts[k]);
    tp_json_close(&j);
    tp_json_array(&j, "a", layouts[k]);
    tp_json_close(&j);
    tp_json_close(&j);
    prints(&j, expected[layouts[k]]);
  }
}
END_TEST

/* A report begins with its version, and a line asked for ends with the container. */
START_TEST(a_report) {
  tp_json j = {0};
  tp_json_report(&j);
  tp_json_array(&j, "a", TP_JSON_LINE);
  tp_json_break(&j);
  tp_json_close(&j);
  tp_json_null(&j, "b");
  tp_json_close(&j);
  prints(&j, "{\n  \"topple\": \"" TP_VERSION "\",\n  \"a\": [],\n  \"b\": null\n}\n");
}
END_TEST

/* Keys and texts alike: what JSON takes for its own, what is not seen, what is no character. */
START_TEST(escapes) {
  static const char hostile[] = "a\"b\\c/\n\x01\x7fé\u202e\U000e0001\xff";
  static const char escaped[] =
      "\"a\\\"b\\\\c/\\u000a\\u0001\\u007fé\\u202e\\udb40\\udc01\\ufffd\"";
  char expected[200];
  tp_json j = {0};
  tp_json_object(&j, NULL, TP_JSON_LINE);
  tp_json_string(&j, hostile, hostile);
  tp_json_string(&j, "", "");
  tp_json_close(&j);
  snprintf(expected, sizeof expected, "{%s: %s, \"\": \"\"}\n", escaped, escaped);
  prints(&j, expected);
}
END_TEST

START_TEST(numbers_that_are_none) {
  const double none[] = {NAN, INFINITY, -INFINITY};
  tp_json j = {0};
  tp_json_array(&j, NULL, TP_JSON_LINE);
  for (int k = 0; k < 3; k++) {
    tp_json_double(&j, NULL, none[k]);
    tp_json_fixed(&j, NULL, none[k], 3);
    tp_json_bounded(&j, NULL, (tp_bounded){.value = 1, .error = none[k]});
  }
  tp_json_close(&j);
  prints(&j, "[null, null, null, null, null, null, null, null, null]\n");
}
END_TEST

START_TEST(computed_numbers) {
  char digits[] = "28.734512345678901";
  tp_json j = {0};
  tp_json_object(&j, NULL, TP_JSON_LINE);
  tp_json_bounded(&j, "n", (tp_bounded){.value = 0.5, .error = 1e-300});
  tp_json_bounded(&j, "d", (tp_bounded){.value = 28.5, .error = 0.25, .digits = digits});
  tp_json_close(&j);
  prints(&j, "{\"n\": {\"value\": 0.5, \"error\": 1e-300}, \"d\": {\"value\": 28.5, "
             "\"error\": 0.25, \"digits\": \"28.734512345678901\"}}\n");
}
END_TEST

START_TEST(the_deepest_that_there_is_room_for) {
  tp_json j = {0};
  char expected[2 * TP_JSON_DEEPEST + 2] = "";
  for (int k = 0; k < TP_JSON_DEEPEST; k++) {
    tp_json_array(&j, NULL, TP_JSON_LINE);
    expected[k] = '[';
    expected[TP_JSON_DEEPEST + k] = ']';
  }
  for (int k = 0; k < TP_JSON_DEEPEST; k++) tp_json_close(&j);
  expected[2 * TP_JSON_DEEPEST] = '\n';
  prints(&j, expected);
}
END_TEST

/* Much longer than what a text begins with. */
START_TEST(many_members) {
  enum { MEMBERS = 20000 };
  tp_json j = {0};
  char *text = NULL;
  tp_json_array(&j, NULL, TP_JSON_LIST);
  for (int k = 0; k < MEMBERS; k++) tp_json_integer(&j, NULL, k);
  tp_json_close(&j);
  ck_assert_int_eq(tp_json_finish(&j, &text), TP_OK);
  const char *at = text + 1;
  for (int k = 0; k < MEMBERS; k++) {
    char member[24];
    const int length = snprintf(member, sizeof member, "%s\n  %d", k > 0 ? "," : "", k);
    ck_assert_int_eq(strncmp(at, member, (size_t)length), 0);
    at += length;
  }
  ck_assert_str_eq(at, "]\n");
  free(text);
}
END_TEST

/* Without the guard of the public entries: the writer itself. */
START_TEST(a_decimal_comma_stays_outside) {
  char printed[8];
  tp_json j = {0};
  if (setlocale(LC_ALL, COMMA_LOCALE) == NULL) return; /* no localedef here */
  snprintf(printed, sizeof printed, "%.1f", 0.5);
  tp_json_array(&j, NULL, TP_JSON_LINE);
  tp_json_double(&j, NULL, -0.5);
  tp_json_double(&j, NULL, 1.5e-300);
  tp_json_double(&j, NULL, 1e300);
  tp_json_double(&j, NULL, 1234567);
  tp_json_fixed(&j, NULL, 1234567.25, 2);
  tp_json_significant(&j, NULL, 2.5, 6);
  tp_json_close(&j);
  setlocale(LC_ALL, "C");
  ck_assert_str_eq(printed, "0,5");
  prints(&j,
         "[-0.5, 1.5000000000000001e-300, 1.0000000000000001e+300, 1234567, 1234567.25, 2.5]\n");
}
END_TEST

static void make_locale(void) {
  comma_locale_make(folder);
}

SUITE(json) {
  folder = scratch_folder();
  Suite *suite = suite_create("json");
  TCase *tests = tcase_create("writer");
  tcase_add_unchecked_fixture(tests, make_locale, NULL);
  tcase_add_test(tests, values_of_every_kind);
  tcase_add_test(tests, every_layout);
  tcase_add_test(tests, empty_containers);
  tcase_add_test(tests, a_report);
  tcase_add_test(tests, escapes);
  tcase_add_test(tests, numbers_that_are_none);
  tcase_add_test(tests, computed_numbers);
  tcase_add_test(tests, the_deepest_that_there_is_room_for);
  tcase_add_test(tests, many_members);
  tcase_add_test(tests, a_decimal_comma_stays_outside);
  suite_add_tcase(suite, tests);
  return suite;
}
