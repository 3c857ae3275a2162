/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The closed formulas of a scene. */

#include "derive/formulas.h"
#include "derive/notation.h"
#include "number/ball.h"
#include "stability/solve.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_VERTICES = 20000 };

tp_derive_options tp_derive_options_default(void) {
  return (tp_derive_options){.notation = TP_NOTATION_TEXT, .elements = false};
}

static void free_pivot(tp_derived_pivot *p) {
  tp_fraction *fractions[] = {&p->x,
                              &p->y,
                              &p->tangent,
                              &p->fos_cot,
                              &p->fos_constant,
                              &p->normal_stabilising,
                              &p->parallel_stabilising,
                              &p->normal_overturning,
                              &p->parallel_overturning};
  for (size_t k = 0; k < sizeof fractions / sizeof fractions[0]; k++)
    tp_notation_free(fractions[k]);
}

void tp_derivation_free(tp_derivation *derivation) {
  if (derivation == NULL) return;
  free(derivation->title);
  tp_notation_free(&derivation->area);
  tp_notation_free(&derivation->x_moment);
  tp_notation_free(&derivation->y_moment);
  for (size_t k = 0; k < derivation->symbol_count; k++) free(derivation->symbols[k]);
  free(derivation->symbols);
  for (size_t k = 0; k < derivation->pivot_count; k++) free_pivot(derivation->pivots + k);
  free(derivation->pivots);
  for (int d = 0; d < 2; d++) {
    for (size_t k = 0; derivation->elements[d] != NULL && k < derivation->element_count; k++) {
      tp_notation_free(&derivation->elements[d][k].area);
      tp_notation_free(&derivation->elements[d][k].normal_arm);
      tp_notation_free(&derivation->elements[d][k].parallel_arm);
    }
    free(derivation->elements[d]);
  }
  free(derivation);
}

/* What a derivation takes. */
typedef struct work {
  tp_derivation *out;
  const tp_solution *solution;
  tp_problem problem;
  tp_symbols symbols;
  tp_formulas formulas;
  tp_message *message;
  bool failed; /* memory was exhausted while writing */
} work;

static tp_fraction write(work *w, const fmpz_mpoly_q_t formula) {
  return tp_notation_write(formula, &w->symbols.field, w->out->notation, &w->failed);
}

/* formula / divisor, written. */
static tp_fraction write_over(work *w, const fmpz_mpoly_q_t formula, long divisor) {
  const fmpz_mpoly_ctx_struct *ring = w->symbols.field.ring;
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
  return tp_notation_write_quotient(top, below, &w->symbols.field, w->out->notation, &w->failed);
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
  tp_bounded result = {0, INFINITY};
  if (tp_field_evaluate(x, x_arm, &w->symbols.field) &&
      tp_field_evaluate(y, y_arm, &w->symbols.field)) {
    arb_set_fmpq(sine, x, 128);
    arb_set_fmpq(cosine, y, 128);
    tp_ball_atan2_degrees(angle, sine, cosine, 128);
    result = tp_ball_bounded(angle);
  }
  fmpq_clear(x);
  fmpq_clear(y);
  arb_clear(sine);
  arb_clear(cosine);
  arb_clear(angle);
  return result;
}

static tp_status derive_elements_form(work *w, tp_derived_pivot *p, long point) {
  const tp_field *field = &w->symbols.field;
  tp_side_formulas sides;
  tp_side_formulas_init(&sides, field);
  const bool whole =
      tp_side_formulas_sum(&sides, &w->formulas, &w->symbols, &w->problem, point, p->towards);
  tp_status status = TP_OK;
  if (whole) {
    p->has_elements = true;
    p->splits =
        fmpz_mpoly_q_is_zero(sides.c, field->ring) && !fmpz_mpoly_q_is_zero(sides.d, field->ring);
    p->normal_stabilising = write(w, sides.a);
    p->parallel_stabilising = write(w, sides.b);
    p->normal_overturning = write(w, sides.c);
    p->parallel_overturning = write(w, sides.d);
    if (p->splits) {
      p->fos_cot = write_quotient(w, sides.a, sides.d);
      p->fos_constant = write_quotient(w, sides.b, sides.d);
    }
  } else {
    status = tp_fail(w->message, TP_NO_ANSWER, w->problem.scene->block.place,
                     "the triangles of this block hold only at these values of the parameters: "
                     "corners of different rings meet by chance; derive without --elements");
  }
  tp_side_formulas_clear(&sides, field);
  return status;
}

static tp_status derive_pivot(work *w, tp_derived_pivot *p, const tp_case *own, size_t k,
                              bool elements) {
  const fmpz_mpoly_ctx_struct *ring = w->symbols.field.ring;
  const long point = w->problem.contact.points[k].point;
  const fmpz_mpoly_q_struct *px = tp_formulas_x(&w->symbols, &w->problem, point);
  const fmpz_mpoly_q_struct *py = tp_formulas_y(&w->symbols, &w->problem, point);
  if (px == NULL || py == NULL) {
    return tp_fail(w->message, TP_NO_ANSWER, w->problem.scene->base.place,
                   "a pivot lies on the base past the block, where the base has no formula; give "
                   "the base as a profile");
  }
  p->towards = own->towards;
  p->kind = own->pivots[k].kind;
  p->admissible = own->pivots[k].admissible;
  p->governs = own->has_governing && own->governing == k;
  p->x = write(w, px);
  p->y = write(w, py);
  fmpz_mpoly_q_t x_arm, y_arm;
  fmpz_mpoly_q_init(x_arm, ring);
  fmpz_mpoly_q_init(y_arm, ring);
  tp_formulas_arm(x_arm, w->formulas.x6, w->formulas.weighted2, px, &w->symbols.field);
  tp_formulas_arm(y_arm, w->formulas.y6, w->formulas.weighted2, py, &w->symbols.field);
  if (p->towards == TP_TOWARDS_RIGHT) fmpz_mpoly_q_neg(x_arm, x_arm, ring);
  p->tangent = write_quotient(w, x_arm, y_arm);
  p->critical_angle_deg = angle_at_values(w, x_arm, y_arm);
  fmpz_mpoly_q_clear(x_arm, ring);
  fmpz_mpoly_q_clear(y_arm, ring);
  return elements ? derive_elements_form(w, p, point) : TP_OK;
}

static tp_status list_elements(work *w, const tp_case *own) {
  const tp_elements *all = &w->problem.elements;
  tp_derived_element *list = calloc((size_t)all->count + 1, sizeof *list);
  if (list == NULL) return tp_fail_memory(w->message, "the elements");
  w->out->elements[own->towards] = list;
  w->out->element_count = (size_t)all->count;
  const long pivot = w->problem.contact.points[own->governing].point;
  tp_element_formulas e;
  tp_element_formulas_init(&e, &w->symbols.field);
  for (long k = 0; k < all->count; k++) {
    tp_element_formulas_set(&e, &w->symbols, &w->problem, k, pivot, own->towards);
    list[k] = (tp_derived_element){.kind = all->items[k].kind,
                                   .part = all->items[k].part,
                                   .area = write(w, e.area),
                                   .normal_arm = write(w, e.normal_arm),
                                   .parallel_arm = write(w, e.parallel_arm),
                                   .normal_stabilises = e.normal_stabilises,
                                   .parallel_overturns = e.parallel_overturns};
  }
  tp_element_formulas_clear(&e, &w->symbols.field);
  return TP_OK;
}

static tp_status derive_pivots(work *w, bool elements) {
  const tp_solution *solution = w->solution;
  const size_t points = (size_t)w->problem.contact.point_count;
  w->out->pivots = calloc(points * solution->case_count + 1, sizeof *w->out->pivots);
  if (w->out->pivots == NULL) return tp_fail_memory(w->message, "the pivots");
  tp_status status = TP_OK;
  for (size_t c = 0; c < solution->case_count && status == TP_OK; c++) {
    for (size_t k = 0; k < points && status == TP_OK; k++) {
      status =
          derive_pivot(w, w->out->pivots + w->out->pivot_count++, solution->cases + c, k, elements);
    }
    if (status == TP_OK && elements && solution->cases[c].has_governing) {
      status = list_elements(w, solution->cases + c);
    }
  }
  return status;
}

static tp_status fill(work *w, const tp_scene *scene, const tp_derive_options *options) {
  tp_status status = tp_symbols_init(&w->symbols, scene, &w->problem.section, w->message);
  if (status != TP_OK) return status;
  tp_formulas_init(&w->formulas, &w->symbols.field);
  tp_formulas_sum(&w->formulas, &w->symbols, &w->problem.section);
  w->out->area = write_over(w, w->formulas.area2, 2);
  w->out->x_moment = write_over(w, w->formulas.x6, 6);
  w->out->y_moment = write_over(w, w->formulas.y6, 6);
  w->out->symbol_count = tp_field_list_symbols(&w->out->symbols, &w->symbols.field);
  if (w->out->symbols == NULL) status = tp_fail_memory(w->message, "the symbols");
  if (status == TP_OK) status = derive_pivots(w, options->elements);
  if (status == TP_OK && w->failed) status = tp_fail_memory(w->message, "the formulas");
  tp_formulas_clear(&w->formulas, &w->symbols.field);
  tp_symbols_clear(&w->symbols);
  return status;
}

static tp_status derive(tp_derivation *out, tp_solution *solution, const tp_scene *scene,
                        const tp_derive_options *options, tp_message *message) {
  work w = {.out = out, .solution = solution, .message = message};
  tp_solve_options solve = tp_solve_options_default();
  solve.elements = options->elements;
  tp_status status = tp_problem_init(&w.problem, scene, &solve, solution, message);
  if (status != TP_OK) return status;
  solve.elements = false; /* needs no account in numbers */
  status = tp_solve_problem(solution, &w.problem, &solve, message);
  if (status == TP_OK && w.problem.lattice.start[w.problem.section.ring_count] > MOST_VERTICES) {
    status = tp_fail(message, TP_NO_ANSWER, scene->block.place,
                     "more than %d vertices; formulas are derived for fewer", MOST_VERTICES);
  }
  if (status == TP_OK && scene->title != NULL) {
    out->title = strdup(scene->title);
    if (out->title == NULL) status = tp_fail_memory(message, "the derivation");
  }
  if (status == TP_OK) status = fill(&w, scene, options);
  tp_problem_clear(&w.problem);
  return status;
}

tp_status tp_derive(tp_derivation **derivation, const tp_scene *scene,
                    const tp_derive_options *options, tp_message *message) {
  tp_solution *solution = calloc(1, sizeof *solution);
  tp_derivation *out = calloc(1, sizeof *out);
  tp_status status = TP_OK;
  if (solution == NULL || out == NULL) {
    status = tp_fail_memory(message, "the derivation");
  } else {
    out->notation = options->notation;
    status = derive(out, solution, scene, options, message);
  }
  tp_solution_free(solution);
  if (status == TP_OK) {
    *derivation = out;
  } else {
    tp_derivation_free(out);
  }
  return status;
}
