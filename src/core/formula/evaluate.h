/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a formula comes to in an algebra: the rationals (formula/rational.h), rational functions
 * (derive/field.c, verify/evaluate_field.c), balls (verify/evaluate_ball.c).
 *
 * Nodes are evaluated in their order, operands first, each into a place of its own; a node takes
 * over the value of its left operand. The time is that of the operations, the memory that of one
 * value a node. */

#ifndef TP_FORMULA_EVALUATE_H
#define TP_FORMULA_EVALUATE_H

#include "formula/formula.h"

typedef struct tp_evaluator tp_evaluator;

/* Operations on values of `size` bytes. Those that are true have set the value; those that are
 * false have not, because the algebra has no such value or because something is wrong: then they
 * say so by tp_evaluator_fail, or set the status themselves. */
typedef struct tp_algebra {
  size_t size;
  void (*init)(void *value, const void *context);
  void (*clear)(void *value, const void *context);
  void (*swap)(void *value, void *other, const void *context);
  void (*negate)(void *value, const void *context);
  void (*set_number)(void *value, const fmpq_t number, const void *context);
  bool (*set_name)(void *value, long name, tp_evaluator *evaluator);
  /* value = value op other, for one of the five binary operators */
  bool (*combine)(void *value, tp_formula_kind kind, const void *other, tp_evaluator *evaluator);
  bool (*call)(void *value, tp_function function, tp_evaluator *evaluator); /* NULL: no functions */
} tp_algebra;

/* An evaluation on its way. */
struct tp_evaluator {
  const tp_formula *formula;
  const tp_algebra *algebra;
  const void *context; /* of the algebra */
  tp_message *message;
  tp_status status;
  const tp_formula_node *node; /* in hand */
  unsigned char *values;       /* of the nodes, one behind the other */
};

/* The formula's value, of a dialect that the algebra can follow. On failure `value` is left in any
 * state that can be cleared. */
TP_MUST_USE tp_status tp_formula_evaluate(void *value, const tp_formula *formula,
                                          const tp_algebra *algebra, const void *context,
                                          tp_message *message);

/* Step by step, where some nodes may have no value: set up, with formula, algebra, context and
 * message in place; the k-th node, whose operands must have values; its value; clear. */
TP_MUST_USE tp_status tp_evaluator_init(tp_evaluator *evaluator);
bool tp_evaluator_step(tp_evaluator *evaluator, long k);
static inline void *tp_evaluator_value(const tp_evaluator *evaluator, long k) {
  return evaluator->values + (size_t)k * evaluator->algebra->size;
}
void tp_evaluator_clear(tp_evaluator *evaluator);

/* Complain at the node in hand; false. */
bool tp_evaluator_fail(tp_evaluator *evaluator, const char *problem);

#endif
