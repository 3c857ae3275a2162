/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scenes: exact expressions, CSV in its dialects, suggestions for misspelt keys. What must be
 * refused is tested from outside, by tests/bad; here stands what must be understood, and how. */

#include "scene/expression.h"
#include "scene/node.h"
#include "scene_reading/csv.h"
#include "suite.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Expressions are exact rationals, with the usual precedences: values by hand. */
START_TEST(expressions_are_exact) {
  static const struct {
    const char *text, *value;
  } cases[] = {{"1/3", "1/3"},    {"1/3 + 1/6", "1/2"},  {"0.1 + 0.2", "3/10"},
               {"2 + 3*4", "14"}, {"(2 + 3)*4", "20"},   {"2 - 3 - 4", "-5"},
               {"12/3/2", "2"},   {"-2^2", "-4"},        {"(-2)^2", "4"},
               {"2^-3", "1/8"},   {"2^3^2", "512"},      {"--3", "3"},
               {"3*-2", "-6"},    {" ( ( a ) ) ", "30"}, {"3*a/(b_1 - 1e1)", "-10"},
               {"a^0", "1"},      {"0^0", "1"}};
  char first[] = "a", second[] = "b_1";
  char *names[] = {first, second};
  fmpq values[2];
  fmpq_t result;
  fmpq_init(values);
  fmpq_init(values + 1);
  fmpq_init(result);
  fmpq_set_si(values, 30, 1);
  fmpq_set_si(values + 1, 1, 1);
  const tp_parameters parameters = {2, names, values};
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    tp_message message;
    ck_assert_int_eq(
        tp_expression_evaluate(result, cases[k].text, (tp_place){"s", 1, 1}, &parameters, &message),
        TP_OK);
    char *text = fmpq_get_str(NULL, 10, result);
    ck_assert_msg(strcmp(text, cases[k].value) == 0, "%s = %s", cases[k].text, text);
    flint_free(text);
  }
  fmpq_clear(values);
  fmpq_clear(values + 1);
  fmpq_clear(result);
}
END_TEST

/* A complaint names the column of the character at fault, and leaves the result untouched. */
START_TEST(complaints_have_a_column) {
  static const struct {
    const char *text, *message;
  } cases[] = {{"1 + ", "s:4:14: a number is missing at the end"},
               {"1 + q", "s:4:14: unknown name 'q'"},
               {"(1 + 2", "s:4:10: this '(' is not closed"},
               {"1/(2 - 2)", "s:4:11: division by zero"},
               {"1 2", "s:4:12: '2' does not continue"},
               {"2^(1/2)", "s:4:11: an exponent must be a whole number"},
               {"", "s:4:10: a number belongs here"}};
  fmpq_t result;
  fmpq_init(result);
  fmpq_set_si(result, 77, 1);
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    tp_message message;
    ck_assert_int_eq(
        tp_expression_evaluate(result, cases[k].text, (tp_place){"s", 4, 10}, NULL, &message),
        TP_BAD_INPUT);
    ck_assert_msg(strncmp(message.text, cases[k].message, strlen(cases[k].message)) == 0, "%s",
                  message.text);
    ck_assert(fmpq_equal_si(result, 77));
  }
  fmpq_clear(result);
}
END_TEST

/* Misspelt words find their nearest key; words that are like none find none. */
START_TEST(suggestions) {
  static const char *const keys[] = {"outline", "thickness", "unit_weight_kn_m3", "teeth", NULL};
  ck_assert_str_eq(tp_nearest("outlin", keys), "outline");
  ck_assert_str_eq(tp_nearest("thicknes", keys), "thickness");
  ck_assert_str_eq(tp_nearest("unit_weight", keys), "unit_weight_kn_m3");
  ck_assert_str_eq(tp_nearest("tooth", keys), "teeth");
  ck_assert_ptr_null(tp_nearest("colour_of_the_rock", keys));
}
END_TEST

static tp_status read_csv(tp_polyline *line, const char *text, bool closed, tp_notes *notes,
                          tp_message *message) {
  static char path[] = "/tmp/topple-test-XXXXXX";
  strcpy(path + strlen(path) - 6, "XXXXXX");
  const int handle = mkstemp(path);
  ck_assert_int_ge(handle, 0);
  ck_assert_int_eq(write(handle, text, strlen(text)), (ssize_t)strlen(text));
  close(handle);
  const char *unit = NULL;
  const tp_status status = tp_csv_read(line, &unit, path, closed, notes, message);
  unlink(path);
  return status;
}

/* One triangle in every dialect that people export: separators, headers, comments, line ends, a
 * byte order mark, a closed ring. */
START_TEST(csv_dialects) {
  static const char *const texts[] = {
      "0,0\n1.5,0\n0,2\n",
      "x,y\n0,0\n1.5,0\n0,2\n",
      "# a comment\n\nx ; y\n0;0\n1.5 ; 0 # half of three\n0;2",
      "0\t0\r\n1.5\t0\r\n0\t2\r\n",
      "\xef\xbb\xbfx y\n0 0\n15e-1   0\n  0 2\n",
      "\"x\",\"y\"\n0,0\n+1.5,-0\n0,2\n0,0\n",
  };
  for (size_t k = 0; k < sizeof texts / sizeof texts[0]; k++) {
    tp_polyline line;
    tp_notes notes = {0};
    tp_message message = {.text = ""};
    ck_assert_msg(read_csv(&line, texts[k], true, &notes, &message) == TP_OK, "%s", message.text);
    ck_assert_int_eq(line.count, 3);
    ck_assert(fmpq_is_zero(line.x) && fmpq_is_zero(line.y));
    ck_assert(fmpq_equal_si(line.y + 2, 2));
    fmpq_mul_2exp(line.x + 1, line.x + 1, 1);
    ck_assert(fmpq_equal_si(line.x + 1, 3));
    tp_polyline_clear(&line);
  }
}
END_TEST

/* A point knows the line and the column where it stands; an open profile keeps its last point even
 * where it equals the first. */
START_TEST(csv_places) {
  tp_polyline line;
  tp_notes notes = {0};
  tp_message message;
  ck_assert_int_eq(read_csv(&line, "x,y\n0,0\n\n  1,2\n0,0\n", false, &notes, &message), TP_OK);
  ck_assert_int_eq(line.count, 3);
  ck_assert_int_eq(line.marks[1].line, 4);
  ck_assert_int_eq(line.marks[1].column, 3);
  tp_polyline_clear(&line);
}
END_TEST

/* Lines of any length around the read buffer's size: no point is lost at its seams. */
START_TEST(csv_seams) {
  const long count = 30000;
  char *text = malloc((size_t)count * 24);
  size_t length = 0;
  ck_assert_ptr_nonnull(text);
  for (long k = 0; k < count; k++)
    length += (size_t)sprintf(text + length, "%ld,%ld.25\n", k, k * k);
  tp_polyline line;
  tp_notes notes = {0};
  tp_message message = {.text = ""};
  ck_assert_msg(read_csv(&line, text, true, &notes, &message) == TP_OK, "%s", message.text);
  ck_assert_int_eq(line.count, count);
  for (long k = 0; k < count; k++) {
    ck_assert(fmpq_equal_si(line.x + k, k));
    ck_assert(fmpz_equal_si(fmpq_numref(line.y + k), 4 * k * k + 1));
  }
  tp_polyline_clear(&line);
  free(text);
}
END_TEST

/* Orientation from three points agrees with the sign of the area, and reversing keeps the numbers
 * by which the author knows the vertices. */
START_TEST(polyline_orientation) {
  static const long xs[] = {0, 4, 4, 2, 0}, ys[] = {0, 0, 3, 1, 3};
  tp_polyline line = {0};
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  for (int k = 0; k < 5; k++) {
    fmpq_set_si(x, xs[k], 1);
    fmpq_set_si(y, ys[k], 1);
    ck_assert(tp_polyline_append(&line, x, y, (tp_mark){k + 1, 1}));
  }
  ck_assert_int_eq(tp_polyline_orientation(&line), 1);
  tp_polyline_reverse(&line);
  ck_assert_int_eq(tp_polyline_orientation(&line), -1);
  ck_assert_int_eq(tp_polyline_number(&line, 0), 5);
  ck_assert_int_eq(tp_polyline_place(&line, 0).line, 5);
  tp_polyline_orient(&line);
  ck_assert_int_eq(tp_polyline_number(&line, 0), 1);
  fmpq_clear(x);
  fmpq_clear(y);
  tp_polyline_clear(&line);
}
END_TEST

/* A scene from memory is the scene of the same file: it solves, and a complaint names the text by
 * its name and place. Text without a scene in it is refused, the empty one too. */
START_TEST(scenes_from_text) {
  static const char slab[] = "topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 2}}\n"
                             "base: {mated: true}\n";
  static const char *const wrong[][2] = {
      {"", "name:1:1: the file is empty; a scene begins with 'topple: 1'"},
      {"topple: 1\nblock: {slap: 3}\n", "name:1:1: "},
      {"topple: 1\nlength_unit: m\nblock: {slap: 3}\n", "name:3:9: "},
      {"[", "name:2:1: not YAML"}};
  const tp_solve_options options = tp_solve_options_default();
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_message message = {.text = ""};
  ck_assert_int_eq(tp_scene_read_text(&scene, slab, "name", &message), TP_OK);
  ck_assert_int_eq(tp_solve(&solution, scene, &options, &message), TP_OK);
  ck_assert_double_eq(solution->block.area_m2.value, 2);
  tp_solution_free(solution);
  tp_scene_free(scene);
  scene = NULL;
  for (size_t k = 0; k < sizeof wrong / sizeof wrong[0]; k++) {
    ck_assert_int_eq(tp_scene_read_text(&scene, wrong[k][0], "name", &message), TP_BAD_INPUT);
    ck_assert_msg(strncmp(message.text, wrong[k][1], strlen(wrong[k][1])) == 0, "%s", message.text);
    ck_assert_ptr_null(scene);
  }
}
END_TEST

SUITE(scene) {
  Suite *suite = suite_create("scene");
  TCase *scenes = tcase_create("scene");
  tcase_add_test(scenes, expressions_are_exact);
  tcase_add_test(scenes, complaints_have_a_column);
  tcase_add_test(scenes, suggestions);
  tcase_add_test(scenes, csv_dialects);
  tcase_add_test(scenes, csv_places);
  tcase_add_test(scenes, csv_seams);
  tcase_add_test(scenes, polyline_orientation);
  tcase_add_test(scenes, scenes_from_text);
  suite_add_tcase(suite, scenes);
  return suite;
}
