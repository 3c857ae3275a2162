/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Quantities from the lever arms of the weight about the pivot (docs/mechanics.md section 3); what
 * each is stands in quantities.c. */

#include "verify/quantity_rules.h"

#include "derive/field_work.h"

static tp_status init_rounding(tp_rounding *rounding, const tp_subject *s, tp_message *message) {
  const tp_angle *i = s->angles + TP_ANGLE_I;
  const tp_rounding_symbols symbols = {s->length, i->sine, i->cosine};
  return tp_rounding_init(rounding, &s->model, s->pivot, s->towards, &symbols, message);
}

static void divide_by(fmpz_mpoly_q_t value, long divisor, const tp_subject *s) {
  fmpz_t integer;
  fmpz_init_set_si(integer, divisor);
  fmpz_mpoly_q_div_fmpz(value, value, integer, s->field->ring);
  fmpz_clear(integer);
}

/* For all N of a parity. */
static tp_status family_arms(fmpz_mpoly_q_t x, fmpz_mpoly_q_t y, fmpz_mpoly_q_t area, tp_subject *s,
                             tp_message *message) {
  const bool even = s->members == TP_MEMBERS_EVEN;
  tp_family_sums sums;
  tp_teeth_formulas f;
  tp_family_sums_init(&sums, s->field);
  tp_teeth_formulas_init(&f, s->field);
  tp_status status = tp_teeth_formulas_read(&f, &s->own, s->scene, message);
  if (status == TP_OK) {
    status = tp_family_sums_derive(&sums, even, &f, s->scene, s->field, message);
  }
  if (status == TP_OK) {
    tp_family_arms(x, y, &sums, &f, tp_family_toe_kind(s->scene, even, s->towards), s->towards,
                   s->field);
    fmpz_mpoly_q_set(area, sums.of[0], s->field->ring);
  }
  tp_teeth_formulas_clear(&f, s->field);
  tp_family_sums_clear(&sums, s->field);
  return status;
}

tp_status tp_quantity_shift(fmpz_mpoly_q_t x, fmpz_mpoly_q_t y, const fmpz_mpoly_q_t weight,
                            const tp_subject *s, tp_message *message) {
  tp_rounding rounding;
  const tp_status status = init_rounding(&rounding, s, message);
  if (status != TP_OK) return status;
  fmpz_mpoly_q_t along, up;
  fmpz_mpoly_q_init(along, s->field->ring);
  fmpz_mpoly_q_init(up, s->field->ring);
  tp_rounding_shift(along, up, &rounding, s->field);
  tp_field_mul(along, along, weight, s->field);
  tp_field_mul(up, up, weight, s->field);
  tp_field_sub(x, x, along, s->field);
  tp_field_sub(y, y, up, s->field);
  fmpz_mpoly_q_clear(along, s->field->ring);
  fmpz_mpoly_q_clear(up, s->field->ring);
  tp_rounding_clear(&rounding, s->field);
  return TP_OK;
}

/* The lever arms, and the weighted area. */
static tp_status arms(fmpz_mpoly_q_t x, fmpz_mpoly_q_t y, fmpz_mpoly_q_t area, tp_subject *s,
                      bool rounded, tp_message *message) {
  tp_status status = TP_OK;
  if (!s->has_model) {
    status = family_arms(x, y, area, s, message);
  } else {
    tp_symbolic_point pivot;
    status = tp_model_pivot(&pivot, &s->model, s->pivot, message);
    if (status == TP_OK) tp_model_arms(x, y, &s->model, &pivot, s->towards);
    fmpz_mpoly_q_set(area, s->model.formulas.weighted2, s->field->ring);
  }
  if (status != TP_OK) return status;
  divide_by(x, 3, s); /* 6 (S - A p) over 3 (2 A) */
  divide_by(y, 3, s);
  tp_field_div(x, x, area, s->field);
  tp_field_div(y, y, area, s->field);
  divide_by(area, 2, s);
  if (!rounded) return TP_OK;
  fmpz_mpoly_q_t one;
  fmpz_mpoly_q_init(one, s->field->ring);
  fmpz_mpoly_q_one(one, s->field->ring);
  status = tp_quantity_shift(x, y, one, s, message);
  fmpz_mpoly_q_clear(one, s->field->ring);
  return status;
}

TP_QUANTITY_RULE(tp_quantity_area) {
  fmpz_mpoly_q_t y;
  fmpz_mpoly_q_init(y, s->field->ring);
  const tp_status status = arms(run, y, value, s, false, message);
  fmpz_mpoly_q_clear(y, s->field->ring);
  return status;
}

/* value = x arm, run = y arm. */
TP_QUANTITY_RULE(tp_quantity_critical_angle) {
  fmpz_mpoly_q_t area;
  fmpz_mpoly_q_init(area, s->field->ring);
  const tp_status status = arms(value, run, area, s, s->rounded, message);
  fmpz_mpoly_q_clear(area, s->field->ring);
  return status;
}

TP_QUANTITY_RULE(tp_quantity_y_arm) {
  return tp_quantity_critical_angle(run, value, s, message);
}

/* value = value cot alpha */
static void times_cotangent(fmpz_mpoly_q_t value, const tp_subject *s) {
  const tp_angle *alpha = s->angles + TP_ANGLE_ALPHA;
  fmpz_mpoly_q_t function;
  fmpz_mpoly_q_init(function, s->field->ring);
  fmpz_mpoly_q_gen(function, alpha->cosine, s->field->ring);
  tp_field_mul(value, value, function, s->field);
  fmpz_mpoly_q_gen(function, alpha->sine, s->field->ring);
  tp_field_div(value, value, function, s->field);
  fmpz_mpoly_q_clear(function, s->field->ring);
}

TP_QUANTITY_RULE(tp_quantity_fos) {
  const tp_status status = tp_quantity_critical_angle(value, run, s, message);
  if (status != TP_OK) return status;
  if (fmpz_mpoly_q_is_zero(run, s->field->ring)) {
    return tp_subject_lacks(s, message,
                            "nothing overturns about this pivot, so it has no factor of safety");
  }
  tp_field_div(value, value, run, s->field);
  times_cotangent(value, s);
  return TP_OK;
}

static tp_status set_rounding(fmpz_mpoly_q_t value, tp_subject *s, bool radius,
                              tp_message *message) {
  if (!s->has_model)
    return tp_subject_lacks(s, message, "corners are rounded for one number of teeth");
  const tp_angle *alpha = s->angles + TP_ANGLE_ALPHA;
  tp_rounding rounding;
  tp_status status = init_rounding(&rounding, s, message);
  if (status != TP_OK) return status;
  fmpz_mpoly_q_t x, y, area, sine, cosine, length;
  fmpz_mpoly_q_struct *const all[] = {x, y, area, sine, cosine, length};
  for (int k = 0; k < 6; k++) fmpz_mpoly_q_init(all[k], s->field->ring);
  status = arms(x, y, area, s, false, message);
  fmpz_mpoly_q_gen(sine, alpha->sine, s->field->ring);
  fmpz_mpoly_q_gen(cosine, alpha->cosine, s->field->ring);
  if (status == TP_OK && radius && !rounding.upright_side) {
    status = tp_subject_lacks(
        s, message,
        "the corner at the pivot has no side normal to the base, so its angle is not that "
        "of Appendix B; ask for rounding_length");
  }
  if (status == TP_OK) {
    tp_rounding_critical_length(length, &rounding, x, y, sine, cosine, s->field);
    if (radius) {
      tp_rounding_radius(value, &rounding, length, s->field);
    } else {
      fmpz_mpoly_q_swap(value, length, s->field->ring);
    }
  }
  for (int k = 0; k < 6; k++) fmpz_mpoly_q_clear(all[k], s->field->ring);
  tp_rounding_clear(&rounding, s->field);
  return status;
}

TP_QUANTITY_RULE(tp_quantity_rounding_length) {
  (void)run;
  return set_rounding(value, s, false, message);
}

TP_QUANTITY_RULE(tp_quantity_corner_radius) {
  (void)run;
  return set_rounding(value, s, true, message);
}

/* Area over width. */
TP_QUANTITY_RULE(tp_quantity_mean_height) {
  fmpz_mpoly_q_t scratch;
  fmpz_mpoly_q_init(scratch, s->field->ring);
  tp_status status = tp_quantity_area(value, scratch, s, message);
  if (status == TP_OK) status = tp_quantity_block_width(run, scratch, s, message);
  if (status == TP_OK) tp_field_div(value, value, run, s->field);
  fmpz_mpoly_q_clear(scratch, s->field->ring);
  return status;
}
