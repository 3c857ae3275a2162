/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The wrenches of load/loads.h that are constants, about the centroid and over the weight, with
 * their signs turned: what the base bears of them. */

#include "case_filter/staying_plan.h"

#include "evaluation/loaded.h"
#include "number/ball.h"

enum { BITS = 256 };

static const tp_near zero = {0, 0};

static bool stays(const tp_load *load, const tp_loads_description *loads) {
  switch (load->kind) {
  case TP_LOAD_WATER:
  case TP_LOAD_UPLIFT:
  case TP_LOAD_ICE:
    return tp_water_is_sited(&loads->water);
  case TP_LOAD_PRESSURE:
  case TP_LOAD_SUPPORT:
  case TP_LOAD_ANCHOR:
    return true;
  case TP_LOAD_WEIGHT:
  case TP_LOAD_SEISMIC:
  case TP_LOAD_SURCHARGE:
    break;
  }
  return false;
}

static tp_filter_side side_of(const tp_load *load) {
  switch (load->kind) {
  case TP_LOAD_WATER:
  case TP_LOAD_UPLIFT:
  case TP_LOAD_ICE:
    return TP_FILTER_WATER;
  case TP_LOAD_SUPPORT:
  case TP_LOAD_ANCHOR:
    return TP_FILTER_SUPPORT;
  default:
    return TP_FILTER_PUSH;
  }
}

static tp_load_number with_of(const tp_load *load, const tp_loads_description *loads) {
  const bool is_water = load->kind == TP_LOAD_WATER || load->kind == TP_LOAD_UPLIFT;
  const bool is_first = load->kind == TP_LOAD_ANCHOR && load->anchor == loads->anchors;
  return is_water ? TP_NUMBER_WATER_WEIGHT : is_first ? TP_NUMBER_BOLT_FORCE : TP_LOAD_NUMBERS;
}

/* What the base bears of it, over the weight: forces, and the moment over `unit` too. False where
 * it turns with the tilt after all. */
static bool plan_load(tp_staying_load *own, const tp_load *load, const tp_loads_description *loads,
                      const arb_t centroid_x, const arb_t centroid_y, const arb_t weight,
                      const arb_t unit) {
  const tp_wrench *w = &load->wrench;
  const tp_trig *parts[3] = {&w->x, &w->y, NULL};
  tp_trig moment;
  arb_t share;
  bool is_fixed = true;
  tp_trig_init(&moment);
  arb_init(share);
  tp_wrench_moment(&moment, w, centroid_x, centroid_y, BITS);
  parts[2] = &moment;
  *own = (tp_staying_load){
      .load = {.active = load->active, .passive = load->passive, .side = side_of(load)},
      .with = with_of(load, loads)};
  for (int k = 0; k < 3; k++) {
    for (int part = 0; part < TP_BASIS; part++) {
      is_fixed = is_fixed && (part == TP_ONE || arb_is_zero(parts[k]->of + part));
    }
    arb_div(share, parts[k]->of + TP_ONE, weight, BITS);
    if (k == 2) arb_div(share, share, unit, BITS);
    arb_neg(share, share);
    own->load.fixed[k] = arb_is_zero(share) ? zero : tp_ball_near(share);
  }
  tp_trig_clear(&moment);
  arb_clear(share);
  return is_fixed;
}

/* Bolts that are not at a spacing hold any thickness with the same force; on a slope the pull of
 * one that dips follows that, and the water of a site is that of the tilt. */
static void plan_dependences(tp_staying_plan *plan, const tp_scene *scene) {
  const tp_loads_description *loads = &scene->loads;
  plan->knows_tilt = loads->water.given && tp_water_is_sited(&loads->water);
  plan->knows_thickness = false;
  plan->has_capacity = loads->anchor_count > 0 && loads->anchors[0].capacity_kn.given;
  for (long k = 0; k < loads->anchor_count; k++) {
    const tp_anchor_description *own = loads->anchors + k;
    plan->knows_thickness = plan->knows_thickness || !own->spacing.given;
    plan->knows_tilt = plan->knows_tilt || (own->dip_deg.given && scene->frame == TP_FRAME_SLOPE);
  }
}

bool tp_staying_plan_init(tp_staying_plan *plan, const tp_evaluation *e, tp_direction towards,
                          const arb_t centroid_x, const arb_t centroid_y, const arb_t unit) {
  const tp_scene *scene = e->problem->scene;
  tp_loaded loaded;
  arb_t weight;
  *plan = (tp_staying_plan){.count = 0};
  plan_dependences(plan, scene);
  if (!tp_loaded_init(&loaded, e, towards)) return false;
  arb_init(weight);
  tp_evaluation_weight(weight, e);
  bool fits = true;
  for (long k = 0; k < loaded.count && fits; k++) {
    if (!stays(loaded.items + k, &scene->loads)) continue;
    fits = plan->count < TP_FILTER_LOADS &&
           plan_load(plan->items + plan->count++, loaded.items + k, &scene->loads, centroid_x,
                     centroid_y, weight, unit);
  }
  arb_clear(weight);
  tp_loaded_clear(&loaded);
  return fits;
}
