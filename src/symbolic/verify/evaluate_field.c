/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Formulas as rational functions: the algebra of the field with what is known of angles. A value is
 * missing where a formula is no rational function. */

#include "verify/evaluate.h"

#include "derive/field_work.h"
#include "formula/evaluate.h"
#include "verify/angles.h"
#include "verify/branches.h"

#include <stdlib.h>

/* The context of the algebra. */
typedef struct field_context {
  tp_subject *subject;
} field_context;

static tp_subject *subject_of(const tp_evaluator *e) {
  const field_context *c = e->context;
  return c->subject;
}

static const fmpz_mpoly_ctx_struct *ring_of(const tp_evaluator *e) {
  return subject_of(e)->field->ring;
}

/* A definition is evaluated once. */
static bool of_definition(fmpz_mpoly_q_t value, long index, tp_evaluator *e) {
  tp_subject *s = subject_of(e);
  tp_name *name = s->names + index;
  if (!name->ready) {
    e->status = tp_evaluate_field(name->value, &name->rational, &name->definition, s, e->message);
    if (e->status != TP_OK) return false;
    name->ready = true;
  }
  if (name->rational) fmpz_mpoly_q_set(value, name->value, ring_of(e));
  return name->rational;
}

static bool set_name(void *value, long index, tp_evaluator *e) {
  tp_subject *s = subject_of(e);
  const tp_name *name = NULL;
  e->status = tp_subject_name(&name, s, index, e->message);
  if (e->status != TP_OK) return false;
  switch (name->kind) {
  case TP_NAME_FORMULA:
    fmpz_mpoly_q_set(value, name->value, ring_of(e));
    return true;
  case TP_NAME_ANGLE:
    fmpz_mpoly_q_gen(value, s->angles[name->angle].degrees, ring_of(e));
    return true;
  case TP_NAME_DEFINITION:
    return of_definition(value, index, e);
  case TP_NAME_DIRECTION:
    break;
  }
  return false;
}

/* value = |value|, by the sign that it has on the domain or in the branch that is looked at. */
static bool magnitude(fmpz_mpoly_q_t value, tp_evaluator *e) {
  const int sign = tp_branches_sign(value, subject_of(e));
  if (sign < 0) fmpz_mpoly_q_neg(value, value, ring_of(e));
  return sign != 0;
}

/* The root of a polynomial that is a square, verified by its square. */
static bool polynomial_root(fmpz_mpoly_t root, const fmpz_mpoly_t of,
                            const fmpz_mpoly_ctx_struct *ring) {
  if (!fmpz_mpoly_sqrt(root, of, ring)) return false;
  fmpz_mpoly_t square;
  fmpz_mpoly_init(square, ring);
  fmpz_mpoly_mul(square, root, root, ring);
  const bool is = fmpz_mpoly_equal(square, of, ring) != 0;
  fmpz_mpoly_clear(square, ring);
  return is;
}

/* The root of a perfect square that is not below zero. */
static bool square_root(fmpz_mpoly_q_t value, tp_evaluator *e) {
  const fmpz_mpoly_ctx_struct *ring = ring_of(e);
  fmpz_mpoly_q_t root;
  fmpz_mpoly_q_init(root, ring);
  const bool square =
      polynomial_root(fmpz_mpoly_q_numref(root), fmpz_mpoly_q_numref(value), ring) &&
      polynomial_root(fmpz_mpoly_q_denref(root), fmpz_mpoly_q_denref(value), ring);
  bool known = false;
  if (square) {
    fmpz_mpoly_q_swap(value, root, ring);
    known = magnitude(value, e);
  } else { /* the denominator of a value that is not valid must not be zero */
    fmpz_mpoly_q_one(root, ring);
  }
  fmpz_mpoly_q_clear(root, ring);
  return known;
}

/* base = base^exponent: whole exponents, and halves of squares. */
static bool power(fmpz_mpoly_q_t base, const fmpz_mpoly_q_t exponent, tp_evaluator *e) {
  if (!fmpz_mpoly_q_is_fmpq(exponent, ring_of(e))) return false;
  fmpz_t top, below;
  fmpz_init(top);
  fmpz_init(below);
  fmpz_mpoly_get_fmpz(top, fmpz_mpoly_q_numref(exponent), ring_of(e));
  fmpz_mpoly_get_fmpz(below, fmpz_mpoly_q_denref(exponent), ring_of(e));
  const bool whole = fmpz_is_one(below) != 0, half = fmpz_equal_si(below, 2) != 0;
  const long count = fmpz_fits_si(top) ? fmpz_get_si(top) : LONG_MAX;
  fmpz_clear(top);
  fmpz_clear(below);
  if (!whole && !half) return false;
  if (half && !square_root(base, e)) return false;
  if (count < 0) tp_branches_divide(base, subject_of(e));
  const char *problem = tp_field_power(base, count, subject_of(e)->field);
  return problem == NULL || tp_evaluator_fail(e, problem);
}

/* A tangent is not finite where its denominator vanishes. */
static void divide_by_denominator(const fmpz_mpoly_q_t value, tp_evaluator *e) {
  fmpz_mpoly_q_t below;
  fmpz_mpoly_q_init(below, ring_of(e));
  fmpz_mpoly_set(fmpz_mpoly_q_numref(below), fmpz_mpoly_q_denref(value), ring_of(e));
  tp_branches_divide(below, subject_of(e));
  fmpz_mpoly_q_clear(below, ring_of(e));
}

/* value = cot value, from the tangent; zero where that is infinite, and the other way round. */
static bool cotangent(fmpz_mpoly_q_t value, bool *infinite, tp_evaluator *e) {
  const fmpz_mpoly_ctx_struct *ring = ring_of(e);
  if (*infinite) {
    fmpz_mpoly_q_zero(value, ring);
    *infinite = false;
    return true;
  }
  *infinite = fmpz_mpoly_q_is_zero(value, ring) != 0;
  if (*infinite) return false;
  tp_branches_divide(value, subject_of(e));
  fmpz_mpoly_q_inv(value, value, ring);
  return true;
}

/* Sine, cosine, tangent or cotangent. */
static bool trigonometric(fmpz_mpoly_q_t value, tp_function function, tp_evaluator *e) {
  const fmpz_mpoly_ctx_struct *ring = ring_of(e);
  const tp_subject *s = subject_of(e);
  fmpz_mpoly_q_t result, other;
  fmpz_mpoly_q_init(result, ring);
  fmpz_mpoly_q_init(other, ring);
  bool infinite = false, known = false;
  if (function == TP_FUNCTION_SIN) known = tp_angle_sine_cosine(result, other, value, s);
  if (function == TP_FUNCTION_COS) known = tp_angle_sine_cosine(other, result, value, s);
  if (function == TP_FUNCTION_TAN || function == TP_FUNCTION_COT)
    known = tp_angle_tangent(result, &infinite, value, s);
  fmpz_mpoly_q_swap(value, result, ring);
  if (known && function == TP_FUNCTION_COT) known = cotangent(value, &infinite, e);
  fmpz_mpoly_q_clear(result, ring);
  fmpz_mpoly_q_clear(other, ring);
  if (infinite) return tp_evaluator_fail(e, "it is infinite, whatever the values");
  if (known && function == TP_FUNCTION_TAN) divide_by_denominator(value, e);
  return known;
}

static bool call(void *value, tp_function function, tp_evaluator *e) {
  bool known = false;
  switch (function) {
  case TP_FUNCTION_SQRT:
    known = square_root(value, e);
    break;
  case TP_FUNCTION_ABS:
    known = magnitude(value, e);
    break;
  case TP_FUNCTION_ATAN:
  case TP_FUNCTION_LOG10:
    break;
  default:
    known = trigonometric(value, function, e);
    break;
  }
  if (known) tp_subject_reduce(value, subject_of(e));
  return known;
}

/* value = value op other, in normal form */
static bool combine(void *value, tp_formula_kind kind, const void *other, tp_evaluator *e) {
  const tp_field *field = subject_of(e)->field;
  bool known = true;
  if (kind == TP_FORMULA_POWER) {
    known = power(value, other, e);
  } else {
    if (kind == TP_FORMULA_DIVIDE) {
      if (fmpz_mpoly_q_is_zero(other, field->ring))
        return tp_evaluator_fail(e, "division by zero, whatever the values");
      tp_branches_divide(other, subject_of(e));
    }
    const char *problem = tp_field_combine(value, kind, other, field);
    known = problem == NULL || tp_evaluator_fail(e, problem);
  }
  if (known) tp_subject_reduce(value, subject_of(e));
  return known;
}

static const fmpz_mpoly_ctx_struct *ring_in(const void *context) {
  const field_context *c = context;
  return c->subject->field->ring;
}

static void init(void *value, const void *context) {
  fmpz_mpoly_q_init(value, ring_in(context));
}

static void clear(void *value, const void *context) {
  fmpz_mpoly_q_clear(value, ring_in(context));
}

static void swap(void *value, void *other, const void *context) {
  fmpz_mpoly_q_swap(value, other, ring_in(context));
}

static void negate(void *value, const void *context) {
  fmpz_mpoly_q_neg(value, value, ring_in(context));
}

static void set_number(void *value, const fmpq_t number, const void *context) {
  fmpz_mpoly_q_set_fmpq(value, number, ring_in(context));
}

static const tp_algebra angles_algebra = {
    .size = sizeof(fmpz_mpoly_q_struct),
    .init = init,
    .clear = clear,
    .swap = swap,
    .negate = negate,
    .set_number = set_number,
    .set_name = set_name,
    .combine = combine,
    .call = call,
};

/* Evaluate all nodes before `end`; `known` tells which have a value. After one that has none the
 * others are looked at for the sake of their branches alone, and what is wrong with them is left to
 * the points. */
static void of_nodes(tp_evaluator *e, bool *known, long end) {
  bool all = true;
  for (long k = 0; k < end && e->status == TP_OK; k++) {
    const tp_formula_node *node = e->formula->nodes + k;
    if (node->left >= 0 && !known[node->left]) continue;
    if (node->right >= 0 && !known[node->right]) continue;
    if (!all && subject_of(e)->branches == NULL) return;
    known[k] = tp_evaluator_step(e, k);
    if (!all && e->status != TP_OK && e->status != TP_OUT_OF_MEMORY) {
      e->status = TP_OK;
      tp_field_forgive(subject_of(e)->field);
    }
    all = all && known[k];
  }
}

/* The value of the formula, or with `operand` of what its root is taken of. */
static tp_status evaluate(fmpz_mpoly_q_t value, bool *rational, bool operand,
                          const tp_formula *formula, tp_subject *subject, tp_message *message) {
  const long last = formula->count - 1;
  const field_context context = {subject};
  tp_evaluator e = {
      .formula = formula, .algebra = &angles_algebra, .context = &context, .message = message};
  bool *known = calloc((size_t)formula->count, sizeof *known);
  if (known == NULL) return tp_fail_memory(message, "a formula");
  const tp_status room = tp_evaluator_init(&e);
  if (room != TP_OK) {
    free(known);
    return room;
  }
  of_nodes(&e, known, operand ? last : last + 1);
  const long wanted = operand ? tp_formula_root(formula)->left : last;
  *rational = e.status == TP_OK && known[wanted];
  free(known);
  if (*rational) fmpz_mpoly_q_swap(value, tp_evaluator_value(&e, wanted), subject->field->ring);
  tp_evaluator_clear(&e);
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
