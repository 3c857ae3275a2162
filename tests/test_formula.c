/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The language of formulas: what is read, as trees written out with all their brackets; where each
 * part stands; what is refused, and the place that is named; the bounds. Values are those of
 * test_algebras.c. */

#include "formula/rational.h"
#include "formula/read.h"
#include "formula/spelling.h"
#include "runner.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* All that a dialect may allow, and as little as possible. */
static const tp_dialect printed = {
    .letters = true,
    .products = true,
    .functions = true,
    .lines = true,
    .most_nodes = 1000,
    .formula = "a formula",
    .operand = "a number or a name",
    .no_operand = "is no operand",
    .continued = "a formula",
    .unknown_name = "it is not known",
    .quoted = 8,
};
static const tp_dialect plain = {
    .formula = "a number",
    .operand = "a number",
    .no_operand = "is no number",
    .continued = "an expression",
    .unknown_name = "it is not known",
    .quoted = SIZE_MAX,
};

static const char *const names[] = {"a", "b", "ab", "alpha", "sigma_n", "dx", "sine"};
enum { NAMES = sizeof names / sizeof names[0] };

static long find(const void *context, const char *name, size_t length) {
  (void)context;
  for (long k = 0; k < NAMES; k++) {
    if (strlen(names[k]) == length && memcmp(names[k], name, length) == 0) return k;
  }
  return -1;
}

static bool is_angle(const void *context, long name) {
  (void)context;
  return strcmp(names[name], "alpha") == 0;
}

static const tp_vocabulary vocabulary = {find, is_angle, NULL};

static void append(char *out, const char *text) {
  ck_assert_uint_lt(strlen(out) + strlen(text), 900);
  strcat(out, text);
}

/* A node with brackets round every operation; "." is a product that is not written. */
static void write_out(char *out, const tp_formula *f, long index) {
  static const char *const operators[] = {NULL, NULL, "-", "+", "-", "*", "/", "^"};
  static const char *const functions[] = {"sin",  "cos",  "tan",   "cot",
                                          "atan", "sqrt", "log10", "abs"};
  const tp_formula_node *n = f->nodes + index;
  char *number = NULL;
  switch (n->kind) {
  case TP_FORMULA_NUMBER:
    number = fmpq_get_str(NULL, 10, &n->value);
    append(out, number);
    flint_free(number);
    break;
  case TP_FORMULA_NAME:
    append(out, names[n->name]);
    break;
  case TP_FORMULA_CALL:
    append(out, functions[n->function]);
    append(out, "(");
    write_out(out, f, n->left);
    append(out, ")");
    break;
  default:
    append(out, "(");
    if (n->kind != TP_FORMULA_NEGATE) write_out(out, f, n->left);
    append(out, n->length > 0 ? operators[n->kind] : ".");
    write_out(out, f, n->kind == TP_FORMULA_NEGATE ? n->left : n->right);
    append(out, ")");
    break;
  }
}

/* The text is read as this tree. */
static void reads(const tp_dialect *dialect, const char *text, const char *tree) {
  tp_formula formula;
  tp_message message = {""};
  char out[1000] = "";
  ck_assert_msg(tp_formula_read(&formula, text, (tp_place){"t", 1, 1}, dialect, &vocabulary,
                                &message) == TP_OK,
                "%s: %s", text, message.text);
  write_out(out, &formula, formula.count - 1);
  ck_assert_msg(strcmp(out, tree) == 0, "%s is read as %s", text, out);
  tp_formula_clear(&formula);
}

/* The text is refused with a message that begins so. */
static void refuses(const tp_dialect *dialect, const char *text, const char *beginning) {
  tp_formula formula;
  tp_message message = {""};
  ck_assert_msg(tp_formula_read(&formula, text, (tp_place){"t", 7, 3}, dialect, &vocabulary,
                                &message) == TP_BAD_INPUT,
                "%s is read", text);
  ck_assert_msg(strncmp(message.text, beginning, strlen(beginning)) == 0, "%s: %s", text,
                message.text);
  ck_assert_int_eq(formula.count, 0);
  tp_formula_clear(&formula);
}

/* Precedence and grouping are the same in every dialect. */
START_TEST(operators_group_as_in_algebra) {
  static const char *const cases[][2] = {
      {"1 + 2", "(1+2)"},
      {"a - b", "(a-b)"},
      {"a*b", "(a*b)"},
      {"a/b", "(a/b)"},
      {"a^b", "(a^b)"},
      {"1 - 2 - 3", "((1-2)-3)"},
      {"8/4/2", "((8/4)/2)"},
      {"8/4*2", "((8/4)*2)"},
      {"1 + 2*3", "(1+(2*3))"},
      {"(1 + 2)*3", "((1+2)*3)"},
      {"2*3^2", "(2*(3^2))"},
      {"2^3^2", "(2^(3^2))"},
      {"(2^3)^2", "((2^3)^2)"},
      {"-2^2", "(-(2^2))"},
      {"(-2)^2", "((-2)^2)"},
      {"2^-1", "(2^(-1))"},
      {"2^-3^2", "(2^(-(3^2)))"},
      {"-2*3", "((-2)*3)"},
      {"2*-3", "(2*(-3))"},
      {"2 - -3", "(2-(-3))"},
      {"--a", "(-(-a))"},
      {"+a", "a"},
      {"-+-a", "(-(-a))"},
      {"((a))", "a"},
      {"1.50", "3/2"},
      {"2e-1 + .5", "(1/5+1/2)"},
      {"sigma_n*dx", "(sigma_n*dx)"},
      {"\ta \t+ b ", "(a+b)"},
  };
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    reads(&plain, cases[k][0], cases[k][1]);
    reads(&printed, cases[k][0], cases[k][1]);
  }
}
END_TEST

/* What papers print. */
START_TEST(notation_of_print) {
  static const char *const cases[][2] = {
      {"27ab", "(27.ab)"}, /* the longest name that is known */
      {"27ba", "((27.b).a)"},
      {"2(a + b)", "(2.(a+b))"},
      {"a b", "(a.b)"},
      {"(a)(b)", "(a.b)"},
      {"ab^2", "(ab^2)"},
      {"2ba^2", "((2.b).(a^2))"},
      {"a/b*2", "((a/b)*2)"},
      {"2a/b", "((2.a)/b)"},
      {"-2a", "((-2).a)"},
      {"α", "alpha"},
      {"2α", "(2.alpha)"},
      {"σ_n", "sigma_n"},
      {"Δx", "dx"},
      {"a − b", "(a-b)"},
      {"a – b", "(a-b)"},
      {"a·b⋅a×b", "(((a*b)*a)*b)"},
      {"{a + b}^2", "((a+b)^2)"},
      {"20° + α", "(20+alpha)"},
      {"a\n+ b", "(a+b)"},
      {"sin(a)", "sin(a)"},
      {"sin α", "sin(alpha)"},
      {"sinα", "sin(alpha)"},
      {"sin 30°", "sin(30)"},
      {"2 sin α cos α", "((2.sin(alpha)).cos(alpha))"},
      {"sin α^2", "(sin(alpha)^2)"},
      {"sin^2 α", "(sin(alpha)^2)"},
      {"sin ^ 2 α", "(sin(alpha)^2)"},
      {"sin^2(a + b)", "(sin((a+b))^2)"},
      {"tan^-1 α", "cot(alpha)"}, /* of an angle */
      {"tan^-1 a", "atan(a)"},    /* of anything else */
      {"tan^{-1}(α)", "cot(alpha)"},
      {"atan(a)*cot α", "(atan(a)*cot(alpha))"},
      {"sqrt(a) + log10(b) - abs(a)", "((sqrt(a)+log10(b))-abs(a))"},
      {"cos^-2 α", "(cos(alpha)^(-2))"},
      {"sine", "sine"}, /* a name that begins like a function */
      {"1/sin α", "(1/sin(alpha))"},
  };
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++)
    reads(&printed, cases[k][0], cases[k][1]);
}
END_TEST

/* Every part knows where it stands: brackets belong to what they hold, blanks to nothing. */
START_TEST(parts_have_places) {
  static const char text[] = "2·( α - b ) + sin^2 a";
  static const struct {
    tp_formula_kind kind;
    const char *part, *own;
  } nodes[] = {{TP_FORMULA_NUMBER, "2", "2"},
               {TP_FORMULA_NAME, "α", "α"},
               {TP_FORMULA_NAME, "b", "b"},
               {TP_FORMULA_SUBTRACT, "( α - b )", "-"},
               {TP_FORMULA_MULTIPLY, "2·( α - b )", "·"},
               {TP_FORMULA_NUMBER, "2", "2"},
               {TP_FORMULA_NAME, "a", "a"},
               {TP_FORMULA_CALL, "sin^2 a", "sin"},
               {TP_FORMULA_POWER, "sin^2 a", "^"},
               {TP_FORMULA_ADD, text, "+"}};
  tp_formula f;
  tp_message message = {""};
  ck_assert_int_eq(
      tp_formula_read(&f, text, (tp_place){"t", 1, 5}, &printed, &vocabulary, &message), TP_OK);
  ck_assert_int_eq(f.count, sizeof nodes / sizeof nodes[0]);
  for (long k = 0; k < f.count; k++) {
    const tp_formula_node *n = f.nodes + k;
    ck_assert_int_eq(n->kind, nodes[k].kind);
    ck_assert_int_eq(n->end - n->begin, (int)strlen(nodes[k].part));
    ck_assert_int_eq(strncmp(text + n->begin, nodes[k].part, strlen(nodes[k].part)), 0);
    ck_assert_int_eq(n->length, (int)strlen(nodes[k].own));
    ck_assert_int_eq(strncmp(text + n->at, nodes[k].own, strlen(nodes[k].own)), 0);
  }
  ck_assert_int_eq(tp_formula_root(&f)->kind, TP_FORMULA_ADD);
  /* columns count characters: the + is the 13th, the text begins in column 5 */
  ck_assert_int_eq(tp_formula_place(&f, tp_formula_root(&f)->at).column, 17);
  ck_assert_int_eq(tp_formula_fail(&f, tp_formula_root(&f), &message, "no"), TP_BAD_INPUT);
  ck_assert_str_eq(message.text, "t:1:17: no");
  tp_formula_clear(&f);
}
END_TEST

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
      {&plain, "1 + *2", "t:7:7: '*' is no number"},
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
      {&plain, "2*.", "t:7:5: '.' is no number"},
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

/* A dialect without them has neither letters nor signs of print, products or functions. */
START_TEST(a_plain_dialect_is_plain) {
  refuses(&plain, "α", "t:7:3: 'α' is no number");
  refuses(&plain, "a − b", "t:7:5: '− b' does not continue");
  refuses(&plain, "a·b", "t:7:4: '·b' does not continue");
  refuses(&plain, "{a}", "t:7:3: '{a}' is no number");
  refuses(&plain, "20°", "t:7:5: '°' does not continue");
  refuses(&plain, "2a", "t:7:4: 'a' does not continue");
  refuses(&plain, "2(a)", "t:7:4: '(a)' does not continue");
  refuses(&plain, "ba", "t:7:3: unknown name 'ba'");
  refuses(&plain, "sin", "t:7:3: unknown name 'sin'");
  refuses(&plain, "2 + sin (a)", "t:7:7: 'sin(…)' is no exact operation");
  refuses(&plain, "a\n+ b", "t:7:4: ' + b' does not continue");
}
END_TEST

/* Names of any length where they stand for themselves; where letters are spelt out they are
 * bounded. */
START_TEST(names_have_lengths) {
  char name[TP_NAME_SIZE], longest[300];
  ck_assert_uint_eq(tp_name_length("a_1b + 2"), 4);
  ck_assert_uint_eq(tp_name_length("1a"), 0);
  ck_assert_uint_eq(tp_name_length("α"), 0);
  ck_assert_uint_eq(tp_name_spell(name, sizeof name, "Δα_1 + 2", 100), 6);
  ck_assert_str_eq(name, "dalpha_1");
  ck_assert_uint_eq(tp_name_spell(name, sizeof name, "αβ", 3), 2); /* no half letters */
  ck_assert_str_eq(name, "alpha");
  memset(longest, 'q', sizeof longest);
  longest[sizeof longest - 1] = '\0';
  ck_assert_uint_eq(tp_name_length(longest), sizeof longest - 1);
  ck_assert_uint_eq(tp_name_spell(name, sizeof name, longest, SIZE_MAX), TP_NAME_SIZE - 1);
  refuses(&plain, longest, "t:7:3: unknown name 'qqq");
  refuses(&printed, longest, "t:7:3: unknown name 'qqq");
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
    tp_message message = {""};
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

int main(void) {
  Suite *suite = suite_create("formula");
  TCase *formulas = tcase_create("formula");
  tcase_add_test(formulas, operators_group_as_in_algebra);
  tcase_add_test(formulas, notation_of_print);
  tcase_add_test(formulas, parts_have_places);
  tcase_add_test(formulas, failures_have_places);
  tcase_add_test(formulas, a_plain_dialect_is_plain);
  tcase_add_test(formulas, names_have_lengths);
  tcase_add_test(formulas, bounds);
  tcase_add_test(formulas, lent_room);
  tcase_add_test(formulas, rational_failures);
  suite_add_tcase(suite, formulas);
  return run_suite(suite);
}
