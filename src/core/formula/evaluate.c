/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One pass over the nodes in order, with values in one array on the stack or the heap; the algebra
 * supplies the operations. */

#include "formula/evaluate.h"

#include <stdalign.h>
#include <stdlib.h>

enum { FEW_BYTES = 256 };

bool tp_evaluator_fail(tp_evaluator *e, const char *problem) {
  e->status = tp_formula_fail(e->formula, e->node, e->message, problem);
  return false;
}

static void init_values(const tp_evaluator *e) {
  for (long k = 0; k < e->formula->count; k++) {
    e->algebra->init(tp_evaluator_value(e, k), e->context);
  }
}

static void clear_values(const tp_evaluator *e) {
  for (long k = 0; k < e->formula->count; k++) {
    e->algebra->clear(tp_evaluator_value(e, k), e->context);
  }
}

tp_status tp_evaluator_init(tp_evaluator *e) {
  e->values = malloc((size_t)e->formula->count * e->algebra->size);
  if (e->values == NULL) return tp_fail_memory(e->message, "a formula");
  init_values(e);
  return TP_OK;
}

void tp_evaluator_clear(tp_evaluator *e) {
  clear_values(e);
  free(e->values);
}

bool tp_evaluator_step(tp_evaluator *e, long k) {
  const tp_algebra *algebra = e->algebra;
  const tp_formula_node *node = e->formula->nodes + k;
  void *value = tp_evaluator_value(e, k);
  e->node = node;
  if (node->left >= 0) algebra->swap(value, tp_evaluator_value(e, node->left), e->context);
  switch (node->kind) {
  case TP_FORMULA_NUMBER:
    algebra->set_number(value, &node->value, e->context);
    return true;
  case TP_FORMULA_NAME:
    return algebra->set_name(value, node->name, e);
  case TP_FORMULA_NEGATE:
    algebra->negate(value, e->context);
    return true;
  case TP_FORMULA_CALL:
    return algebra->call(value, node->function, e);
  default:
    return algebra->combine(value, node->kind, tp_evaluator_value(e, node->right), e);
  }
}

/* Values of short formulas lie on the stack, so that a number takes no memory. */
tp_status tp_formula_evaluate(void *value, const tp_formula *formula, const tp_algebra *algebra,
                              const void *context, tp_message *message) {
  alignas(max_align_t) unsigned char few[FEW_BYTES];
  tp_evaluator e = {.formula = formula,
                    .algebra = algebra,
                    .context = context,
                    .message = message,
                    .values = few};
  const bool fits = (size_t)formula->count * algebra->size <= sizeof few;
  if (fits) {
    init_values(&e);
  } else {
    const tp_status status = tp_evaluator_init(&e);
    if (status != TP_OK) return status;
  }
  bool known = true;
  for (long k = 0; k < formula->count && known; k++) known = tp_evaluator_step(&e, k);
  if (known) algebra->swap(value, tp_evaluator_value(&e, formula->count - 1), context);
  if (fits) {
    clear_values(&e);
  } else {
    tp_evaluator_clear(&e);
  }
  return e.status;
}
