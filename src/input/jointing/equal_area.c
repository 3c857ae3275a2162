/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* x runs along the bases of the columns, which dip by p, from the toe on. With the dips f of the
 * face, b of the base, s of the ground behind the crest and the height H of the crest, the base
 * rises by tan(b - p), so that the surface lies over it by d(x) = x (tan(f - p) - tan(b - p)) up to
 * the crest, at X = H cos(f - p) / sin f, d(x) = d(X) - (x - X) (tan(p - s) + tan(b - p))  behind
 * it, down to nothing. A column of the width w has the height of the mean of d over its strip, of
 * which the integral is a square in x on either side. Directions are fractions that are off by less
 * than 1e-8 degrees; all else is exact. */

#include "jointing/equal_area.h"

#include "common/message.h"
#include "jointing/cuts.h"
#include "number/divide.h"

/* Directions are rounded, so that dips which differ by less than this may have one direction. */
#define NEAR_DEG "2e-8°"

/* The tangent of a - b, from -90 to 90 degrees; bad input at the place where that is upright. */
static tp_status tangent_of_difference(fmpq_t result, const fmpq_t a, const fmpq_t b,
                                       tp_place place, tp_message *message) {
  tp_cut_point u;
  fmpq_t angle;
  tp_cut_point_init(&u);
  fmpq_init(angle);
  fmpq_sub(angle, a, b);
  tp_direction_of_degrees(&u, angle);
  const tp_status status = tp_divide_above_zero(
      result, u.y, u.x, place,
      "this dip differs by 90° from that of the bases of the columns, to within " NEAR_DEG
      ": the columns would have no end; give another dip",
      message);
  tp_cut_point_clear(&u);
  fmpq_clear(angle);
  return status;
}

/* H cos(f - p) / sin f. */
static tp_status set_crest(tp_equal_area *area, const tp_columns_description *columns,
                           const fmpq_t dip, tp_message *message) {
  tp_cut_point u;
  fmpq_t angle;
  tp_cut_point_init(&u);
  fmpq_init(angle);
  fmpq_sub(angle, columns->face_dip_deg.value, dip);
  tp_direction_of_degrees(&u, angle);
  fmpq_mul(area->crest, columns->height.value, u.x);
  tp_direction_of_degrees(&u, columns->face_dip_deg.value);
  const tp_status status = tp_divide_above_zero(
      area->crest, area->crest, u.y, columns->face_dip_deg.place,
      "the face is level to within " NEAR_DEG ", and never comes to its height; give a steeper one",
      message);
  tp_cut_point_clear(&u);
  fmpq_clear(angle);
  return status;
}

static tp_place upper_place(const tp_columns_description *c) {
  return c->upper_dip_deg.given ? c->upper_dip_deg.place : c->base_dip_deg.place;
}

static tp_status check_dips(const tp_columns_description *c, const tp_quantity *dip,
                            tp_message *message) {
  fmpq_t angle;
  fmpq_init(angle);
  fmpq_sub(angle, c->face_dip_deg.value, dip->value);
  const bool overhangs = fmpq_cmp_si(angle, 90) >= 0;
  fmpq_clear(angle);
  if (overhangs) {
    return tp_refuse(message, TP_FAULT_RANGE, c->face_dip_deg.place,
                     "the face must dip by less than 90° more than the bases of the columns, which "
                     "stand normal to these");
  }
  if (fmpq_cmp(c->face_dip_deg.value, c->base_dip_deg.value) <= 0) {
    return tp_refuse(message, TP_FAULT_RANGE, c->face_dip_deg.place,
                     "the face must be steeper than the base below all columns, base_dip_deg");
  }
  if (fmpq_cmp(c->upper_dip_deg.value, c->base_dip_deg.value) >= 0) {
    return tp_refuse(message, TP_FAULT_RANGE, upper_place(c),
                     "the ground behind the crest must be flatter than the base below all columns, "
                     "base_dip_deg, or the two never meet");
  }
  return TP_OK;
}

/* Dips that differ by less than their rounding pass check_dips, and have one direction. */
static tp_status check_slopes(const tp_equal_area *area, const tp_columns_description *c,
                              tp_message *message) {
  if (fmpq_sgn(area->rise) <= 0) {
    return tp_refuse(message, TP_FAULT_RANGE, c->face_dip_deg.place,
                     "the face must be steeper than the base below all columns, base_dip_deg, by "
                     "more than " NEAR_DEG ", to which directions are rounded");
  }
  if (fmpq_sgn(area->fall) > 0) return TP_OK;
  return tp_refuse(message, TP_FAULT_RANGE, upper_place(c),
                   "the ground behind the crest must be flatter than the base below all columns, "
                   "base_dip_deg, by more than " NEAR_DEG
                   ", to which directions are rounded, or the two never meet");
}

static tp_status set_slopes(tp_equal_area *area, const tp_columns_description *columns,
                            const tp_quantity *dip, tp_message *message) {
  tp_status status = tangent_of_difference(area->step, columns->base_dip_deg.value, dip->value,
                                           columns->base_dip_deg.place, message);
  if (status == TP_OK) {
    status = tangent_of_difference(area->rise, columns->face_dip_deg.value, dip->value,
                                   columns->face_dip_deg.place, message);
  }
  if (status == TP_OK) {
    status = tangent_of_difference(area->fall, dip->value, columns->upper_dip_deg.value,
                                   upper_place(columns), message);
  }
  if (status != TP_OK) return status;
  fmpq_sub(area->rise, area->rise, area->step);
  fmpq_add(area->fall, area->fall, area->step);
  fmpq_mul(area->step, area->step, area->width);
  return check_slopes(area, columns, message);
}

tp_status tp_equal_area_init(tp_equal_area *area, const tp_columns_description *columns,
                             const tp_quantity *dip_deg, tp_message *message) {
  tp_status status = check_dips(columns, dip_deg, message);
  if (status != TP_OK) return status;
  fmpq *const all[] = {area->width, area->step, area->rise, area->fall, area->crest, area->back};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) fmpq_init(all[k]);
  fmpq_set(area->width, columns->width.value);
  status = set_slopes(area, columns, dip_deg, message);
  if (status == TP_OK) status = set_crest(area, columns, dip_deg->value, message);
  if (status == TP_OK) {
    fmpq_mul(area->back, area->crest, area->rise);
    fmpq_div(area->back, area->back, area->fall); /* above zero */
    fmpq_add(area->back, area->back, area->crest);
  } else {
    tp_equal_area_clear(area);
  }
  return status;
}

void tp_equal_area_clear(tp_equal_area *area) {
  fmpq *const all[] = {area->width, area->step, area->rise, area->fall, area->crest, area->back};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) fmpq_clear(all[k]);
}

void tp_equal_area_count(fmpz_t count, const tp_equal_area *area) {
  fmpq_t widths;
  fmpq_init(widths);
  fmpq_div(widths, area->back, area->width);
  fmpz_cdiv_q(count, fmpq_numref(widths), fmpq_denref(widths));
  fmpq_clear(widths);
}

/* Twice the area from the toe on, up to x: rise x^2, less (rise + fall) (x - X)^2 behind the crest.
 */
static void twice_area(fmpq_t twice, const tp_equal_area *area, const fmpq_t x) {
  fmpq_t part, rate;
  fmpq_init(part);
  fmpq_init(rate);
  fmpq_mul(twice, x, x);
  fmpq_mul(twice, twice, area->rise);
  fmpq_sub(part, x, area->crest);
  if (fmpq_sgn(part) > 0) {
    fmpq_mul(part, part, part);
    fmpq_add(rate, area->rise, area->fall);
    fmpq_mul(part, part, rate);
    fmpq_sub(twice, twice, part);
  }
  fmpq_clear(part);
  fmpq_clear(rate);
}

void tp_equal_area_height(fmpq_t height, const tp_equal_area *area, long column) {
  fmpq_t x, before;
  fmpq_init(x);
  fmpq_init(before);
  fmpq_mul_si(x, area->width, column);
  twice_area(before, area, x);
  fmpq_mul_si(x, area->width, column + 1);
  if (fmpq_cmp(x, area->back) > 0) fmpq_set(x, area->back);
  twice_area(height, area, x);
  fmpq_sub(height, height, before);
  fmpq_div(height, height, area->width);
  fmpq_div_2exp(height, height, 1);
  fmpq_clear(x);
  fmpq_clear(before);
}
