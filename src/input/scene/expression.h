/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Expressions in named parameters, as scenes write their numbers: formulas (formula/formula.h) in
 * their plainest dialect, evaluated in exact rationals. */

#ifndef TP_SCENE_EXPRESSION_H
#define TP_SCENE_EXPRESSION_H

#include "formula/evaluate.h"

/* Named values, in the order of their definition. */
typedef struct tp_parameters {
  long count;
  char **names;
  fmpq *values;
} tp_parameters;

/* Evaluate `text`, whose first character stands at `place`; NULL: no parameters. `value` is
 * untouched on failure. */
TP_MUST_USE tp_status tp_expression_evaluate(fmpq_t value, const char *text, tp_place place,
                                             const tp_parameters *parameters, tp_message *message);

/* The same in any algebra, for which the names are the parameters by their numbers. `value` is left
 * in any state on failure. */
TP_MUST_USE tp_status tp_expression_evaluate_in(void *value, const tp_algebra *algebra,
                                                const void *context, const char *text,
                                                tp_place place, const tp_parameters *parameters,
                                                tp_message *message);

/* Is `text` a name that a parameter can have? */
bool tp_expression_is_name(const char *text);

#endif
