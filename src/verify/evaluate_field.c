/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Formulas as rational functions. */

#include "verify/branches.h"

#include "derive/field_work.h"

#include <stdlib.h>

/* What becomes of a node. */
typedef enum outcome {
  RATIONAL,
  NOT_RATIONAL,
  FAILED /* `status` says why */
} outcome;

typedef struct evaluation {
  const tp_formula *formula;
  tp_subject *subject;
  tp_message *message;
  tp_status status;
  fmpz_mpoly_q_struct *values; /* of the nodes so far */
  bool *known;                 /* which of them are rational */
} evaluation;

static const fmpz_mpoly_ctx_struct *ring_of(const evaluation *e) {
  return e->subject->field->ring;
}

static const tp_field *field_of(const evaluation *e) {
  return e->subject->field;
}

static outcome fail(evaluation *e, const tp_formula_node *node, const char *problem) {
  e->status = tp_formula_fail(e->formula, node, e->message, problem);
  return FAILED;
}

/* A definition is evaluated once. */
static outcome of_definition(evaluation *e, fmpz_mpoly_q_t value, long index) {
  tp_name *name = e->subject->names + index;
  if (!name->ready) {
    e->status =
        tp_evaluate_field(name->value, &name->rational, &name->definition, e->subject, e->message);
    if (e->status != TP_OK) return FAILED;
    name->ready = true;
  }
  if (!name->rational) return NOT_RATIONAL;
  fmpz_mpoly_q_set(value, name->value, ring_of(e));
  return RATIONAL;
}

static outcome of_name(evaluation *e, fmpz_mpoly_q_t value, long index) {
  const tp_name *name = NULL;
  e->status = tp_subject_name(&name, e->subject, index, e->message);
  if (e->status != TP_OK) return FAILED;
  switch (name->kind) {
  case TP_NAME_FORMULA:
    fmpz_mpoly_q_set(value, name->value, ring_of(e));
    return RATIONAL;
  case TP_NAME_ANGLE:
    fmpz_mpoly_q_gen(value, e->subject->angles[name->angle].degrees, ring_of(e));
    return RATIONAL;
  case TP_NAME_DEFINITION:
    return of_definition(e, value, index);
  case TP_NAME_DIRECTION:
    break;
  }
  return NOT_RATIONAL;
}

/* value = |value|, by the sign that it has on the domain or in the branch that is looked at. */
static outcome magnitude(evaluation *e, fmpz_mpoly_q_t value) {
  const int sign = tp_branches_sign(value, e->subject);
  if (sign < 0) fmpz_mpoly_q_neg(value, value, ring_of(e));
  return sign != 0 ? RATIONAL : NOT_RATIONAL;
}

/* The root of a perfect square that is not below zero. */
static outcome square_root(evaluation *e, fmpz_mpoly_q_t value) {
  const fmpz_mpoly_ctx_struct *ring = ring_of(e);
  fmpz_mpoly_q_t root;
  fmpz_mpoly_q_init(root, ring);
  const bool square =
      fmpz_mpoly_sqrt(fmpz_mpoly_q_numref(root), fmpz_mpoly_q_numref(value), ring) &&
      fmpz_mpoly_sqrt(fmpz_mpoly_q_denref(root), fmpz_mpoly_q_denref(value), ring);
  outcome result = NOT_RATIONAL;
  if (square) {
    fmpz_mpoly_q_swap(value, root, ring);
    result = magnitude(e, value);
  } else { /* the denominator of a value that is not valid must not be zero */
    fmpz_mpoly_q_one(root, ring);
  }
  fmpz_mpoly_q_clear(root, ring);
  return result;
}

/* base = base^exponent: whole exponents, and halves of squares. */
static outcome power(evaluation *e, fmpz_mpoly_q_t base, const fmpz_mpoly_q_t exponent,
                     const tp_formula_node *node) {
  if (!fmpz_mpoly_q_is_fmpq(exponent, ring_of(e))) return NOT_RATIONAL;
  fmpz_t top, below;
  fmpz_init(top);
  fmpz_init(below);
  fmpz_mpoly_get_fmpz(top, fmpz_mpoly_q_numref(exponent), ring_of(e));
  fmpz_mpoly_get_fmpz(below, fmpz_mpoly_q_denref(exponent), ring_of(e));
  const bool whole = fmpz_is_one(below) != 0, half = fmpz_equal_si(below, 2) != 0;
  const long count = fmpz_fits_si(top) ? fmpz_get_si(top) : LONG_MAX;
  fmpz_clear(top);
  fmpz_clear(below);
  if (!whole && !half) return NOT_RATIONAL;
  const outcome root = half ? square_root(e, base) : RATIONAL;
  if (root != RATIONAL) return root;
  if (count < 0) tp_branches_divide(base, e->subject);
  const char *problem = tp_field_power(base, count, e->subject->field);
  return problem == NULL ? RATIONAL : fail(e, node, problem);
}

/* A tangent is not finite where its denominator vanishes. */
static void divide_by_denominator(evaluation *e, const fmpz_mpoly_q_t value) {
  fmpz_mpoly_q_t below;
  fmpz_mpoly_q_init(below, ring_of(e));
  fmpz_mpoly_set(fmpz_mpoly_q_numref(below), fmpz_mpoly_q_denref(value), ring_of(e));
  tp_branches_divide(below, e->subject);
  fmpz_mpoly_q_clear(below, ring_of(e));
}

static outcome call(evaluation *e, fmpz_mpoly_q_t value, const tp_formula_node *node) {
  const fmpz_mpoly_ctx_struct *ring = ring_of(e);
  if (node->function == TP_FUNCTION_SQRT) return square_root(e, value);
  if (node->function == TP_FUNCTION_ABS) return magnitude(e, value);
  fmpz_mpoly_q_t sine, cosine;
  fmpz_mpoly_q_init(sine, ring);
  fmpz_mpoly_q_init(cosine, ring);
  bool infinite = false, known = false;
  switch (node->function) {
  case TP_FUNCTION_SIN:
    known = tp_angle_sine_cosine(sine, cosine, value, e->subject);
    fmpz_mpoly_q_swap(value, sine, ring);
    break;
  case TP_FUNCTION_COS:
    known = tp_angle_sine_cosine(sine, cosine, value, e->subject);
    fmpz_mpoly_q_swap(value, cosine, ring);
    break;
  case TP_FUNCTION_TAN:
    known = tp_angle_tangent(sine, &infinite, value, e->subject);
    fmpz_mpoly_q_swap(value, sine, ring);
    break;
  case TP_FUNCTION_COT:
    known = tp_angle_tangent(sine, &infinite, value, e->subject);
    fmpz_mpoly_q_swap(value, sine, ring);
    if (known && !infinite && fmpz_mpoly_q_is_zero(value, ring)) {
      known = false;
      infinite = true;
    } else if (known && infinite) {
      fmpz_mpoly_q_zero(value, ring);
      infinite = false;
    } else if (known) {
      tp_branches_divide(value, e->subject);
      fmpz_mpoly_q_inv(value, value, ring);
    }
    break;
  default:
    break;
  }
  fmpz_mpoly_q_clear(sine, ring);
  fmpz_mpoly_q_clear(cosine, ring);
  if (infinite) return fail(e, node, "it is infinite, whatever the values");
  if (known && node->function == TP_FUNCTION_TAN) divide_by_denominator(e, value);
  return known ? RATIONAL : NOT_RATIONAL;
}

/* left = left op right */
static outcome combine(evaluation *e, fmpz_mpoly_q_t left, const fmpz_mpoly_q_t right,
                       const tp_formula_node *node) {
  const tp_field *field = field_of(e);
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  if (node->kind == TP_FORMULA_POWER) return power(e, left, right, node);
  switch (node->kind) {
  case TP_FORMULA_ADD:
    tp_field_add(left, left, right, field);
    break;
  case TP_FORMULA_SUBTRACT:
    tp_field_sub(left, left, right, field);
    break;
  case TP_FORMULA_MULTIPLY:
    tp_field_mul(left, left, right, field);
    break;
  default:
    if (fmpz_mpoly_q_is_zero(right, ring)) {
      return fail(e, node, "division by zero, whatever the values");
    }
    tp_branches_divide(right, e->subject);
    tp_field_div(left, left, right, field);
    break;
  }
  const char *problem = tp_field_problem(field);
  return problem == NULL ? RATIONAL : fail(e, node, problem);
}

/* The value of a node from those of its operands, which it may take over. */
static outcome of_node(evaluation *e, const tp_formula_node *node, fmpz_mpoly_q_t value) {
  if (node->left >= 0) fmpz_mpoly_q_swap(value, e->values + node->left, ring_of(e));
  outcome result = RATIONAL;
  switch (node->kind) {
  case TP_FORMULA_NUMBER:
    fmpz_mpoly_q_set_fmpq(value, &node->value, ring_of(e));
    break;
  case TP_FORMULA_NAME:
    result = of_name(e, value, node->name);
    break;
  case TP_FORMULA_NEGATE:
    fmpz_mpoly_q_neg(value, value, ring_of(e));
    break;
  case TP_FORMULA_CALL:
    result = call(e, value, node);
    break;
  default:
    result = combine(e, value, e->values + node->right, node);
    break;
  }
  if (result == RATIONAL) tp_subject_reduce(value, e->subject);
  return result;
}

/* Evaluate all nodes before `end`. After one that is not rational the others are looked at for the
 * sake of their branches alone, and what is wrong with them is left to the points. */
static void of_nodes(evaluation *e, long end) {
  bool all = true;
  for (long k = 0; k < end && e->status == TP_OK; k++) {
    const tp_formula_node *node = e->formula->nodes + k;
    if (node->left >= 0 && !e->known[node->left]) continue;
    if (node->right >= 0 && !e->known[node->right]) continue;
    if (!all && e->subject->branches == NULL) return;
    e->known[k] = of_node(e, node, e->values + k) == RATIONAL;
    if (!all && e->status != TP_OK && e->status != TP_OUT_OF_MEMORY) {
      e->status = TP_OK;
      tp_field_forgive(field_of(e));
    }
    all = all && e->known[k];
  }
}

static fmpz_mpoly_q_struct *new_values(long count, const fmpz_mpoly_ctx_t ring) {
  fmpz_mpoly_q_struct *values = malloc((size_t)count * sizeof *values);
  for (long k = 0; values != NULL && k < count; k++) fmpz_mpoly_q_init(values + k, ring);
  return values;
}

static void free_values(fmpz_mpoly_q_struct *values, long count, const fmpz_mpoly_ctx_t ring) {
  for (long k = 0; k < count; k++) fmpz_mpoly_q_clear(values + k, ring);
  free(values);
}

/* The value of the formula, or with `operand` of what its root is taken of. */
static tp_status evaluate(fmpz_mpoly_q_t value, bool *rational, bool operand,
                          const tp_formula *formula, tp_subject *subject, tp_message *message) {
  const fmpz_mpoly_ctx_struct *ring = subject->field->ring;
  const long last = formula->count - 1;
  fmpz_mpoly_q_struct *values = new_values(formula->count, ring);
  if (values == NULL) return tp_fail_memory(message, "a formula");
  bool *known = calloc((size_t)formula->count, sizeof *known);
  if (known == NULL) {
    free_values(values, formula->count, ring);
    return tp_fail_memory(message, "a formula");
  }
  evaluation e = {
      .formula = formula, .subject = subject, .message = message, .values = values, .known = known};
  of_nodes(&e, operand ? last : last + 1);
  const long wanted = operand ? tp_formula_root(formula)->left : last;
  *rational = e.status == TP_OK && known[wanted];
  free(known);
  if (*rational) fmpz_mpoly_q_swap(value, values + wanted, ring);
  free_values(values, formula->count, ring);
  return e.status;
}

tp_status tp_evaluate_field(fmpz_mpoly_q_t value, bool *rational, const tp_formula *formula,
                            tp_subject *subject, tp_message *message) {
  return evaluate(value, rational, false, formula, subject, message);
}

tp_status tp_evaluate_operand(fmpz_mpoly_q_t value, bool *rational, const tp_formula *formula,
                              tp_subject *subject, tp_message *message) {
  return evaluate(value, rational, true, formula, subject, message);
}
