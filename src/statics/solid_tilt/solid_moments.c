/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sums of the surface in metres about the centroid, by balls that take the bounds of the sums
 * along. */

#include "solid_tilt/solid_moments.h"

#include "number/ball.h"

#include <string.h>

enum { BITS = 192 }; /* of balls: roundings far below what a double shows */

void tp_solid_moments_init(tp_solid_moments *moments, const tp_surface *surface) {
  *moments = (tp_solid_moments){.surface = surface, .level = TP_LEVEL_DOUBLE};
  for (int k = 0; k < TP_SOLID_SUM_COUNT; k++) fmpz_init(moments->exact + k);
  tp_solid_sums_near(moments->near, surface);
  tp_centre_of_near(&moments->centre, surface, moments->near);
}

void tp_solid_moments_copy(tp_solid_moments *copy, const tp_solid_moments *moments) {
  *copy = (tp_solid_moments){.surface = moments->surface, .level = moments->level};
  memcpy(copy->near, moments->near, sizeof copy->near);
  for (int k = 0; k < TP_SOLID_SUM_COUNT; k++) fmpz_init_set(copy->exact + k, moments->exact + k);
  if (copy->level == TP_LEVEL_EXACT) {
    tp_centre_of_exact(&copy->centre, copy->surface, copy->exact);
  } else {
    tp_centre_of_near(&copy->centre, copy->surface, copy->near);
  }
}

void tp_solid_moments_climb(tp_solid_moments *moments) {
  if (moments->level == TP_LEVEL_EXACT) return;
  moments->level = TP_LEVEL_EXACT;
  tp_centre_clear(&moments->centre);
  tp_solid_sums_exact(moments->exact, moments->surface, TP_SOLID_SUM_COUNT);
  tp_centre_of_exact(&moments->centre, moments->surface, moments->exact);
}

void tp_solid_moments_clear(tp_solid_moments *moments) {
  for (int k = 0; k < TP_SOLID_SUM_COUNT; k++) fmpz_clear(moments->exact + k);
  tp_centre_clear(&moments->centre);
}

tp_status tp_solid_moments_check(tp_solid_moments *moments, tp_message *message) {
  int sign = tp_near_sign(moments->near[TP_SOLID_V6]);
  if (sign == 0) {
    tp_solid_moments_climb(moments);
    sign = fmpz_sgn(moments->exact + TP_SOLID_V6);
  }
  if (sign > 0) return TP_OK;
  char name[TP_SURFACE_NAME];
  const tp_place place = tp_surface_place(moments->surface, 0);
  return sign == 0
             ? tp_refuse(message, TP_FAULT_GEOMETRY, place,
                         "the surface is flat: what its triangles enclose has no volume; a solid "
                         "needs one")
             : tp_refuse(message, TP_FAULT_GEOMETRY, place,
                         "the surface is inside out: %s and all others run clockwise seen from "
                         "outside; turn the faces of the mesh round",
                         tp_surface_name(name, moments->surface, 0));
}

bool tp_solid_moments_told(const tp_solid_moments *moments) {
  static const double accuracy = 1e-11;
  if (moments->level == TP_LEVEL_EXACT) return true;
  bool told = tp_near_tells(moments->near[TP_SOLID_V6], accuracy);
  const double volume = moments->near[TP_SOLID_V6].value;
  for (int k = TP_SOLID_X24; k < TP_SOLID_SUM_COUNT; k++) {
    if (!(moments->near[k].error <= accuracy * volume)) told = false;
  }
  return told;
}

/* ---- results -----------------------------------------------------------------------------------
 */

/* A sum in lattice units. */
static void set_sum(arb_t sum, const tp_solid_moments *moments, int k) {
  const int powers = k == TP_SOLID_V6 ? 3 : k < TP_SOLID_XX120 ? 4 : 5;
  if (moments->level == TP_LEVEL_EXACT) {
    arb_set_fmpz(sum, moments->exact + k);
    return;
  }
  tp_ball_set_bounded(sum, moments->near[k].value, moments->near[k].error);
  arb_mul_2exp_si(sum, sum, powers * moments->surface->exponent);
}

/* times (metres per step)^power */
static tp_bounded in_metres(const arb_t number, const fmpq_t step, int power) {
  arb_t factor, metres;
  arb_init(factor);
  arb_init(metres);
  arb_set_fmpq(factor, step, BITS);
  arb_pow_ui(factor, factor, (ulong)power, BITS);
  arb_mul(metres, number, factor, BITS);
  const tp_bounded result = tp_ball_bounded(metres);
  arb_clear(factor);
  arb_clear(metres);
  return result;
}

static void tell_centroid(tp_solid *solid, const tp_surface *surface, const arb_struct *centre,
                          const fmpq_t step) {
  arb_t at;
  arb_init(at);
  for (int k = 0; k < 3; k++) {
    arb_add_fmpz(at, centre + k, surface->origin[k], ARF_PREC_EXACT);
    solid->centroid_m[k] = in_metres(at, step, 1);
  }
  arb_clear(at);
}

/* int (x - X)(y - Y) = XY120 / 120 - V X Y */
static void tell_inertia(tp_solid *solid, const tp_solid_moments *moments, const arb_t volume,
                         const arb_struct *centre, const fmpq_t step) {
  arb_t sum, product;
  arb_init(sum);
  arb_init(product);
  for (int k = 0; k < 6; k++) {
    set_sum(sum, moments, TP_SOLID_XX120 + k);
    arb_div_ui(sum, sum, 120, 2 * BITS);
    arb_mul(product, centre + tp_solid_axes[k][0], centre + tp_solid_axes[k][1], 2 * BITS);
    arb_mul(product, product, volume, 2 * BITS);
    arb_sub(sum, sum, product, 2 * BITS);
    solid->inertia_m5[k] = in_metres(sum, step, 5);
  }
  arb_clear(sum);
  arb_clear(product);
}

static void tell_weight(tp_solid *solid, const arb_t volume, const fmpq_t step,
                        const fmpq_t unit_weight) {
  static const ulong newtons = 1000; /* of a kilonewton */
  arb_t weight;
  arb_init(weight);
  arb_set_fmpq(weight, unit_weight, BITS);
  arb_mul_ui(weight, weight, newtons, BITS);
  arb_mul(weight, weight, volume, BITS);
  solid->weight_n = in_metres(weight, step, 3);
  arb_clear(weight);
}

void tp_solid_moments_tell(tp_solid *solid, const tp_solid_moments *moments,
                           const fmpq_t metres_per_unit, const fmpq_t unit_weight) {
  arb_t volume;
  arb_struct centre[3];
  fmpq_t step;
  arb_init(volume);
  fmpq_init(step);
  fmpq_div_fmpz(step, metres_per_unit, moments->surface->divisor);
  set_sum(volume, moments, TP_SOLID_V6);
  for (int k = 0; k < 3; k++) {
    arb_init(centre + k);
    set_sum(centre + k, moments, TP_SOLID_X24 + k);
    arb_div(centre + k, centre + k, volume, 2 * BITS);
    arb_div_ui(centre + k, centre + k, 4, 2 * BITS);
  }
  arb_div_ui(volume, volume, 6, 2 * BITS);
  solid->level = moments->level;
  solid->volume_m3 = in_metres(volume, step, 3);
  tell_centroid(solid, moments->surface, centre, step);
  tell_inertia(solid, moments, volume, centre, step);
  if (solid->has_weight) tell_weight(solid, volume, step, unit_weight);
  for (int k = 0; k < 3; k++) arb_clear(centre + k);
  arb_clear(volume);
  fmpq_clear(step);
}
