/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Facet up-dip of the pivot as symbolic sine and cosine, the shift of the axis along it, and the
 * critical length (Appendix B). */

#include "derive/rounding.h"

#include "derive/field_work.h"

#include <string.h>

static int compare(const fmpz *values, long a, long b) {
  return fmpz_cmp(values + a, values + b);
}

/* Is one of the outline's edges at the point normal to the mean plane? */
static bool has_upright_side(const tp_problem *problem, long point) {
  const tp_lattice *lattice = &problem->lattice;
  const long first = lattice->start[0], count = lattice->start[1] - first;
  for (long k = 0; k < count; k++) {
    if (!tp_lattice_same_point(lattice, first + k, point)) continue;
    const long before = first + (k + count - 1) % count, after = first + (k + 1) % count;
    return compare(lattice->x, before, point) == 0 || compare(lattice->x, after, point) == 0;
  }
  return false;
}

static void set_symbol(fmpz_mpoly_q_t value, long symbol, const tp_field *field) {
  fmpz_mpoly_q_gen(value, symbol, field->ring);
}

/* The facet from its end at the pivot to the other one. */
static bool set_facet(tp_rounding *r, const tp_model *model, long from, long to,
                      tp_direction towards) {
  const tp_lattice *lattice = &model->problem.lattice;
  const tp_field *field = &model->symbols.field;
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  tp_symbolic_point p, q;
  if (!tp_formulas_point(&p, &model->symbols, &model->problem, from) ||
      !tp_formulas_point(&q, &model->symbols, &model->problem, to)) {
    return false;
  }
  r->slope = compare(lattice->y, to, from);
  r->slope = (r->slope > 0) - (r->slope < 0);
  tp_field_sub(r->rise, q.y, p.y, field);
  tp_field_sub(r->run, q.x, p.x, field);
  if (r->slope < 0) fmpz_mpoly_q_neg(r->rise, r->rise, ring);
  tp_symbol_mirror(r->run, towards, field);
  return true;
}

tp_status tp_rounding_init(tp_rounding *r, const tp_model *model, size_t k, tp_direction towards,
                           const tp_rounding_symbols *symbols, tp_message *message) {
  const tp_field *field = &model->symbols.field;
  const tp_contact *contact = &model->problem.contact;
  const tp_contact_point *pivot = contact->points + k;
  memset(r, 0, sizeof *r);
  fmpz_mpoly_q_init(r->length, field->ring);
  fmpz_mpoly_q_init(r->sine, field->ring);
  fmpz_mpoly_q_init(r->cosine, field->ring);
  fmpz_mpoly_q_init(r->rise, field->ring);
  fmpz_mpoly_q_init(r->run, field->ring);
  const bool left = towards == TP_TOWARDS_LEFT;
  const long own = left ? pivot->right : pivot->left;
  const tp_facet *facet = own >= 0 ? contact->facets + own : NULL;
  if (facet == NULL ||
      !set_facet(r, model, left ? facet->t0 : facet->t1, left ? facet->t1 : facet->t0, towards)) {
    tp_rounding_clear(r, field);
    return tp_fail(
        message, TP_NO_ANSWER, model->problem.scene->block.place,
        "the pivot has no facet of the base up-dip of it along which rounding could move "
        "the axis");
  }
  set_symbol(r->length, symbols->length, field);
  if (r->slope == 0) {
    fmpz_mpoly_q_one(r->cosine, field->ring);
  } else {
    set_symbol(r->sine, symbols->sine, field);
    set_symbol(r->cosine, symbols->cosine, field);
  }
  r->upright_side = has_upright_side(&model->problem, pivot->point);
  return TP_OK;
}

void tp_rounding_clear(tp_rounding *r, const tp_field *field) {
  fmpz_mpoly_q_clear(r->length, field->ring);
  fmpz_mpoly_q_clear(r->sine, field->ring);
  fmpz_mpoly_q_clear(r->cosine, field->ring);
  fmpz_mpoly_q_clear(r->rise, field->ring);
  fmpz_mpoly_q_clear(r->run, field->ring);
}

void tp_rounding_shift(fmpz_mpoly_q_t along, fmpz_mpoly_q_t up, const tp_rounding *r,
                       const tp_field *field) {
  tp_field_mul(along, r->length, r->cosine, field);
  tp_field_mul(up, r->length, r->sine, field);
  if (r->slope < 0) fmpz_mpoly_q_neg(up, up, field->ring);
}

void tp_rounding_critical_length(fmpz_mpoly_q_t value, const tp_rounding *r, const fmpz_mpoly_q_t x,
                                 const fmpz_mpoly_q_t y, const fmpz_mpoly_q_t sine,
                                 const fmpz_mpoly_q_t cosine, const tp_field *field) {
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  fmpz_mpoly_q_t below, term;
  fmpz_mpoly_q_init(below, ring);
  fmpz_mpoly_q_init(term, ring);
  tp_field_mul(below, r->cosine, cosine, field);
  tp_field_mul(term, r->sine, sine, field);
  if (r->slope < 0) {
    tp_field_add(below, below, term, field);
  } else {
    tp_field_sub(below, below, term, field);
  }
  tp_field_mul(value, x, cosine, field);
  tp_field_mul(term, y, sine, field);
  tp_field_sub(value, value, term, field);
  tp_field_div(value, value, below, field);
  fmpz_mpoly_q_clear(below, ring);
  fmpz_mpoly_q_clear(term, ring);
}

/* tan(45 - slope i / 2) = (1 - slope sin i) / cos i. */
void tp_rounding_radius(fmpz_mpoly_q_t radius, const tp_rounding *r, const fmpz_mpoly_q_t length,
                        const tp_field *field) {
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  fmpz_mpoly_q_t factor;
  fmpz_mpoly_q_init(factor, ring);
  fmpz_mpoly_q_one(factor, ring);
  if (r->slope < 0) {
    tp_field_add(factor, factor, r->sine, field);
  } else {
    tp_field_sub(factor, factor, r->sine, field);
  }
  tp_field_div(factor, factor, r->cosine, field);
  tp_field_mul(radius, length, factor, field);
  fmpz_mpoly_q_clear(factor, ring);
}
