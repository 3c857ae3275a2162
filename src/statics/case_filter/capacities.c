/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which facets lie on one straight line is found once, exactly; lengths and forces are those of a
 * sample. The thickness is a factor of the weight and of all capacities, and cancels. */

#include "case_filter/capacities.h"

static const tp_near zero = {0, 0};

/* ---- once --------------------------------------------------------------------------------------
 */

/* The first end of a facet with a length. */
static bool begins_facet(const tp_contact_plan *plan, int k) {
  const tp_plan_point *own = plan->points + k;
  return own->facet >= 0 && k + 1 < plan->point_count && own[1].facet == own->facet;
}

/* Do two points on parallel facets lie on one line? In lattice units, exactly. */
static bool are_in_line(const tp_cones *cones, long a, long b) {
  const arb_struct ax = tp_cones_x(cones, a), bx = tp_cones_x(cones, b);
  const arb_struct ay = tp_cones_y(cones, a), by = tp_cones_y(cones, b);
  arb_t across, dx;
  arb_init(across);
  arb_init(dx);
  arb_sub(dx, &bx, &ax, ARF_PREC_EXACT);
  arb_sub(across, &by, &ay, ARF_PREC_EXACT);
  arb_mul_fmpz(across, across, cones->tx + a, ARF_PREC_EXACT);
  arb_submul_fmpz(across, dx, cones->ty + a, ARF_PREC_EXACT);
  const bool in_line = arb_is_zero(across) != 0;
  arb_clear(across);
  arb_clear(dx);
  return in_line;
}

/* Do facets of two points have an end in common? */
static bool are_joined(const tp_contact_plan *plan, int a, int b) {
  for (int k = 0; k < plan->point_count; k++) {
    if (plan->points[k].facet != plan->points[a].facet) continue;
    for (int other = 0; other < plan->point_count; other++) {
      if (plan->points[other].facet == plan->points[b].facet &&
          plan->points[other].site == plan->points[k].site) {
        return true;
      }
    }
  }
  return false;
}

/* Facets that stay parallel stay on one line where they have an end in common: false where others
 * may leave it. */
static bool set_lines(tp_capacity_plan *own, const tp_contact_plan *plan, const tp_cones *cones,
                      bool varies) {
  for (int k = 0; k < plan->point_count; k++) {
    const tp_plan_point *point = plan->points + k;
    own->line_of[k] = k;
    for (int before = k - 1; before >= 0; before--) {
      const tp_plan_point *other = plan->points + before;
      if (other->axis != point->axis || other->along != point->along) continue;
      if (other->facet != point->facet && !are_in_line(cones, before, k)) continue;
      if (varies && !are_joined(plan, before, k)) return false;
      own->line_of[k] = own->line_of[before];
    }
  }
  return true;
}

/* Is the scene's weight that of its one outline, of one unit weight? */
static bool weighs_outline(const tp_evaluation *e) {
  const tp_scene *scene = e->problem->scene;
  return scene->block.part_count == 0 && fmpq_sgn(scene->block.unit_weight_kn_m3.value) > 0;
}

bool tp_capacity_plan_init(tp_capacity_plan *own, const tp_evaluation *e,
                           const tp_onset_asked *asked, const tp_contact_plan *plan, bool varies) {
  const tp_problem *problem = e->problem;
  const tp_loads_description *loads = &problem->scene->loads;
  *own = (tp_capacity_plan){.acts = loads->cohesion_kpa.given || loads->bond_kpa.given,
                            .weighs_outline = varies};
  if (!own->acts) return true;
  own->slips = tp_contact_is_free_to_slip(&problem->contact, &problem->lattice);
  for (int k = 0; k < plan->point_count; k++) {
    if (begins_facet(plan, k)) own->points[own->count++] = k;
  }
  return set_lines(own, plan, &asked->cones, varies) && !(varies && !weighs_outline(e));
}

/* ---- of a sample -------------------------------------------------------------------------------
 */

/* kPa times this and a length of the shape is a force over the weight. */
static tp_near force_of(const tp_capacity_plan *own, const tp_load_plan *loads,
                        const tp_case_shape *shape, double metres_per_unit,
                        const tp_near numbers[TP_LOAD_NUMBERS]) {
  static const tp_near one = {1, 0};
  if (!own->weighs_outline) {
    return tp_near_div(loads->metres_per_unit, tp_load_plan_weight(loads, numbers));
  }
  const tp_near unit = {metres_per_unit, metres_per_unit * DBL_EPSILON};
  return tp_near_div(one,
                     tp_near_mul(unit, tp_near_mul(shape->area, numbers[TP_NUMBER_UNIT_WEIGHT])));
}

/* Do parallel facets on two lines keep these apart? */
static bool keep_apart(const tp_capacity_plan *own, const tp_contact_plan *plan,
                       const tp_case_shape *shape) {
  for (int k = 0; k < plan->point_count; k++) {
    for (int before = 0; before < k; before++) {
      if (plan->points[before].axis != plan->points[k].axis) continue;
      if (own->line_of[before] == own->line_of[k]) continue;
      const tp_shape_point *a = shape->points + before, *b = shape->points + k;
      const tp_near across = tp_near_minus(tp_near_times(tp_near_minus(b->y, a->y), a->tx),
                                           tp_near_times(tp_near_minus(b->x, a->x), a->ty));
      if (tp_near_sign(across) == 0) return false;
    }
  }
  return true;
}

/* A force (f_x, f_y) at a place as (f_x, f_y, moment). */
static void set_force(tp_near force[3], tp_near fx, tp_near fy, tp_near x, tp_near y) {
  force[0] = fx;
  force[1] = fy;
  force[2] = tp_near_minus(tp_near_times(x, fy), tp_near_times(y, fx));
}

static void set_pull(tp_filter_capacity *own, const tp_case_shape *shape, tp_near bond) {
  static const tp_near half = {0.5, 0};
  const tp_shape_point *p = shape->points + own->point;
  const tp_near size = tp_near_div(tp_near_mul(bond, own->length), tp_near_length(p->tx, p->ty));
  const tp_near x = tp_near_times(half, tp_near_plus(p[0].x, p[1].x));
  const tp_near y = tp_near_times(half, tp_near_plus(p[0].y, p[1].y));
  set_force(own->pull, tp_near_times(size, p->ty), tp_near_neg(tp_near_times(size, p->tx)), x, y);
}

/* Of a line, by its first facet. */
static void set_shear(tp_filter_capacities *all, int k, const tp_case_shape *shape,
                      tp_near cohesion) {
  tp_filter_capacity *own = all->items + k;
  const tp_shape_point *p = shape->points + own->point;
  tp_near length = zero;
  for (int other = 0; other < all->count; other++) {
    if (all->items[other].line != own->line) continue;
    if (other < k) return;
    length = tp_near_plus(length, all->items[other].length);
  }
  const tp_near size = tp_near_div(tp_near_mul(cohesion, length), tp_near_length(p->tx, p->ty));
  set_force(own->shear, tp_near_times(size, p->tx), tp_near_times(size, p->ty), p->x, p->y);
}

bool tp_capacities_evaluate(tp_filter_capacities *own, const tp_capacity_plan *capacities,
                            const tp_load_plan *loads, const tp_contact_plan *plan,
                            const tp_case_shape *shape, double metres_per_unit,
                            const tp_near numbers[TP_LOAD_NUMBERS]) {
  own->acts = capacities->acts && !(tp_near_is_zero(numbers[TP_NUMBER_COHESION]) &&
                                    tp_near_is_zero(numbers[TP_NUMBER_BOND]));
  if (!own->acts) return true;
  const tp_near per_kpa = force_of(capacities, loads, shape, metres_per_unit, numbers);
  const tp_near cohesion = tp_near_times(numbers[TP_NUMBER_COHESION], per_kpa);
  own->line_of = capacities->line_of;
  own->count = capacities->count;
  own->bond = tp_near_times(numbers[TP_NUMBER_BOND], per_kpa);
  own->bonds = !tp_near_is_zero(own->bond);
  tp_near all = zero;
  for (int k = 0; k < own->count; k++) {
    const int point = capacities->points[k];
    const tp_shape_point *p = shape->points + point;
    own->items[k] = (tp_filter_capacity){.point = point, .line = own->line_of[point]};
    own->items[k].length =
        tp_near_length(tp_near_minus(p[1].x, p[0].x), tp_near_minus(p[1].y, p[0].y));
    all = tp_near_plus(all, own->items[k].length);
  }
  own->cohesion = tp_near_times(cohesion, all);
  for (int k = 0; k < own->count; k++) {
    if (!tp_near_is_zero(cohesion)) set_shear(own, k, shape, cohesion);
    if (own->bonds) set_pull(own->items + k, shape, own->bond);
  }
  return isfinite(per_kpa.error) &&
         (!capacities->weighs_outline || keep_apart(capacities, plan, shape));
}

void tp_capacities_scale(tp_filter_capacities *scaled, const tp_filter_capacities *own,
                         double share) {
  const tp_near by = {share, 0};
  *scaled = *own;
  scaled->bond = tp_near_times(by, own->bond);
  scaled->cohesion = tp_near_times(by, own->cohesion);
  for (int k = 0; k < own->count; k++) {
    for (int e = 0; e < 3; e++) {
      scaled->items[k].shear[e] = tp_near_times(by, own->items[k].shear[e]);
      scaled->items[k].pull[e] = tp_near_times(by, own->items[k].pull[e]);
    }
  }
}

/* (q - P) . t of length 1, and not below zero. */
static tp_near opening(const tp_contact_plan *plan, const tp_case_shape *shape, int end, int facet,
                       long pivot) {
  if (plan->points[end].site == plan->points[pivot].site) return zero;
  const tp_shape_point *q = shape->points + end, *p = shape->points + pivot;
  const tp_shape_point *t = shape->points + facet;
  const tp_near along = tp_near_plus(tp_near_times(tp_near_minus(q->x, p->x), t->tx),
                                     tp_near_times(tp_near_minus(q->y, p->y), t->ty));
  const tp_near distance = tp_near_div(along, tp_near_length(t->tx, t->ty));
  return (tp_near){fmax(distance.value, 0), distance.error};
}

tp_near tp_capacities_bond_moment(const tp_filter_capacities *own, const tp_contact_plan *plan,
                                  const tp_case_shape *shape, long pivot) {
  static const tp_near half = {0.5, 0};
  tp_near sum = zero;
  for (int k = 0; k < own->count; k++) {
    const int point = own->items[k].point;
    const tp_near first = opening(plan, shape, point, point, pivot);
    const tp_near last = opening(plan, shape, point + 1, point, pivot);
    const tp_near part = tp_near_minus(tp_near_times(last, last), tp_near_times(first, first));
    sum = tp_near_plus(sum, (tp_near){fabs(part.value), part.error}); /* whichever end is up-dip */
  }
  return tp_near_times(half, tp_near_times(own->bond, sum));
}

bool tp_capacity_meets(const tp_filter_capacities *own, const tp_contact_plan *plan, int capacity,
                       long site) {
  for (int k = 0; k < plan->point_count; k++) {
    if (plan->points[k].site == site && own->line_of[k] == own->items[capacity].line) return true;
  }
  return false;
}
