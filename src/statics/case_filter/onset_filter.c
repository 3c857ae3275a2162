/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A mode can begin where its cone of loads holds those of the block (motion/bounds.h), over the
 * weight and cos(tilt) w = -(b_0 + t b_1 + s b_2) with t = tan(tilt), s = 1 / cos(tilt)
 * (filter_loads.h). The cone is the union of the simple ones of three of its generators each, so
 * that its tilts, an interval, reach from the least lower to the largest upper end of theirs. With
 * h across g_1 and g_2 the factor of g_0 in w is (h . w) / (h . g_0), where no load stays with the
 * block a linear function of t. Where some do, no tilts but from level to upright are looked at,
 * and each such plane has to be passed once there at most: the faces of the cone are among them, so
 * that its tilts are an interval, too. Every sign is that of a double beyond its bound. */

#include "case_filter/onset_filter.h"

enum { GENERATORS = 2 + TP_PLAN_EDGES };

static void keep_up_to(tp_near_interval *own, tp_near end) {
  own->high = own->has_high ? tp_near_lesser(own->high, end) : end;
  own->has_high = true;
}

static void keep_from(tp_near_interval *own, tp_near end) {
  own->low = own->has_low ? tp_near_larger(own->low, end) : end;
  own->has_low = true;
}

/* Keep where rise t <= level, both times `sign`. False where open. */
static bool keep(tp_near_interval *own, tp_near rise, tp_near level, int sign) {
  if (tp_near_is_zero(rise)) {
    const int side = sign * tp_near_sign(level);
    own->empty = own->empty || side < 0;
    return side != 0;
  }
  const int side = sign * tp_near_sign(rise);
  if (side == 0) return false;
  const tp_near end = tp_near_div(level, rise);
  if (side > 0) {
    keep_up_to(own, end);
  } else {
    keep_from(own, end);
  }
  return true;
}

/* Likewise where the power of loads of which some stay with the block is below zero, times `sign`.
 */
static bool keep_below(tp_near_interval *own, const tp_tilt_form *power, int sign) {
  tp_tilt_change change;
  if (!tp_tilt_form_change(&change, power)) return false;
  if (change.level == change.upright) {
    own->empty = own->empty || sign * change.level > 0;
  } else if (sign * change.level < 0) {
    keep_up_to(own, change.tangent);
  } else {
    keep_from(own, change.tangent);
  }
  return true;
}

/* Two planes that share a generator meet the loads at one tilt where these lie along it: weight
 * along a facet that slides. */
static void settle(tp_near_interval *own) {
  if (own->empty || !own->has_low || !own->has_high) return;
  const int order = tp_near_sign(tp_near_sub(own->high, own->low));
  own->empty = order < 0;
  own->perhaps = order == 0;
}

/* What spans the cone of a mode: rays, then edges turned round. */
typedef struct cone {
  const tp_plan_mode *mode;
  const tp_filter_loads *loads;
  tp_near of[GENERATORS][3];
  tp_near across[3]; /* to both rays: M^-1 h of their normal line, times k^2 */
} cone;

static void set_cone(cone *c, const tp_plan_mode *mode, const tp_filter_case *of,
                     tp_near edges[][2][3]) {
  const tp_case_shape *shape = of->shape;
  c->mode = mode;
  c->loads = of->loads;
  for (int k = 0; k < mode->ray_count; k++) {
    for (int e = 0; e < 3; e++) c->of[k][e] = shape->inertia[mode->rays[k]][e];
  }
  for (int k = 0; k < mode->edge_count; k++) {
    const tp_cone_edge *edge = mode->edges + k;
    for (int e = 0; e < 3; e++) {
      c->of[mode->ray_count + k][e] = tp_near_neg(edges[edge->point][edge->against][e]);
    }
  }
  if (mode->ray_count < 2) return;
  tp_shape_response(c->across, shape, mode->line);
}

/* The normal of the plane of two generators; of two rays from their normal line, which is exact
 * where its facet is level. */
static void set_plane(tp_near plane[3], const cone *c, int i, int j) {
  if (c->mode->ray_count == 2 && i + j == 1) {
    for (int e = 0; e < 3; e++) plane[e] = c->across[e];
  } else {
    tp_sparse_cross(plane, c->of[i], c->of[j]);
  }
}

/* Where the loads have h . w >= 0, times `sign`. False where open. */
static bool keep_loads(tp_near_interval *own, const tp_near h[3], const tp_filter_loads *loads,
                       int sign) {
  tp_tilt_form power;
  tp_filter_loads_power(&power, loads, h);
  return loads->stays ? keep_below(own, &power, sign)
                      : keep(own, power.rise, tp_near_neg(power.level), sign);
}

/* The factor of each: (h . w) (h . g) >= 0, h the plane of the other two. */
static bool span_triple(tp_near_interval *own, const cone *c, const signed char of[3]) {
  *own = (tp_near_interval){.empty = false};
  for (int k = 0; k < 3 && (!own->empty || c->loads->stays); k++) {
    tp_near h[3];
    set_plane(h, c, of[(k + 1) % 3], of[(k + 2) % 3]);
    const int sign = tp_near_sign(tp_sparse_dot(h, c->of[of[k]]));
    if (sign == 0 || !keep_loads(own, h, c->loads, sign)) return false;
  }
  settle(own);
  return true;
}

static void unite(tp_near_interval *sum, const tp_near_interval *own) {
  if (own->empty) return;
  if (sum->empty) {
    *sum = *own;
    return;
  }
  sum->has_low = sum->has_low && own->has_low;
  sum->has_high = sum->has_high && own->has_high;
  if (sum->has_low) sum->low = tp_near_lesser(sum->low, own->low);
  if (sum->has_high) sum->high = tp_near_larger(sum->high, own->high);
}

/* An end that may be another one as well. */
static tp_near or_else(tp_near own, tp_near other) {
  const double low = fmin(own.value - own.error, other.value - other.error);
  const double high = fmax(own.value + own.error, other.value + other.error);
  const double value = low + (high - low) / 2;
  return tp_near_of(value, (high - low) / 2 + (fabs(value) + fabs(low) + fabs(high)) * DBL_EPSILON);
}

/* All of a mode: an interval, of which what may be in it or not is no more than an end. */
static void add_perhaps(tp_near_interval *sum, const tp_near_interval *perhaps) {
  if (perhaps->empty) return;
  if (sum->empty) {
    *sum = *perhaps;
    return;
  }
  if (sum->has_low && tp_near_sign(tp_near_sub(perhaps->low, sum->low)) <= 0) {
    sum->low = or_else(sum->low, perhaps->low);
  }
  if (sum->has_high && tp_near_sign(tp_near_sub(sum->high, perhaps->high)) <= 0) {
    sum->high = or_else(sum->high, perhaps->high);
  }
}

static bool find_mode(tp_mode_interval *own, const tp_plan_mode *mode, const tp_filter_case *of,
                      tp_near edges[][2][3]) {
  cone c;
  set_cone(&c, mode, of, edges);
  const tp_near_interval none = {.empty = true};
  tp_near_interval perhaps = none, perhaps_with_rays = none;
  own->all = own->with_rays = none;
  for (int k = 0; k < mode->triple_count; k++) {
    tp_near_interval triple;
    if (!span_triple(&triple, &c, mode->triples[k].of)) return false;
    unite(triple.perhaps ? &perhaps : &own->all, &triple);
    if (!mode->triples[k].all_rays) continue;
    unite(triple.perhaps ? &perhaps_with_rays : &own->with_rays, &triple);
  }
  add_perhaps(&own->all, &perhaps);
  add_perhaps(&own->with_rays, &perhaps_with_rays);
  return true;
}

/* Does a point before it open under the same loads? Of those without a moment, one on a parallel
 * facet. */
static bool is_repeated(const tp_filter_case *of, int k) {
  const tp_plan_point *point = of->plan->points + k;
  for (int before = 0; before < k; before++) {
    const tp_plan_point *own = of->plan->points + before;
    if (own->axis == point->axis && own->along == point->along &&
        (!of->loads->turns || own->site == point->site)) {
      return true;
    }
  }
  return false;
}

/* Where all points open under the loads: h . M^-1 w >= 0 of each. */
static bool find_leaving(tp_near_interval *own, const tp_filter_case *of) {
  const tp_contact_plan *plan = of->plan;
  *own = (tp_near_interval){.empty = !plan->opens_all};
  for (int k = 0; k < plan->point_count && !own->empty; k++) {
    tp_near response[3];
    if (is_repeated(of, k)) continue;
    tp_shape_response(response, of->shape, k);
    if (!keep_loads(own, response, of->loads, 1)) return false;
  }
  settle(own);
  return true;
}

/* An interval takes part in the onset: the least of what begins above level ground. False where it
 * holds level ground, or may. */
static bool take(tp_onset_filter *found, const tp_near_interval *own) {
  if (own->empty || (own->has_high && tp_near_sign(own->high) < 0)) return true;
  if (!own->has_low || tp_near_sign(own->low) <= 0) return false;
  if (own->perhaps) {
    found->perhaps = found->has_perhaps ? tp_near_lesser(found->perhaps, own->low) : own->low;
    found->has_perhaps = true;
    return true;
  }
  found->tangent = found->never ? own->low : tp_near_lesser(found->tangent, own->low);
  found->never = false;
  return true;
}

bool tp_onset_filter_find(tp_onset_filter *found, const tp_filter_case *of) {
  const tp_contact_plan *plan = of->plan;
  tp_near edges[TP_PLAN_POINTS][2][3];
  for (long k = 0; k < plan->point_count; k++) {
    tp_shape_edge(edges[k][0], of->shape, (tp_cone_edge){k, false}, of->friction);
    tp_shape_edge(edges[k][1], of->shape, (tp_cone_edge){k, true}, of->friction);
  }
  found->plan = plan;
  found->never = true;
  found->has_perhaps = false;
  if (!find_leaving(&found->leaves, of) || !take(found, &found->leaves)) return false;
  for (int k = 0; k < plan->mode_count; k++) {
    tp_mode_interval *own = found->modes + k;
    if (!find_mode(own, plan->modes + k, of, edges) || !take(found, &own->all)) return false;
  }
  return !found->has_perhaps ||
         (!found->never && tp_near_sign(tp_near_sub(found->perhaps, found->tangent)) > 0);
}

/* 1 within, strictly, -1 without, 0 open. */
static int side_of(const tp_near_interval *own, tp_near tangent) {
  if (own->empty) return -1;
  const int low = own->has_low ? tp_near_sign(tp_near_sub(tangent, own->low)) : 1;
  const int high = own->has_high ? tp_near_sign(tp_near_sub(own->high, tangent)) : 1;
  return low < 0 || high < 0 ? -1 : low > 0 && high > 0 && !own->perhaps ? 1 : 0;
}

bool tp_onset_filter_look(bool *moves, unsigned *beginnings, const tp_onset_filter *found,
                          tp_near tangent) {
  *beginnings = 0;
  const int leaves = side_of(&found->leaves, tangent);
  *moves = leaves > 0;
  if (leaves > 0) *beginnings |= 1U << TP_LEAVES_BASE;
  bool told = leaves != 0;
  for (int k = 0; k < found->plan->mode_count && told; k++) {
    const int side = side_of(&found->modes[k].all, tangent);
    const int start = side > 0 ? side_of(&found->modes[k].with_rays, tangent) : -1;
    told = side != 0 && start != 0;
    *moves = *moves || side > 0;
    if (start > 0) *beginnings |= 1U << found->plan->modes[k].mechanism;
  }
  return told;
}
