/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Angles in balls of 128 bits. */

#include "block_system/resultant.h"

#include "number/ball.h"

enum { BITS = 128, RIGHT_ANGLE_DEG = 90 };

bool tp_scene_asks_side(const tp_scene *scene, bool left) {
  if (scene->frame != TP_FRAME_SLOPE) return left ? scene->towards_left : scene->towards_right;
  const tp_loads_description *loads = &scene->loads;
  const bool down_dip = scene->slope.left == left;
  const bool only = loads->direction_given && loads->direction != TP_SEISMIC_BOTH;
  if (!loads->horizontal.given) return down_dip;
  return !only || (loads->direction == TP_SEISMIC_DOWN_DIP) == down_dip;
}

bool tp_scene_needs_side(const tp_scene *scene, bool left) {
  return tp_scene_asks_side(scene, left) ||
         (scene->frame == TP_FRAME_SLOPE && scene->slope.left == left);
}

void tp_scene_side_tilt(fmpq_t degrees, const tp_scene *scene, bool towards_left) {
  fmpq_zero(degrees);
  if (scene->frame == TP_FRAME_SLOPE) {
    fmpq_set(degrees, scene->slope.dip_deg.value);
    if (scene->slope.left != towards_left) fmpq_neg(degrees, degrees);
  } else if (scene->tilt_angle_deg.given) {
    fmpq_set(degrees, scene->tilt_angle_deg.value);
  }
}

void tp_scene_lie(tp_lie *lie, const tp_scene *scene, bool towards_left) {
  fmpq_t degrees;
  fmpq_init(degrees);
  tp_scene_side_tilt(degrees, scene, towards_left);
  tp_lie_tilt(lie, degrees, towards_left);
  tp_lie_measure(lie);
  fmpq_clear(degrees);
}

static void set_tilt(tp_resultant *r, const tp_scene *scene, bool towards_left) {
  fmpq_t degrees;
  fmpq_init(degrees);
  tp_scene_side_tilt(degrees, scene, towards_left);
  arb_set_fmpq(r->tilt_deg, degrees, BITS);
  fmpq_clear(degrees);
}

/* k_h and 1 - k_v; the earthquake as an angle. */
static tp_status set_earthquake(tp_resultant *r, const tp_scene *scene, const tp_resultant_case *of,
                                tp_message *message) {
  const tp_loads_description *loads = &scene->loads;
  arb_one(r->along);
  if (of->is_static) return TP_OK;
  if (loads->horizontal.given) arb_set_fmpq(r->across, loads->horizontal.value, BITS);
  if (loads->vertical.given && of->vertical_acts) {
    arb_set_fmpq(r->along, loads->vertical.value, BITS);
    arb_sub_ui(r->along, r->along, 1, BITS);
    arb_neg(r->along, r->along);
  }
  if (!arb_is_positive(r->along)) {
    return tp_refuse(message, TP_FAULT_RANGE, loads->vertical.place,
                     "with 'vertical' of 1 or more nothing has weight: give less");
  }
  tp_ball_atan2_degrees(r->earthquake_deg, r->across, r->along, BITS);
  return TP_OK;
}

/* Weights at a tilt to the side, of which sine and cosine are given: times 1 - k_v along gravity,
 * and times s along the horizontal. */
static tp_weight_loads loads_at(const tp_resultant *r, const arb_t sine, const arb_t cosine) {
  arb_t part;
  arb_init(part);
  tp_weight_loads own = {.applied = r->applied};
  own.down[0] = tp_ball_near_exact(sine);
  own.down[1] = tp_near_neg(tp_ball_near_exact(cosine));
  arb_mul(part, r->along, sine, BITS);
  own.dead[0] = tp_ball_near_exact(part);
  arb_mul(part, r->along, cosine, BITS);
  own.dead[1] = tp_near_neg(tp_ball_near_exact(part));
  own.live[0] = tp_ball_near_exact(cosine);
  own.live[1] = tp_ball_near_exact(sine);
  if (r->left) {
    own.dead[0] = tp_near_neg(own.dead[0]);
    own.live[0] = tp_near_neg(own.live[0]);
    own.down[0] = tp_near_neg(own.down[0]);
  }
  arb_clear(part);
  return own;
}

tp_weight_loads tp_resultant_at(const tp_resultant *r, double tilt) {
  arb_t angle, sine, cosine;
  arb_init(angle);
  arb_init(sine);
  arb_init(cosine);
  arb_set_d(angle, tilt);
  arb_sin_cos(sine, cosine, angle, BITS);
  const tp_weight_loads own = loads_at(r, sine, cosine);
  arb_clear(angle);
  arb_clear(sine);
  arb_clear(cosine);
  return own;
}

static void set_as_it_lies(tp_resultant *r) {
  arb_t sine, cosine;
  arb_init(sine);
  arb_init(cosine);
  tp_ball_sin_cos(sine, cosine, r->tilt_deg, BITS);
  r->loads = loads_at(r, sine, cosine);
  r->target = tp_ball_near_exact(r->across);
  r->along_normal = 1;
  arb_clear(sine);
  arb_clear(cosine);
}

static void set_along_base(tp_resultant *r) {
  arb_t angle, sine, cosine, size;
  arb_init(angle);
  arb_init(sine);
  arb_init(cosine);
  arb_init(size);
  arb_add(angle, r->tilt_deg, r->earthquake_deg, BITS);
  tp_ball_sin_cos(sine, cosine, angle, BITS);
  arb_hypot(size, r->along, r->across, BITS);
  r->beyond = !arb_is_positive(cosine);
  arb_mul(size, size, cosine, BITS);
  r->along_normal = arf_get_d(arb_midref(size), ARF_RND_NEAR);
  r->loads = tp_weight_loads_tilted(r->left);
  if (!r->beyond) {
    arb_div(sine, sine, cosine, BITS);
    r->target = tp_ball_near_exact(sine);
  }
  arb_clear(angle);
  arb_clear(sine);
  arb_clear(cosine);
  arb_clear(size);
}

tp_status tp_resultant_init(tp_resultant *r, const tp_scene *scene, const tp_resultant_case *of,
                            const tp_applied_load *applied, tp_message *message) {
  const bool towards_left = of->towards_left, is_measured = of->is_measured;
  *r = (tp_resultant){.left = towards_left, .applied = applied};
  arb_init(r->tilt_deg);
  arb_init(r->earthquake_deg);
  arb_init(r->along);
  arb_init(r->across);
  set_tilt(r, scene, towards_left);
  const tp_status status = set_earthquake(r, scene, of, message);
  if (status != TP_OK) {
    tp_resultant_clear(r);
  } else if (is_measured) {
    set_as_it_lies(r);
  } else {
    set_along_base(r);
  }
  return status;
}

void tp_resultant_clear(tp_resultant *r) {
  arb_clear(r->tilt_deg);
  arb_clear(r->earthquake_deg);
  arb_clear(r->along);
  arb_clear(r->across);
}

tp_near tp_resultant_at_rest(const tp_resultant *r, bool is_measured) {
  arb_t sine, cosine;
  tp_near tangent = {0, 0};
  if (is_measured) return tangent;
  arb_init(sine);
  arb_init(cosine);
  tp_ball_sin_cos(sine, cosine, r->tilt_deg, BITS);
  arb_div(sine, sine, cosine, BITS);
  tangent = tp_ball_near_exact(sine);
  arb_clear(sine);
  arb_clear(cosine);
  return tangent;
}

/* The angle with a tangent between the bounds, in degrees. */
static void set_angle(arb_t degrees, double low, double high) {
  arb_t one;
  arf_t bound;
  arb_init(one);
  arf_init(bound);
  arb_one(one);
  arf_set_d(arb_midref(degrees), low);
  arf_set_d(bound, high);
  arb_set_interval_arf(degrees, arb_midref(degrees), bound, BITS);
  tp_ball_atan2_degrees(degrees, degrees, one, BITS);
  arf_clear(bound);
  arb_clear(one);
}

tp_bounded tp_resultant_tilt_deg(const tp_resultant *r, double low, double high) {
  arb_t degrees;
  arb_init(degrees);
  set_angle(degrees, low, high);
  arb_sub(degrees, degrees, r->earthquake_deg, BITS);
  const tp_bounded tilt = tp_ball_bounded(degrees);
  arb_clear(degrees);
  return tilt;
}

/* By the angle of the resultant from the normal. */
static bool acceleration_at(tp_bounded *acceleration, const tp_resultant *r, arb_t degrees) {
  arb_t sine, cosine;
  arb_init(sine);
  arb_init(cosine);
  arb_sub(degrees, degrees, r->tilt_deg, BITS);
  tp_ball_sin_cos(sine, cosine, degrees, BITS);
  const bool known = arb_is_positive(cosine);
  if (known) {
    arb_div(sine, sine, cosine, BITS);
    arb_mul(sine, sine, r->along, BITS);
    *acceleration = tp_ball_bounded(sine);
  }
  arb_clear(sine);
  arb_clear(cosine);
  return known;
}

bool tp_resultant_acceleration(tp_bounded *acceleration, const tp_resultant *r, double low,
                               double high) {
  arb_t degrees;
  arb_init(degrees);
  set_angle(degrees, low, high);
  const bool known = acceleration_at(acceleration, r, degrees);
  arb_clear(degrees);
  return known;
}

bool tp_resultant_acceleration_of(tp_bounded *acceleration, const tp_resultant *r,
                                  double tilt_deg) {
  arb_t degrees;
  arb_init(degrees);
  arb_set_d(degrees, tilt_deg);
  arb_add(degrees, degrees, r->earthquake_deg, BITS);
  const bool known = acceleration_at(acceleration, r, degrees);
  arb_clear(degrees);
  return known;
}
