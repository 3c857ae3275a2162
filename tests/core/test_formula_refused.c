/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The language of formulas: what is refused, and the place that is named; the bounds. */

#include "formula/rational.h"
#include "formula_stage.h"
#include "suite.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The first character of the text stands at line 7, column 3. */
START_TEST(failures_have_places) {
  static const struct {
    const tp_dialect *dialect;
    const char *text, *message;
  } cases[] = {
      {&plain, "", "t:7:3: a number belongs here"},
      {&plain, "  ", "t:7:5: a number belongs here"},
      {&printed, " \n", "t:7:5: a formula belongs here"},
      {&plain, "1 + ", "t:7:7: a number is missing at the end"},
      {&printed, "1 + ", "t:7:7: a number or a name is missing at the end"},
      {&plain, "1 + *2", "t:7:7: '*' is not a number"},
      {&printed, "α + *2", "t:7:7: '*' is no operand"},
      {&plain, "2*(a + (b - 1)", "t:7:5: this '(' is not closed"},
      {&printed, "2{a + b)", "t:7:4: '{a + b)' does not continue a formula"},
      {&printed, "2*{a + b)", "t:7:5: this '{' is not closed"},
      {&plain, "1 2", "t:7:5: '2' does not continue an expression"},
      {&plain, "a)", "t:7:4: ')' does not continue an expression"},
      {&printed, "α° + 1", "t:7:4: '° + 1' does not continue a formula"},
      {&plain, "1 + q_1*2", "t:7:7: unknown name 'q_1'; it is not known"},
      {&printed, "α + q", "t:7:7: unknown name 'q'; it is not known"},
      {&plain, "inf", "t:7:3: 'inf' is not a finite number"},
      {&plain, "-.INF", "t:7:4: '.INF' is not a finite number"},
      {&printed, "1 - NaN", "t:7:7: 'NaN' is not a finite number"},
      {&plain, "2*.", "t:7:5: '.' is not a number"},
      {&plain, "2 - 1e999*3", "t:7:7: '1e999' is larger than 1e308"},
      {&printed, "2 - 1e-999a", "t:7:7: '1e-999a' is smaller than 1e-308"},
      {&printed, "a/b c", "t:7:7: is this factor above or below the stroke?"},
      {&printed, "sin", "t:7:6: sin of what? Write sin(x)"},
      {&printed, "α cos + 1", "t:7:9: cos of what? Write cos(x)"},
      {&printed, "α sin cos a", "t:7:9: unknown name 'cos'"},
      {&printed, "1 + sin^-1 a", "t:7:7: what does sin^-1 mean?"},
      {&printed, "log a", "t:7:3: write log10 for the decimal logarithm"},
  };
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++)
    refuses(cases[k].dialect, cases[k].text, cases[k].message);
}
END_TEST

/* `count` times `text` and what follows, in new memory. */
static char *repeated(const char *text, size_t count, const char *behind) {
  const size_t length = strlen(text), size = count * length + strlen(behind) + 1;
  char *all = malloc(size);
  ck_assert_ptr_nonnull(all);
  for (size_t k = 0; k < count * length; k++) all[k] = text[k % length];
  snprintf(all + count * length, size - count * length, "%s", behind);
  return all;
}

static void refuses_repeated(const tp_dialect *dialect, const char *text, size_t count,
                             const char *behind, const char *message) {
  char *all = repeated(text, count, behind);
  refuses(dialect, all, message);
  free(all);
}

START_TEST(bounds) {
  tp_formula f;
  char *nested = repeated("-", 199, "a"), *sum = repeated("a+", 499, "a");
  ck_assert_int_eq(tp_formula_read(&f, nested, (tp_place){0}, &plain, &vocabulary, NULL), TP_OK);
  ck_assert_int_eq(f.count, 200);
  tp_formula_clear(&f);
  ck_assert_int_eq(tp_formula_read(&f, sum, (tp_place){0}, &printed, &vocabulary, NULL), TP_OK);
  ck_assert_int_eq(f.count, 999);
  tp_formula_clear(&f);
  free(nested);
  free(sum);
  refuses_repeated(&plain, "-", 200, "a", "t:7:203: nested deeper than 200 levels");
  refuses_repeated(&plain, "(", 100000, "a", "t:7:203: nested deeper than 200 levels");
  refuses_repeated(&plain, "2^", 200, "a", "t:7:403: nested deeper than 200 levels");
  refuses_repeated(&printed, "a+", 500, "a",
                   "t:7:1002: a formula of more than 1000 numbers, names and operators");
  sum = repeated("a+", 50000, "a"); /* no bound of length */
  ck_assert_int_eq(tp_formula_read(&f, sum, (tp_place){0}, &plain, &vocabulary, NULL), TP_OK);
  ck_assert_int_eq(f.count, 100001);
  tp_formula_clear(&f);
  free(sum);
}
END_TEST

/* Room that is lent is used while it lasts; the tree is the same with any room. */
START_TEST(lent_room) {
  static const char text[] = "a*(b - 12345678901234567890123)/(2 + a)";
  for (long room = 0; room < 12; room++) {
    tp_formula_node lent[12];
    tp_formula f;
    char out[1000] = "";
    ck_assert_int_eq(
        tp_formula_read_into(&f, lent, room, text, (tp_place){0}, &plain, &vocabulary, NULL),
        TP_OK);
    write_out(out, &f, f.count - 1);
    ck_assert_str_eq(out, "((a*(b-12345678901234567890123))/(2+a))");
    ck_assert_int_eq(f.nodes == lent, room >= 9);
    tp_formula_clear(&f);
    ck_assert_ptr_null(f.nodes);
  }
}
END_TEST

/* What has no value in rationals says so at its operator. */
START_TEST(rational_failures) {
  static const char *const cases[][2] = {
      {"1/(2 - 2)", "t:1:2: division by zero"},
      {"a + 0^-1", "t:1:6: division by zero: zero to a negative power"},
      {"2^(1/2)", "t:1:2: an exponent must be a whole number"},
      {"1 + 2^20001", "t:1:6: the value grows beyond 20 000 bits here"},
      {"2^6000*2^6000*2^6000*2^6000", "t:1:21: the value grows beyond 20 000 bits here"},
      {"9^99999999999999999999", "t:1:2: the value grows beyond 20 000 bits here"},
  };
  fmpq values[NAMES];
  fmpq_t value;
  fmpq_init(value);
  for (int k = 0; k < NAMES; k++) fmpq_init(values + k);
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    tp_formula f;
    tp_message message = {.text = ""};
    ck_assert_int_eq(
        tp_formula_read(&f, cases[k][0], (tp_place){"t", 1, 1}, &plain, &vocabulary, &message),
        TP_OK);
    ck_assert_int_eq(tp_formula_evaluate(value, &f, &tp_rational_algebra, values, &message),
                     TP_BAD_INPUT);
    ck_assert_str_eq(message.text, cases[k][1]);
    tp_formula_clear(&f);
  }
  for (int k = 0; k < NAMES; k++) fmpq_clear(values + k);
  fmpq_clear(value);
}
END_TEST

SUITE(formula_refused) {
  Suite *suite = suite_create("formula_refused");
  TCase *tests = tcase_create("formula");
  tcase_add_test(tests, failures_have_places);
  tcase_add_test(tests, bounds);
  tcase_add_test(tests, lent_room);
  tcase_add_test(tests, rational_failures);
  suite_add_tcase(suite, tests);
  return suite;
}
