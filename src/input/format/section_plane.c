/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Unit direction of the plane in rationals, from two points or from the tangent of half the
 * azimuth; signed distances of vertices by doubles with a bound, then exactly. */

#include "format/section_plane.h"

#include <arb.h>
#include <float.h>
#include <math.h>

enum { DIRECTION_BITS = 40, SCALE_BITS = 64, WORKING_BITS = 256 };

void tp_section_plane_init(tp_section_plane *plane) {
  fmpq_init(&plane->x);
  fmpq_init(&plane->y);
  fmpq_init(&plane->dx);
  fmpq_init(&plane->dy);
  fmpq_init(&plane->scale);
  plane->y_is_up = false;
}

void tp_section_plane_clear(tp_section_plane *plane) {
  fmpq_clear(&plane->x);
  fmpq_clear(&plane->y);
  fmpq_clear(&plane->dx);
  fmpq_clear(&plane->dy);
  fmpq_clear(&plane->scale);
}

/* ---- the direction -----------------------------------------------------------------------------
 */

/* The whole number nearest to `value` times 2^bits, of a value that is known to more bits. */
static void nearest(fmpz_t whole, const arb_t value, long bits) {
  arf_t shifted, half;
  arf_init(shifted);
  arf_init(half);
  arf_mul_2exp_si(shifted, arb_midref(value), bits);
  arf_set_d(half, 0.5);
  arf_add(shifted, shifted, half, ARF_PREC_EXACT, ARF_RND_DOWN);
  arf_floor(shifted, shifted);
  arf_get_fmpz(whole, shifted, ARF_RND_DOWN);
  arf_clear(shifted);
  arf_clear(half);
}

/* 1/sqrt(square), exactly where it is a fraction, else within 2^-64 of itself. */
static void set_inverse_root(fmpq_t inverse, const fmpq_t square) {
  if (fmpz_is_square(fmpq_numref(square)) && fmpz_is_square(fmpq_denref(square))) {
    fmpz_sqrt(fmpq_numref(inverse), fmpq_denref(square));
    fmpz_sqrt(fmpq_denref(inverse), fmpq_numref(square));
    return;
  }
  arb_t value;
  arb_init(value);
  arb_set_fmpq(value, square, WORKING_BITS);
  arb_rsqrt(value, value, WORKING_BITS);
  const long bits = SCALE_BITS - arf_abs_bound_lt_2exp_si(arb_midref(value)) + 1;
  nearest(fmpq_numref(inverse), value, bits);
  fmpz_one(fmpq_denref(inverse));
  fmpz *const side = bits < 0 ? fmpq_numref(inverse) : fmpq_denref(inverse);
  fmpz_mul_2exp(side, side, (unsigned long)(bits < 0 ? -bits : bits));
  fmpq_canonicalise(inverse);
  arb_clear(value);
}

bool tp_section_plane_through(tp_section_plane *plane, const fmpq_t x0, const fmpq_t y0,
                              const fmpq_t x1, const fmpq_t y1) {
  fmpq_t square;
  fmpq_set(&plane->x, x0);
  fmpq_set(&plane->y, y0);
  fmpq_sub(&plane->dx, x1, x0);
  fmpq_sub(&plane->dy, y1, y0);
  if (fmpq_is_zero(&plane->dx) && fmpq_is_zero(&plane->dy)) return false;
  fmpq_init(square);
  fmpq_mul(square, &plane->dx, &plane->dx);
  fmpq_addmul(square, &plane->dy, &plane->dy);
  set_inverse_root(&plane->scale, square);
  fmpq_clear(square);
  return true;
}

/* t = tan(azimuth/2) of an azimuth from 0 to 90 degrees, to 40 binary digits. */
static void half_tangent(fmpq_t t, const fmpq_t azimuth_deg) {
  arb_t angle, sine, cosine;
  arb_init(angle);
  arb_init(sine);
  arb_init(cosine);
  arb_set_fmpq(angle, azimuth_deg, WORKING_BITS);
  arb_div_ui(angle, angle, 360, WORKING_BITS);
  arb_sin_cos_pi(sine, cosine, angle, WORKING_BITS);
  arb_div(sine, sine, cosine, WORKING_BITS);
  nearest(fmpq_numref(t), sine, DIRECTION_BITS);
  fmpz_one(fmpq_denref(t));
  fmpq_div_2exp(t, t, DIRECTION_BITS);
  arb_clear(angle);
  arb_clear(sine);
  arb_clear(cosine);
}

/* dx + i dy from (1 - t^2)/(1 + t^2) and 2 t/(1 + t^2), in the first quarter from y to x. */
static void set_direction(tp_section_plane *plane, const fmpq_t t) {
  fmpq_t square, sum;
  fmpq_init(square);
  fmpq_init(sum);
  fmpq_mul(square, t, t);
  fmpq_one(sum);
  fmpq_sub(&plane->dy, sum, square);
  fmpq_add(sum, sum, square);
  fmpq_div(&plane->dy, &plane->dy, sum);
  fmpq_add(&plane->dx, t, t);
  fmpq_div(&plane->dx, &plane->dx, sum);
  fmpq_clear(square);
  fmpq_clear(sum);
}

void tp_section_plane_at(tp_section_plane *plane, const fmpq_t x, const fmpq_t y,
                         const fmpq_t azimuth_deg) {
  fmpq_t quarter, rest;
  fmpz_t turns;
  fmpq_init(quarter);
  fmpq_init(rest);
  fmpz_init(turns);
  fmpq_set(&plane->x, x);
  fmpq_set(&plane->y, y);
  fmpq_set_si(rest, 90, 1);
  fmpq_div(quarter, azimuth_deg, rest);
  fmpz_fdiv_q(turns, fmpq_numref(quarter), fmpq_denref(quarter));
  fmpq_mul_fmpz(rest, rest, turns);
  fmpq_sub(rest, azimuth_deg, rest);
  half_tangent(quarter, rest);
  set_direction(plane, quarter);
  for (unsigned long k = fmpz_fdiv_ui(turns, 4); k > 0; k--) {
    fmpq_swap(&plane->dx, &plane->dy);
    fmpq_neg(&plane->dy, &plane->dy);
  }
  fmpq_one(&plane->scale);
  fmpq_clear(quarter);
  fmpq_clear(rest);
  fmpz_clear(turns);
}

/* ---- vertices ----------------------------------------------------------------------------------
 */

/* From the plane's point to the vertex, on the map. */
static void step_to(fmpq_t x, fmpq_t y, const tp_section_plane *plane, const fmpq vertex[3]) {
  fmpq_sub(x, vertex, &plane->x);
  if (plane->y_is_up) {
    fmpq_add(y, vertex + 2, &plane->y);
    fmpq_neg(y, y);
  } else {
    fmpq_sub(y, vertex + 1, &plane->y);
  }
}

void tp_section_plane_across(fmpq_t across, const tp_section_plane *plane, const fmpq vertex[3]) {
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  step_to(x, y, plane, vertex);
  fmpq_mul(across, &plane->dx, y);
  fmpq_submul(across, &plane->dy, x);
  fmpq_clear(x);
  fmpq_clear(y);
}

/* Into a double; false where it is too small for one of full length. */
static bool is_near(double *near, const fmpq_t exact) {
  *near = fmpq_get_d(exact);
  return fmpq_is_zero(exact) || fabs(*near) > DBL_MIN / DBL_EPSILON;
}

/* The sign by doubles, 0 where they do not tell. Each of the six numbers is off by at most one unit
 * in its last place (2^-52 of it), as fmpq_get_d cuts off, and each of the operations by half of
 * one: in all by less than 2^-48 of the sum of the sizes of all products. */
static int near_side(const tp_section_plane *plane, const fmpq vertex[3]) {
  double dx = 0, dy = 0, x0 = 0, y0 = 0, x = 0, y = 0;
  const bool near = is_near(&dx, &plane->dx) && is_near(&dy, &plane->dy) &&
                    is_near(&x0, &plane->x) && is_near(&y0, &plane->y) && is_near(&x, vertex) &&
                    is_near(&y, vertex + (plane->y_is_up ? 2 : 1));
  if (plane->y_is_up) y = -y;
  const double across = dx * (y - y0) - dy * (x - x0);
  const double size = fabs(dx) * (fabs(y) + fabs(y0)) + fabs(dy) * (fabs(x) + fabs(x0));
  const bool sized = size > DBL_MIN / DBL_EPSILON && size < DBL_MAX * DBL_EPSILON;
  if (!near || !sized || fabs(across) <= ldexp(size, -48)) return 0;
  return across > 0 ? 1 : -1;
}

int tp_section_plane_side(const tp_section_plane *plane, const fmpq vertex[3]) {
  const int near = near_side(plane, vertex);
  if (near != 0) return near;
  fmpq_t across;
  fmpq_init(across);
  tp_section_plane_across(across, plane, vertex);
  const int sign = fmpq_sgn(across);
  fmpq_clear(across);
  return sign;
}

void tp_section_plane_along(fmpq_t along, fmpq_t height, const tp_section_plane *plane,
                            const fmpq vertex[3]) {
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  step_to(x, y, plane, vertex);
  fmpq_mul(along, &plane->dx, x);
  fmpq_addmul(along, &plane->dy, y);
  fmpq_mul(along, along, &plane->scale);
  fmpq_set(height, vertex + (plane->y_is_up ? 1 : 2));
  fmpq_clear(x);
  fmpq_clear(y);
}
