/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A formula as it is read (read.c): its place in the text, and the pieces found there, operators
 * and numbers (parser.c), names and functions (words.c). What fails gives -1 or false and sets the
 * status. Of this room alone. */

#ifndef TP_FORMULA_PARSER_H
#define TP_FORMULA_PARSER_H

#include "formula/dialect.h"
#include "formula/formula.h"

typedef struct tp_parser {
  tp_formula *formula;
  const tp_dialect *dialect;
  const tp_vocabulary *vocabulary;
  tp_message *message;
  size_t size; /* of the text */
  int at, depth;
  tp_status status;
} tp_parser;

__attribute__((format(printf, 3, 4))) long tp_parser_fail(tp_parser *parser, int at,
                                                          const char *format, ...);

/* Bytes of the text. */
typedef struct tp_span {
  int at, length;
} tp_span;

/* Append a node of no operand, which ends here, of one, of two, with the span of its number, name
 * or operator; its index. */
long tp_parser_leaf(tp_parser *parser, tp_formula_kind kind, tp_span own);
long tp_parser_unary(tp_parser *parser, tp_formula_kind kind, long operand, tp_span own);
long tp_parser_binary(tp_parser *parser, tp_formula_kind kind, long left, long right, tp_span own);

static inline const char *tp_parser_here(const tp_parser *parser) {
  return parser->formula->text + parser->at;
}

static inline void tp_parser_skip_blanks(tp_parser *parser) {
  const char *text = tp_parser_here(parser);
  for (; *text == ' ' || *text == '\t' || (*text == '\n' && parser->dialect->lines); text++)
    parser->at++;
}

/* An operator by a spelling of print at the front; bytes used, or 0. */
int tp_operator_printed(const char *text, char *op);

/* The operator here, or zero, and its length in the text. */
static inline int tp_parser_operator(tp_parser *parser, char *op) {
  tp_parser_skip_blanks(parser);
  const char first = *tp_parser_here(parser);
  *op = first;
  if (first == '+' || first == '-' || first == '*' || first == '/' || first == '^') return 1;
  *op = '\0';
  if (!parser->dialect->letters || ((unsigned char)first & 0x80) == 0) return 0;
  return tp_operator_printed(tp_parser_here(parser), op);
}

/* Does a number, or a name, begin here? */
bool tp_parser_begins_number(const tp_parser *parser);
bool tp_parser_begins_word(const tp_parser *parser);

/* The number here, as a node. */
long tp_parser_number(tp_parser *parser);

/* Complain about the number or word here. */
long tp_parser_fail_at_word(tp_parser *parser, const char *problem);

/* A name or a function. */
typedef struct tp_word {
  bool is_function;
  tp_function function;
  long name; /* of the vocabulary */
  tp_span own;
} tp_word;

/* The word here, and step past it. Where factors may stand side by side it is the longest known
 * front of the letters, so that 27ab is a product. As an argument a function is none. */
bool tp_parser_word(tp_parser *parser, tp_word *word, bool as_argument);

/* "sin", "log10" */
const char *tp_function_name(tp_function function);

#endif
