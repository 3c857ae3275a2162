/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A formula as it is read: operators, brackets and numbers (formula_read.c); names and functions
 * (formula_words.c). What fails gives -1 and sets the status. */

#ifndef TP_FORMULA_PARSER_H
#define TP_FORMULA_PARSER_H

#include "verify/formula.h"

typedef struct tp_parser {
  tp_formula *formula;
  const tp_vocabulary *vocabulary;
  tp_message *message;
  int at, depth;
  tp_status status;
} tp_parser;

__attribute__((format(printf, 3, 4))) long tp_parser_fail(tp_parser *parser, int at,
                                                          const char *format, ...);

/* Append a node; its index. */
long tp_parser_add(tp_parser *parser, tp_formula_node node);
long tp_parser_join(tp_parser *parser, tp_formula_kind kind, long left, long right, int at,
                    int length);

const char *tp_parser_here(const tp_parser *parser);
void tp_parser_skip_space(tp_parser *parser);
/* The operator here and its length in the text; 0 where there is none. */
int tp_parser_operator(tp_parser *parser, char *op);

/* Between an opening bracket here and its partner. */
long tp_parser_bracketed(tp_parser *parser, char close);
long tp_parser_number(tp_parser *parser);
/* Signs and powers: -2^2 is -(2^2), 2^3^2 is 2^(3^2). */
long tp_parser_factor(tp_parser *parser);
/* A name or a function: the longest known front of the letters here, so that 27ab is a product. As
 * an argument a function is none. */
long tp_parser_word(tp_parser *parser, bool as_argument);

#endif
