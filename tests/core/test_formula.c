/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The language of formulas: what is read, as trees written out with all their brackets, and where
 * each part stands. Values are those of test_algebras.c. */

#include "formula/spelling.h"
#include "formula_stage.h"
#include "suite.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
  tp_message message = {.text = ""};
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

/* A dialect without them has neither letters nor signs of print, products or functions. */
START_TEST(a_plain_dialect_is_plain) {
  refuses(&plain, "α", "t:7:3: 'α' is not a number");
  refuses(&plain, "a − b", "t:7:5: '− b' does not continue");
  refuses(&plain, "a·b", "t:7:4: '·b' does not continue");
  refuses(&plain, "{a}", "t:7:3: '{a}' is not a number");
  refuses(&plain, "20°", "t:7:5: '°' does not continue");
  refuses(&plain, "2a", "t:7:4: 'a' does not continue");
  refuses(&plain, "2(a)", "t:7:4: '(a)' does not continue");
  refuses(&plain, "ba", "t:7:3: unknown name 'ba'");
  refuses(&plain, "sin", "t:7:3: unknown name 'sin'");
  refuses(&plain, "2 + sin (a)", "t:7:7: 'sin(…)' is not an exact operation");
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

SUITE(formula) {
  Suite *suite = suite_create("formula");
  TCase *formulas = tcase_create("formula");
  tcase_add_test(formulas, operators_group_as_in_algebra);
  tcase_add_test(formulas, notation_of_print);
  tcase_add_test(formulas, parts_have_places);
  tcase_add_test(formulas, a_plain_dialect_is_plain);
  tcase_add_test(formulas, names_have_lengths);
  suite_add_tcase(suite, formulas);
  return suite;
}
