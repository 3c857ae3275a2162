/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Loads that turn with the tilt as the weight does, over the weight W and the cosine: k_h W and
 * k_v W at the centroid; water of height h along the face, g h^2 / 2 at h / 3 over the heel, and
 * its uplift g h L / 2 at L / 3 from there; surcharges, weights at the middle of their lines
 * (load/seismic.c, water.c, surcharge.c). The thickness is a factor of all of them but those of the
 * earthquake, and W one of these, so that it cancels. */

#include "case_filter/load_plan.h"

#include "evaluation/loaded.h"
#include "number/ball.h"

#include <math.h>

static const tp_near zero = {0, 0};

const char *tp_load_number_key(tp_load_number number) {
  static const char *const keys[TP_LOAD_NUMBERS] = {
      "loads.seismic.horizontal", "loads.seismic.vertical", "loads.water.height",
      "loads.water.unit_weight_kn_m3", "block.unit_weight_kn_m3"};
  return keys[number];
}

/* ---- which scenes ------------------------------------------------------------------------------
 */

/* Water of a height that rises along the face as the table turns. */
static bool water_fits(const tp_water_description *water) {
  return !water->given || !(tp_water_is_sited(water) || water->stays_level || water->lifts_alone ||
                            water->ice_kpa.given || water->ice_thickness.given);
}

bool tp_load_plan_fits(const tp_scene *scene) {
  const tp_loads_description *loads = &scene->loads;
  return water_fits(&loads->water) && loads->pressure_count == 0 && loads->support_count == 0 &&
         loads->anchor_count == 0 && !loads->bond_kpa.given && !loads->cohesion_kpa.given &&
         (!loads->direction_given || loads->direction == TP_SEISMIC_DOWN_DIP) &&
         scene->base.beyond_cosine == NULL;
}

bool tp_load_plan_knows_outline(const tp_load_plan *plan) {
  return plan->has_water || plan->surcharge_count > 0;
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
  const fmpq *values[TP_LOAD_NUMBERS] = {
      loads->horizontal.value, loads->vertical.value, loads->water.height.value,
      loads->water.unit_weight_kn_m3.value, scene->block.unit_weight_kn_m3.value};
  for (int k = 0; k < TP_LOAD_NUMBERS; k++) plan->numbers[k] = near_of(values[k]);
}

bool tp_load_plan_init(tp_load_plan *plan, const tp_evaluation *e, const tp_onset_asked *asked,
                       tp_direction towards) {
  const tp_problem *problem = e->problem;
  const tp_scene *scene = problem->scene;
  const tp_loads_description *loads = &scene->loads;
  plan->called_for = tp_loads_are_called_for(loads);
  plan->shakes = loads->horizontal.given || loads->vertical.given;
  plan->has_water = loads->water.given;
  plan->lifts = loads->water.given && loads->water.uplift;
  plan->surcharge_count = (int)loads->surcharge_count;
  plan_numbers(plan, scene);
  /* the weight, the earthquake, water and its uplift are up to four */
  if (loads->surcharge_count > TP_FILTER_LOADS - 4) return false;
  if (!tp_load_plan_knows_outline(plan)) return true;
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  find_centroid(x, y, e, asked, towards);
  plan->weight_kn_m = weight_of(e);
  plan->metres_per_unit = near_of(problem->lattice.step_m);
  plan->metres_per_length = near_of(scene->metres_per_unit);
  if (plan->has_water) plan_water(plan, problem, x, y, towards);
  for (int k = 0; k < plan->surcharge_count; k++) {
    plan_surcharge(plan->surcharges + k, loads->surcharges + k, scene, x, y, towards);
  }
  arb_clear(x);
  arb_clear(y);
  return true;
}

/* ---- a sample ----------------------------------------------------------------------------------
 */

/* (k_h, -k_v) - t (k_v, k_h) */
static bool add_earthquake(tp_filter_loads *loads, tp_near horizontal, tp_near vertical) {
  const tp_filter_load own = {
      {horizontal, tp_near_neg(vertical), zero},
      {tp_near_neg(vertical), tp_near_neg(horizontal), zero},
  };
  return tp_filter_loads_add(loads, &own);
}

/* A moment in metres in the unit of the shape. */
static tp_near in_units(tp_near moment, const tp_load_plan *plan) {
  return tp_near_is_zero(moment) ? moment : tp_near_div(moment, plan->metres_per_unit);
}

/* Of the water, over the weight: g h / 2 a metre of length. */
static bool add_water(tp_filter_loads *loads, const tp_load_plan *plan,
                      const tp_near numbers[TP_LOAD_NUMBERS], tp_near weight) {
  static const tp_near half = {0.5, 0}, three = {3, 0};
  const tp_near height = tp_near_times(numbers[TP_NUMBER_WATER_HEIGHT], plan->metres_per_length);
  if (tp_near_sign(tp_near_minus(plan->top, height)) <= 0) return false;
  const tp_near product =
      tp_near_times(tp_near_times(numbers[TP_NUMBER_WATER_WEIGHT], height), half);
  const tp_near head = tp_near_is_zero(product) ? zero : tp_near_div(product, weight);
  const tp_near push = tp_near_times(head, height);
  const tp_near over = tp_near_plus(plan->heel_y, tp_near_div(height, three));
  const tp_filter_load face = {{push, zero, in_units(tp_near_neg(tp_near_times(over, push)), plan)},
                               {zero, zero, zero}};
  if (!tp_filter_loads_add(loads, &face)) return false;
  if (!plan->lifts) return true;
  const tp_near lift = tp_near_times(head, plan->joint);
  const tp_near x = tp_near_minus(plan->heel_x, tp_near_div(plan->joint, three));
  const tp_filter_load uplift = {
      {zero, tp_near_neg(lift), in_units(tp_near_neg(tp_near_times(x, lift)), plan)},
      {zero, zero, zero}};
  return tp_filter_loads_add(loads, &uplift);
}

/* A weight beside the centroid. */
static bool add_surcharge(tp_filter_loads *loads, const tp_load_plan *plan,
                          const tp_planned_surcharge *own, tp_near weight) {
  const tp_near share = tp_near_is_zero(own->kn_m) ? zero : tp_near_div(own->kn_m, weight);
  const tp_filter_load load = {
      {zero, share, in_units(tp_near_times(own->x, share), plan)},
      {share, zero, in_units(tp_near_neg(tp_near_times(own->y, share)), plan)}};
  return tp_filter_loads_add(loads, &load);
}

/* That of the scene, times the unit weight over that of the scene. */
static tp_near weight_with(const tp_load_plan *plan, const tp_near numbers[TP_LOAD_NUMBERS]) {
  const tp_near own = numbers[TP_NUMBER_UNIT_WEIGHT], given = plan->numbers[TP_NUMBER_UNIT_WEIGHT];
  if (own.value == given.value && own.error == given.error) return plan->weight_kn_m;
  return tp_near_div(tp_near_mul(plan->weight_kn_m, own), given);
}

/* An earthquake beyond this is none that a filter has been tried with. */
static bool is_moderate(tp_near share) {
  return fabs(share.value) <= 10;
}

bool tp_load_plan_evaluate(tp_filter_loads *loads, const tp_load_plan *plan,
                           const tp_near numbers[TP_LOAD_NUMBERS]) {
  tp_filter_loads_init(loads);
  loads->called_for = plan->called_for;
  const tp_near horizontal = numbers[TP_NUMBER_HORIZONTAL], vertical = numbers[TP_NUMBER_VERTICAL];
  if (plan->shakes && !(is_moderate(horizontal) && is_moderate(vertical) &&
                        add_earthquake(loads, horizontal, vertical))) {
    return false;
  }
  if (!tp_load_plan_knows_outline(plan)) return true;
  const tp_near weight = weight_with(plan, numbers);
  if (tp_near_sign(weight) <= 0) return false;
  if (plan->has_water && !add_water(loads, plan, numbers, weight)) return false;
  for (int k = 0; k < plan->surcharge_count; k++) {
    if (!add_surcharge(loads, plan, plan->surcharges + k, weight)) return false;
  }
  return true;
}
