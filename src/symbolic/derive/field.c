/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Algebra of rational functions over FLINT's multivariate polynomials with bounded exponents;
 * symbols and their names from the parameters of a scene, and its nodes read as elements of the
 * field. */

#include "derive/field.h"

#include "scene/setting.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_POWER = 1000 };

static const fmpz_mpoly_ctx_struct *ring(const void *context) {
  const tp_field *field = context;
  return field->ring;
}

static void init(void *value, const void *context) {
  fmpz_mpoly_q_init(value, ring(context));
}

static void clear(void *value, const void *context) {
  fmpz_mpoly_q_clear(value, ring(context));
}

static void set_number(void *value, const fmpq_t number, const void *context) {
  fmpz_mpoly_q_set_fmpq(value, number, ring(context));
}

static bool set_name(void *value, long name, tp_evaluator *evaluator) {
  const tp_field *field = evaluator->context;
  fmpz_mpoly_q_set(value, field->values + name, field->ring);
  return true;
}

static void swap(void *value, void *other, const void *context) {
  fmpz_mpoly_q_swap(value, other, ring(context));
}

static void negate(void *value, const void *context) {
  fmpz_mpoly_q_neg(value, value, ring(context));
}

/* The whole number that a constant formula is; false for any other. */
static bool whole_number(slong *number, const fmpz_mpoly_q_struct *f, const fmpz_mpoly_ctx_t ctx) {
  if (!fmpz_mpoly_is_one(fmpz_mpoly_q_denref(f), ctx) ||
      !fmpz_mpoly_is_fmpz(fmpz_mpoly_q_numref(f), ctx)) {
    return false;
  }
  fmpz_t constant;
  fmpz_init(constant);
  fmpz_mpoly_get_fmpz(constant, fmpz_mpoly_q_numref(f), ctx);
  *number = fmpz_fits_si(constant) ? fmpz_get_si(constant) : MOST_POWER + 1;
  fmpz_clear(constant);
  return true;
}

const char *tp_field_power(fmpz_mpoly_q_t base, long exponent, const tp_field *field) {
  const fmpz_mpoly_ctx_struct *ctx = field->ring;
  if (exponent > MOST_POWER || exponent < -MOST_POWER) {
    return "an exponent may be at most 1000 here";
  }
  if (fmpz_mpoly_q_is_zero(base, ctx) && exponent < 0) {
    return "division by zero: zero to a negative power";
  }
  fmpz_mpoly_q_t factor;
  fmpz_mpoly_q_init(factor, ctx);
  fmpz_mpoly_q_set(factor, base, ctx);
  if (exponent < 0) fmpz_mpoly_q_inv(factor, factor, ctx);
  fmpz_mpoly_q_one(base, ctx);
  for (long k = 0; k < labs(exponent) && tp_field_problem(field) == NULL; k++) {
    tp_field_mul(base, base, factor, field);
  }
  fmpz_mpoly_q_clear(factor, ctx);
  return tp_field_problem(field);
}

const char *tp_field_combine(fmpz_mpoly_q_t value, tp_formula_kind kind, const fmpz_mpoly_q_t other,
                             const tp_field *field) {
  switch (kind) {
  case TP_FORMULA_ADD:
    tp_field_add(value, value, other, field);
    break;
  case TP_FORMULA_SUBTRACT:
    tp_field_sub(value, value, other, field);
    break;
  case TP_FORMULA_MULTIPLY:
    tp_field_mul(value, value, other, field);
    break;
  default:
    tp_field_div(value, value, other, field);
    break;
  }
  return tp_field_problem(field);
}

static bool combine(void *value, tp_formula_kind kind, const void *other, tp_evaluator *evaluator) {
  const tp_field *field = evaluator->context;
  const char *problem = NULL;
  slong exponent = 0;
  if (kind == TP_FORMULA_DIVIDE && fmpz_mpoly_q_is_zero(other, field->ring)) {
    problem = "division by zero, whatever the parameters";
  } else if (kind != TP_FORMULA_POWER) {
    problem = tp_field_combine(value, kind, other, field);
  } else if (whole_number(&exponent, other, field->ring)) {
    problem = tp_field_power(value, exponent, field);
  } else {
    problem = "an exponent must be a whole number";
  }
  return problem == NULL || tp_evaluator_fail(evaluator, problem);
}

/* Values are fmpz_mpoly_q, the context is the field; names are its parameters. */
static const tp_algebra field_algebra = {
    .size = sizeof(fmpz_mpoly_q_struct),
    .init = init,
    .clear = clear,
    .swap = swap,
    .negate = negate,
    .set_number = set_number,
    .set_name = set_name,
    .combine = combine,
};

tp_status tp_field_read(fmpz_mpoly_q_t value, const tp_field *field, const tp_node *node,
                        const tp_scene *scene, tp_message *message) {
  const tp_override *own = tp_scene_override(scene, node);
  if (own != NULL && own->setting == NULL) {
    fmpz_mpoly_q_set_fmpq(value, own->value, field->ring);
    return TP_OK;
  }
  const tp_place at =
      own != NULL ? (tp_place){own->setting, 0, 0} : tp_node_place(node, scene->path);
  const char *text =
      own != NULL ? own->setting + tp_setting_key_length(own->setting) + 1 : node->text;
  tp_place place = at;
  if (own == NULL) place.column += node->text_offset;
  tp_parameters known = *field->parameters;
  known.count = field->known; /* an expression may use those before it */
  const tp_status status =
      tp_expression_evaluate_in(value, &field_algebra, field, text, place, &known, message);
  const slong terms = fmpz_mpoly_length(fmpz_mpoly_q_numref(value), field->ring) +
                      fmpz_mpoly_length(fmpz_mpoly_q_denref(value), field->ring);
  if (status == TP_OK && terms > TP_FIELD_COORDINATE_TERMS + 1) {
    return tp_refuse(message, TP_FAULT_RANGE, at,
                     "more than %d terms in one number; formulas are derived for shorter ones",
                     TP_FIELD_COORDINATE_TERMS);
  }
  return status;
}

void tp_field_clear(tp_field *field) {
  for (long k = 0; field->names != NULL && k < field->parameters->count; k++) {
    fmpz_mpoly_q_clear(field->values + k, field->ring);
  }
  free(field->values);
  for (long k = 0; field->renamed != NULL && k < field->parameters->count; k++) {
    free(field->renamed[k]);
  }
  free(field->renamed);
  free(field->count_name);
  free(field->names);
  free(field->work);
  fmpz_mpoly_ctx_clear(field->ring);
}

void tp_field_count_symbol(fmpz_mpoly_q_t value, const tp_field *field) {
  fmpz_mpoly_q_gen(value, field->parameters->count, field->ring);
}

long tp_field_added(const tp_field *field, long k) {
  return field->parameters->count + 1 + k;
}

static bool is_symbol(const tp_field *field, long parameter) {
  fmpz_mpoly_q_t symbol;
  fmpz_mpoly_q_init(symbol, field->ring);
  fmpz_mpoly_q_gen(symbol, parameter, field->ring);
  const bool is = fmpz_mpoly_q_equal(symbol, field->values + parameter, field->ring);
  fmpz_mpoly_q_clear(symbol, field->ring);
  return is;
}

bool tp_field_list_symbols(size_t *count, char ***names, char ***parameters,
                           const tp_field *field) {
  const size_t most = (size_t)field->parameters->count;
  *count = 0;
  *names = calloc(most + 1, sizeof **names);
  *parameters = calloc(most + 1, sizeof **parameters);
  if (*names == NULL || *parameters == NULL) return false;
  bool done = true;
  for (size_t k = 0; k < most; k++) {
    if (!is_symbol(field, (long)k)) continue;
    (*names)[*count] = strdup(field->names[k]);
    (*parameters)[*count] = strdup(field->parameters->names[k]);
    done = done && (*names)[*count] != NULL && (*parameters)[*count] != NULL;
    ++*count;
  }
  return done;
}

static bool is_parameter(const tp_parameters *parameters, const char *name) {
  for (long k = 0; k < parameters->count; k++) {
    if (strcmp(parameters->names[k], name) == 0) return true;
  }
  return false;
}

/* N, else n, else N_, N__ and so on: what no parameter is called. NULL when memory is exhausted. */
static char *name_count(const tp_parameters *parameters) {
  char *name = calloc((size_t)parameters->count + 3, 1);
  if (name == NULL) return NULL;
  strcpy(name, is_parameter(parameters, "N") ? "n" : "N");
  if (is_parameter(parameters, name)) name[0] = 'N';
  while (is_parameter(parameters, name)) name[strlen(name)] = '_'; /* zeros stand behind it */
  return name;
}

static bool name_symbols(tp_field *field, const tp_symbol_names *more) {
  const tp_parameters *parameters = field->parameters;
  field->count_name = name_count(parameters);
  if (field->count_name == NULL) return false;
  field->names = calloc((size_t)field->symbol_count, sizeof *field->names);
  if (field->names == NULL) return false;
  for (long k = 0; k < parameters->count; k++) field->names[k] = parameters->names[k];
  field->names[parameters->count] = field->count_name;
  for (long k = 0; more != NULL && k < more->count; k++) {
    field->names[tp_field_added(field, k)] = more->names[k];
  }
  return true;
}

tp_status tp_field_init(tp_field *field, const tp_scene *scene, const tp_symbol_names *more,
                        tp_message *message) {
  static const tp_parameters none = {0};
  *field = (tp_field){.parameters = scene != NULL ? &scene->parameters : &none};
  const long count = field->parameters->count;
  field->symbol_count = count + 1 + (more != NULL ? more->count : 0);
  fmpz_mpoly_ctx_init(field->ring, field->symbol_count, ORD_LEX);
  field->values = calloc((size_t)count + 1, sizeof *field->values);
  field->work = calloc(1, sizeof *field->work);
  if (field->values == NULL || field->work == NULL || !name_symbols(field, more)) {
    tp_field_clear(field);
    return tp_fail_memory(message, "the field of formulas");
  }
  field->work->budget = TP_FIELD_BUDGET;
  for (long k = 0; k < count; k++) fmpz_mpoly_q_init(field->values + k, field->ring);
  tp_status status = TP_OK;
  const tp_node *source = scene != NULL ? tp_node_get(scene->source, "parameters") : NULL;
  const tp_node *node = source != NULL ? source->first : NULL;
  for (long k = 0; k < count && node != NULL && status == TP_OK; k++, node = node->next) {
    status = tp_field_read(field->values + k, field, node, scene, message);
    if (fmpz_mpoly_q_is_fmpq(field->values + k, field->ring)) {
      fmpz_mpoly_q_gen(field->values + k, k, field->ring);
    }
    field->known = k + 1;
  }
  if (status != TP_OK) tp_field_clear(field);
  return status;
}
