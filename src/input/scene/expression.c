/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Plain numbers are read without a tree; other texts by the reader of formula/read.h and the
 * algebra of rationals. */

#include "scene/expression.h"

#include "formula/rational.h"
#include "formula/read.h"
#include "formula/spelling.h"
#include "number/ratio.h"

#include <stdint.h>
#include <string.h>

/* Nodes of the expressions that take no memory of their own. */
enum { FEW_NODES = 16 };

static const tp_dialect dialect = {
    .formula = "a number",
    .operand = "a number",
    .no_operand = "is not a number",
    .continued = "a number or an expression",
    .unknown_name = "define it under 'parameters', before its first use",
    .quoted = SIZE_MAX,
};

/* The last of a name counts. */
static long find(const void *context, const char *name, size_t length) {
  const tp_parameters *known = context;
  for (long k = known != NULL ? known->count - 1 : -1; k >= 0; k--) {
    if (strncmp(known->names[k], name, length) == 0 && known->names[k][length] == '\0') return k;
  }
  return -1;
}

tp_status tp_expression_evaluate_in(void *value, const tp_algebra *algebra, const void *context,
                                    const char *text, tp_place place,
                                    const tp_parameters *parameters, tp_message *message) {
  const tp_vocabulary names = {.find = find, .context = parameters};
  tp_dialect own = dialect;
  if (parameters == NULL) own.unknown_name = "a number stands here, without names";
  tp_formula_node few[FEW_NODES];
  tp_formula formula;
  tp_status status =
      tp_formula_read_into(&formula, few, FEW_NODES, text, place, &own, &names, message);
  if (status != TP_OK) return status;
  status = tp_formula_evaluate(value, &formula, algebra, context, message);
  tp_formula_clear(&formula);
  return status;
}

/* Most numbers of a scene are plain decimals, which need no tree. */
tp_status tp_expression_evaluate(fmpq_t value, const char *text, tp_place place,
                                 const tp_parameters *parameters, tp_message *message) {
  const char *problem = NULL;
  fmpq_t result;
  fmpq_init(result);
  tp_status status = TP_OK;
  if (!tp_ratio_read_fraction(result, text, strlen(text), &problem)) {
    status = tp_expression_evaluate_in(result, &tp_rational_algebra,
                                       parameters != NULL ? parameters->values : NULL, text, place,
                                       parameters, message);
  }
  if (status == TP_OK) fmpq_swap(value, result);
  fmpq_clear(result);
  return status;
}

bool tp_expression_is_name(const char *text) {
  const size_t length = tp_name_length(text);
  return length > 0 && text[length] == '\0';
}
