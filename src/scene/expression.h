/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Expressions in named parameters, evaluated exactly: + - * / ^ and parentheses over decimals and
 * names. 1/3 is a third. Powers take whole exponents; nesting is bounded by 200 levels and numbers
 * by 20 000 bits, so that no input exhausts the stack or the memory. */

#ifndef TP_EXPRESSION_H
#define TP_EXPRESSION_H

#include "message.h"

#include <flint/fmpq.h>

/* Named values, in the order of their definition. */
typedef struct tp_parameters {
  long count;
  char **names;
  fmpq *values;
} tp_parameters;

/* Evaluate `text`, whose first character stands at `place`. `value` is untouched on failure. */
TP_MUST_USE tp_status tp_expression_evaluate(fmpq_t value, const char *text, tp_place place,
                                             const tp_parameters *parameters, tp_message *message);

/* Is `text` a name that a parameter can have? */
bool tp_expression_is_name(const char *text);

/* Does `text` spell infinity or not-a-number? */
bool tp_expression_is_not_finite(const char *text);

#endif
