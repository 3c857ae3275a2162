/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Quantities of the contact of a block with its base. For all numbers of teeth they are those of
 * one tooth: c / a its slope, c its amplitude, N a the width. */

#include "verify/quantity_rules.h"

#include "derive/field_work.h"

/* a, c and N a of a toothed block for all N. */
static tp_status read_teeth(fmpz_mpoly_q_t width, fmpz_mpoly_q_t a, fmpz_mpoly_q_t c,
                            const tp_subject *s, tp_message *message) {
  tp_teeth_formulas f;
  tp_teeth_formulas_init(&f, s->field);
  const tp_status status = tp_teeth_formulas_read(&f, &s->own, s->scene, message);
  if (status == TP_OK) {
    tp_field_mul(width, f.count, f.a, s->field);
    fmpz_mpoly_q_set(a, f.a, s->field->ring);
    fmpz_mpoly_q_set(c, f.c, s->field->ring);
  }
  tp_teeth_formulas_clear(&f, s->field);
  return status;
}

static tp_status teeth_value(fmpz_mpoly_q_t value, fmpz_mpoly_q_t run, const tp_subject *s,
                             bool width, tp_message *message) {
  fmpz_mpoly_q_t other;
  fmpz_mpoly_q_init(other, s->field->ring);
  const tp_status status =
      width ? read_teeth(value, run, other, s, message) : read_teeth(other, run, value, s, message);
  fmpz_mpoly_q_clear(other, s->field->ring);
  return status;
}

/* value = rise, run = run of the facet at the pivot. */
TP_QUANTITY_RULE(tp_quantity_facet_angle) {
  if (!s->has_model) return teeth_value(value, run, s, false, message);
  const tp_angle *i = s->angles + TP_ANGLE_I;
  const tp_rounding_symbols symbols = {s->length, i->sine, i->cosine};
  tp_rounding rounding;
  const tp_status status =
      tp_rounding_init(&rounding, &s->model, s->pivot, s->towards, &symbols, message);
  if (status != TP_OK) return status;
  fmpz_mpoly_q_set(value, rounding.rise, s->field->ring);
  fmpz_mpoly_q_set(run, rounding.run, s->field->ring);
  tp_rounding_clear(&rounding, s->field);
  return TP_OK;
}

/* Two contact points in symbols; false where one has none. */
static bool ends(tp_symbolic_point *p, tp_symbolic_point *q, const tp_subject *s, long from,
                 long to) {
  const tp_model *m = &s->model;
  return tp_formulas_point(p, &m->symbols, &m->problem, from) &&
         tp_formulas_point(q, &m->symbols, &m->problem, to);
}

/* Sums over the facets of dy^2 / dx, and of dx. */
static tp_status sum_slopes(fmpz_mpoly_q_t squares, fmpz_mpoly_q_t length, fmpz_mpoly_q_t dx,
                            fmpz_mpoly_q_t dy, const tp_subject *s, tp_message *message) {
  const tp_field *field = s->field;
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  const tp_contact *contact = &s->model.problem.contact;
  for (long k = 0; k < contact->facet_count; k++) {
    const tp_facet *f = contact->facets + k;
    tp_symbolic_point p, q;
    if (f->q0 == f->q1) continue;
    if (!ends(&p, &q, s, f->q0, f->q1)) {
      return tp_subject_lacks(s, message,
                              "the contact ends on the base, which has no formula there");
    }
    tp_field_sub(dx, q.x, p.x, field);
    tp_field_sub(dy, q.y, p.y, field);
    if (fmpz_mpoly_q_is_zero(dx, ring)) {
      return tp_subject_lacks(s, message, "a facet stands upright: its slope is not finite");
    }
    tp_field_add(length, length, dx, field);
    tp_field_mul(dy, dy, dy, field);
    tp_field_div(dy, dy, dx, field);
    tp_field_add(squares, squares, dy, field);
  }
  return TP_OK;
}

TP_QUANTITY_RULE(tp_quantity_mean_square_slope) {
  const tp_field *field = s->field;
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  if (!s->has_model) {
    const tp_status status = teeth_value(value, run, s, false, message);
    if (status == TP_OK) tp_field_div(value, value, run, field);
    tp_field_mul(value, value, value, field);
    return status;
  }
  fmpz_mpoly_q_t dx, dy;
  fmpz_mpoly_q_init(dx, ring);
  fmpz_mpoly_q_init(dy, ring);
  fmpz_mpoly_q_zero(value, ring);
  fmpz_mpoly_q_zero(run, ring);
  tp_status status = sum_slopes(value, run, dx, dy, s, message);
  if (status == TP_OK && fmpz_mpoly_q_is_zero(run, ring)) {
    status = tp_subject_lacks(s, message, "the block touches its base only in points");
  }
  if (status == TP_OK) tp_field_div(value, value, run, field);
  fmpz_mpoly_q_clear(dx, ring);
  fmpz_mpoly_q_clear(dy, ring);
  return status;
}

/* From the first to the last contact point. */
TP_QUANTITY_RULE(tp_quantity_block_width) {
  if (!s->has_model) return teeth_value(value, run, s, true, message);
  const tp_contact *contact = &s->model.problem.contact;
  tp_symbolic_point p, q;
  if (!ends(&p, &q, s, contact->points[0].point, contact->points[contact->point_count - 1].point)) {
    return tp_subject_lacks(s, message, "the contact ends on the base, which has no formula there");
  }
  tp_field_sub(value, q.x, p.x, s->field);
  return TP_OK;
}

/* From the lowest to the highest contact point, at the scene's values. */
TP_QUANTITY_RULE(tp_quantity_amplitude) {
  if (!s->has_model) return teeth_value(value, run, s, false, message);
  const tp_contact *contact = &s->model.problem.contact;
  const fmpz *y = s->model.problem.lattice.y;
  long low = contact->points[0].point, high = low;
  for (long k = 1; k < contact->point_count; k++) {
    const long point = contact->points[k].point;
    if (fmpz_cmp(y + point, y + low) < 0) low = point;
    if (fmpz_cmp(y + point, y + high) > 0) high = point;
  }
  tp_symbolic_point p, q;
  if (!ends(&p, &q, s, low, high)) {
    return tp_subject_lacks(s, message, "the contact ends on the base, which has no formula there");
  }
  tp_field_sub(value, q.y, p.y, s->field);
  return TP_OK;
}
