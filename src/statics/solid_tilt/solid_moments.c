/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sums of the surface in metres about the centroid, by balls that take the bounds of the sums
 * along. */

#include "solid_tilt/solid_moments.h"

#include "number/ball.h"

#include <string.h>

enum { BITS = 192 }; /* of balls: roundings far below what a double shows */

static void start(tp_solid_moments *moments, const tp_surface *surface) {
  *moments = (tp_solid_moments){.surface = surface, .summed = surface, .level = TP_LEVEL_DOUBLE};
  for (int k = 0; k < TP_SOLID_SUM_COUNT; k++) fmpz_init(moments->exact + k);
  fmpz_init_set_ui(moments->multiple, 1);
  fmpz_init(moments->exact_volume6);
}

void tp_solid_moments_init(tp_solid_moments *moments, const tp_surface *surface) {
  start(moments, surface);
  tp_solid_sums_near(moments->near, surface);
  moments->near_volume6 = moments->near[TP_SOLID_V6];
  tp_centre_of_near(&moments->centre, surface, moments->near);
  moments->centre.summed = surface;
}

void tp_solid_moments_lie_on(tp_solid_moments *moments, const tp_surface *surface) {
  moments->surface = surface;
  moments->centre.surface = surface;
}

static bool is_hole(const tp_solid_part_moments *part) {
  return fmpz_is_one(fmpq_denref(part->excess)) && fmpz_equal_si(fmpq_numref(part->excess), -1);
}

/* All numbers of the level exact times `factor`, which makes `multiple` that many times as much. */
static void stretch(tp_solid_moments *m, const fmpz_t factor) {
  for (int k = 0; k < TP_SOLID_SUM_COUNT; k++) fmpz_mul(m->exact + k, m->exact + k, factor);
  fmpz_mul(m->exact_volume6, m->exact_volume6, factor);
  fmpz_mul(m->multiple, m->multiple, factor);
}

/* One part, with sums of its own times `own`: excess times them. */
static void weigh_part(tp_solid_moments *m, const tp_solid_part_moments *part, const fmpz *sums,
                       const fmpz_t own) {
  fmpz_t factor, common;
  fmpz_init(factor);
  fmpz_init(common);
  fmpz_mul(common, own, fmpq_denref(part->excess));
  fmpz_lcm(common, common, m->multiple);
  fmpz_divexact(factor, common, m->multiple);
  stretch(m, factor);
  fmpz_divexact(factor, common, own);
  if (is_hole(part)) fmpz_submul(m->exact_volume6, factor, sums + TP_SOLID_V6);
  fmpz_divexact(factor, factor, fmpq_denref(part->excess));
  fmpz_mul(factor, factor, fmpq_numref(part->excess));
  for (int k = 0; k < TP_SOLID_SUM_COUNT; k++) fmpz_addmul(m->exact + k, factor, sums + k);
  fmpz_clear(factor);
  fmpz_clear(common);
}

/* Of the level exact: of the rock alone, then of each part. */
static void weigh_exact(tp_solid_moments *m) {
  fmpz sums[TP_SOLID_SUM_COUNT];
  fmpz_t own;
  fmpz_init(own);
  for (int k = 0; k < TP_SOLID_SUM_COUNT; k++) fmpz_init(sums + k);
  fmpz_set(m->exact_volume6, m->exact + TP_SOLID_V6);
  for (long n = 0; n < m->part_count; n++) {
    tp_solid_sums_exact(sums, own, m->parts[n].own->surface);
    weigh_part(m, m->parts + n, sums, own);
  }
  for (int k = 0; k < TP_SOLID_SUM_COUNT; k++) fmpz_clear(sums + k);
  fmpz_clear(own);
}

static void weigh_near(tp_solid_moments *m) {
  for (long n = 0; n < m->part_count; n++) {
    const tp_solid_part_moments *part = m->parts + n;
    const double excess = tp_surface_nearest(part->excess);
    const tp_near factor = {excess, fabs(excess) * DBL_EPSILON};
    for (int k = 0; k < TP_SOLID_SUM_COUNT; k++) {
      m->near[k] = tp_near_plus(m->near[k], tp_near_times(factor, part->own->near[k]));
    }
    if (is_hole(part)) {
      m->near_volume6 = tp_near_sub(m->near_volume6, part->own->near[TP_SOLID_V6]);
    }
  }
}

static void take_exact(tp_solid_moments *m) {
  m->level = TP_LEVEL_EXACT;
  weigh_exact(m);
  tp_centre_of_exact(&m->centre, m->surface, m->exact, m->multiple);
}

void tp_solid_moments_weigh(tp_solid_moments *weighed, const tp_solid_moments *moments,
                            const tp_solid_part_moments *parts, long part_count) {
  start(weighed, moments->surface);
  weighed->summed = moments->summed;
  weighed->parts = parts;
  weighed->part_count = part_count;
  memcpy(weighed->near, moments->near, sizeof weighed->near);
  weighed->near_volume6 = moments->near_volume6;
  weigh_near(weighed);
  if (moments->level == TP_LEVEL_EXACT) {
    for (int k = 0; k < TP_SOLID_SUM_COUNT; k++) fmpz_set(weighed->exact + k, moments->exact + k);
    fmpz_set(weighed->multiple, moments->multiple);
    take_exact(weighed);
  } else {
    tp_centre_of_near(&weighed->centre, weighed->surface, weighed->near);
    weighed->centre.summed = part_count == 0 ? weighed->summed : NULL;
  }
}

void tp_solid_moments_climb(tp_solid_moments *moments) {
  if (moments->level == TP_LEVEL_EXACT) return;
  tp_centre_clear(&moments->centre);
  tp_solid_sums_exact(moments->exact, moments->multiple, moments->summed);
  take_exact(moments);
}

void tp_solid_moments_clear(tp_solid_moments *moments) {
  for (int k = 0; k < TP_SOLID_SUM_COUNT; k++) fmpz_clear(moments->exact + k);
  fmpz_clear(moments->multiple);
  fmpz_clear(moments->exact_volume6);
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
                         "outside; turn the faces of the mesh round, or have them turned by "
                         "--repair, in a scene 'repair: true'",
                         tp_surface_name(name, moments->surface, 0));
}

bool tp_solid_moments_told(const tp_solid_moments *moments) {
  static const double accuracy = 1e-11;
  if (moments->level == TP_LEVEL_EXACT) return true;
  bool told = tp_near_tells(moments->near[TP_SOLID_V6], accuracy);
  told = told && tp_near_tells(moments->near_volume6, accuracy);
  const double volume = moments->near[TP_SOLID_V6].value;
  for (int k = TP_SOLID_X24; k < TP_SOLID_SUM_COUNT; k++) {
    if (!(moments->near[k].error <= accuracy * volume)) told = false;
  }
  return told;
}

/* ---- results -----------------------------------------------------------------------------------
 */

/* A number of doubles in lattice units, of so many lengths. */
static void set_near(arb_t number, const tp_solid_moments *moments, tp_near near, int powers) {
  tp_ball_set_bounded(number, near.value, near.error);
  arb_mul_2exp_si(number, number, powers * moments->surface->exponent);
}

/* A sum in lattice units. */
static void set_sum(arb_t sum, const tp_solid_moments *moments, int k) {
  if (moments->level == TP_LEVEL_EXACT) {
    arb_set_fmpz(sum, moments->exact + k);
    arb_div_fmpz(sum, sum, moments->multiple, 2 * BITS);
  } else {
    set_near(sum, moments, moments->near[k], k == TP_SOLID_V6 ? 3 : k < TP_SOLID_XX120 ? 4 : 5);
  }
}

/* The same of the volume without holes. */
static void set_volume(arb_t volume, const tp_solid_moments *moments) {
  if (moments->level == TP_LEVEL_EXACT) {
    arb_set_fmpz(volume, moments->exact_volume6);
    arb_div_fmpz(volume, volume, moments->multiple, 2 * BITS);
  } else {
    set_near(volume, moments, moments->near_volume6, 3);
  }
  arb_div_ui(volume, volume, 6, 2 * BITS);
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

/* int (x - X)(y - Y) = XY120 / 120 - V X Y, of weights times V over their sum. */
static void tell_inertia(tp_solid *solid, const tp_solid_moments *moments, const arb_t volume,
                         const arb_t weighed, const arb_struct *centre, const fmpq_t step) {
  arb_t sum, product;
  arb_init(sum);
  arb_init(product);
  for (int k = 0; k < 6; k++) {
    set_sum(sum, moments, TP_SOLID_XX120 + k);
    arb_div_ui(sum, sum, 120, 2 * BITS);
    arb_mul(product, centre + tp_solid_axes[k][0], centre + tp_solid_axes[k][1], 2 * BITS);
    arb_mul(product, product, weighed, 2 * BITS);
    arb_sub(sum, sum, product, 2 * BITS);
    if (moments->part_count > 0) {
      arb_mul(sum, sum, volume, 2 * BITS);
      arb_div(sum, sum, weighed, 2 * BITS);
    }
    solid->inertia_m5[k] = in_metres(sum, step, 5);
  }
  arb_clear(sum);
  arb_clear(product);
}

static void tell_weight(tp_solid *solid, const arb_t weighed, const fmpq_t step,
                        const fmpq_t unit_weight) {
  static const ulong newtons = 1000; /* of a kilonewton */
  arb_t weight;
  arb_init(weight);
  arb_set_fmpq(weight, unit_weight, BITS);
  arb_mul_ui(weight, weight, newtons, BITS);
  arb_mul(weight, weight, weighed, BITS);
  solid->weight_n = in_metres(weight, step, 3);
  arb_clear(weight);
}

tp_bounded tp_solid_moments_volume(const tp_solid_moments *moments, const fmpq_t metres_per_unit) {
  arb_t volume;
  fmpq_t step;
  arb_init(volume);
  fmpq_init(step);
  fmpq_div_fmpz(step, metres_per_unit, moments->surface->divisor);
  set_volume(volume, moments);
  const tp_bounded told = in_metres(volume, step, 3);
  arb_clear(volume);
  fmpq_clear(step);
  return told;
}

/* int x y / V = XY120 / (20 V6), and X = X24 / (4 V6). */
void tp_solid_moments_inertia(fmpq inertia[6], const tp_solid_moments *moments) {
  const fmpz *sums = moments->exact;
  fmpq_t part;
  fmpz_t weight;
  fmpq_init(part);
  fmpz_init(weight);
  for (int k = 0; k < 6; k++) {
    fmpz_mul_ui(weight, sums + TP_SOLID_V6, 20);
    fmpq_set_fmpz_frac(inertia + k, sums + TP_SOLID_XX120 + k, weight);
    fmpz_mul_ui(weight, sums + TP_SOLID_V6, 4);
    fmpz_mul(fmpq_numref(part), sums + TP_SOLID_X24 + tp_solid_axes[k][0],
             sums + TP_SOLID_X24 + tp_solid_axes[k][1]);
    fmpz_mul(fmpq_denref(part), weight, weight);
    fmpq_canonicalise(part);
    fmpq_sub(inertia + k, inertia + k, part);
  }
  fmpq_clear(part);
  fmpz_clear(weight);
}

void tp_solid_moments_tell(tp_solid *solid, const tp_solid_moments *moments,
                           const fmpq_t metres_per_unit, const fmpq_t unit_weight) {
  arb_t volume, weighed; /* the volume that weighs as much at the rock's unit weight */
  arb_struct centre[3];
  fmpq_t step;
  arb_init(volume);
  arb_init(weighed);
  fmpq_init(step);
  fmpq_div_fmpz(step, metres_per_unit, moments->surface->divisor);
  set_volume(volume, moments);
  set_sum(weighed, moments, TP_SOLID_V6);
  for (int k = 0; k < 3; k++) {
    arb_init(centre + k);
    set_sum(centre + k, moments, TP_SOLID_X24 + k);
    arb_div(centre + k, centre + k, weighed, 2 * BITS);
    arb_div_ui(centre + k, centre + k, 4, 2 * BITS);
  }
  arb_div_ui(weighed, weighed, 6, 2 * BITS);
  solid->level = moments->level;
  solid->volume_m3 = in_metres(volume, step, 3);
  tell_centroid(solid, moments->surface, centre, step);
  tell_inertia(solid, moments, volume, weighed, centre, step);
  if (solid->has_weight) tell_weight(solid, weighed, step, unit_weight);
  for (int k = 0; k < 3; k++) arb_clear(centre + k);
  arb_clear(volume);
  arb_clear(weighed);
  fmpq_clear(step);
}
