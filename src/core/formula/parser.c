/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a formula is made of, one piece at a time: operators, numbers, and nodes for the tree. */

#include "formula/parser.h"

#include "common/outside.h"
#include "formula/spelling.h"
#include "number/ratio.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

long tp_parser_fail(tp_parser *p, int at, const char *format, ...) {
  char text[512];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  p->status = tp_refuse(p->message, TP_FAULT_FORMAT, tp_formula_place(p->formula, at), "%s", text);
  return -1;
}

/* Append a node; NULL when there is no room. */
static tp_formula_node *add(tp_parser *p, tp_formula_kind kind, tp_span own) {
  tp_formula *f = p->formula;
  if (f->count == p->dialect->most_nodes && f->count > 0) {
    tp_parser_fail(p, own.at, "a formula of more than %ld numbers, names and operators",
                   p->dialect->most_nodes);
    return NULL;
  }
  tp_formula_node *node = tp_formula_add(f, kind);
  if (node == NULL) {
    p->status = tp_fail_memory(p->message, "a formula");
    return NULL;
  }
  node->begin = node->at = own.at;
  node->length = own.length;
  return node;
}

long tp_parser_leaf(tp_parser *p, tp_formula_kind kind, tp_span own) {
  tp_formula_node *node = add(p, kind, own);
  if (node == NULL) return -1;
  node->end = p->at;
  return p->formula->count - 1;
}

long tp_parser_unary(tp_parser *p, tp_formula_kind kind, long operand, tp_span own) {
  tp_formula_node *node = add(p, kind, own);
  if (node == NULL) return -1;
  node->left = operand;
  node->end = p->formula->nodes[operand].end;
  return p->formula->count - 1;
}

long tp_parser_binary(tp_parser *p, tp_formula_kind kind, long left, long right, tp_span own) {
  tp_formula_node *node = add(p, kind, own);
  if (node == NULL) return -1;
  node->left = left;
  node->right = right;
  const tp_formula_node *first = p->formula->nodes + left, *last = p->formula->nodes + right;
  node->begin = first->begin;
  node->end = first->end > last->end ? first->end : last->end; /* sin^2 x ends with x */
  return p->formula->count - 1;
}

int tp_operator_printed(const char *text, char *op) {
  static const struct {
    const char *spelling;
    char op;
  } printed[] = {
      {"\u2212", '-'}, {"\u2013", '-'}, {"\u00b7", '*'}, {"\u22c5", '*'}, {"\u00d7", '*'}};
  for (size_t k = 0; k < sizeof printed / sizeof printed[0]; k++) {
    const size_t length = strlen(printed[k].spelling);
    if (strncmp(text, printed[k].spelling, length) != 0) continue;
    *op = printed[k].op;
    return (int)length;
  }
  return 0;
}

/* What stands here as one word for a message: a number with its exponent, or what looks like one.
 */
static size_t word_length(const char *text) {
  size_t length = 0;
  while (text[length] != '\0' && strchr(" \t\n*/^()", text[length]) == NULL) {
    const bool sign = text[length] == '+' || text[length] == '-';
    if (sign && (length == 0 || strchr("eE", text[length - 1]) == NULL)) break;
    length++;
  }
  return length > 0 ? length : 1;
}

long tp_parser_fail_at_word(tp_parser *p, const char *problem) {
  const char *text = tp_parser_here(p);
  return tp_parser_fail(p, p->at, "'%s' %s", tp_quote_of(text, word_length(text)).text,
                        tp_ratio_is_not_finite(text) ? "is not a finite number" : problem);
}

long tp_parser_number(tp_parser *p) {
  const char *problem = NULL;
  const int at = p->at;
  fmpq_t value;
  fmpq_init(value);
  const size_t used =
      tp_ratio_read_decimal(value, tp_parser_here(p), p->size - (size_t)at, &problem);
  long node = -1;
  if (used == 0) {
    tp_parser_fail_at_word(p, problem);
  } else {
    static const char degrees[] = "\u00b0"; /* the unit of angles anyway */
    p->at += (int)used;
    if (p->dialect->letters && strncmp(tp_parser_here(p), degrees, strlen(degrees)) == 0)
      p->at += (int)strlen(degrees);
    node = tp_parser_leaf(p, TP_FORMULA_NUMBER, (tp_span){at, (int)used});
    if (node >= 0) fmpq_swap(&p->formula->nodes[node].value, value);
  }
  fmpq_clear(value);
  return node;
}

bool tp_parser_begins_number(const tp_parser *p) {
  const char first = *tp_parser_here(p);
  return isdigit((unsigned char)first) || first == '.';
}

bool tp_parser_begins_word(const tp_parser *p) {
  char name[TP_NAME_SIZE];
  const char *text = tp_parser_here(p);
  return tp_name_length(text) > 0 ||
         (p->dialect->letters && tp_name_spell(name, sizeof name, text, sizeof name) > 0);
}
