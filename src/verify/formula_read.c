/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "verify/formula.h"

#include "number/ratio.h"
#include "outside.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_DEPTH = 200, MOST_NODES = 10000 };

static const char *const functions[] = {"sin", "cos", "tan", "cot", "atan", "sqrt", "log10", "abs"};
enum { FUNCTIONS = sizeof functions / sizeof functions[0] };

typedef struct parser {
  tp_formula *formula;
  const tp_vocabulary *vocabulary;
  tp_message *message;
  int at, depth;
  tp_status status;
} parser;

__attribute__((format(printf, 3, 4))) static long fail_at(parser *p, int at, const char *format,
                                                          ...) {
  char text[512];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  p->status = tp_fail(p->message, TP_BAD_INPUT, tp_formula_place(p->formula, at), "%s", text);
  return -1;
}

/* Append a node; its index, or -1 when there is no room. */
static long add(parser *p, tp_formula_node node) {
  if (p->formula->count == MOST_NODES) {
    return fail_at(p, node.at, "a formula of more than %d numbers, names and operators",
                   MOST_NODES);
  }
  const long index = tp_formula_add(p->formula, node);
  if (index < 0) p->status = tp_fail_memory(p->message, "a formula");
  return index;
}

static long join(parser *p, tp_formula_kind kind, long left, long right, int at, int length) {
  const tp_formula_node *nodes = p->formula->nodes;
  return add(p, (tp_formula_node){.kind = kind,
                                  .left = left,
                                  .right = right,
                                  .begin = nodes[left].begin,
                                  .end = nodes[right].end,
                                  .at = at,
                                  .length = length});
}

/* One of these operators, by any of its spellings, at the front; bytes used, or 0. */
static int operator_at(const char *text, char *op) {
  static const struct {
    const char *spelling;
    char op;
  } spellings[] = {{"+", '+'},      {"-", '-'},      {"\u2212", '-'}, {"\u2013", '-'}, {"*", '*'},
                   {"\u00b7", '*'}, {"\u22c5", '*'}, {"\u00d7", '*'}, {"/", '/'},      {"^", '^'}};
  for (size_t k = 0; k < sizeof spellings / sizeof spellings[0]; k++) {
    const size_t length = strlen(spellings[k].spelling);
    if (strncmp(text, spellings[k].spelling, length) != 0) continue;
    *op = spellings[k].op;
    return (int)length;
  }
  *op = '\0';
  return 0;
}

static const char *here(const parser *p) {
  return p->formula->text + p->at;
}

static void skip_space(parser *p) {
  while (*here(p) != '\0' && strchr(" \t\n", *here(p)) != NULL) p->at++;
}

static int next_operator(parser *p, char *op) {
  skip_space(p);
  return operator_at(here(p), op);
}

static long sum(parser *p);
static long factor(parser *p);

/* Between an opening bracket here and its partner. */
static long bracketed(parser *p, char close) {
  const int open = p->at++;
  const long inner = sum(p);
  if (inner < 0) return -1;
  skip_space(p);
  if (*here(p) != close) return fail_at(p, open, "this '%c' is not closed", p->formula->text[open]);
  p->at++;
  p->formula->nodes[inner].begin = open;
  p->formula->nodes[inner].end = p->at;
  return inner;
}

static long number(parser *p) {
  const char *problem = NULL;
  const int at = p->at;
  fmpq_t value;
  fmpq_init(value);
  size_t used = tp_ratio_read_decimal(value, here(p), strlen(here(p)), &problem);
  long node = -1;
  if (used == 0) {
    fail_at(p, at, "'%s' %s", tp_quote_of(here(p), 20).text, problem);
  } else {
    p->at += (int)used;
    if (strncmp(here(p), "\u00b0", 2) == 0) p->at += 2; /* degrees are the unit of angles anyway */
    node = add(p, (tp_formula_node){.kind = TP_FORMULA_NUMBER,
                                    .left = -1,
                                    .right = -1,
                                    .begin = at,
                                    .end = p->at,
                                    .at = at,
                                    .length = (int)used});
    if (node >= 0) fmpq_set(&p->formula->nodes[node].value, value);
  }
  fmpq_clear(value);
  return node;
}

static long call(parser *p, tp_function function, long argument, int at, int length) {
  return add(p, (tp_formula_node){.kind = TP_FORMULA_CALL,
                                  .function = function,
                                  .left = argument,
                                  .right = -1,
                                  .begin = at,
                                  .end = p->formula->nodes[argument].end,
                                  .at = at,
                                  .length = length});
}

static long word(parser *p, bool argument);

/* What a function is taken of: brackets, a name or a number. */
static long argument(parser *p, const char *function) {
  skip_space(p);
  const char *text = here(p);
  char name[TP_NAME_SIZE];
  if (*text == '(') return bracketed(p, ')');
  if (isdigit((unsigned char)*text)) return number(p);
  if (tp_formula_spell(name, sizeof name, text, sizeof name) > 0) return word(p, true);
  return fail_at(p, p->at, "%s of what? Write %s(x)", function, function);
}

/* sin, sin^2 or tan^-1, and what it is taken of. */
static long application(parser *p, tp_function function, int at, int length) {
  char op;
  long exponent = -1;
  bool inverse = false;
  const int mark = p->at, used = next_operator(p, &op);
  if (op == '^') {
    p->at += used;
    exponent = factor(p);
    if (exponent < 0) return -1;
    const tp_formula_node *e = p->formula->nodes + exponent;
    inverse = e->kind == TP_FORMULA_NEGATE &&
              p->formula->nodes[e->left].kind == TP_FORMULA_NUMBER &&
              fmpq_is_one(&p->formula->nodes[e->left].value);
    if (inverse && function != TP_FUNCTION_TAN) {
      return fail_at(p, at, "what does %s^-1 mean? Write 1/%s(x), or an inverse function",
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
  return join(p, TP_FORMULA_POWER, value, exponent, mark, used);
}

static int function_named(const char *name) {
  for (int k = 0; k < FUNCTIONS; k++) {
    if (strcmp(name, functions[k]) == 0) return k;
  }
  return -1;
}

/* A name or a function: the longest known front of the letters here, so that 27ab is a product. As
 * an argument a function is none. */
static long word(parser *p, bool as_argument) {
  char name[TP_NAME_SIZE];
  const int at = p->at;
  const size_t all = tp_formula_spell(name, sizeof name, here(p), sizeof name - 1);
  for (size_t most = all; most > 0; most--) {
    const size_t used = tp_formula_spell(name, sizeof name, here(p), most);
    const int function = function_named(name);
    if (function >= 0 && !as_argument) {
      p->at += (int)used;
      return application(p, (tp_function)function, at, (int)used);
    }
    const long known =
        used > 0 ? p->vocabulary->find(p->vocabulary->context, name, strlen(name)) : -1;
    if (known < 0) continue;
    p->at += (int)used;
    return add(p, (tp_formula_node){.kind = TP_FORMULA_NAME,
                                    .left = -1,
                                    .right = -1,
                                    .name = known,
                                    .begin = at,
                                    .end = p->at,
                                    .at = at,
                                    .length = (int)used});
  }
  if (strncmp(here(p), "log", 3) == 0)
    return fail_at(p, at, "write log10 for the decimal logarithm");
  return fail_at(p, at,
                 "unknown name '%s'; names are the scene's parameters, the quantities, and what "
                 "'symbols', 'angles' and 'with' define",
                 tp_quote_of(here(p), (size_t)all).text);
}

static long primary(parser *p) {
  skip_space(p);
  const char *text = here(p);
  char name[TP_NAME_SIZE];
  if (*text == '(') return bracketed(p, ')');
  if (*text == '{') return bracketed(p, '}');
  if (*text == '\0') return fail_at(p, p->at, "a number or a name is missing at the end");
  if (isdigit((unsigned char)*text) || *text == '.') return number(p);
  if (tp_formula_spell(name, sizeof name, text, sizeof name) > 0) return word(p, false);
  return fail_at(p, p->at, "'%s' does not begin a number, a name or a bracket",
                 tp_quote_of(text, 12).text);
}

/* Signs and powers: -2^2 is -(2^2), 2^3^2 is 2^(3^2). */
static long factor(parser *p) {
  if (++p->depth > MOST_DEPTH) return fail_at(p, p->at, "nested deeper than %d levels", MOST_DEPTH);
  char op;
  int used = next_operator(p, &op);
  const int at = p->at;
  long value;
  if (op == '+' || op == '-') {
    p->at += used;
    value = factor(p);
    if (value >= 0 && op == '-') {
      const int end = p->formula->nodes[value].end;
      value = add(p, (tp_formula_node){.kind = TP_FORMULA_NEGATE,
                                       .left = value,
                                       .right = -1,
                                       .begin = at,
                                       .end = end,
                                       .at = at,
                                       .length = used});
    }
  } else {
    value = primary(p);
    if (value >= 0 && (used = next_operator(p, &op)) > 0 && op == '^') {
      const int mark = p->at;
      p->at += used;
      const long exponent = factor(p);
      value = exponent < 0 ? -1 : join(p, TP_FORMULA_POWER, value, exponent, mark, used);
    }
  }
  p->depth--;
  return value;
}

/* Does a factor begin here without an operator, as in 27ab? */
static bool factor_follows(parser *p) {
  char name[TP_NAME_SIZE];
  skip_space(p);
  return *here(p) == '(' || tp_formula_spell(name, sizeof name, here(p), sizeof name) > 0;
}

static long product(parser *p) {
  long value = factor(p);
  bool divided = false;
  while (value >= 0) {
    char op;
    const int used = next_operator(p, &op), at = p->at;
    const bool written = op == '*' || op == '/';
    if (!written && !(op == '\0' && factor_follows(p))) break;
    if (!written && divided) {
      return fail_at(p, at,
                     "is this factor above or below the stroke? Write '*' or put brackets round "
                     "the divisor");
    }
    p->at += written ? used : 0;
    const long other = factor(p);
    if (other < 0) return -1;
    const bool divide = op == '/';
    value = join(p, divide ? TP_FORMULA_DIVIDE : TP_FORMULA_MULTIPLY, value, other, at,
                 written ? used : 0);
    divided = divide || (divided && !written);
  }
  return value;
}

static long sum(parser *p) {
  long value = product(p);
  while (value >= 0) {
    char op;
    const int used = next_operator(p, &op), at = p->at;
    if (op != '+' && op != '-') break;
    p->at += used;
    const long other = product(p);
    value = other < 0
                ? -1
                : join(p, op == '+' ? TP_FORMULA_ADD : TP_FORMULA_SUBTRACT, value, other, at, used);
  }
  return value;
}

tp_status tp_formula_read(tp_formula *formula, const char *text, tp_place place,
                          const tp_vocabulary *vocabulary, tp_message *message) {
  *formula = (tp_formula){.text = text, .place = place};
  parser p = {.formula = formula, .vocabulary = vocabulary, .message = message};
  skip_space(&p);
  if (*here(&p) == '\0') {
    fail_at(&p, p.at, "a formula belongs here");
  } else if (sum(&p) >= 0) {
    skip_space(&p);
    if (*here(&p) != '\0') {
      fail_at(&p, p.at, "'%s' does not continue a formula", tp_quote_of(here(&p), 20).text);
    }
  }
  if (p.status != TP_OK) tp_formula_clear(formula);
  return p.status;
}
