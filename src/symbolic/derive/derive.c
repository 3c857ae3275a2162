/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Public call that derives the closed formulas of a scene: tan(alpha_crit) of each pivot, the
 * elements form, rounding, limit and onset, written in the notation asked for (docs/mechanics.md
 * section 9). */

#include "common/host.h"
#include "common/notes.h"
#include "common/options.h"
#include "derive/c_names.h"
#include "derive/derive_limit.h"
#include "derive/derive_onset.h"
#include "derive/derive_rounding.h"
#include "derive/field_work.h"
#include "derive/notation.h"
#include "number/ball.h"

#include <stdlib.h>
#include <string.h>

TP_OPTIONS_END(tp_derive_options, checked);

void tp_derive_options_init(tp_derive_options *options, size_t size) {
  const tp_derive_options defaults = {
      .size = sizeof defaults, .notation = TP_NOTATION_TEXT, .checked = true};
  tp_options_fill(options, size, &defaults);
}

/* Symbols besides the scene's: those of rounded corners first, then that of the limit. */
enum { MOST_ADDED = 8 };

/* Of an angle at the scene's values, which is given as a double: cancellation may take half. */
enum { ANGLE_BITS = 128 };

static tp_symbol_names added_symbols(const char *names[MOST_ADDED],
                                     const tp_derive_options *options) {
  long count = 0;
  for (long k = 0; options->rounded && k < tp_derive_rounding_symbols.count; k++) {
    names[count++] = tp_derive_rounding_symbols.names[k];
  }
  if (options->limit) names[count++] = TP_DERIVE_LIMIT_SYMBOL;
  return (tp_symbol_names){count, names};
}

/* What a derivation takes. */
typedef struct work {
  tp_derivation *out;
  tp_model model;
  tp_message *message;
  bool failed; /* memory was exhausted while writing */
} work;

static tp_fraction write(work *w, const fmpz_mpoly_q_t formula) {
  return tp_notation_write(formula, &w->model.symbols.field, w->out->notation, &w->failed);
}

/* formula / divisor, written. */
static tp_fraction write_over(work *w, const fmpz_mpoly_q_t formula, long divisor) {
  const fmpz_mpoly_ctx_struct *ring = w->model.symbols.field.ring;
  fmpz_mpoly_q_t value;
  fmpz_t integer;
  fmpz_mpoly_q_init(value, ring);
  fmpz_init_set_si(integer, divisor);
  fmpz_mpoly_q_div_fmpz(value, formula, integer, ring);
  const tp_fraction f = write(w, value);
  fmpz_mpoly_q_clear(value, ring);
  fmpz_clear(integer);
  return f;
}

static tp_fraction write_quotient(work *w, const fmpz_mpoly_q_t top, const fmpz_mpoly_q_t below) {
  return tp_notation_write_quotient(top, below, &w->model.symbols.field, w->out->notation,
                                    &w->failed);
}

/* atan2 of the arms at the scene's values. */
static tp_bounded angle_at_values(const work *w, const fmpz_mpoly_q_t x_arm,
                                  const fmpz_mpoly_q_t y_arm) {
  fmpq_t x, y;
  arb_t sine, cosine, angle;
  fmpq_init(x);
  fmpq_init(y);
  arb_init(sine);
  arb_init(cosine);
  arb_init(angle);
  tp_bounded result = {.error = INFINITY};
  if (tp_field_evaluate(x, x_arm, &w->model.symbols.field) &&
      tp_field_evaluate(y, y_arm, &w->model.symbols.field)) {
    arb_set_fmpq(sine, x, ANGLE_BITS);
    arb_set_fmpq(cosine, y, ANGLE_BITS);
    tp_ball_atan2_degrees(angle, sine, cosine, ANGLE_BITS);
    result = tp_ball_bounded(angle);
  }
  fmpq_clear(x);
  fmpq_clear(y);
  arb_clear(sine);
  arb_clear(cosine);
  arb_clear(angle);
  return result;
}

static tp_status derive_elements_form(work *w, tp_derived_pivot *p,
                                      const tp_symbolic_point *point) {
  const tp_model *m = &w->model;
  const tp_field *field = &m->symbols.field;
  tp_side_formulas sides;
  tp_side_formulas_init(&sides, field);
  tp_status status = TP_OK;
  if (tp_side_formulas_sum(&sides, &m->formulas, &m->symbols, &m->problem, point, p->towards)) {
    p->has_elements = true;
    p->splits =
        fmpz_mpoly_q_is_zero(sides.c, field->ring) && !fmpz_mpoly_q_is_zero(sides.d, field->ring);
    p->stabilising_cos = write(w, sides.a);
    p->stabilising_sin = write(w, sides.b);
    p->overturning_cos = write(w, sides.c);
    p->overturning_sin = write(w, sides.d);
    if (p->splits) {
      p->fos_cot = write_quotient(w, sides.a, sides.d);
      p->fos_constant = write_quotient(w, sides.b, sides.d);
    }
  } else if (tp_field_problem(field) == NULL) {
    status = tp_fail(w->message, TP_NO_ANSWER, m->problem.scene->block.place,
                     "the triangles of this block hold only at these values of the parameters: "
                     "corners of different rings meet by chance; derive without --elements");
  }
  tp_side_formulas_clear(&sides, field);
  return status;
}

static tp_status derive_pivot(work *w, tp_derived_pivot *p, const tp_case *own, size_t k,
                              bool elements) {
  const fmpz_mpoly_ctx_struct *ring = w->model.symbols.field.ring;
  tp_symbolic_point point;
  const tp_status status = tp_model_pivot(&point, &w->model, k, w->message);
  if (status != TP_OK) return status;
  p->towards = own->towards;
  p->kind = own->pivots[k].kind;
  p->admissible = own->pivots[k].admissible;
  p->governs = own->has_toppling_pivot && own->toppling_pivot == k;
  p->x = write(w, point.x);
  p->y = write(w, point.y);
  fmpz_mpoly_q_t x_arm, y_arm;
  fmpz_mpoly_q_init(x_arm, ring);
  fmpz_mpoly_q_init(y_arm, ring);
  tp_model_arms(x_arm, y_arm, &w->model, &point, p->towards);
  p->tan_critical_angle = write_quotient(w, x_arm, y_arm);
  p->critical_angle_deg = angle_at_values(w, x_arm, y_arm);
  fmpz_mpoly_q_clear(x_arm, ring);
  fmpz_mpoly_q_clear(y_arm, ring);
  return elements ? derive_elements_form(w, p, &point) : TP_OK;
}

static tp_status list_elements(work *w, const tp_case *own) {
  const tp_model *m = &w->model;
  const tp_elements *all = &m->problem.elements;
  tp_symbolic_point pivot;
  const tp_status status = tp_model_pivot(&pivot, m, own->toppling_pivot, w->message);
  if (status != TP_OK) return status;
  tp_derived_element *list = calloc((size_t)all->count + 1, sizeof *list);
  if (list == NULL) return tp_fail_memory(w->message, "the elements");
  w->out->elements[own->towards] = list;
  w->out->element_count = (size_t)all->count;
  tp_element_formulas e;
  tp_element_formulas_init(&e, &m->symbols.field);
  for (long k = 0; k < all->count; k++) {
    tp_element_formulas_set(&e, &m->symbols, &m->problem, k, &pivot, own->towards);
    list[k] = (tp_derived_element){.kind = all->items[k].kind,
                                   .part = all->items[k].part,
                                   .area = write(w, e.area),
                                   .normal_arm = write(w, e.normal_arm),
                                   .parallel_arm = write(w, e.parallel_arm),
                                   .normal_stabilises = e.normal_stabilises,
                                   .parallel_overturns = e.parallel_overturns};
  }
  tp_element_formulas_clear(&e, &m->symbols.field);
  return TP_OK;
}

static tp_status derive_limit(work *w, const tp_case *own, const tp_derive_options *options) {
  const tp_field *field = &w->model.symbols.field;
  const long before = options->rounded ? tp_derive_rounding_symbols.count : 0;
  const long friction = tp_field_added(field, before);
  tp_derived_limit *limit = w->out->limit + own->towards;
  const tp_status status =
      tp_derive_limit(limit, &w->model, own, friction, options, &w->failed, w->message);
  if (status != TP_OK) return status;
  return tp_derive_onset(w->out->onset + own->towards, limit, &w->model, own, friction, options,
                         &w->failed, w->message);
}

static tp_status derive_case(work *w, const tp_case *own, const tp_derive_options *options) {
  const size_t points = (size_t)w->model.problem.contact.point_count;
  tp_status status = options->limit ? derive_limit(w, own, options) : TP_OK;
  for (size_t k = 0; k < points && status == TP_OK; k++) {
    status = derive_pivot(w, w->out->pivots + w->out->pivot_count++, own, k, options->elements);
  }
  if (!own->has_toppling_pivot) return status;
  if (status == TP_OK && options->elements) status = list_elements(w, own);
  if (status == TP_OK && options->rounded) {
    status = tp_derive_rounding(w->out->rounded + own->towards, &w->model, own, options->notation,
                                &w->failed, w->message);
  }
  return status;
}

static tp_status derive_pivots(work *w, const tp_derive_options *options) {
  const tp_solution *solution = w->model.solution;
  const size_t points = (size_t)w->model.problem.contact.point_count;
  w->out->pivots = calloc(points * solution->case_count + 1, sizeof *w->out->pivots);
  if (w->out->pivots == NULL) return tp_fail_memory(w->message, "the pivots");
  tp_status status = TP_OK;
  for (size_t c = 0; c < solution->case_count && status == TP_OK; c++) {
    status = derive_case(w, solution->cases + c, options);
  }
  return status;
}

static tp_status fill(work *w, const tp_derive_options *options) {
  tp_derivation *out = w->out;
  const tp_formulas *f = &w->model.formulas;
  const char *title = w->model.problem.scene->title;
  if (options->notation == TP_NOTATION_C && !tp_c_names_set(&w->model.symbols.field)) {
    return tp_fail_memory(w->message, "the names in C");
  }
  out->area = write_over(w, f->area2, 2);
  out->x_moment = write_over(w, f->x6, 6);
  out->y_moment = write_over(w, f->y6, 6);
  if (!tp_field_list_symbols(&out->symbol_count, &out->symbols, &out->parameters,
                             &w->model.symbols.field)) {
    w->failed = true;
  }
  if (title != NULL) out->title = strdup(title);
  if (title != NULL && out->title == NULL) w->failed = true;
  tp_status status = tp_notes_append(&out->notes, &w->model.solution->notes, w->message);
  if (status == TP_OK) status = derive_pivots(w, options);
  if (status == TP_OK) {
    status =
        tp_field_check(&w->model.symbols.field, w->model.problem.scene->block.place, w->message);
  }
  return status == TP_OK && w->failed ? tp_fail_memory(w->message, "the formulas") : status;
}

tp_status tp_derive(tp_derivation **derivation, const tp_scene *scene,
                    const tp_derive_options *options, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, derivation);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, options);
  tp_derive_options own = tp_derive_options_default();
  TP_TAKE_OPTIONS(message, own, options);
  if ((int)options->notation < TP_NOTATION_TEXT || (int)options->notation > TP_NOTATION_C) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){0}, "there is no such notation");
  }
  if (options->rounded) {
    const tp_status status = tp_derive_rounding_check(scene, message);
    if (status != TP_OK) return status;
  }
  if (options->limit) {
    const tp_status status = tp_derive_limit_check(scene, message);
    if (status != TP_OK) return status;
  }
  tp_derivation *out = calloc(1, sizeof *out);
  if (out == NULL) return tp_fail_memory(message, "the derivation");
  out->size = sizeof *out;
  out->notation = options->notation;
  work w = {.out = out, .message = message};
  const char *names[MOST_ADDED];
  const tp_symbol_names added = added_symbols(names, options);
  tp_status status = tp_model_init(&w.model, scene, options->elements, &added, message);
  if (status == TP_OK) {
    status = fill(&w, options);
    tp_model_clear(&w.model);
  }
  if (status == TP_OK) {
    *derivation = out;
  } else {
    tp_derivation_free(out);
  }
  return status;
}
