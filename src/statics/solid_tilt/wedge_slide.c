/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Areas and volume of the shape, forces in kilonewtons, and the way that they drive it. */

#include "solid_tilt/wedge_slide.h"

#include "number/ball.h"
#include "solid/surface.h"

enum { BITS = TP_WEDGE_BITS, NEWTONS = 1000 };

/* What has to be cleared together. */
enum {
  PUSH_X, /* R */
  PUSH_Y,
  PUSH_Z,
  SPARE_X,
  SPARE_Y,
  SPARE_Z,
  OTHER_X,
  OTHER_Y,
  OTHER_Z,
  METRE, /* in metres, a length of the scene */
  AREA_A,
  AREA_B,
  AREA_CRACK,
  VOLUME,
  PRESSURE,
  ON_A, /* N */
  ON_B,
  DRIVING, /* S */
  STRENGTH,
  OWN,
  SECOND,
  NUMBERS
};

typedef struct work {
  const tp_wedge_shape *shape;
  const tp_scene *scene;
  tp_solid_wedge *result;
  arb_struct n[NUMBERS];
} work;

static arb_struct *vector(work *w, int first) {
  return w->n + first;
}

static const arb_struct *normal(const work *w, int plane) {
  return w->shape->normals[plane];
}

/* ---- shape -------------------------------------------------------------------------------------
 */

/* Adds p x q to a vector. */
static void add_cross(work *w, const arb_struct p[3], const arb_struct q[3]) {
  tp_wedge_cross(vector(w, OTHER_X), p, q);
  for (int k = 0; k < 3; k++)
    arb_add(w->n + SPARE_X + k, w->n + SPARE_X + k, w->n + OTHER_X + k, BITS);
}

static void set_length(arb_t length, const arb_struct v[3]) {
  tp_wedge_dot(length, v, v);
  arb_sqrt(length, length, BITS);
}

/* Half of the sum, in square metres. */
static void set_area(work *w, int area) {
  set_length(w->n + area, vector(w, SPARE_X));
  arb_mul(w->n + area, w->n + area, w->n + METRE, BITS);
  arb_mul(w->n + area, w->n + area, w->n + METRE, BITS);
  arb_mul_2exp_si(w->n + area, w->n + area, -1);
  for (int k = 0; k < 3; k++) arb_zero(w->n + SPARE_X + k);
}

static void set_areas(work *w) {
  const arb_struct(*p)[3] = w->shape->points;
  for (int joint = 0; joint < 2; joint++) {
    add_cross(w, p[TP_WEDGE_END_A + joint], p[TP_WEDGE_BACK_A + joint]);
    add_cross(w, p[TP_WEDGE_BACK_A + joint], p[TP_WEDGE_DEEP]);
    set_area(w, AREA_A + joint);
  }
  add_cross(w, p[TP_WEDGE_BACK_A], p[TP_WEDGE_BACK_B]);
  add_cross(w, p[TP_WEDGE_BACK_B], p[TP_WEDGE_DEEP]);
  add_cross(w, p[TP_WEDGE_DEEP], p[TP_WEDGE_BACK_A]);
  set_area(w, AREA_CRACK);
}

/* Adds that of a tetrahedron from the toe. */
static void add_volume(work *w, int p, int q, int r) {
  tp_wedge_cross(vector(w, OTHER_X), w->shape->points[p], w->shape->points[q]);
  tp_wedge_dot(w->n + OWN, vector(w, OTHER_X), w->shape->points[r]);
  arb_add(w->n + VOLUME, w->n + VOLUME, w->n + OWN, BITS);
}

static void set_volume(work *w) {
  add_volume(w, TP_WEDGE_END_A, TP_WEDGE_END_B, TP_WEDGE_BACK_B);
  add_volume(w, TP_WEDGE_END_A, TP_WEDGE_BACK_B, TP_WEDGE_BACK_A);
  add_volume(w, TP_WEDGE_BACK_A, TP_WEDGE_BACK_B, TP_WEDGE_DEEP);
  arb_abs(w->n + VOLUME, w->n + VOLUME);
  arb_div_ui(w->n + VOLUME, w->n + VOLUME, 6, BITS);
  for (int k = 0; k < 3; k++) arb_mul(w->n + VOLUME, w->n + VOLUME, w->n + METRE, BITS);
}

/* ---- forces ------------------------------------------------------------------------------------
 */

/* A sixth of the height, or a third of how deep the crack is below the ground above it. */
static void set_pressure(work *w) {
  const tp_wedge_description *own = &w->scene->solid.wedge;
  const arb_struct *upper = normal(w, TP_WEDGE_UPPER);
  if (!own->has_water) return;
  if (own->has_crack) {
    tp_wedge_dot(w->n + PRESSURE, upper, w->shape->points[TP_WEDGE_BACK_A]);
    tp_wedge_dot(w->n + OWN, upper, w->shape->points[TP_WEDGE_DEEP]);
    arb_sub(w->n + PRESSURE, w->n + PRESSURE, w->n + OWN, BITS);
    arb_div(w->n + PRESSURE, w->n + PRESSURE, upper + 2, BITS);
    arb_div_ui(w->n + PRESSURE, w->n + PRESSURE, 3, BITS);
  } else {
    arb_set_fmpq(w->n + PRESSURE, own->height.value, BITS);
    arb_div_ui(w->n + PRESSURE, w->n + PRESSURE, 6, BITS);
  }
  arb_mul(w->n + PRESSURE, w->n + PRESSURE, w->n + METRE, BITS);
  arb_set_fmpq(w->n + OWN, own->water_kn_m3.value, BITS);
  arb_mul(w->n + PRESSURE, w->n + PRESSURE, w->n + OWN, BITS);
}

/* The pressure on an area, along its normal times a sign. */
static void add_pressure(work *w, int area, int plane, int sign) {
  arb_mul_si(w->n + OWN, w->n + area, sign, BITS);
  arb_mul(w->n + OWN, w->n + OWN, w->n + PRESSURE, BITS);
  for (int k = 0; k < 3; k++) {
    arb_addmul(w->n + PUSH_X + k, w->n + OWN, normal(w, plane) + k, BITS);
  }
}

/* The weight, and shares of it towards an azimuth and upwards. */
static void set_weight(work *w) {
  const tp_quantity *towards = &w->scene->loads.azimuth_deg;
  arb_set_fmpq(w->n + OWN, w->scene->solid.unit_weight_kn_m3.value, BITS);
  arb_mul(w->n + OWN, w->n + OWN, w->n + VOLUME, BITS);
  arb_set_fmpq(w->n + SECOND, w->scene->loads.vertical.value, BITS);
  arb_sub_ui(w->n + SECOND, w->n + SECOND, 1, BITS);
  arb_mul(w->n + PUSH_Z, w->n + OWN, w->n + SECOND, BITS);
  if (!towards->given) return;
  tp_ball_sin_cos_degrees(w->n + PUSH_X, w->n + PUSH_Y, towards->value, BITS);
  arb_set_fmpq(w->n + SECOND, w->scene->loads.horizontal.value, BITS);
  arb_mul(w->n + OWN, w->n + OWN, w->n + SECOND, BITS);
  for (int k = 0; k < 2; k++) arb_mul(w->n + PUSH_X + k, w->n + PUSH_X + k, w->n + OWN, BITS);
}

static void set_push(work *w) {
  set_weight(w);
  add_pressure(w, AREA_A, TP_WEDGE_A, 1);
  add_pressure(w, AREA_B, TP_WEDGE_B, 1);
  if (!w->shape->has_crack) return;
  /* towards the toe, where the wedge is */
  tp_wedge_dot(w->n + OWN, normal(w, TP_WEDGE_CRACK), w->shape->points[TP_WEDGE_DEEP]);
  add_pressure(w, AREA_CRACK, TP_WEDGE_CRACK, arb_is_positive(w->n + OWN) ? -1 : 1);
}

/* ---- ways --------------------------------------------------------------------------------------
 */

/* Adds c A + N tan(phi) of a joint. */
static void add_strength(work *w, int joint) {
  const tp_wedge_description *own = &w->scene->solid.wedge;
  if (own->cohesion_kpa[joint].given) {
    arb_set_fmpq(w->n + OWN, own->cohesion_kpa[joint].value, BITS);
    arb_addmul(w->n + STRENGTH, w->n + OWN, w->n + AREA_A + joint, BITS);
  }
  tp_ball_sin_cos_degrees(w->n + OWN, w->n + SECOND, own->friction_deg[joint].value, BITS);
  arb_div(w->n + OWN, w->n + OWN, w->n + SECOND, BITS);
  arb_addmul(w->n + STRENGTH, w->n + OWN, w->n + ON_A + joint, BITS);
}

static void set_on_both(work *w) {
  tp_wedge_dot(w->n + OWN, normal(w, TP_WEDGE_A), normal(w, TP_WEDGE_B));
  for (int joint = 0; joint < 2; joint++) {
    arb_struct *on = w->n + ON_A + joint;
    tp_wedge_dot(on, vector(w, PUSH_X), normal(w, 1 - joint));
    arb_mul(on, on, w->n + OWN, BITS);
    tp_wedge_dot(w->n + SECOND, vector(w, PUSH_X), normal(w, joint));
    arb_sub(on, on, w->n + SECOND, BITS);
  }
  arb_mul(w->n + OWN, w->n + OWN, w->n + OWN, BITS);
  arb_sub_ui(w->n + OWN, w->n + OWN, 1, BITS);
  arb_neg(w->n + OWN, w->n + OWN);
  for (int joint = 0; joint < 2; joint++) {
    arb_div(w->n + ON_A + joint, w->n + ON_A + joint, w->n + OWN, BITS);
  }
  tp_wedge_dot(w->n + DRIVING, vector(w, PUSH_X), w->shape->line);
  arb_neg(w->n + DRIVING, w->n + DRIVING);
}

/* Down a joint; does that take it away from the other one, and press on this? */
static bool slides_on(work *w, int joint) {
  arb_t on;
  arb_init(on);
  tp_wedge_dot(on, vector(w, PUSH_X), normal(w, joint));
  for (int k = 0; k < 3; k++) {
    arb_mul(w->n + SPARE_X + k, on, normal(w, joint) + k, BITS);
    arb_sub(w->n + SPARE_X + k, w->n + PUSH_X + k, w->n + SPARE_X + k, BITS);
  }
  tp_wedge_dot(w->n + OWN, vector(w, SPARE_X), normal(w, 1 - joint));
  const bool is = arb_is_negative(on) && arb_is_positive(w->n + OWN);
  if (is) {
    arb_neg(w->n + ON_A + joint, on);
    arb_zero(w->n + ON_A + 1 - joint);
    set_length(w->n + DRIVING, vector(w, SPARE_X));
  }
  arb_clear(on);
  return is;
}

static void set_factor(work *w, bool on_a, bool on_b) {
  tp_solid_wedge *own = w->result;
  own->slides_on = on_a && on_b ? "a and b" : on_a ? "a" : "b";
  if (on_a) add_strength(w, 0);
  if (on_b) add_strength(w, 1);
  if (!arb_is_nonzero(w->n + DRIVING)) {
    own->verdict = arb_is_positive(w->n + STRENGTH) ? TP_STANDS : TP_MECHANISM_UNDECIDED;
    return;
  }
  /* up the line or down it: strength acts against either */
  arb_abs(w->n + SECOND, w->n + DRIVING);
  arb_sub(w->n + OWN, w->n + STRENGTH, w->n + SECOND, BITS);
  own->verdict = arb_is_positive(w->n + OWN)   ? TP_STANDS
                 : arb_is_negative(w->n + OWN) ? TP_SLIDES
                                               : TP_MECHANISM_UNDECIDED;
  arb_div(w->n + OWN, w->n + STRENGTH, w->n + SECOND, BITS);
  own->has_fos = true;
  own->fos = tp_ball_bounded(w->n + OWN);
}

static void set_way(work *w) {
  set_on_both(w);
  if (arb_is_nonnegative(w->n + ON_A) && arb_is_nonnegative(w->n + ON_B)) {
    set_factor(w, true, true);
  } else if (slides_on(w, TP_WEDGE_A)) {
    set_factor(w, true, false);
  } else if (slides_on(w, TP_WEDGE_B)) {
    set_factor(w, false, true);
  } else {
    const bool certain = arb_is_negative(w->n + ON_A) || arb_is_negative(w->n + ON_B);
    w->result->slides_on = "neither";
    w->result->verdict = certain ? TP_LEAVES_BASE : TP_MECHANISM_UNDECIDED;
    w->result->has_fos = certain; /* nothing holds it */
  }
}

/* ---- all ---------------------------------------------------------------------------------------
 */

static tp_bounded in_newtons(work *w, const arb_struct *kilonewtons) {
  arb_mul_ui(w->n + OWN, kilonewtons, NEWTONS, BITS);
  return tp_ball_bounded(w->n + OWN);
}

static double number_of(const tp_quantity *quantity) {
  return quantity->given ? tp_surface_nearest(quantity->value) : 0;
}

static void tell_shape(work *w) {
  const tp_wedge_description *given = &w->scene->solid.wedge;
  for (int k = 0; k < TP_WEDGE_PLANES; k++) {
    tp_wedge_side *side = w->result->sides + k;
    side->dip_deg = number_of(&given->planes[k].dip_deg);
    side->dip_direction_deg = number_of(&given->planes[k].dip_direction_deg);
    if (k > TP_WEDGE_B) continue;
    side->friction_angle_deg = number_of(given->friction_deg + k);
    side->cohesion_kpa = number_of(given->cohesion_kpa + k);
  }
  for (int k = 0; k < TP_WEDGE_POINTS; k++) {
    double at[3];
    for (int i = 0; i < 3; i++) {
      arb_mul(w->n + OWN, w->shape->points[k] + i, w->n + METRE, BITS);
      at[i] = tp_ball_bounded(w->n + OWN).value;
    }
    w->result->corners[k] = (tp_wedge_corner){at[0], at[1], at[2]};
  }
}

static void tell(work *w) {
  tp_solid_wedge *own = w->result;
  const arb_struct *line = w->shape->line;
  own->has_crack = w->shape->has_crack;
  own->has_water = w->scene->solid.wedge.has_water;
  own->crack_area_m2 = tp_ball_bounded(w->n + AREA_CRACK);
  own->water_kpa = tp_ball_bounded(w->n + PRESSURE);
  for (int joint = 0; joint < 2; joint++) {
    own->areas_m2[joint] = tp_ball_bounded(w->n + AREA_A + joint);
    own->normal_n[joint] = in_newtons(w, w->n + ON_A + joint);
  }
  own->driving_n = in_newtons(w, w->n + DRIVING);
  arb_hypot(w->n + OWN, line, line + 1, BITS);
  tp_ball_atan2_degrees(w->n + SECOND, line + 2, w->n + OWN, BITS);
  own->plunge_deg = tp_ball_bounded(w->n + SECOND);
  arb_neg(w->n + OWN, line);
  arb_neg(w->n + SECOND, line + 1);
  tp_ball_atan2_degrees(w->n + OWN, w->n + OWN, w->n + SECOND, BITS);
  if (arb_is_negative(w->n + OWN)) arb_add_ui(w->n + OWN, w->n + OWN, 360, BITS);
  own->trend_deg = tp_ball_bounded(w->n + OWN);
}

void tp_wedge_slide(tp_solid_wedge *result, const tp_wedge_shape *shape, const tp_scene *scene) {
  work w = {.shape = shape, .scene = scene, .result = result};
  for (int k = 0; k < NUMBERS; k++) arb_init(w.n + k);
  arb_set_fmpq(w.n + METRE, scene->metres_per_unit, BITS);
  set_areas(&w);
  set_volume(&w);
  set_pressure(&w);
  set_push(&w);
  set_way(&w);
  tell(&w);
  tell_shape(&w);
  for (int k = 0; k < NUMBERS; k++) arb_clear(w.n + k);
}
