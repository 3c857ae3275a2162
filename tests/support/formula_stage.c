/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "formula_stage.h"

#include "suite.h"

#include <stdint.h>
#include <string.h>

const tp_dialect printed = {
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
const tp_dialect plain = {
    .formula = "a number",
    .operand = "a number",
    .no_operand = "is not a number",
    .continued = "an expression",
    .unknown_name = "it is not known",
    .quoted = SIZE_MAX,
};

static void append(char *out, const char *text) {
  ck_assert_uint_lt(strlen(out) + strlen(text), 900);
  strcat(out, text);
}

void write_out(char *out, const tp_formula *f, long index) {
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
    append(out, formula_names[n->name]);
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

void reads(const tp_dialect *dialect, const char *text, const char *tree) {
  tp_formula formula;
  tp_message message = {.text = ""};
  char out[1000] = "";
  ck_assert_msg(tp_formula_read(&formula, text, (tp_place){"t", 1, 1}, dialect, &vocabulary,
                                &message) == TP_OK,
                "%s: %s", text, message.text);
  write_out(out, &formula, formula.count - 1);
  ck_assert_msg(strcmp(out, tree) == 0, "%s is read as %s", text, out);
  tp_formula_clear(&formula);
}

void refuses(const tp_dialect *dialect, const char *text, const char *beginning) {
  tp_formula formula;
  tp_message message = {.text = ""};
  ck_assert_msg(tp_formula_read(&formula, text, (tp_place){"t", 7, 3}, dialect, &vocabulary,
                                &message) == TP_BAD_INPUT,
                "%s is read", text);
  ck_assert_msg(strncmp(message.text, beginning, strlen(beginning)) == 0, "%s: %s", text,
                message.text);
  ck_assert_int_eq(formula.count, 0);
  tp_formula_clear(&formula);
}
