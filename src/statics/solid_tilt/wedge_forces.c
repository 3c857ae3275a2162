/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sums over the faces of the shape. */

#include "solid_tilt/wedge_forces.h"

#include "number/ball.h"

enum { BITS = TP_WEDGE_BITS, CRACK = 2, SPARES = 2 };

typedef struct work {
  tp_wedge_forces *forces;
  const tp_wedge_shape *shape;
  const tp_scene *scene;
  arb_struct sum[3], product[3], spares[SPARES];
} work;

static const arb_struct *normal(const work *w, int plane) {
  return w->shape->normals[plane];
}

/* ---- shape -------------------------------------------------------------------------------------
 */

/* Adds p x q to the sum. */
static void add_cross(work *w, int p, int q) {
  tp_wedge_cross(w->product, w->shape->points[p], w->shape->points[q]);
  for (int k = 0; k < 3; k++) arb_add(w->sum + k, w->sum + k, w->product + k, BITS);
}

/* Half of the sum, in square metres. */
static void take_area(work *w, int side) {
  arb_struct *area = w->forces->areas + side;
  tp_wedge_dot(area, w->sum, w->sum);
  arb_sqrt(area, area, BITS);
  for (int k = 0; k < 2; k++) arb_mul(area, area, &w->forces->metres, BITS);
  arb_mul_2exp_si(area, area, -1);
  for (int k = 0; k < 3; k++) arb_zero(w->sum + k);
}

static void set_areas(work *w) {
  for (int joint = 0; joint < 2; joint++) {
    add_cross(w, TP_WEDGE_END_A + joint, TP_WEDGE_BACK_A + joint);
    add_cross(w, TP_WEDGE_BACK_A + joint, TP_WEDGE_DEEP);
    take_area(w, joint);
  }
  add_cross(w, TP_WEDGE_BACK_A, TP_WEDGE_BACK_B);
  add_cross(w, TP_WEDGE_BACK_B, TP_WEDGE_DEEP);
  add_cross(w, TP_WEDGE_DEEP, TP_WEDGE_BACK_A);
  take_area(w, CRACK);
}

/* Adds that of a tetrahedron from the toe. */
static void add_volume(work *w, int p, int q, int r) {
  tp_wedge_cross(w->product, w->shape->points[p], w->shape->points[q]);
  tp_wedge_dot(w->spares, w->product, w->shape->points[r]);
  arb_add(&w->forces->volume, &w->forces->volume, w->spares, BITS);
}

static void set_volume(work *w) {
  arb_struct *volume = &w->forces->volume;
  add_volume(w, TP_WEDGE_END_A, TP_WEDGE_END_B, TP_WEDGE_BACK_B);
  add_volume(w, TP_WEDGE_END_A, TP_WEDGE_BACK_B, TP_WEDGE_BACK_A);
  add_volume(w, TP_WEDGE_BACK_A, TP_WEDGE_BACK_B, TP_WEDGE_DEEP);
  arb_abs(volume, volume);
  arb_div_ui(volume, volume, 6, BITS);
  for (int k = 0; k < 3; k++) arb_mul(volume, volume, &w->forces->metres, BITS);
}

/* ---- forces ------------------------------------------------------------------------------------
 */

/* A sixth of the height, or a third of how deep the crack is below the ground above it. */
static void set_pressure(work *w) {
  const tp_wedge_description *own = &w->scene->solid.wedge;
  const arb_struct *upper = normal(w, TP_WEDGE_UPPER);
  arb_struct *pressure = &w->forces->pressure, *spare = w->spares;
  if (!own->has_water) return;
  if (own->has_crack) {
    tp_wedge_dot(pressure, upper, w->shape->points[TP_WEDGE_BACK_A]);
    tp_wedge_dot(spare, upper, w->shape->points[TP_WEDGE_DEEP]);
    arb_sub(pressure, pressure, spare, BITS);
    arb_div(pressure, pressure, upper + 2, BITS);
    arb_div_ui(pressure, pressure, 3, BITS);
  } else {
    arb_set_fmpq(pressure, own->height.value, BITS);
    arb_div_ui(pressure, pressure, 6, BITS);
  }
  arb_mul(pressure, pressure, &w->forces->metres, BITS);
  arb_set_fmpq(spare, own->water_kn_m3.value, BITS);
  arb_mul(pressure, pressure, spare, BITS);
}

/* The pressure on an area, along its normal times a sign. */
static void add_pressure(work *w, int side, int plane, int sign) {
  arb_mul_si(w->spares, w->forces->areas + side, sign, BITS);
  arb_mul(w->spares, w->spares, &w->forces->pressure, BITS);
  for (int k = 0; k < 3; k++) {
    arb_addmul(w->forces->push + k, w->spares, normal(w, plane) + k, BITS);
  }
}

static void set_weight(work *w) {
  arb_struct *weight = &w->forces->weight, *share = w->spares;
  arb_set_fmpq(weight, w->scene->solid.unit_weight_kn_m3.value, BITS);
  arb_mul(weight, weight, &w->forces->volume, BITS);
  arb_set_fmpq(share, w->scene->loads.vertical.value, BITS);
  arb_sub_ui(share, share, 1, BITS);
  arb_mul(w->forces->push + 2, weight, share, BITS);
}

/* F (cos d sin z, cos d cos z, -sin d) of one that dips by d below the horizontal towards z. */
static void add_bolt(work *w, const tp_anchor_description *bolt) {
  arb_struct *const force = w->spares, *const level = w->spares + 1, *const way = w->product;
  arb_set_fmpq(force, bolt->force_kn.value, BITS);
  tp_ball_sin_cos_degrees(way + 2, level, bolt->dip_deg.value, BITS);
  arb_neg(way + 2, way + 2);
  tp_ball_sin_cos_degrees(way, way + 1, bolt->azimuth_deg.value, BITS);
  for (int k = 0; k < 2; k++) arb_mul(way + k, way + k, level, BITS);
  for (int k = 0; k < 3; k++) arb_addmul(w->forces->push + k, force, way + k, BITS);
}

static void set_push(work *w) {
  set_weight(w);
  for (long k = 0; k < w->scene->loads.anchor_count; k++) {
    add_bolt(w, w->scene->loads.anchors + k);
  }
  add_pressure(w, TP_WEDGE_A, TP_WEDGE_A, 1);
  add_pressure(w, TP_WEDGE_B, TP_WEDGE_B, 1);
  if (!w->shape->has_crack) return;
  /* towards the toe, where the wedge is */
  tp_wedge_dot(w->spares + 1, normal(w, TP_WEDGE_CRACK), w->shape->points[TP_WEDGE_DEEP]);
  add_pressure(w, CRACK, TP_WEDGE_CRACK, arb_is_positive(w->spares + 1) ? -1 : 1);
}

/* ---- all ---------------------------------------------------------------------------------------
 */

static void each(tp_wedge_forces *forces, void (*what)(arb_t number)) {
  what(&forces->metres);
  what(&forces->volume);
  what(&forces->pressure);
  what(&forces->weight);
  for (int k = 0; k < 3; k++) what(forces->areas + k);
  for (int k = 0; k < 3; k++) what(forces->push + k);
}

static void each_spare(work *w, void (*what)(arb_t number)) {
  for (int k = 0; k < 3; k++) what(w->sum + k);
  for (int k = 0; k < 3; k++) what(w->product + k);
  for (int k = 0; k < SPARES; k++) what(w->spares + k);
}

void tp_wedge_forces_init(tp_wedge_forces *forces, const tp_wedge_shape *shape,
                          const tp_scene *scene) {
  work w = {.forces = forces, .shape = shape, .scene = scene};
  each(forces, arb_init);
  each_spare(&w, arb_init);
  arb_set_fmpq(&forces->metres, scene->metres_per_unit, BITS);
  set_areas(&w);
  set_volume(&w);
  set_pressure(&w);
  set_push(&w);
  each_spare(&w, arb_clear);
}

void tp_wedge_forces_clear(tp_wedge_forces *forces) {
  each(forces, arb_clear);
}
