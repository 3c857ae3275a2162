/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Barton's law, Eq. (8), with JRC given or from Eqs. (9) and (10), in balls: stress at a tilt under
 * the loads, the angle clamped to [phi_r, 70 degrees] (docs/mechanics.md section 8). */

#include "evaluation/friction.h"

#include "evaluation/contact_length.h"
#include "load/setting.h"
#include "number/ball.h"

bool tp_friction_is_load_dependent(const tp_evaluation *e) {
  return e->problem->scene->friction.load_dependent;
}

void tp_friction_stress_when_level(arb_t pascal, const tp_evaluation *e) {
  arb_zero(pascal);
  if (!tp_friction_is_load_dependent(e)) return;
  const tp_scene *scene = e->problem->scene;
  arb_t length;
  arb_init(length);
  if (scene->friction.contact_width.given) {
    arb_set_fmpq(length, scene->friction.contact_width.value, e->rung.bits);
    arb_mul_fmpz(length, length, fmpq_numref(scene->metres_per_unit), e->rung.bits);
    arb_div_fmpz(length, length, fmpq_denref(scene->metres_per_unit), e->rung.bits);
  } else {
    tp_contact_nominal_length(length, e);
    tp_evaluation_to_metres(length, e, 1);
  }
  tp_weight_per_area(pascal, e, length);
  arb_clear(length);
}

/* log10(JCS / sigma), sigma in Pa. */
static void log_strength(arb_t value, const arb_t sigma, const tp_evaluation *e) {
  const long bits = e->rung.bits;
  arb_t ten;
  arb_init(ten);
  arb_set_fmpq(value, e->problem->scene->friction.jcs_mpa.value, bits);
  arb_mul_ui(value, value, TP_KILO * TP_KILO, bits);
  arb_div(value, value, sigma, bits);
  arb_log(value, value, bits);
  arb_const_log10(ten, bits);
  arb_div(value, value, ten, bits);
  arb_clear(ten);
}

/* Given, by Eq. (9), or by Eq. (10) at the stress on level ground. */
static void set_jrc(arb_t jrc, const tp_evaluation *e) {
  const tp_scene *scene = e->problem->scene;
  const tp_friction_description *f = &scene->friction;
  const long bits = e->rung.bits;
  if (f->jrc.given) {
    arb_set_fmpq(jrc, f->jrc.value, bits);
    return;
  }
  arb_t sigma, divisor;
  arb_init(sigma);
  arb_init(divisor);
  if (f->roughness_angle_deg.given) {
    arb_set(sigma, e->weight_per_area_pa);
    arb_set_fmpq(jrc, f->roughness_angle_deg.value, bits);
  } else {
    fmpq_t angle;
    fmpq_init(angle);
    fmpq_sub(angle, f->test_angle_deg.value, scene->friction_angle_deg.value);
    arb_set_fmpq(jrc, angle, bits);
    fmpq_clear(angle);
    arb_set_fmpq(sigma, f->test_stress_kpa.value, bits);
    arb_mul_ui(sigma, sigma, TP_KILO, bits);
  }
  log_strength(divisor, sigma, e);
  arb_div(jrc, jrc, divisor, bits);
  arb_clear(sigma);
  arb_clear(divisor);
}

/* The mean normal stress over that of the weight on level ground: cos(alpha), or what the loads
 * make of it. */
static void stress_ratio(arb_t ratio, const tp_evaluation *e, const arb_t tilt) {
  const long bits = e->rung.bits;
  arb_t sine, cosine;
  arb_init(sine);
  arb_init(cosine);
  tp_ball_sin_cos(sine, cosine, tilt, bits);
  if (e->loaded == NULL) {
    arb_set(ratio, cosine);
  } else {
    tp_trig_evaluate(ratio, &e->loaded->sum.y, sine, cosine, bits);
    arb_div(ratio, ratio, e->loaded->items[0].wrench.y.of + TP_COS, bits); /* both downwards */
  }
  arb_clear(sine);
  arb_clear(cosine);
}

enum { MOST_DEGREES = 70 };

/* phi_r + JRC log10(JCS / sigma), within [phi_r, 70]: asperities crushed by stresses above JCS
 * leave the residual surface, and the formula would take that friction away too. The same where
 * Eq. (10) would put the JRC below zero. */
static void barton_pressed(arb_t degrees, const arb_t sigma, const tp_evaluation *e) {
  const long bits = e->rung.bits;
  arb_t roughness, residual, zero, most;
  arb_init(roughness);
  arb_init(residual);
  arb_init(zero);
  arb_init(most);
  arb_set_fmpq(residual, e->problem->scene->friction_angle_deg.value, bits);
  arb_set_ui(most, MOST_DEGREES);
  log_strength(degrees, sigma, e);
  arb_max(degrees, degrees, zero, bits);
  set_jrc(roughness, e);
  arb_max(roughness, roughness, zero, bits);
  arb_mul(degrees, degrees, roughness, bits);
  arb_add(degrees, degrees, residual, bits);
  arb_min(degrees, degrees, most, bits);
  if (!arb_is_finite(degrees)) { /* a JRC over log10(1): all that is known is the range */
    arb_min(residual, residual, most, bits);
    arb_union(degrees, residual, most, bits);
  }
  arb_clear(roughness);
  arb_clear(residual);
  arb_clear(zero);
  arb_clear(most);
}

/* The most friction where nothing presses; where that is not known, all from what the largest
 * stress gives to that. */
static void barton(arb_t degrees, const arb_t sigma, const tp_evaluation *e) {
  if (arb_is_positive(sigma)) {
    barton_pressed(degrees, sigma, e);
    return;
  }
  arb_set_ui(degrees, MOST_DEGREES);
  if (arb_is_nonpositive(sigma)) return;
  const long bits = e->rung.bits;
  arb_t most, least;
  arf_t end;
  arb_init(most);
  arb_init(least);
  arf_init(end);
  arb_get_ubound_arf(end, sigma, bits);
  arb_set_arf(most, end);
  barton_pressed(least, most, e);
  arb_union(degrees, degrees, least, bits);
  arb_clear(most);
  arb_clear(least);
  arf_clear(end);
}

void tp_friction_stress_at(arb_t pascal, const tp_evaluation *e, const arb_t tilt) {
  arb_t ratio;
  arb_init(ratio);
  stress_ratio(ratio, e, tilt);
  arb_mul(pascal, e->weight_per_area_pa, ratio, e->rung.bits);
  arb_clear(ratio);
}

static bool is_one(const fmpq *divisor) {
  return divisor == NULL || fmpq_is_one(divisor);
}

void tp_friction_divide_tangent(arb_t tangent, const tp_scene *scene, long bits) {
  if (is_one(scene->friction_divisor)) return;
  arb_t own;
  arb_init(own);
  arb_set_fmpq(own, scene->friction_divisor, bits);
  arb_div(tangent, tangent, own, bits);
  arb_clear(own);
}

void tp_friction_divide_angle(arb_t degrees, const tp_scene *scene, long bits) {
  if (is_one(scene->friction_divisor)) return;
  arb_t tangent, one;
  arb_init(tangent);
  arb_init(one);
  arb_one(one);
  tp_friction_tangent(tangent, degrees, bits);
  tp_friction_divide_tangent(tangent, scene, bits);
  if (arb_is_zero(tangent)) {
    arb_zero(degrees);
  } else {
    tp_ball_atan2_degrees(degrees, tangent, one, bits);
  }
  arb_clear(tangent);
  arb_clear(one);
}

bool tp_friction_is_divided(const tp_evaluation *e) {
  return !is_one(e->problem->scene->friction_divisor);
}

const fmpq *tp_friction_exact(const tp_evaluation *e, long facet) {
  if (tp_friction_is_load_dependent(e) || tp_friction_is_divided(e)) return NULL;
  const fmpq *own = tp_friction_own(e->problem, facet);
  return own != NULL ? own : e->problem->scene->friction_angle_deg.value;
}

void tp_friction_at(arb_t degrees, const tp_evaluation *e, const arb_t tilt) {
  const long bits = e->rung.bits;
  if (!tp_friction_is_load_dependent(e)) {
    arb_set_fmpq(degrees, e->problem->scene->friction_angle_deg.value, bits);
    tp_friction_divide_angle(degrees, e->problem->scene, e->rung.bits);
    return;
  }
  arb_t sigma;
  arb_init(sigma);
  tp_friction_stress_at(sigma, e, tilt);
  barton(degrees, sigma, e);
  tp_friction_divide_angle(degrees, e->problem->scene, e->rung.bits);
  arb_clear(sigma);
}

const fmpq *tp_friction_own(const tp_problem *problem, long facet) {
  const tp_facet_friction *f = &problem->friction;
  const long own = f->of_facet != NULL && facet >= 0 ? f->of_facet[facet] : 0;
  return own > 0 ? f->angles[own - 1] : NULL;
}

void tp_friction_of_facet(arb_t degrees, const tp_evaluation *e, long facet, const arb_t tilt) {
  const fmpq *own = tp_friction_own(e->problem, facet);
  if (own != NULL) {
    arb_set_fmpq(degrees, own, e->rung.bits);
    tp_friction_divide_angle(degrees, e->problem->scene, e->rung.bits);
  } else {
    tp_friction_at(degrees, e, tilt);
  }
}

bool tp_friction_take_own(tp_cones *cones, const tp_evaluation *e) {
  const tp_facet_friction *f = &e->problem->friction;
  if (f->count == 0) return true;
  if (!tp_cones_take_own(cones, f->count)) return false;
  arb_t degrees;
  arb_init(degrees);
  for (long k = 0; k < f->count; k++) {
    arb_set_fmpq(degrees, f->angles[k], e->rung.bits);
    tp_friction_tangent(cones->own_friction + k, degrees, e->rung.bits);
    tp_friction_divide_tangent(cones->own_friction + k, e->problem->scene, e->rung.bits);
  }
  arb_clear(degrees);
  return true;
}

void tp_friction_tangent(arb_t tangent, const arb_t degrees, long bits) {
  if (arb_is_zero(degrees) || arb_equal_si(degrees, 45)) {
    arb_set_si(tangent, arb_is_zero(degrees) ? 0 : 1);
    return;
  }
  arb_div_ui(tangent, degrees, 180, bits);
  arb_tan_pi(tangent, tangent, bits);
}

void tp_friction_set_tangent(arb_t tangent, const tp_evaluation *e, const arb_t degrees) {
  if (tp_friction_is_load_dependent(e)) {
    tp_friction_tangent(tangent, degrees, e->rung.bits);
  } else {
    arb_set(tangent, e->friction_tangent);
  }
}

void tp_friction_facet_tangent(arb_t tangent, const tp_evaluation *e, long facet,
                               const arb_t degrees) {
  if (tp_friction_own(e->problem, facet) != NULL) {
    tp_friction_tangent(tangent, degrees, e->rung.bits);
  } else {
    tp_friction_set_tangent(tangent, e, degrees);
  }
}

void tp_friction_tangent_given(arb_t tangent, const tp_evaluation *e) {
  const tp_quantity *given = &e->problem->scene->friction_angle_deg;
  if (!given->given || tp_friction_is_load_dependent(e)) return;
  arb_t degrees;
  arb_init(degrees);
  arb_set_fmpq(degrees, given->value, e->rung.bits);
  tp_friction_tangent(tangent, degrees, e->rung.bits);
  tp_friction_divide_tangent(tangent, e->problem->scene, e->rung.bits);
  arb_clear(degrees);
}
