/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Formulas in balls. */

#include "verify/evaluate.h"

#include "number/ball.h"

#include <math.h>
#include <stdlib.h>

typedef struct evaluation {
  tp_subject *subject;
  const tp_sample *sample;
  bool strict;
  long bits;
  tp_message *message;
  arb_srcptr symbols;
  arb_ptr definitions; /* by name, computed once */
  bool *defined;
} evaluation;

static tp_status of_formula(arb_t value, evaluation *e, const tp_formula *formula);

/* Symbols that the formula uses need values: the angle i of a facet takes its own. */
static tp_status check_given(const evaluation *e, const fmpz_mpoly_q_t f, const tp_formula *formula,
                             const tp_formula_node *node) {
  const tp_subject *s = e->subject;
  int *used = calloc((size_t)s->field->symbol_count, sizeof *used);
  if (used == NULL) return tp_fail_memory(e->message, "a formula");
  fmpz_mpoly_q_used_vars(used, f, s->field->ring);
  tp_status status = TP_OK;
  for (long k = 0; k < s->field->symbol_count && status == TP_OK; k++) {
    if (!used[k]) continue;
    long symbol = k;
    for (long a = 0; a < s->angle_count; a++) {
      if (s->angles[a].sine == k || s->angles[a].cosine == k) symbol = s->angles[a].degrees;
    }
    const bool own = s->scene != NULL && symbol == s->angles[TP_ANGLE_I].degrees;
    if (e->sample->given[symbol] || own) continue;
    char problem[160];
    snprintf(problem, sizeof problem, "this needs a value of '%s': 'at: {%s: …}'",
             s->field->names[symbol], s->field->names[symbol]);
    status = tp_formula_fail(formula, node, e->message, problem);
  }
  free(used);
  return status;
}

static tp_status of_rational(arb_t value, const evaluation *e, const fmpz_mpoly_q_t f,
                             const tp_formula *formula, const tp_formula_node *node) {
  const tp_status status = e->strict ? check_given(e, f, formula, node) : TP_OK;
  if (status == TP_OK) tp_field_evaluate_ball(value, f, e->symbols, e->subject->field, e->bits);
  return status;
}

static tp_status of_direction(arb_t value, const evaluation *e, const tp_name *name,
                              const tp_formula *formula, const tp_formula_node *node) {
  arb_t run;
  arb_init(run);
  tp_status status = of_rational(value, e, name->value, formula, node);
  if (status == TP_OK) status = of_rational(run, e, name->run, formula, node);
  if (status == TP_OK) tp_ball_atan2_degrees(value, value, run, e->bits);
  arb_clear(run);
  return status;
}

static tp_status of_angle(arb_t value, const evaluation *e, long angle, const tp_formula *formula,
                          const tp_formula_node *node) {
  fmpz_mpoly_q_t symbol;
  fmpz_mpoly_q_init(symbol, e->subject->field->ring);
  fmpz_mpoly_q_gen(symbol, e->subject->angles[angle].degrees, e->subject->field->ring);
  const tp_status status = of_rational(value, e, symbol, formula, node);
  fmpz_mpoly_q_clear(symbol, e->subject->field->ring);
  return status;
}

static tp_status of_name(arb_t value, evaluation *e, const tp_formula *formula,
                         const tp_formula_node *node) {
  const tp_name *name = NULL;
  tp_status status = tp_subject_name(&name, e->subject, node->name, e->message);
  if (status != TP_OK) return status;
  switch (name->kind) {
  case TP_NAME_FORMULA:
    return of_rational(value, e, name->value, formula, node);
  case TP_NAME_ANGLE:
    return of_angle(value, e, name->angle, formula, node);
  case TP_NAME_DIRECTION:
    return of_direction(value, e, name, formula, node);
  case TP_NAME_DEFINITION:
    break;
  }
  if (!e->defined[node->name]) {
    status = of_formula(e->definitions + node->name, e, &name->definition);
    e->defined[node->name] = true;
  }
  arb_set(value, e->definitions + node->name);
  return status;
}

/* Functions of angles in degrees. */
static void call(arb_t value, tp_function function, long bits) {
  arb_t other;
  arb_init(other);
  switch (function) {
  case TP_FUNCTION_SIN:
  case TP_FUNCTION_COS:
  case TP_FUNCTION_TAN:
  case TP_FUNCTION_COT:
    arb_div_ui(value, value, 180, bits);
    if (function == TP_FUNCTION_SIN) arb_sin_pi(value, value, bits);
    if (function == TP_FUNCTION_COS) arb_cos_pi(value, value, bits);
    if (function == TP_FUNCTION_TAN) arb_tan_pi(value, value, bits);
    if (function == TP_FUNCTION_COT) arb_cot_pi(value, value, bits);
    break;
  case TP_FUNCTION_ATAN:
    arb_one(other);
    tp_ball_atan2_degrees(value, value, other, bits);
    break;
  case TP_FUNCTION_SQRT:
    arb_sqrt(value, value, bits);
    break;
  case TP_FUNCTION_LOG10:
    arb_log_base_ui(value, value, 10, bits);
    break;
  case TP_FUNCTION_ABS:
    arb_abs(value, value);
    break;
  }
  arb_clear(other);
}

static void combine(arb_t value, const arb_t other, tp_formula_kind kind, long bits) {
  switch (kind) {
  case TP_FORMULA_ADD:
    arb_add(value, value, other, bits);
    break;
  case TP_FORMULA_SUBTRACT:
    arb_sub(value, value, other, bits);
    break;
  case TP_FORMULA_MULTIPLY:
    arb_mul(value, value, other, bits);
    break;
  case TP_FORMULA_DIVIDE:
    arb_div(value, value, other, bits);
    break;
  default:
    arb_pow(value, value, other, bits);
    break;
  }
}

static tp_status of_nodes(arb_ptr values, evaluation *e, const tp_formula *formula) {
  tp_status status = TP_OK;
  for (long k = 0; k < formula->count && status == TP_OK; k++) {
    const tp_formula_node *node = formula->nodes + k;
    if (node->left >= 0) arb_swap(values + k, values + node->left);
    switch (node->kind) {
    case TP_FORMULA_NUMBER:
      arb_set_fmpq(values + k, &node->value, e->bits);
      break;
    case TP_FORMULA_NAME:
      status = of_name(values + k, e, formula, node);
      break;
    case TP_FORMULA_NEGATE:
      arb_neg(values + k, values + k);
      break;
    case TP_FORMULA_CALL:
      call(values + k, node->function, e->bits);
      break;
    default:
      combine(values + k, values + node->right, node->kind, e->bits);
      break;
    }
  }
  return status;
}

static tp_status of_formula(arb_t value, evaluation *e, const tp_formula *formula) {
  arb_ptr values = _arb_vec_init(formula->count);
  const tp_status status = of_nodes(values, e, formula);
  arb_swap(value, values + formula->count - 1);
  _arb_vec_clear(values, formula->count);
  return status;
}

tp_status tp_evaluate_ball(arb_t value, const tp_formula *formula, tp_subject *subject,
                           const tp_sample *sample, bool strict, long bits, tp_message *message) {
  evaluation e = {.subject = subject,
                  .sample = sample,
                  .strict = strict,
                  .bits = bits,
                  .message = message,
                  .defined = calloc((size_t)subject->name_count + 1, sizeof(bool))};
  if (e.defined == NULL) return tp_fail_memory(message, "a formula");
  arb_ptr symbols = tp_sample_balls(sample, subject, bits);
  e.symbols = symbols;
  e.definitions = _arb_vec_init(subject->name_count);
  const tp_status status = of_formula(value, &e, formula);
  _arb_vec_clear(e.definitions, subject->name_count);
  _arb_vec_clear(symbols, sample->count);
  free(e.defined);
  return status;
}

static double units_of(const tp_formula *formula, long bits) {
  const double function = 10 * pow((double)bits / 256, 1.3);
  double units = 0;
  for (long k = 0; k < formula->count; k++) {
    const tp_formula_kind kind = formula->nodes[k].kind;
    const bool dear = kind == TP_FORMULA_CALL || kind == TP_FORMULA_POWER;
    units += dear ? function : 0.5 * (double)(256 + bits) / 256;
  }
  return units;
}

double tp_evaluate_units(const tp_formula *formula, const tp_subject *s, long bits) {
  double units = units_of(formula, bits);
  for (long k = s->permanent; k < s->name_count; k++) {
    if (s->names[k].kind == TP_NAME_DEFINITION) units += units_of(&s->names[k].definition, bits);
  }
  return units;
}

/* By names alone, so that it holds for what is not rational too. */
tp_status tp_evaluate_used(int *used, const tp_formula *formula, tp_subject *s,
                           tp_message *message) {
  const fmpz_mpoly_ctx_struct *ring = s->field->ring;
  int *own = calloc((size_t)s->field->symbol_count, sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "a formula");
  tp_status status = TP_OK;
  for (long k = 0; k < formula->count && status == TP_OK; k++) {
    const tp_formula_node *node = formula->nodes + k;
    const tp_name *name = NULL;
    if (node->kind != TP_FORMULA_NAME) continue;
    status = tp_subject_name(&name, s, node->name, message);
    if (status != TP_OK) break;
    if (name->kind == TP_NAME_DEFINITION) {
      for (long j = 0; j < s->field->symbol_count; j++) used[j] |= name->used[j];
      continue;
    }
    if (name->kind == TP_NAME_ANGLE) used[s->angles[name->angle].degrees] = 1;
    fmpz_mpoly_q_used_vars(own, name->value, ring);
    for (long j = 0; j < s->field->symbol_count; j++) used[j] |= own[j];
    if (name->kind != TP_NAME_DIRECTION) continue;
    fmpz_mpoly_q_used_vars(own, name->run, ring);
    for (long j = 0; j < s->field->symbol_count; j++) used[j] |= own[j];
  }
  free(own);
  return status;
}
