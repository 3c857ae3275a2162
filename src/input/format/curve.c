/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Circles and arcs by their angles as edges with a bulge (tangent of a quarter of the angle), the
 * tolerance of a drawing, and rounding of computed points, with their uncertainty. */

#include "format/curve.h"

#include <math.h>

enum { BITS = 192, DECIMALS = 18 };

void tp_curve_tolerance(fmpq_t tolerance, const tp_drawing_options *options, const fmpq_t length) {
  if (fmpq_is_zero(options->tolerance)) {
    fmpq_set_si(tolerance, 1, 10000);
    fmpq_mul(tolerance, tolerance, length);
  } else {
    fmpq_set(tolerance, options->tolerance);
  }
}

void tp_curve_deviates(tp_drawing_object *object, const fmpq_t tolerance) {
  if (fmpq_cmp(object->deviation, tolerance) < 0) fmpq_set(object->deviation, tolerance);
}

void tp_curve_round(fmpq_t value, const fmpq_t tolerance) {
  enum { FINER = 3 }; /* decimals */
  const int decimals = (int)ceil(-log10(fmpq_get_d(tolerance))) + FINER;
  fmpz_t ten, whole;
  fmpq_t scale, half;
  fmpz_init_set_ui(ten, 10);
  fmpz_init(whole);
  fmpq_init(scale);
  fmpq_init(half);
  fmpz_pow_ui(fmpq_numref(scale), ten, (ulong)(decimals < 0 ? -decimals : decimals));
  if (decimals < 0) fmpq_inv(scale, scale);
  fmpq_set_si(half, 1, 2);
  fmpq_mul(value, value, scale);
  fmpq_add(value, value, half);
  fmpz_fdiv_q(whole, fmpq_numref(value), fmpq_denref(value));
  fmpq_set_fmpz(value, whole);
  fmpq_div(value, value, scale);
  fmpz_clear(ten);
  fmpz_clear(whole);
  fmpq_clear(scale);
  fmpq_clear(half);
}

/* 4 (atan 1/2 + atan 1/3) is half a turn: two bulges of whole decimals about the centre, twice. */
bool tp_curve_circle(tp_drawing_object *object, const fmpq_t x, const fmpq_t y, const fmpq_t radius,
                     tp_mark mark) {
  static const int ends[4][2] = {{25, 0}, {-7, 24}, {-25, 0}, {7, -24}}; /* over 25 */
  fmpq_t px, py, bulge;
  fmpq_init(px);
  fmpq_init(py);
  fmpq_init(bulge);
  bool done = true;
  for (int k = 0; k < 4 && done; k++) {
    fmpq_set_si(px, ends[k][0], 25);
    fmpq_set_si(py, ends[k][1], 25);
    fmpq_mul(px, px, radius);
    fmpq_mul(py, py, radius);
    fmpq_add(px, px, x);
    fmpq_add(py, py, y);
    fmpq_set_si(bulge, 1, k % 2 == 0 ? 2 : 3);
    done = tp_drawing_add_point(object, px, py, mark) && tp_drawing_bend(object, bulge);
  }
  object->closure = TP_DRAWING_CLOSED;
  fmpq_clear(px);
  fmpq_clear(py);
  fmpq_clear(bulge);
  return done;
}

void tp_curve_decimal(fmpq_t value, const arb_t ball) {
  arb_t scaled;
  fmpz_t ten, whole;
  arb_init(scaled);
  fmpz_init_set_ui(ten, 10);
  fmpz_init(whole);
  fmpz_pow_ui(ten, ten, DECIMALS);
  arb_mul_fmpz(scaled, ball, ten, BITS);
  arf_get_fmpz(whole, arb_midref(scaled), ARF_RND_NEAR);
  fmpq_set_fmpz_frac(value, whole, ten);
  arb_clear(scaled);
  fmpz_clear(ten);
  fmpz_clear(whole);
}

/* centre + radius (cos, sin). */
static bool add_end(tp_drawing_object *object, const fmpq_t x, const fmpq_t y, const fmpq_t radius,
                    const arb_t angle, tp_mark mark) {
  arb_t cosine, sine;
  fmpq_t px, py;
  arb_init(cosine);
  arb_init(sine);
  fmpq_init(px);
  fmpq_init(py);
  arb_sin_cos(sine, cosine, angle, BITS);
  tp_curve_decimal(px, cosine);
  tp_curve_decimal(py, sine);
  fmpq_mul(px, px, radius);
  fmpq_mul(py, py, radius);
  fmpq_add(px, px, x);
  fmpq_add(py, py, y);
  const bool done = tp_drawing_add_point(object, px, py, mark);
  arb_clear(cosine);
  arb_clear(sine);
  fmpq_clear(px);
  fmpq_clear(py);
  return done;
}

/* Of a quarter of an angle, below a quarter of a turn, that ends a little before it where it is a
 * whole one. */
static bool bend_by(tp_drawing_object *object, const arb_t angle) {
  arb_t quarter;
  fmpq_t bulge;
  arb_init(quarter);
  fmpq_init(bulge);
  arb_mul_2exp_si(quarter, angle, -2);
  arb_tan(quarter, quarter, BITS);
  tp_curve_decimal(bulge, quarter);
  const bool done = tp_drawing_bend(object, bulge);
  arb_clear(quarter);
  fmpq_clear(bulge);
  return done;
}

/* 1e-9 of the numbers that the ends are made of: CAD writes these with ten digits and more. */
static void raise_uncertainty(tp_drawing_object *object, const fmpq_t x, const fmpq_t y,
                              const fmpq_t radius) {
  enum { SHARE = 1000000000 };
  fmpq_t own, size;
  fmpq_init(own);
  fmpq_init(size);
  fmpq_abs(own, x);
  fmpq_abs(size, y);
  fmpq_add(own, own, size);
  fmpq_add(own, own, radius);
  fmpq_set_si(size, 1, SHARE);
  fmpq_mul(own, own, size);
  if (fmpq_cmp(object->uncertainty, own) < 0) fmpq_set(object->uncertainty, own);
  fmpq_clear(own);
  fmpq_clear(size);
}

bool tp_curve_arc(tp_drawing_object *object, const fmpq_t x, const fmpq_t y, const fmpq_t radius,
                  const arb_t from, const arb_t to, tp_mark mark) {
  arb_t middle, half;
  arb_init(middle);
  arb_init(half);
  arb_sub(half, to, from, BITS);
  arb_mul_2exp_si(half, half, -1);
  arb_add(middle, from, half, BITS);
  /* in two, so that no bulge is above one */
  const bool done = add_end(object, x, y, radius, from, mark) && bend_by(object, half) &&
                    add_end(object, x, y, radius, middle, mark) && bend_by(object, half) &&
                    add_end(object, x, y, radius, to, mark);
  raise_uncertainty(object, x, y, radius);
  arb_clear(middle);
  arb_clear(half);
  return done;
}
