/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The quantities that claims may be about: derived from the block, its pivot and its base.
 *
 * area               of the section, holes taken off, parts weighted by relative density
 * x_arm, y_arm       lever arms of the weight about the pivot (docs/mechanics.md section 3)
 * critical_angle     atan2(x_arm, y_arm)
 * fos                x_arm cot alpha / y_arm: the resultant form, Eq. (2)
 * fos_elements       by elements, each moment on its own side, (A1.3)
 * stabilising_moment, overturning_moment
 *                    the sums of moments by elements, with the weights w_1, w_2, … as symbols:
 * slabs first, the farthest up-dip first, then triangles likewise, (A1.1) stabilising_area_moment,
 * overturning_area_moment the same with the elements' areas for their weights rounding_length the l
 * at which the block topples at alpha, (A2.4) corner_radius      the radius that this l belongs to,
 * (A2.6) facet_angle        of the facet at the pivot to the mean plane, positive: Eq. (7)
 * mean_square_slope  (1/L) int (dy/dx)^2 dx over the contact: the square of Eq. (13)'s root
 * block_width, mean_height, amplitude
 *                    along the mean plane; area over width; of the contact, peak to valley
 *
 * With a rounded corner everything but `rounding_length` and `corner_radius` is about the axis
 * where rounding puts it. Which side a moment is on is decided with the sharp corner, at the
 * scene's values. */

#include "verify/quantities.h"

#include "derive/field_work.h"

tp_status tp_quantity_fail(const tp_subject *s, tp_message *message, const char *problem) {
  return tp_fail(message, TP_NO_ANSWER, s->scene->block.place, "%s", problem);
}

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

static tp_status set_area(fmpz_mpoly_q_t value, fmpz_mpoly_q_t run, tp_subject *s,
                          tp_message *message) {
  fmpz_mpoly_q_t y;
  fmpz_mpoly_q_init(y, s->field->ring);
  const tp_status status = arms(run, y, value, s, false, message);
  fmpz_mpoly_q_clear(y, s->field->ring);
  return status;
}

/* value = x arm, run = y arm. */
static tp_status set_critical_angle(fmpz_mpoly_q_t value, fmpz_mpoly_q_t run, tp_subject *s,
                                    tp_message *message) {
  fmpz_mpoly_q_t area;
  fmpz_mpoly_q_init(area, s->field->ring);
  const tp_status status = arms(value, run, area, s, s->rounded, message);
  fmpz_mpoly_q_clear(area, s->field->ring);
  return status;
}

static tp_status set_y_arm(fmpz_mpoly_q_t value, fmpz_mpoly_q_t run, tp_subject *s,
                           tp_message *message) {
  return set_critical_angle(run, value, s, message);
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

static tp_status set_fos(fmpz_mpoly_q_t value, fmpz_mpoly_q_t run, tp_subject *s,
                         tp_message *message) {
  const tp_status status = set_critical_angle(value, run, s, message);
  if (status != TP_OK) return status;
  if (fmpz_mpoly_q_is_zero(run, s->field->ring)) {
    return tp_quantity_fail(s, message,
                            "nothing overturns about this pivot, so it has no factor of safety");
  }
  tp_field_div(value, value, run, s->field);
  times_cotangent(value, s);
  return TP_OK;
}

static tp_status set_rounding(fmpz_mpoly_q_t value, tp_subject *s, bool radius,
                              tp_message *message) {
  if (!s->has_model)
    return tp_quantity_fail(s, message, "corners are rounded for one number of teeth");
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
    status = tp_quantity_fail(
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

static tp_status set_rounding_length(fmpz_mpoly_q_t value, fmpz_mpoly_q_t run, tp_subject *s,
                                     tp_message *message) {
  (void)run;
  return set_rounding(value, s, false, message);
}

static tp_status set_corner_radius(fmpz_mpoly_q_t value, fmpz_mpoly_q_t run, tp_subject *s,
                                   tp_message *message) {
  (void)run;
  return set_rounding(value, s, true, message);
}

/* Area over width. */
static tp_status set_mean_height(fmpz_mpoly_q_t value, fmpz_mpoly_q_t run, tp_subject *s,
                                 tp_message *message) {
  fmpz_mpoly_q_t scratch;
  fmpz_mpoly_q_init(scratch, s->field->ring);
  tp_status status = set_area(value, scratch, s, message);
  if (status == TP_OK) status = tp_quantity_block_width(run, scratch, s, message);
  if (status == TP_OK) tp_field_div(value, value, run, s->field);
  fmpz_mpoly_q_clear(scratch, s->field->ring);
  return status;
}

bool tp_quantities_add(tp_subject *s) {
  static const struct {
    const char *name;
    tp_name_kind kind;
    tp_quantity_rule rule;
  } quantities[] = {
      {"area", TP_NAME_FORMULA, set_area},
      {"x_arm", TP_NAME_FORMULA, set_critical_angle},
      {"y_arm", TP_NAME_FORMULA, set_y_arm},
      {"critical_angle", TP_NAME_DIRECTION, set_critical_angle},
      {"fos", TP_NAME_FORMULA, set_fos},
      {"fos_elements", TP_NAME_FORMULA, tp_quantity_fos_elements},
      {"stabilising_moment", TP_NAME_FORMULA, tp_quantity_stabilising},
      {"overturning_moment", TP_NAME_FORMULA, tp_quantity_overturning},
      {"stabilising_area_moment", TP_NAME_FORMULA, tp_quantity_stabilising_area},
      {"overturning_area_moment", TP_NAME_FORMULA, tp_quantity_overturning_area},
      {"rounding_length", TP_NAME_FORMULA, set_rounding_length},
      {"corner_radius", TP_NAME_FORMULA, set_corner_radius},
      {"facet_angle", TP_NAME_DIRECTION, tp_quantity_facet_angle},
      {"mean_square_slope", TP_NAME_FORMULA, tp_quantity_mean_square_slope},
      {"block_width", TP_NAME_FORMULA, tp_quantity_block_width},
      {"mean_height", TP_NAME_FORMULA, set_mean_height},
      {"amplitude", TP_NAME_FORMULA, tp_quantity_amplitude},
  };
  for (size_t k = 0; k < sizeof quantities / sizeof quantities[0]; k++) {
    tp_name *name = tp_subject_add_name(s, quantities[k].name, quantities[k].kind);
    if (name == NULL) return false;
    name->rule = quantities[k].rule;
    name->ready = false;
  }
  return true;
}
