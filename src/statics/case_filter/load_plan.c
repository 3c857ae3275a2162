/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Loads that turn with the tilt as the weight does, over the weight W and the cosine: k_h W and
 * k_v W at the centroid; water of height h along the face, g h^2 / 2 at h / 3 over the heel, and
 * its uplift g h L / 2 at L / 3 from there; surcharges, weights at the middle of their lines
 * (load/seismic.c, water.c, surcharge.c). The thickness is a factor of all of them but those of the
 * earthquake, and W one of these, so that it cancels. Anchors, supports, pressures and the water of
 * a site stay with the block: their wrenches are those of load/loads.h. */

#include "case_filter/load_plan.h"

#include "evaluation/loaded.h"
#include "number/ball.h"

#include <math.h>

static const tp_near zero = {0, 0};

const char *tp_load_number_key(tp_load_number number) {
  static const char *const keys[TP_LOAD_NUMBERS] = {
      "loads.seismic.horizontal", "loads.seismic.vertical",
      "loads.water.height",       "loads.water.unit_weight_kn_m3",
      "block.unit_weight_kn_m3",  "loads.anchors.1.force_kn",
      "loads.cohesion_kpa",       "loads.bond_kpa"};
  return keys[number];
}

/* ---- which scenes ------------------------------------------------------------------------------
 */

/* Water of a height that rises along the face as the table turns, or that of a site. */
static bool water_fits(const tp_water_description *water) {
  return !water->given || tp_water_is_sited(water) || !(water->stays_level || water->lifts_alone);
}

bool tp_load_plan_fits(const tp_scene *scene) {
  const tp_loads_description *loads = &scene->loads;
  return water_fits(&loads->water) &&
         (!loads->direction_given || loads->direction == TP_SEISMIC_DOWN_DIP) &&
         scene->base.beyond_cosine == NULL;
}

bool tp_load_plan_knows_outline(const tp_load_plan *plan) {
  return plan->has_water || plan->surcharge_count > 0 || plan->staying.count > 0;
}

/* ---- once --------------------------------------------------------------------------------------
 */

enum { BITS = 256 };

static tp_near near_of(const fmpq_t value) {
  arb_t ball;
  if (fmpq_is_zero(value)) return zero;
  arb_init(ball);
  arb_set_fmpq(ball, value, BITS);
  const tp_near near = tp_ball_near(ball);
  arb_clear(ball);
  return near;
}

/* The centroid in metres, x mirrored towards the right. */
static void find_centroid(arb_t x, arb_t y, const tp_evaluation *e, const tp_onset_asked *asked,
                          tp_direction towards) {
  const tp_motion_question *q = &asked->question;
  arb_div(x, q->x, q->scale, BITS);
  arb_div(y, q->y, q->scale, BITS);
  tp_ball_mirror(x, towards);
  tp_loaded_metres(x, y, e);
  tp_ball_mirror(x, towards);
}

/* A point in metres, from there. */
static void from_centroid(tp_near *own_x, tp_near *own_y, const fmpq_t x, const fmpq_t y,
                          const arb_t centroid_x, const arb_t centroid_y, tp_direction towards) {
  arb_t ball;
  arb_init(ball);
  arb_set_fmpq(ball, x, BITS);
  tp_ball_mirror(ball, towards);
  arb_sub(ball, ball, centroid_x, BITS);
  *own_x = tp_ball_near(ball);
  arb_set_fmpq(ball, y, BITS);
  arb_sub(ball, ball, centroid_y, BITS);
  *own_y = tp_ball_near(ball);
  arb_clear(ball);
}

static void plan_water(tp_load_plan *plan, const tp_problem *problem, const arb_t centroid_x,
                       const arb_t centroid_y, tp_direction towards) {
  const tp_lattice *l = &problem->lattice;
  const int heel = towards == TP_TOWARDS_LEFT ? 1 : 0;
  const tp_base_joint *joint = &problem->joint;
  fmpq_t length, top;
  fmpq_init(length);
  fmpq_init(top);
  from_centroid(&plan->heel_x, &plan->heel_y, joint->x + heel, joint->y + heel, centroid_x,
                centroid_y, towards);
  fmpq_sub(length, joint->x + 1, joint->x);
  plan->joint = near_of(length);
  long highest = 0;
  for (long k = 1; k < l->start[1]; k++) {
    if (fmpz_cmp(l->y + k, l->y + highest) > 0) highest = k;
  }
  tp_lattice_metres_y(top, l, l->y + highest);
  fmpq_sub(top, top, joint->y + heel);
  plan->top = near_of(top);
  fmpq_clear(length);
  fmpq_clear(top);
}

/* Its middle, and q l. */
static void plan_surcharge(tp_planned_surcharge *own, const tp_line_load *load,
                           const tp_scene *scene, const arb_t centroid_x, const arb_t centroid_y,
                           tp_direction towards) {
  fmpq_t x, y, dx, dy;
  arb_t length, rise;
  fmpq_init(x);
  fmpq_init(y);
  fmpq_init(dx);
  fmpq_init(dy);
  arb_init(length);
  arb_init(rise);
  fmpq_add(x, load->x0.value, load->x1.value);
  fmpq_add(y, load->y0.value, load->y1.value);
  fmpq_div_2exp(x, x, 1);
  fmpq_div_2exp(y, y, 1);
  fmpq_mul(x, x, scene->metres_per_unit);
  fmpq_mul(y, y, scene->metres_per_unit);
  from_centroid(&own->x, &own->y, x, y, centroid_x, centroid_y, towards);
  fmpq_sub(dx, load->x1.value, load->x0.value);
  fmpq_sub(dy, load->y1.value, load->y0.value);
  fmpq_mul(dx, dx, scene->metres_per_unit);
  fmpq_mul(dy, dy, scene->metres_per_unit);
  arb_set_fmpq(length, dx, BITS);
  arb_set_fmpq(rise, dy, BITS);
  arb_hypot(length, length, rise, BITS);
  arb_set_fmpq(rise, load->first_kpa.value, BITS);
  arb_mul(length, length, rise, BITS);
  own->kn_m = arb_is_zero(length) ? zero : tp_ball_near(length);
  fmpq_clear(x);
  fmpq_clear(y);
  fmpq_clear(dx);
  fmpq_clear(dy);
  arb_clear(length);
  arb_clear(rise);
}

/* kN, a metre of thickness. */
static tp_near weight_of(const tp_evaluation *e) {
  arb_t weight, thickness;
  fmpq_t metres;
  arb_init(weight);
  arb_init(thickness);
  fmpq_init(metres);
  tp_evaluation_weight(weight, e);
  tp_problem_thickness(metres, e->problem);
  arb_set_fmpq(thickness, metres, BITS);
  arb_mul_ui(thickness, thickness, TP_KILO, BITS);
  arb_div(weight, weight, thickness, BITS);
  const tp_near near = tp_ball_near(weight);
  arb_clear(weight);
  arb_clear(thickness);
  fmpq_clear(metres);
  return near;
}

static void plan_numbers(tp_load_plan *plan, const tp_scene *scene) {
  const tp_loads_description *loads = &scene->loads;
  const fmpq *values[TP_LOAD_NUMBERS] = {loads->horizontal.value,
                                         loads->vertical.value,
                                         loads->water.height.value,
                                         loads->water.unit_weight_kn_m3.value,
                                         scene->block.unit_weight_kn_m3.value,
                                         loads->anchor_count > 0 ? loads->anchors[0].force_kn.value
                                                                 : NULL,
                                         loads->cohesion_kpa.value,
                                         loads->bond_kpa.value};
  for (int k = 0; k < TP_LOAD_NUMBERS; k++) {
    plan->numbers[k] = values[k] != NULL ? near_of(values[k]) : zero;
  }
}

bool tp_load_plan_init(tp_load_plan *plan, const tp_evaluation *e, const tp_onset_asked *asked,
                       tp_direction towards, slong unit) {
  const tp_problem *problem = e->problem;
  const tp_scene *scene = problem->scene;
  const tp_loads_description *loads = &scene->loads;
  const bool sited = loads->water.given && tp_water_is_sited(&loads->water);
  plan->called_for = tp_loads_are_called_for(loads);
  plan->shakes = loads->horizontal.given || loads->vertical.given;
  plan->has_water = loads->water.given && !sited;
  plan->lifts = plan->has_water && loads->water.uplift;
  plan->surcharge_count = (int)loads->surcharge_count;
  plan_numbers(plan, scene);
  /* the weight, the earthquake, water and its uplift are up to four */
  if (loads->surcharge_count > TP_FILTER_LOADS - 4) return false;
  if (!plan->called_for) return true;
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  find_centroid(x, y, e, asked, towards);
  plan->weight_kn_m = weight_of(e);
  arb_t metres;
  arb_init(metres);
  arb_set_fmpq(metres, problem->lattice.step_m, BITS);
  arb_mul_2exp_si(metres, metres, unit);
  plan->metres_per_unit = tp_ball_near(metres);
  plan->metres_per_length = near_of(scene->metres_per_unit);
  if (plan->has_water) plan_water(plan, problem, x, y, towards);
  for (int k = 0; k < plan->surcharge_count; k++) {
    plan_surcharge(plan->surcharges + k, loads->surcharges + k, scene, x, y, towards);
  }
  const bool fits = tp_staying_plan_init(&plan->staying, e, towards, x, y, metres);
  arb_clear(metres);
  arb_clear(x);
  arb_clear(y);
  return fits;
}
