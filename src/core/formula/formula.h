/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The syntax tree of a formula, whose nodes know where in the text they stand. What it comes to is
 * a matter of an algebra (formula/evaluate.h). */

#ifndef TP_FORMULA_FORMULA_H
#define TP_FORMULA_FORMULA_H

#include "common/message.h"

#include <flint/fmpq.h>

typedef enum tp_formula_kind {
  TP_FORMULA_NUMBER,
  TP_FORMULA_NAME,
  TP_FORMULA_NEGATE, /* left */
  TP_FORMULA_ADD,
  TP_FORMULA_SUBTRACT,
  TP_FORMULA_MULTIPLY,
  TP_FORMULA_DIVIDE,
  TP_FORMULA_POWER,
  TP_FORMULA_CALL /* function of left */
} tp_formula_kind;

/* Angles are in degrees. */
typedef enum tp_function {
  TP_FUNCTION_SIN,
  TP_FUNCTION_COS,
  TP_FUNCTION_TAN,
  TP_FUNCTION_COT,
  TP_FUNCTION_ATAN,
  TP_FUNCTION_SQRT,
  TP_FUNCTION_LOG10,
  TP_FUNCTION_ABS
} tp_function;

typedef struct tp_formula_node {
  tp_formula_kind kind;
  tp_function function;
  long left, right; /* operands, which stand before this node; -1: none */
  long name;        /* of the vocabulary */
  fmpq value;       /* of a number */
  int begin, end;   /* the part of the text that it is, in bytes */
  int at, length;   /* its number, name or operator; length 0: an operator that is not written */
} tp_formula_node;

typedef struct tp_formula {
  const char *text; /* borrowed */
  tp_place place;   /* of its first character */
  long count, capacity;
  tp_formula_node *nodes;      /* operands before what they are operands of; the last is the root */
  const tp_formula_node *lent; /* the nodes while they lie in room that the caller lent */
} tp_formula;

void tp_formula_clear(tp_formula *formula);

/* Append a node, its value zero; NULL when memory is exhausted. */
tp_formula_node *tp_formula_add(tp_formula *formula, tp_formula_kind kind);

const tp_formula_node *tp_formula_root(const tp_formula *formula);

/* Where a byte of the text stands. */
tp_place tp_formula_place(const tp_formula *formula, int at);

/* Complain at a node. */
tp_status tp_formula_fail(const tp_formula *formula, const tp_formula_node *node,
                          tp_message *message, const char *problem);

#endif
