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

enum { TP_ALGEBRA_SIZE = 96 };

/* What an expression is evaluated in: rationals here, rational functions where it is derived. A
 * value takes at most TP_ALGEBRA_SIZE bytes. `combine` sets value = value op other for one of
 * + - * / ^ and returns NULL, or what is wrong as a static string. */
typedef struct tp_algebra {
  void (*init)(void *value, const void *context);
  void (*clear)(void *value, const void *context);
  void (*set_number)(void *value, const fmpq_t number, const void *context);
  bool (*set_name)(void *value, const char *name, size_t length, const void *context);
  void (*negate)(void *value, const void *context);
  const char *(*combine)(void *value, char op, const void *other, const void *context);
} tp_algebra;

extern const tp_algebra tp_rational_algebra; /* fmpq; the context is a tp_parameters */

/* Evaluate `text`, whose first character stands at `place`, into an initialised value, which is
 * left in any state on failure. */
TP_MUST_USE tp_status tp_expression_read(void *value, const tp_algebra *algebra,
                                         const void *context, const char *text, tp_place place,
                                         tp_message *message);

/* Evaluate `text`, whose first character stands at `place`. `value` is untouched on failure. */
TP_MUST_USE tp_status tp_expression_evaluate(fmpq_t value, const char *text, tp_place place,
                                             const tp_parameters *parameters, tp_message *message);

/* Is `text` a name that a parameter can have? */
bool tp_expression_is_name(const char *text);

/* Does `text` spell infinity or not-a-number? */
bool tp_expression_is_not_finite(const char *text);

#endif
