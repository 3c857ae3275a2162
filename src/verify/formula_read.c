/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A printed formula into its syntax tree, by recursive descent: sums, products, powers. */

#include "verify/formula_parser.h"

#include "number/ratio.h"
#include "outside.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_DEPTH = 200, MOST_NODES = 10000 };

long tp_parser_fail(tp_parser *p, int at, const char *format, ...) {
  char text[512];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  p->status = tp_fail(p->message, TP_BAD_INPUT, tp_formula_place(p->formula, at), "%s", text);
  return -1;
}

/* Append a node; its index, or -1 when there is no room. */
long tp_parser_add(tp_parser *p, tp_formula_node node) {
  if (p->formula->count == MOST_NODES) {
    return tp_parser_fail(p, node.at, "a formula of more than %d numbers, names and operators",
                          MOST_NODES);
  }
  const long index = tp_formula_add(p->formula, node);
  if (index < 0) p->status = tp_fail_memory(p->message, "a formula");
  return index;
}

long tp_parser_join(tp_parser *p, tp_formula_kind kind, long left, long right, int at, int length) {
  const tp_formula_node *nodes = p->formula->nodes;
  return tp_parser_add(p, (tp_formula_node){.kind = kind,
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

const char *tp_parser_here(const tp_parser *p) {
  return p->formula->text + p->at;
}

void tp_parser_skip_space(tp_parser *p) {
  while (*tp_parser_here(p) != '\0' && strchr(" \t\n", *tp_parser_here(p)) != NULL) p->at++;
}

int tp_parser_operator(tp_parser *p, char *op) {
  tp_parser_skip_space(p);
  return operator_at(tp_parser_here(p), op);
}

static long sum(tp_parser *p);

/* Between an opening bracket here and its partner. */
long tp_parser_bracketed(tp_parser *p, char close) {
  const int open = p->at++;
  const long inner = sum(p);
  if (inner < 0) return -1;
  tp_parser_skip_space(p);
  if (*tp_parser_here(p) != close)
    return tp_parser_fail(p, open, "this '%c' is not closed", p->formula->text[open]);
  p->at++;
  p->formula->nodes[inner].begin = open;
  p->formula->nodes[inner].end = p->at;
  return inner;
}

long tp_parser_number(tp_parser *p) {
  const char *problem = NULL;
  const int at = p->at;
  fmpq_t value;
  fmpq_init(value);
  size_t used =
      tp_ratio_read_decimal(value, tp_parser_here(p), strlen(tp_parser_here(p)), &problem);
  long node = -1;
  if (used == 0) {
    tp_parser_fail(p, at, "'%s' %s", tp_quote_of(tp_parser_here(p), 20).text, problem);
  } else {
    p->at += (int)used;
    if (strncmp(tp_parser_here(p), "\u00b0", 2) == 0)
      p->at += 2; /* degrees are the unit of angles anyway */
    node = tp_parser_add(p, (tp_formula_node){.kind = TP_FORMULA_NUMBER,
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

static long primary(tp_parser *p) {
  tp_parser_skip_space(p);
  const char *text = tp_parser_here(p);
  char name[TP_NAME_SIZE];
  if (*text == '(') return tp_parser_bracketed(p, ')');
  if (*text == '{') return tp_parser_bracketed(p, '}');
  if (*text == '\0') return tp_parser_fail(p, p->at, "a number or a name is missing at the end");
  if (isdigit((unsigned char)*text) || *text == '.') return tp_parser_number(p);
  if (tp_formula_spell(name, sizeof name, text, sizeof name) > 0) return tp_parser_word(p, false);
  return tp_parser_fail(p, p->at, "'%s' does not begin a number, a name or a bracket",
                        tp_quote_of(text, 12).text);
}

/* Signs and powers: -2^2 is -(2^2), 2^3^2 is 2^(3^2). */
long tp_parser_factor(tp_parser *p) {
  if (++p->depth > MOST_DEPTH)
    return tp_parser_fail(p, p->at, "nested deeper than %d levels", MOST_DEPTH);
  char op;
  int used = tp_parser_operator(p, &op);
  const int at = p->at;
  long value;
  if (op == '+' || op == '-') {
    p->at += used;
    value = tp_parser_factor(p);
    if (value >= 0 && op == '-') {
      const int end = p->formula->nodes[value].end;
      value = tp_parser_add(p, (tp_formula_node){.kind = TP_FORMULA_NEGATE,
                                                 .left = value,
                                                 .right = -1,
                                                 .begin = at,
                                                 .end = end,
                                                 .at = at,
                                                 .length = used});
    }
  } else {
    value = primary(p);
    if (value >= 0 && (used = tp_parser_operator(p, &op)) > 0 && op == '^') {
      const int mark = p->at;
      p->at += used;
      const long exponent = tp_parser_factor(p);
      value = exponent < 0 ? -1 : tp_parser_join(p, TP_FORMULA_POWER, value, exponent, mark, used);
    }
  }
  p->depth--;
  return value;
}

/* Does a factor begin here without an operator, as in 27ab? */
static bool factor_follows(tp_parser *p) {
  char name[TP_NAME_SIZE];
  tp_parser_skip_space(p);
  return *tp_parser_here(p) == '(' ||
         tp_formula_spell(name, sizeof name, tp_parser_here(p), sizeof name) > 0;
}

static long product(tp_parser *p) {
  long value = tp_parser_factor(p);
  bool divided = false;
  while (value >= 0) {
    char op;
    const int used = tp_parser_operator(p, &op), at = p->at;
    const bool written = op == '*' || op == '/';
    if (!written && !(op == '\0' && factor_follows(p))) break;
    if (!written && divided) {
      return tp_parser_fail(
          p, at,
          "is this factor above or below the stroke? Write '*' or put brackets round "
          "the divisor");
    }
    p->at += written ? used : 0;
    const long other = tp_parser_factor(p);
    if (other < 0) return -1;
    const bool divide = op == '/';
    value = tp_parser_join(p, divide ? TP_FORMULA_DIVIDE : TP_FORMULA_MULTIPLY, value, other, at,
                           written ? used : 0);
    divided = divide || (divided && !written);
  }
  return value;
}

static long sum(tp_parser *p) {
  long value = product(p);
  while (value >= 0) {
    char op;
    const int used = tp_parser_operator(p, &op), at = p->at;
    if (op != '+' && op != '-') break;
    p->at += used;
    const long other = product(p);
    value = other < 0 ? -1
                      : tp_parser_join(p, op == '+' ? TP_FORMULA_ADD : TP_FORMULA_SUBTRACT, value,
                                       other, at, used);
  }
  return value;
}

tp_status tp_formula_read(tp_formula *formula, const char *text, tp_place place,
                          const tp_vocabulary *vocabulary, tp_message *message) {
  *formula = (tp_formula){.text = text, .place = place};
  tp_parser p = {.formula = formula, .vocabulary = vocabulary, .message = message};
  tp_parser_skip_space(&p);
  if (*tp_parser_here(&p) == '\0') {
    tp_parser_fail(&p, p.at, "a formula belongs here");
  } else if (sum(&p) >= 0) {
    tp_parser_skip_space(&p);
    if (*tp_parser_here(&p) != '\0') {
      tp_parser_fail(&p, p.at, "'%s' does not continue a formula",
                     tp_quote_of(tp_parser_here(&p), 20).text);
    }
  }
  if (p.status != TP_OK) tp_formula_clear(formula);
  return p.status;
}
