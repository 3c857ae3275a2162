/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Writes tangent, rows and conditions of the onset's formula, or the reason why there is none
 * (docs/mechanics.md section 9). */

#include "derive/derive_onset.h"

#include "derive/checks.h"
#include "derive/field_work.h"
#include "derive/notation.h"
#include "derive/onset_formulas.h"
#include "number/ball.h"

#include <stdlib.h>
#include <string.h>

void tp_derived_onset_free(tp_derived_onset *o) {
  tp_notation_free(&o->tan_critical_angle);
  for (int k = 0; k < 2; k++) {
    tp_notation_free(&o->balance[k].x);
    tp_notation_free(&o->balance[k].y);
  }
  for (size_t k = 0; k < o->condition_count; k++) tp_notation_free(o->conditions + k);
  free(o->conditions);
  tp_checks_free(&o->checks);
}

typedef struct writing {
  tp_derived_onset *out;
  const tp_onset_formulas *formulas;
  tp_notation notation;
  bool *failed;
} writing;

static tp_fraction write(const writing *w, const fmpz_mpoly_q_t formula) {
  return tp_notation_write(formula, w->formulas->terms.field, w->notation, w->failed);
}

/* x of the scene. */
static tp_fraction write_x(const writing *w, fmpz_mpoly_q_t x) {
  const tp_onset_terms *t = &w->formulas->terms;
  tp_symbol_mirror(x, t->towards, t->field);
  return write(w, x);
}

/* (-v_y, v_x) / theta. */
static void write_centre(const writing *w, tp_derived_row *own, const tp_vector_formulas *twist) {
  const tp_field *field = w->formulas->terms.field;
  own->turns = !fmpz_mpoly_q_is_zero(twist->of + 2, field->ring);
  if (!own->turns) return;
  fmpz_mpoly_q_t coordinate;
  fmpz_mpoly_q_init(coordinate, field->ring);
  tp_field_div(coordinate, twist->of + 1, twist->of + 2, field);
  fmpz_mpoly_q_neg(coordinate, coordinate, field->ring);
  own->x = write_x(w, coordinate);
  tp_field_div(coordinate, twist->of, twist->of + 2, field);
  own->y = write(w, coordinate);
  fmpz_mpoly_q_clear(coordinate, field->ring);
}

static void write_rows(const writing *w) {
  const tp_onset_formulas *f = w->formulas;
  const tp_field *field = f->terms.field;
  const long rows[] = {f->begins->i, f->begins->j};
  fmpz_mpoly_q_t x;
  fmpz_mpoly_q_init(x, field->ring);
  for (int k = 0; k < 2; k++) {
    const tp_onset_row *row = f->modes.modes[f->begins->mode].rows + rows[k];
    tp_derived_row *own = w->out->balance + k;
    own->is_force = !row->is_ray;
    if (row->is_ray) {
      write_centre(w, own, f->modes.rays + row->ray);
      continue;
    }
    own->against_slip = !row->against;
    fmpz_mpoly_q_set(x, f->terms.contacts.items[row->point].x, field->ring);
    own->x = write_x(w, x);
    own->y = write(w, f->terms.contacts.items[row->point].y);
  }
  fmpz_mpoly_q_clear(x, field->ring);
}

static void write_conditions(const writing *w) {
  const tp_conditions *c = &w->formulas->conditions;
  w->out->parameters_above_zero = c->positive;
  w->out->conditions = calloc((size_t)c->count + 1, sizeof *w->out->conditions);
  if (w->out->conditions == NULL) {
    *w->failed = true;
    return;
  }
  for (long k = 0; k < c->count; k++) {
    w->out->conditions[w->out->condition_count++] = write(w, c->items + k);
  }
}

static bool all_positive(const tp_scene *scene) {
  for (long k = 0; k < scene->parameters.count; k++) {
    if (fmpq_sgn(scene->parameters.values + k) <= 0) return false;
  }
  return true;
}

static tp_status check(const writing *w, const tp_onset_wanted *wanted, tp_message *message) {
  const tp_onset_formulas *f = w->formulas;
  const tp_checked_formula checked = {.model = wanted->model,
                                      .towards = wanted->towards,
                                      .onset = true,
                                      .friction = wanted->friction,
                                      .tangent = f->tangent,
                                      .conditions = &f->conditions};
  return tp_checks_run(&w->out->checks, &checked, message);
}

static tp_status derive(tp_derived_onset *out, const tp_onset_wanted *wanted,
                        const tp_derive_options *options, bool *failed, tp_message *message) {
  tp_onset_formulas formulas;
  out->reason = tp_onset_formulas_init(&formulas, wanted, failed);
  if (out->reason != NULL) return TP_OK;
  const writing w = {out, &formulas, options->notation, failed};
  out->known = true;
  out->tan_critical_angle = write(&w, formulas.tangent);
  out->critical_angle_deg = tp_field_angle(formulas.tangent, formulas.terms.values,
                                           formulas.terms.field, formulas.terms.bits);
  write_rows(&w);
  write_conditions(&w);
  const tp_status status = options->checked && !*failed ? check(&w, wanted, message) : TP_OK;
  tp_onset_formulas_clear(&formulas);
  return status;
}

/* Why none is to be had at these values, or NULL. */
static const char *why_not(const tp_onset *onset) {
  if (onset->kind == TP_ONSET_UNDECIDED) return "it is undecided at these values";
  if (onset->kind == TP_ONSET_NOWHERE ||
      (onset->kind == TP_ONSET_AT_ANGLE &&
       onset->critical_angle_deg.value <= onset->critical_angle_deg.error)) {
    return "a motion can begin on level ground; formulas are derived for an onset above it";
  }
  return NULL;
}

tp_status tp_derive_onset(tp_derived_onset *out, const tp_derived_limit *limit,
                          const tp_model *model, const tp_case *own, long friction,
                          const tp_derive_options *options, bool *failed, tp_message *message) {
  const tp_onset *onset = &own->onset;
  out->kind = onset->kind;
  out->mechanism = onset->mechanism;
  out->below_limit = onset->below_limit;
  out->reason = why_not(onset);
  if (out->reason != NULL || onset->kind != TP_ONSET_AT_ANGLE) return TP_OK;
  const tp_onset_wanted wanted = {model, own->towards, friction, onset->critical_angle_deg,
                                  all_positive(model->problem.scene)};
  tp_field_work *work = model->symbols.field.work, held = *work;
  *work =
      (tp_field_work){.budget = held.budget}; /* of its own, so that the rest is derived anyhow */
  const tp_status status = derive(out, &wanted, options, failed, message);
  *work = held;
  out->same_as_limit =
      out->known && limit->known && limit->tan_critical_angle.formula != NULL &&
      out->tan_critical_angle.formula != NULL &&
      strcmp(limit->tan_critical_angle.formula, out->tan_critical_angle.formula) == 0;
  return status;
}
