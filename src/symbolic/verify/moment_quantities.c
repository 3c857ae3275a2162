/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Stabilising and overturning moments by elements, their areas and their factor in symbols
 * (Appendix A; docs/mechanics.md section 3). */

#include "verify/quantity_rules.h"

#include "derive/field_work.h"

#include <stdlib.h>

/* The elements in the order of their weights' numbers. */
typedef struct numbered {
  long index;
  bool slab;
  fmpq arm;
} numbered;

static int by_number(const void *a, const void *b) {
  const numbered *one = a, *other = b;
  if (one->slab != other->slab) return one->slab ? -1 : 1;
  const int order = fmpq_cmp(&other->arm, &one->arm);
  return order != 0 ? order : (one->index > other->index) - (one->index < other->index);
}

/* One element's share of the four sums, with `weight` in the place of its area; arms about the
 * axis where rounding puts it. */
static tp_status add_element(tp_side_formulas *sides, const tp_element_formulas *e,
                             const fmpz_mpoly_q_t weight, tp_subject *s, tp_message *message) {
  const tp_field *field = s->field;
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  fmpz_mpoly_q_t x, y;
  fmpz_mpoly_q_init(x, ring);
  fmpz_mpoly_q_init(y, ring);
  tp_field_mul(x, e->normal_arm, weight, field);
  tp_field_mul(y, e->parallel_arm, weight, field);
  const tp_status status = s->rounded ? tp_quantity_shift(x, y, weight, s, message) : TP_OK;
  if (!e->normal_stabilises) fmpz_mpoly_q_neg(x, x, ring);
  if (!e->parallel_overturns) fmpz_mpoly_q_neg(y, y, ring);
  fmpz_mpoly_q_struct *cosine = e->normal_stabilises ? sides->a : sides->c;
  fmpz_mpoly_q_struct *sine = e->parallel_overturns ? sides->d : sides->b;
  tp_field_add(cosine, cosine, x, field);
  tp_field_add(sine, sine, y, field);
  fmpz_mpoly_q_clear(x, ring);
  fmpz_mpoly_q_clear(y, ring);
  return status;
}

/* The order of the elements from the numbers of the scene; NULL when memory is exhausted. */
static numbered *number_elements(tp_subject *s, const tp_symbolic_point *pivot) {
  const tp_model *m = &s->model;
  const long count = m->problem.elements.count;
  numbered *order = calloc((size_t)count + 1, sizeof *order);
  if (order == NULL) return NULL;
  tp_element_formulas e;
  tp_element_formulas_init(&e, s->field);
  for (long k = 0; k < count; k++) {
    tp_element_formulas_set(&e, &m->symbols, &m->problem, k, pivot, s->towards);
    order[k].index = k;
    order[k].slab = m->problem.elements.items[k].kind == TP_ELEMENT_SLAB;
    fmpq_init(&order[k].arm);
    (void)tp_field_evaluate(&order[k].arm, e.normal_arm, s->field);
  }
  tp_element_formulas_clear(&e, s->field);
  qsort(order, (size_t)count, sizeof *order, by_number);
  return order;
}

static tp_status sum_elements(tp_side_formulas *sides, tp_subject *s, bool weights,
                              tp_message *message) {
  const tp_model *m = &s->model;
  tp_symbolic_point pivot;
  if (!s->has_model)
    return tp_subject_lacks(s, message, "sums over elements are for one number of teeth");
  tp_status status = tp_model_pivot(&pivot, m, s->pivot, message);
  if (status != TP_OK) return status;
  const long count = m->problem.elements.count;
  if (weights && count > s->weight_count) {
    return tp_subject_lacks(
        s, message,
        "elements are weighed one by one for teeth, slabs and plain outlines, at most 1000");
  }
  numbered *order = number_elements(s, &pivot);
  if (order == NULL) return tp_fail_memory(message, "the elements");
  tp_element_formulas e;
  fmpz_mpoly_q_t weight;
  tp_element_formulas_init(&e, s->field);
  fmpz_mpoly_q_init(weight, s->field->ring);
  for (long k = 0; k < count && status == TP_OK; k++) {
    tp_element_formulas_set(&e, &m->symbols, &m->problem, order[k].index, &pivot, s->towards);
    if (weights) {
      fmpz_mpoly_q_gen(weight, s->first_weight + k, s->field->ring);
    } else {
      fmpz_mpoly_q_set(weight, e.area, s->field->ring);
    }
    status = add_element(sides, &e, weight, s, message);
  }
  tp_element_formulas_clear(&e, s->field);
  fmpz_mpoly_q_clear(weight, s->field->ring);
  for (long k = 0; k < count; k++) fmpq_clear(&order[k].arm);
  free(order);
  return status;
}

/* cosine cos alpha + sine sin alpha */
static void add_components(fmpz_mpoly_q_t value, const fmpz_mpoly_q_t cosine,
                           const fmpz_mpoly_q_t sine, const tp_subject *s) {
  const tp_angle *alpha = s->angles + TP_ANGLE_ALPHA;
  fmpz_mpoly_q_t term;
  fmpz_mpoly_q_init(term, s->field->ring);
  fmpz_mpoly_q_gen(term, alpha->sine, s->field->ring);
  tp_field_mul(term, term, sine, s->field);
  fmpz_mpoly_q_gen(value, alpha->cosine, s->field->ring);
  tp_field_mul(value, value, cosine, s->field);
  tp_field_add(value, value, term, s->field);
  fmpz_mpoly_q_clear(term, s->field->ring);
}

/* value = what stabilises, run = what overturns. */
static tp_status set_moments(fmpz_mpoly_q_t value, fmpz_mpoly_q_t run, tp_subject *s, bool weights,
                             tp_message *message) {
  tp_side_formulas sides;
  tp_side_formulas_init(&sides, s->field);
  const tp_status status = sum_elements(&sides, s, weights, message);
  if (status == TP_OK) {
    add_components(value, sides.a, sides.b, s);
    add_components(run, sides.c, sides.d, s);
  }
  tp_side_formulas_clear(&sides, s->field);
  return status;
}

tp_status tp_quantity_stabilising(fmpz_mpoly_q_t value, fmpz_mpoly_q_t run, tp_subject *s,
                                  tp_message *message) {
  return set_moments(value, run, s, true, message);
}

tp_status tp_quantity_overturning(fmpz_mpoly_q_t value, fmpz_mpoly_q_t run, tp_subject *s,
                                  tp_message *message) {
  return set_moments(run, value, s, true, message);
}

tp_status tp_quantity_stabilising_area(fmpz_mpoly_q_t value, fmpz_mpoly_q_t run, tp_subject *s,
                                       tp_message *message) {
  return set_moments(value, run, s, false, message);
}

tp_status tp_quantity_overturning_area(fmpz_mpoly_q_t value, fmpz_mpoly_q_t run, tp_subject *s,
                                       tp_message *message) {
  return set_moments(run, value, s, false, message);
}

tp_status tp_quantity_fos_elements(fmpz_mpoly_q_t value, fmpz_mpoly_q_t run, tp_subject *s,
                                   tp_message *message) {
  const tp_status status = set_moments(value, run, s, false, message);
  if (status != TP_OK) return status;
  if (fmpz_mpoly_q_is_zero(run, s->field->ring)) {
    return tp_subject_lacks(s, message,
                            "nothing overturns about this pivot, so it has no factor of safety");
  }
  tp_field_div(value, value, run, s->field);
  return TP_OK;
}

bool tp_quantity_example_weights(tp_subject *s) {
  tp_symbolic_point pivot;
  const tp_model *m = &s->model;
  const long count = m->problem.elements.count;
  if (count > s->weight_count || tp_model_pivot(&pivot, m, s->pivot, NULL) != TP_OK) return true;
  numbered *order = number_elements(s, &pivot);
  if (order == NULL) return false;
  tp_element_formulas e;
  tp_element_formulas_init(&e, s->field);
  for (long k = 0; k < count; k++) {
    tp_element_formulas_set(&e, &m->symbols, &m->problem, order[k].index, &pivot, s->towards);
    (void)tp_field_evaluate(s->values + s->first_weight + k, e.area, s->field);
    fmpq_clear(&order[k].arm);
  }
  tp_element_formulas_clear(&e, s->field);
  free(order);
  return true;
}
