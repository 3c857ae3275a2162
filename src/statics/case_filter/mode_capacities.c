/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* As motion/strength.c has it, by the signs of the plan's rays: a line slips as its closed point
 * does. */

#include "case_filter/mode_capacities.h"

static const tp_near zero = {0, 0};

static void add(tp_near sum[3], const tp_near force[3], bool back) {
  for (int e = 0; e < 3; e++) {
    sum[e] = back ? tp_near_minus(sum[e], force[e]) : tp_near_plus(sum[e], force[e]);
  }
}

void tp_bonds_of_all(tp_near pull[3], const tp_filter_capacities *c) {
  for (int e = 0; e < 3; e++) pull[e] = zero;
  for (int k = 0; k < c->count; k++) add(pull, c->items[k].pull, false);
}

static bool slides(const tp_contact_plan *plan, const tp_plan_mode *mode) {
  return mode->ray_count == 1 && plan->rays[mode->rays[0]].kind == TP_RAY_SLIDES;
}

static int slip_of(const tp_contact_plan *plan, const tp_plan_mode *mode, long point) {
  int slip = 0;
  for (int k = 0; k < mode->ray_count && slip == 0; k++) {
    const signed char own = plan->rays[mode->rays[k]].slips[point];
    slip = (own > 0) - (own < 0);
  }
  return slip;
}

/* The cohesion of a line of which a point stays closed: against its slip, or free. */
static bool add_shear(tp_mode_capacities *own, const tp_filter_case *of, const tp_plan_mode *mode,
                      int capacity, long closed) {
  const tp_near *shear = of->capacities->items[capacity].shear;
  const int slip = slip_of(of->plan, mode, closed);
  if (tp_near_is_zero(shear[0])) return true;
  if (slip != 0) {
    add(own->fixed, shear, slip > 0);
    return true;
  }
  if (own->free_count == TP_MODE_FREE) return false;
  own->free_site[own->free_count] = of->plan->points[closed].site;
  for (int e = 0; e < 3; e++) own->free[own->free_count][e] = shear[e];
  own->free_count++;
  return true;
}

/* The bond of facets that slide, along n between the first and the last normal line of them. False
 * where it is open which these are. */
static bool add_pulls(tp_mode_capacities *own, const tp_filter_case *of, long axis) {
  const tp_contact_plan *plan = of->plan;
  for (int last = 0; last < TP_MODE_PULLS; last++) {
    int end = -1;
    for (int k = 0; k < plan->point_count; k++) {
      if (plan->points[k].axis != axis) continue;
      if (end >= 0 && plan->points[k].along != plan->points[end].along) return false;
      if (end >= 0 && plan->points[k].site == plan->points[end].site) continue;
      const tp_near *p = of->shape->points[k].normal;
      const int order = end < 0
                            ? 1
                            : tp_near_sign(tp_near_sub(tp_near_mul(p[2], of->shape->points[end].tx),
                                                       tp_near_mul(of->shape->points[end].normal[2],
                                                                   of->shape->points[k].tx)));
      if (order == 0) return false;
      if (end < 0 || (order > 0) == (last == 1)) end = k;
    }
    if (end < 0) return false;
    own->pull_site[own->pull_count] = plan->points[end].site;
    for (int e = 0; e < 3; e++) {
      own->pulls[own->pull_count][e] = of->shape->points[end].normal[e];
    }
    own->pull_count++;
  }
  return true;
}

/* What slides shears the facets along it, and opens all others. */
static bool add_slide(tp_mode_capacities *own, const tp_filter_case *of, const tp_plan_mode *mode) {
  const tp_filter_capacities *c = of->capacities;
  const long axis = of->plan->points[of->plan->rays[mode->rays[0]].point].axis;
  bool done = true;
  for (int k = 0; k < c->count && done; k++) {
    const int point = c->items[k].point;
    if (of->plan->points[point].axis == axis) {
      done = add_shear(own, of, mode, k, point);
    } else {
      add(own->fixed, c->items[k].pull, false);
    }
  }
  return done && (!c->bonds || add_pulls(own, of, axis));
}

/* The first edge of the mode on a line, or -1. */
static int edge_on(const tp_filter_case *of, const tp_plan_mode *mode, int line) {
  for (int k = 0; k < mode->edge_count; k++) {
    if (of->capacities->line_of[mode->edges[k].point] == line) return k;
  }
  return -1;
}

/* What turns opens all facets but for closed points. */
static bool add_turn(tp_mode_capacities *own, const tp_filter_case *of, const tp_plan_mode *mode) {
  const tp_filter_capacities *c = of->capacities;
  bool done = true;
  tp_bonds_of_all(own->fixed, c);
  for (int k = 0; k < c->count && done; k++) {
    const int edge = edge_on(of, mode, c->items[k].line);
    if (edge >= 0) done = add_shear(own, of, mode, k, mode->edges[edge].point);
  }
  return done;
}

bool tp_mode_capacities_find(tp_mode_capacities *own, const tp_filter_case *of,
                             const tp_plan_mode *mode) {
  *own = (tp_mode_capacities){.free_count = 0};
  return slides(of->plan, mode) ? add_slide(own, of, mode) : add_turn(own, of, mode);
}
