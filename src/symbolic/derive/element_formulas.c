/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Area, centroid and moments of each element in symbols, and the sums of either side of the
 * elements form (Appendix A; docs/mechanics.md section 3). */

#include "derive/formulas.h"

#include "derive/field_work.h"

void tp_element_formulas_init(tp_element_formulas *e, const tp_field *field) {
  fmpz_mpoly_q_init(e->area, field->ring);
  fmpz_mpoly_q_init(e->normal_arm, field->ring);
  fmpz_mpoly_q_init(e->parallel_arm, field->ring);
}

void tp_element_formulas_clear(tp_element_formulas *e, const tp_field *field) {
  fmpz_mpoly_q_clear(e->area, field->ring);
  fmpz_mpoly_q_clear(e->normal_arm, field->ring);
  fmpz_mpoly_q_clear(e->parallel_arm, field->ring);
}

void tp_side_formulas_init(tp_side_formulas *s, const tp_field *field) {
  fmpz_mpoly_q_init(s->a, field->ring);
  fmpz_mpoly_q_init(s->b, field->ring);
  fmpz_mpoly_q_init(s->c, field->ring);
  fmpz_mpoly_q_init(s->d, field->ring);
}

void tp_side_formulas_clear(tp_side_formulas *s, const tp_field *field) {
  fmpz_mpoly_q_clear(s->a, field->ring);
  fmpz_mpoly_q_clear(s->b, field->ring);
  fmpz_mpoly_q_clear(s->c, field->ring);
  fmpz_mpoly_q_clear(s->d, field->ring);
}

static void divide(fmpz_mpoly_q_t value, long by, const fmpz_mpoly_ctx_t ring) {
  fmpz_t divisor;
  fmpz_init_set_si(divisor, by);
  fmpz_mpoly_q_div_fmpz(value, value, divisor, ring);
  fmpz_clear(divisor);
}

static bool is_negative(const fmpz_mpoly_q_t formula, const tp_field *field) {
  fmpq_t value;
  fmpq_init(value);
  const bool negative = tp_field_evaluate(value, formula, field) && fmpq_sgn(value) < 0;
  fmpq_clear(value);
  return negative;
}

/* Area and centroid of an element: of a slab (x1 - x0) (y1 - y0) and the middle; of a triangle half
 * the determinant and the mean of the corners. */
static void set_shape(tp_element_formulas *e, const tp_exact_element *exact,
                      const tp_symbols *symbols, const tp_problem *problem) {
  const tp_field *field = &symbols->field;
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  const bool slab = exact->kind == TP_ELEMENT_SLAB;
  tp_symbolic_point p[3] = {{0}};
  for (int k = 0; k < (slab ? 2 : 3); k++) {
    (void)tp_formulas_point(p + k, symbols, problem, exact->corner[k]); /* all are the block's */
  }
  tp_field_add(e->normal_arm, p[0].x, p[1].x, field);
  tp_field_add(e->parallel_arm, p[0].y, p[1].y, field);
  fmpz_mpoly_q_t dx, dy;
  fmpz_mpoly_q_init(dx, ring);
  fmpz_mpoly_q_init(dy, ring);
  tp_field_sub(dx, p[1].x, p[0].x, field);
  tp_field_sub(dy, slab ? p[1].y : p[2].y, p[0].y, field);
  tp_field_mul(e->area, dx, dy, field);
  if (!slab) {
    tp_field_add(e->normal_arm, e->normal_arm, p[2].x, field);
    tp_field_add(e->parallel_arm, e->parallel_arm, p[2].y, field);
    tp_field_sub(dx, p[2].x, p[0].x, field);
    tp_field_sub(dy, p[1].y, p[0].y, field);
    tp_field_mul(dx, dx, dy, field);
    tp_field_sub(e->area, e->area, dx, field);
    divide(e->area, 2, ring);
  }
  divide(e->normal_arm, slab ? 2 : 3, ring);
  divide(e->parallel_arm, slab ? 2 : 3, ring);
  if (is_negative(e->area, &symbols->field)) fmpz_mpoly_q_neg(e->area, e->area, ring);
  fmpz_mpoly_q_clear(dx, ring);
  fmpz_mpoly_q_clear(dy, ring);
}

void tp_element_formulas_set(tp_element_formulas *e, const tp_symbols *symbols,
                             const tp_problem *problem, long index, const tp_symbolic_point *pivot,
                             tp_direction towards) {
  const tp_field *field = &symbols->field;
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  const tp_exact_element *exact = problem->elements.items + index;
  set_shape(e, exact, symbols, problem);
  fmpq_t density;
  fmpq_init(density);
  fmpq_set_fmpz(density, problem->section.density_weights + exact->part);
  fmpq_div_fmpz(density, density, problem->section.density_weights);
  fmpz_mpoly_q_mul_fmpq(e->area, e->area, density, ring);
  fmpq_clear(density);
  tp_field_sub(e->normal_arm, e->normal_arm, pivot->x, field);
  tp_field_sub(e->parallel_arm, e->parallel_arm, pivot->y, field);
  tp_symbol_mirror(e->normal_arm, towards, field);
  e->normal_stabilises = !is_negative(e->normal_arm, &symbols->field);
  e->parallel_overturns = !is_negative(e->parallel_arm, &symbols->field);
}

/* One element's two moments onto their sides, each taken positive. */
static void add_sides(tp_side_formulas *s, const tp_element_formulas *e, fmpz_mpoly_q_t scratch,
                      const tp_field *field) {
  tp_field_mul(scratch, e->area, e->normal_arm, field);
  if (e->normal_stabilises) {
    tp_field_add(s->a, s->a, scratch, field);
  } else {
    tp_field_sub(s->c, s->c, scratch, field);
  }
  tp_field_mul(scratch, e->area, e->parallel_arm, field);
  if (e->parallel_overturns) {
    tp_field_add(s->d, s->d, scratch, field);
  } else {
    tp_field_sub(s->b, s->b, scratch, field);
  }
}

bool tp_side_formulas_sum(tp_side_formulas *s, const tp_formulas *formulas,
                          const tp_symbols *symbols, const tp_problem *problem,
                          const tp_symbolic_point *pivot, tp_direction towards) {
  const tp_field *field = &symbols->field;
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  tp_element_formulas element;
  fmpz_mpoly_q_t scratch, area;
  tp_element_formulas_init(&element, &symbols->field);
  fmpz_mpoly_q_init(scratch, ring);
  fmpz_mpoly_q_init(area, ring);
  for (long k = 0; k < problem->elements.count; k++) {
    tp_element_formulas_set(&element, symbols, problem, k, pivot, towards);
    tp_field_add(area, area, element.area, field);
    add_sides(s, &element, scratch, field);
  }
  tp_field_add(area, area, area, field);
  const bool whole = fmpz_mpoly_q_equal(area, formulas->weighted2, ring) != 0;
  tp_element_formulas_clear(&element, &symbols->field);
  fmpz_mpoly_q_clear(scratch, ring);
  fmpz_mpoly_q_clear(area, ring);
  return whole;
}
