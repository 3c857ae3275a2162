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

/* The tangent of a - b, or the other way, below 90 degrees. */
static void tangent_of_difference(fmpq_t result, const fmpq_t a, const fmpq_t b) {
  tp_cut_point u;
  fmpq_t angle;
  tp_cut_point_init(&u);
  fmpq_init(angle);
  fmpq_sub(angle, a, b);
  tp_direction_of_degrees(&u, angle);
  fmpq_div(result, u.y, u.x);
  tp_cut_point_clear(&u);
  fmpq_clear(angle);
}

/* H cos(f - p) / sin f. */
static void set_crest(tp_equal_area *own, const tp_columns_description *columns, const fmpq_t dip) {
  tp_cut_point u;
  fmpq_t angle;
  tp_cut_point_init(&u);
  fmpq_init(angle);
  fmpq_sub(angle, columns->face_dip_deg.value, dip);
  tp_direction_of_degrees(&u, angle);
  fmpq_mul(own->crest, columns->height.value, u.x);
  tp_direction_of_degrees(&u, columns->face_dip_deg.value);
  fmpq_div(own->crest, own->crest, u.y);
  tp_cut_point_clear(&u);
  fmpq_clear(angle);
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
    return tp_refuse(message, TP_FAULT_RANGE,
                     c->upper_dip_deg.given ? c->upper_dip_deg.place : c->base_dip_deg.place,
                     "the ground behind the crest must be flatter than the base below all columns, "
                     "base_dip_deg, or the two never meet");
  }
  return TP_OK;
}

tp_status tp_equal_area_init(tp_equal_area *own, const tp_columns_description *columns,
                             const tp_quantity *dip_deg, tp_message *message) {
  const tp_status status = check_dips(columns, dip_deg, message);
  if (status != TP_OK) return status;
  fmpq *const all[] = {own->width, own->step, own->rise, own->fall, own->crest, own->back};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) fmpq_init(all[k]);
  fmpq_set(own->width, columns->width.value);
  tangent_of_difference(own->step, columns->base_dip_deg.value, dip_deg->value);
  tangent_of_difference(own->rise, columns->face_dip_deg.value, dip_deg->value);
  tangent_of_difference(own->fall, dip_deg->value, columns->upper_dip_deg.value);
  fmpq_sub(own->rise, own->rise, own->step);
  fmpq_add(own->fall, own->fall, own->step);
  fmpq_mul(own->step, own->step, own->width);
  set_crest(own, columns, dip_deg->value);
  fmpq_mul(own->back, own->crest, own->rise);
  fmpq_div(own->back, own->back, own->fall);
  fmpq_add(own->back, own->back, own->crest);
  return TP_OK;
}

void tp_equal_area_clear(tp_equal_area *own) {
  fmpq *const all[] = {own->width, own->step, own->rise, own->fall, own->crest, own->back};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) fmpq_clear(all[k]);
}

void tp_equal_area_count(fmpz_t count, const tp_equal_area *own) {
  fmpq_t widths;
  fmpq_init(widths);
  fmpq_div(widths, own->back, own->width);
  fmpz_cdiv_q(count, fmpq_numref(widths), fmpq_denref(widths));
  fmpq_clear(widths);
}

/* Twice the area from the toe on, up to x: rise x^2, less (rise + fall) (x - X)^2 behind the crest.
 */
static void twice_area(fmpq_t area, const tp_equal_area *own, const fmpq_t x) {
  fmpq_t part, rate;
  fmpq_init(part);
  fmpq_init(rate);
  fmpq_mul(area, x, x);
  fmpq_mul(area, area, own->rise);
  fmpq_sub(part, x, own->crest);
  if (fmpq_sgn(part) > 0) {
    fmpq_mul(part, part, part);
    fmpq_add(rate, own->rise, own->fall);
    fmpq_mul(part, part, rate);
    fmpq_sub(area, area, part);
  }
  fmpq_clear(part);
  fmpq_clear(rate);
}

void tp_equal_area_height(fmpq_t height, const tp_equal_area *own, long column) {
  fmpq_t x, before;
  fmpq_init(x);
  fmpq_init(before);
  fmpq_mul_si(x, own->width, column);
  twice_area(before, own, x);
  fmpq_mul_si(x, own->width, column + 1);
  if (fmpq_cmp(x, own->back) > 0) fmpq_set(x, own->back);
  twice_area(height, own, x);
  fmpq_sub(height, height, before);
  fmpq_div(height, height, own->width);
  fmpq_div_2exp(height, height, 1);
  fmpq_clear(x);
  fmpq_clear(before);
}
