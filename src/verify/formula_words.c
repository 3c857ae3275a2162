/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Names and functions in a printed formula. */

#include "verify/formula_parser.h"

#include "outside.h"

#include <ctype.h>
#include <string.h>

static const char *const functions[] = {"sin", "cos", "tan", "cot", "atan", "sqrt", "log10", "abs"};
enum { FUNCTIONS = sizeof functions / sizeof functions[0] };

static long call(tp_parser *p, tp_function function, long argument, int at, int length) {
  return tp_parser_add(p, (tp_formula_node){.kind = TP_FORMULA_CALL,
                                            .function = function,
                                            .left = argument,
                                            .right = -1,
                                            .begin = at,
                                            .end = p->formula->nodes[argument].end,
                                            .at = at,
                                            .length = length});
}

/* What a function is taken of: brackets, a name or a number. */
static long argument(tp_parser *p, const char *function) {
  tp_parser_skip_space(p);
  const char *text = tp_parser_here(p);
  char name[TP_NAME_SIZE];
  if (*text == '(') return tp_parser_bracketed(p, ')');
  if (isdigit((unsigned char)*text)) return tp_parser_number(p);
  if (tp_formula_spell(name, sizeof name, text, sizeof name) > 0) return tp_parser_word(p, true);
  return tp_parser_fail(p, p->at, "%s of what? Write %s(x)", function, function);
}

/* sin, sin^2 or tan^-1, and what it is taken of. */
static long application(tp_parser *p, tp_function function, int at, int length) {
  char op;
  long exponent = -1;
  bool inverse = false;
  const int mark = p->at, used = tp_parser_operator(p, &op);
  if (op == '^') {
    p->at += used;
    exponent = tp_parser_factor(p);
    if (exponent < 0) return -1;
    const tp_formula_node *e = p->formula->nodes + exponent;
    inverse = e->kind == TP_FORMULA_NEGATE &&
              p->formula->nodes[e->left].kind == TP_FORMULA_NUMBER &&
              fmpq_is_one(&p->formula->nodes[e->left].value);
    if (inverse && function != TP_FUNCTION_TAN) {
      return tp_parser_fail(p, at, "what does %s^-1 mean? Write 1/%s(x), or an inverse function",
                            functions[function], functions[function]);
    }
  } else {
    p->at = mark;
  }
  const long of = argument(p, functions[function]);
  if (of < 0) return -1;
  if (inverse) {
    const tp_formula_node *n = p->formula->nodes + of;
    const bool angle =
        n->kind == TP_FORMULA_NAME && p->vocabulary->is_angle(p->vocabulary->context, n->name);
    function = angle ? TP_FUNCTION_COT : TP_FUNCTION_ATAN;
  }
  const long value = call(p, function, of, at, length);
  if (value < 0 || exponent < 0 || inverse) return value;
  return tp_parser_join(p, TP_FORMULA_POWER, value, exponent, mark, used);
}

static int function_named(const char *name) {
  for (int k = 0; k < FUNCTIONS; k++) {
    if (strcmp(name, functions[k]) == 0) return k;
  }
  return -1;
}

/* A name or a function: the longest known front of the letters here, so that 27ab is a product. As
 * an argument a function is none. */
long tp_parser_word(tp_parser *p, bool as_argument) {
  char name[TP_NAME_SIZE];
  const int at = p->at;
  const size_t all = tp_formula_spell(name, sizeof name, tp_parser_here(p), sizeof name - 1);
  for (size_t most = all; most > 0; most--) {
    const size_t used = tp_formula_spell(name, sizeof name, tp_parser_here(p), most);
    const int function = function_named(name);
    if (function >= 0 && !as_argument) {
      p->at += (int)used;
      return application(p, (tp_function)function, at, (int)used);
    }
    const long known =
        used > 0 ? p->vocabulary->find(p->vocabulary->context, name, strlen(name)) : -1;
    if (known < 0) continue;
    p->at += (int)used;
    return tp_parser_add(p, (tp_formula_node){.kind = TP_FORMULA_NAME,
                                              .left = -1,
                                              .right = -1,
                                              .name = known,
                                              .begin = at,
                                              .end = p->at,
                                              .at = at,
                                              .length = (int)used});
  }
  if (strncmp(tp_parser_here(p), "log", 3) == 0)
    return tp_parser_fail(p, at, "write log10 for the decimal logarithm");
  return tp_parser_fail(
      p, at,
      "unknown name '%s'; names are the scene's parameters, the quantities, and what "
      "'symbols', 'angles' and 'with' define",
      tp_quote_of(tp_parser_here(p), (size_t)all).text);
}
