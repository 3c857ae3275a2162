/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Writes tangent, centre, reactions and conditions of the limit's formula, and has them checked by
 * derive/checks.h (docs/mechanics.md section 9). */

#include "derive/derive_limit.h"

#include "derive/checks.h"
#include "derive/contact_conditions.h"
#include "derive/field_work.h"
#include "derive/notation.h"
#include "evaluation/friction.h"
#include "number/ball.h"

#include <stdlib.h>
#include <string.h>

/* Of the scene's values, at which the signs of conditions are read. */
enum { BITS = 256 };

tp_status tp_derive_limit_check(const tp_scene *scene, tp_message *message) {
  if (!scene->friction_angle_deg.given) {
    return tp_refuse(
        message, TP_FAULT_KEY, (tp_place){scene->path, 0, 0},
        "the static limit needs friction_angle_deg; its value picks the mechanism, and "
        "the formula then holds for every tan(phi) in its range");
  }
  if (scene->friction.facet_count > 0) {
    return tp_refuse(message, TP_FAULT_KEY, scene->friction.facets[0].place,
                     "formulas of the limit take one friction angle for all facets; leave out what "
                     "facets have of their own");
  }
  if (scene->friction.load_dependent) {
    return tp_refuse(
        message, TP_FAULT_KEY, scene->friction_angle_deg.place,
        "formulas of the limit take one friction angle; give friction_angle_deg, and the "
        "formula holds for tan(phi) at any stress");
  }
  for (long k = 0; k < scene->parameters.count; k++) {
    if (strcmp(scene->parameters.names[k], "phi") != 0) continue;
    return tp_refuse(message, TP_FAULT_KEY,
                     tp_node_place(tp_node_get(scene->source, "parameters"), scene->path),
                     "the formulas of the limit need the name 'phi' for themselves; rename this "
                     "parameter");
  }
  return TP_OK;
}

void tp_derived_limit_free(tp_derived_limit *l) {
  tp_notation_free(&l->tan_critical_angle);
  tp_notation_free(&l->centre_x);
  tp_notation_free(&l->centre_y);
  for (int k = 0; k < 2; k++) {
    tp_notation_free(&l->reactions[k].x);
    tp_notation_free(&l->reactions[k].y);
  }
  for (size_t k = 0; k < l->condition_count; k++) tp_notation_free(l->conditions + k);
  free(l->conditions);
  tp_checks_free(&l->checks);
}

typedef struct writing {
  tp_derived_limit *out;
  const tp_limit_formulas *formulas;
  const tp_field *field;
  tp_notation notation;
  bool *failed;
  arb_ptr values; /* of all symbols at the scene's */
  bool checked;
  tp_message *message;
} writing;

/* (-v_y, v_x) / omega. */
static void write_centre(const writing *w) {
  const fmpz_mpoly_ctx_struct *ring = w->field->ring;
  const tp_limit_formulas *f = w->formulas;
  w->out->has_centre = !fmpz_mpoly_q_is_zero(f->twist.of + 2, ring);
  if (!w->out->has_centre) return;
  fmpz_mpoly_q_t x;
  fmpz_mpoly_q_init(x, ring);
  fmpz_mpoly_q_set(x, f->twist.of + 1, ring);
  if (f->towards == TP_TOWARDS_LEFT) fmpz_mpoly_q_neg(x, x, ring);
  w->out->centre_x =
      tp_notation_write_quotient(x, f->twist.of + 2, w->field, w->notation, w->failed);
  w->out->centre_y =
      tp_notation_write_quotient(f->twist.of, f->twist.of + 2, w->field, w->notation, w->failed);
  fmpz_mpoly_q_clear(x, ring);
}

static void write_reactions(const writing *w) {
  const tp_limit_formulas *f = w->formulas;
  fmpz_mpoly_q_t x;
  fmpz_mpoly_q_init(x, w->field->ring);
  for (int k = 0; k < 2; k++) {
    const tp_contact_formulas *c = f->contacts.items + f->edges[k].point;
    tp_derived_reaction *own = w->out->reactions + k;
    fmpz_mpoly_q_set(x, c->x, w->field->ring);
    tp_symbol_mirror(x, f->towards, w->field);
    own->x = tp_notation_write(x, w->field, w->notation, w->failed);
    own->y = tp_notation_write(c->y, w->field, w->notation, w->failed);
    own->against_slip = !f->edges[k].against;
  }
  fmpz_mpoly_q_clear(x, w->field->ring);
}

/* The powers of all columns on the twist, not below zero where the basis is optimal. */
static void add_powers(tp_conditions *conditions, const writing *w) {
  const tp_limit_formulas *f = w->formulas;
  tp_vector_formulas force;
  fmpz_mpoly_q_t power;
  tp_vector_formulas_init(&force, w->field);
  fmpz_mpoly_q_init(power, w->field->ring);
  for (long column = 0; column < 2 * f->contacts.count; column++) {
    const tp_contact_formulas *c = f->contacts.items + column / 2;
    if (!c->known) continue;
    tp_contact_formulas_edge(&force, c, f->friction, column % 2 == 1, w->field);
    tp_symbol_set_dot(power, f->twist.of, force.of, w->field);
    tp_conditions_add(conditions, power);
  }
  tp_vector_formulas_clear(&force, w->field);
  fmpz_mpoly_q_clear(power, w->field->ring);
}

static bool all_positive(const writing *w) {
  const tp_parameters *parameters = &w->formulas->model->problem.scene->parameters;
  for (long k = 0; k < parameters->count; k++) {
    if (fmpq_sgn(parameters->values + k) <= 0) return false;
  }
  return true;
}

static tp_status check(const writing *w, const tp_conditions *conditions) {
  const tp_limit_formulas *f = w->formulas;
  if (*w->failed || tp_field_problem(w->field) != NULL) return TP_OK; /* which fails by itself */
  fmpz_mpoly_q_t tangent;
  fmpz_mpoly_q_init(tangent, w->field->ring);
  tp_field_div(tangent, f->sine, f->cosine, w->field);
  const tp_checked_formula checked = {.model = f->model,
                                      .towards = f->towards,
                                      .friction = f->friction,
                                      .tangent = tangent,
                                      .conditions = conditions};
  const tp_status status = tp_checks_run(&w->out->checks, &checked, w->message);
  fmpz_mpoly_q_clear(tangent, w->field->ring);
  return status;
}

/* The basis is optimal where both forces push, every other one resists no motion by the twist, and
 * the twist goes with the tilt. */
static tp_status write_conditions(const writing *w) {
  tp_conditions conditions = {
      .field = w->field, .positive = all_positive(w), .at = w->values, .bits = BITS};
  fmpz_mpoly_q_t factors[2];
  for (int k = 0; k < 2; k++) fmpz_mpoly_q_init(factors[k], w->field->ring);
  tp_limit_formulas_factors(factors, w->formulas);
  for (int k = 0; k < 2; k++) tp_conditions_add(&conditions, factors[k]);
  tp_conditions_add(&conditions, w->formulas->cosine);
  add_powers(&conditions, w);
  (void)tp_contact_conditions(&conditions, w->formulas->model); /* alike: either end will do */
  w->out->parameters_above_zero = conditions.positive;
  w->out->conditions = calloc((size_t)conditions.count + 1, sizeof *w->out->conditions);
  if (w->out->conditions == NULL || conditions.failed) *w->failed = true;
  for (long k = 0; k < conditions.count && w->out->conditions != NULL; k++) {
    w->out->conditions[w->out->condition_count++] =
        tp_notation_write(conditions.items + k, w->field, w->notation, w->failed);
  }
  for (int k = 0; k < 2; k++) fmpz_mpoly_q_clear(factors[k], w->field->ring);
  const tp_status status = w->checked ? check(w, &conditions) : TP_OK;
  tp_conditions_clear(&conditions);
  return status;
}

void tp_derive_limit_values(arb_ptr values, const tp_model *model, long friction, long bits) {
  const tp_scene *scene = model->problem.scene;
  for (long k = 0; k < scene->parameters.count; k++) {
    arb_set_fmpq(values + k, scene->parameters.values + k, bits);
  }
  arb_t degrees;
  arb_init(degrees);
  arb_set_fmpq(degrees, scene->friction_angle_deg.value, bits);
  tp_friction_tangent(values + friction, degrees, bits);
  arb_clear(degrees);
}

static tp_bounded angle_at_values(const writing *w) {
  const tp_limit_formulas *f = w->formulas;
  fmpz_mpoly_q_t quotient;
  fmpz_mpoly_q_init(quotient, w->field->ring);
  tp_field_div(quotient, f->sine, f->cosine, w->field);
  const tp_bounded angle = tp_field_angle(quotient, w->values, w->field, BITS);
  fmpz_mpoly_q_clear(quotient, w->field->ring);
  return angle;
}

static tp_status write_all(const writing *w) {
  const tp_limit_formulas *f = w->formulas;
  w->out->tan_critical_angle =
      tp_notation_write_quotient(f->sine, f->cosine, w->field, w->notation, w->failed);
  w->out->critical_angle_deg = angle_at_values(w);
  write_centre(w);
  write_reactions(w);
  return write_conditions(w);
}

tp_status tp_derive_limit(tp_derived_limit *out, const tp_model *model, const tp_case *own,
                          long friction, const tp_derive_options *options, bool *failed,
                          tp_message *message) {
  const tp_limit *limit = &own->limit;
  const tp_field *field = &model->symbols.field;
  out->mechanism = limit->mechanism;
  out->base_beyond_toe = limit->base_beyond_toe;
  if (limit->kind != TP_LIMIT_AT_ANGLE) return TP_OK;
  if (limit->tie || limit->reaction_count != 2) {
    return tp_fail(message, TP_NO_ANSWER, model->problem.scene->friction_angle_deg.place,
                   "at these values two mechanisms tie, each with a different formula; derive at "
                   "values to one side");
  }
  out->known = true;
  tp_limit_formulas formulas;
  tp_status status =
      tp_limit_formulas_init(&formulas, model, own->towards, friction, limit->reactions, message);
  if (status != TP_OK) return status;
  const writing w = {out,
                     &formulas,
                     field,
                     options->notation,
                     failed,
                     _arb_vec_init(field->symbol_count),
                     options->checked,
                     message};
  tp_derive_limit_values(w.values, model, friction, BITS);
  status = write_all(&w);
  _arb_vec_clear(w.values, field->symbol_count);
  tp_limit_formulas_clear(&formulas);
  return status;
}
