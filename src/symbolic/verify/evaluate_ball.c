/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Algebra of balls for formulas: names by the values of a sample, functions of angles in degrees,
 * powers by products, and an estimate of the work. */

#include "verify/evaluate.h"

#include "formula/evaluate.h"
#include "number/ball.h"

#include <math.h>
#include <stdlib.h>

/* The context of the algebra of balls. */
typedef struct ball_context {
  tp_subject *subject;
  const tp_claim_sample *sample;
  bool strict;
  long bits;
  arb_srcptr symbols;
  arb_ptr definitions; /* by name, computed once */
  bool *defined;
} ball_context;

static tp_status of_formula(arb_t value, const ball_context *c, const tp_formula *formula,
                            tp_message *message);

/* Symbols that the formula uses need values: the angle i of a facet takes its own. */
static bool check_given(const fmpz_mpoly_q_t f, tp_evaluator *e) {
  const ball_context *c = e->context;
  const tp_subject *s = c->subject;
  int *used = calloc((size_t)s->field->symbol_count, sizeof *used);
  if (used == NULL) {
    e->status = tp_fail_memory(e->message, "a formula");
    return false;
  }
  fmpz_mpoly_q_used_vars(used, f, s->field->ring);
  bool given = true;
  for (long k = 0; k < s->field->symbol_count && given; k++) {
    if (!used[k]) continue;
    long symbol = k;
    for (long a = 0; a < s->angle_count; a++) {
      if (s->angles[a].sine == k || s->angles[a].cosine == k) symbol = s->angles[a].degrees;
    }
    const bool own = s->scene != NULL && symbol == s->angles[TP_ANGLE_I].degrees;
    if (c->sample->given[symbol] || own) continue;
    char problem[160];
    snprintf(problem, sizeof problem, "this needs a value of '%s': 'at: {%s: …}'",
             s->field->names[symbol], s->field->names[symbol]);
    given = tp_evaluator_fail(e, problem);
  }
  free(used);
  return given;
}

static bool of_rational(arb_t value, const fmpz_mpoly_q_t f, tp_evaluator *e) {
  const ball_context *c = e->context;
  if (c->strict && !check_given(f, e)) return false;
  tp_field_evaluate_ball(value, f, c->symbols, c->subject->field, c->bits);
  return true;
}

static bool of_direction(arb_t value, const tp_name *name, tp_evaluator *e) {
  const ball_context *c = e->context;
  arb_t run;
  arb_init(run);
  const bool known = of_rational(value, name->value, e) && of_rational(run, name->run, e);
  if (known) tp_ball_atan2_degrees(value, value, run, c->bits);
  arb_clear(run);
  return known;
}

static bool of_angle(arb_t value, long angle, tp_evaluator *e) {
  const ball_context *c = e->context;
  const tp_subject *s = c->subject;
  fmpz_mpoly_q_t symbol;
  fmpz_mpoly_q_init(symbol, s->field->ring);
  fmpz_mpoly_q_gen(symbol, s->angles[angle].degrees, s->field->ring);
  const bool known = of_rational(value, symbol, e);
  fmpz_mpoly_q_clear(symbol, s->field->ring);
  return known;
}

static bool of_definition(arb_t value, const tp_name *name, long index, tp_evaluator *e) {
  const ball_context *c = e->context;
  if (!c->defined[index]) {
    e->status = of_formula(c->definitions + index, c, &name->definition, e->message);
    c->defined[index] = true;
  }
  arb_set(value, c->definitions + index);
  return e->status == TP_OK;
}

static bool set_name(void *value, long index, tp_evaluator *e) {
  const ball_context *c = e->context;
  const tp_name *name = NULL;
  e->status = tp_subject_name(&name, c->subject, index, e->message);
  if (e->status != TP_OK) return false;
  switch (name->kind) {
  case TP_NAME_ANGLE:
    return of_angle(value, name->angle, e);
  case TP_NAME_DIRECTION:
    return of_direction(value, name, e);
  case TP_NAME_DEFINITION:
    return of_definition(value, name, index, e);
  default:
    return of_rational(value, name->value, e);
  }
}

/* Functions of angles in degrees. */
static bool call(void *value, tp_function function, tp_evaluator *e) {
  const ball_context *c = e->context;
  const long bits = c->bits;
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
  return true;
}

/* Whole exponents by products: arb_pow takes a root first, which a ball about zero or below has
 * none of. Those of more bits than a word would take all memory to write down. */
static void power(arb_t value, const arb_t exponent, long bits) {
  enum { MOST_BITS = 62 };
  if (!arb_is_int(exponent) || arf_cmpabs_2exp_si(arb_midref(exponent), MOST_BITS) > 0) {
    arb_pow(value, value, exponent, bits);
    return;
  }
  fmpz_t whole;
  fmpz_init(whole);
  arb_get_unique_fmpz(whole, exponent);
  arb_pow_fmpz(value, value, whole, bits);
  fmpz_clear(whole);
}

static bool combine(void *value, tp_formula_kind kind, const void *other, tp_evaluator *e) {
  const ball_context *c = e->context;
  const long bits = c->bits;
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
    power(value, other, bits);
    break;
  }
  return true;
}

static void init(void *value, const void *context) {
  (void)context;
  arb_init(value);
}

static void clear(void *value, const void *context) {
  (void)context;
  arb_clear(value);
}

static void swap(void *value, void *other, const void *context) {
  (void)context;
  arb_swap(value, other);
}

static void negate(void *value, const void *context) {
  (void)context;
  arb_neg(value, value);
}

static void set_number(void *value, const fmpq_t number, const void *context) {
  const ball_context *c = context;
  arb_set_fmpq(value, number, c->bits);
}

static const tp_algebra ball_algebra = {
    .size = sizeof(arb_struct),
    .init = init,
    .clear = clear,
    .swap = swap,
    .negate = negate,
    .set_number = set_number,
    .set_name = set_name,
    .combine = combine,
    .call = call,
};

static tp_status of_formula(arb_t value, const ball_context *c, const tp_formula *formula,
                            tp_message *message) {
  return tp_formula_evaluate(value, formula, &ball_algebra, c, message);
}

tp_status tp_evaluate_ball(arb_t value, const tp_formula *formula, tp_subject *subject,
                           const tp_claim_sample *sample, bool strict, long bits,
                           tp_message *message) {
  ball_context c = {.subject = subject,
                    .sample = sample,
                    .strict = strict,
                    .bits = bits,
                    .defined = calloc((size_t)subject->name_count + 1, sizeof(bool))};
  if (c.defined == NULL) return tp_fail_memory(message, "a formula");
  arb_ptr symbols = tp_sample_balls(sample, subject, bits);
  c.symbols = symbols;
  c.definitions = _arb_vec_init(subject->name_count);
  const tp_status status = of_formula(value, &c, formula, message);
  _arb_vec_clear(c.definitions, subject->name_count);
  _arb_vec_clear(symbols, sample->count);
  free(c.defined);
  return status;
}

/* Microseconds, about: of a function of Arb at 256 bits ten, growing by a power of the bits that
 * was fitted; of an operation half of one and more. */
static double units_of(const tp_formula *formula, long bits) {
  static const double of_function = 10, of_operation = 0.5, growth = 1.3, at_bits = 256;
  const double function = of_function * pow((double)bits / at_bits, growth);
  double units = 0;
  for (long k = 0; k < formula->count; k++) {
    const tp_formula_kind kind = formula->nodes[k].kind;
    const bool dear = kind == TP_FORMULA_CALL || kind == TP_FORMULA_POWER;
    units += dear ? function : of_operation * (at_bits + (double)bits) / at_bits;
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
