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

#include "case_filter/strong_modes.h"

enum { GENERATORS = 2 + TP_PLAN_EDGES };

/* The normal of the plane of two generators, and the loads' power on it. */
typedef struct plane {
  tp_near h[3];
  tp_tilt_form power;
} plane;

/* What spans the cone of a mode: rays, then edges turned round. */
typedef struct cone {
  const tp_plan_mode *mode;
  const tp_filter_loads *loads;
  tp_near of[GENERATORS][3];
  tp_near across[3];                    /* to both rays: M^-1 h of their normal line, times k^2 */
  unsigned known[GENERATORS];           /* bit j of the i-th: their plane is there */
  plane planes[GENERATORS][GENERATORS]; /* of each two, the lesser first, that were asked for */
} cone;

static void set_cone(cone *c, const tp_plan_mode *mode, const tp_filter_case *of,
                     tp_near edges[][2][3]) {
  const tp_case_shape *shape = of->shape;
  const int count = mode->ray_count + mode->edge_count;
  c->mode = mode;
  c->loads = of->loads;
  for (int k = 0; k < count; k++) c->known[k] = 0;
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

static bool is_across(const cone *c, int i, int j) {
  return c->mode->ray_count == 2 && i + j == 1;
}

/* Of i < j; of two rays from their normal line, which is exact where its facet is level. */
static const plane *plane_of(cone *c, int i, int j) {
  plane *own = &c->planes[i][j];
  if ((c->known[i] & 1U << j) != 0) return own;
  c->known[i] |= 1U << j;
  if (is_across(c, i, j)) {
    for (int e = 0; e < 3; e++) own->h[e] = c->across[e];
  } else {
    tp_sparse_cross(own->h, c->of[i], c->of[j]);
  }
  tp_filter_loads_power(&own->power, c->loads, own->h);
  return own;
}

/* Where the loads have h . w >= 0, times `sign`. False where open. */
static bool keep_loads(tp_near_interval *own, const tp_near h[3], const tp_filter_loads *loads,
                       int sign) {
  tp_tilt_form power;
  tp_filter_loads_power(&power, loads, h);
  return tp_near_interval_keep(own, &power, sign, loads->stays);
}

/* The factor of each: (h . w) (h . g) >= 0, h the plane of the other two; all h . g are the one
 * determinant, for i < j < k that of h across i and k turned round. */
static bool span_triple(tp_near_interval *own, cone *c, const unsigned char of[3]) {
  const plane *last = plane_of(c, of[1], of[2]);
  const int turn = tp_near_sign(tp_sparse_dot(last->h, c->of[of[0]]));
  *own = (tp_near_interval){.empty = false};
  if (turn == 0) return false;
  for (int k = 0; k < 3 && (!own->empty || c->loads->stays); k++) {
    const int i = of[k == 0 ? 1 : 0], j = of[k == 2 ? 1 : 2];
    const plane *p = k == 0 ? last : plane_of(c, i, j);
    int sign = k == 1 ? -turn : turn;
    if (is_across(c, i, j)) sign = tp_near_sign(tp_sparse_dot(p->h, c->of[of[k]]));
    if (sign == 0 || !tp_near_interval_keep(own, &p->power, sign, c->loads->stays)) return false;
  }
  tp_near_interval_settle(own);
  return true;
}

static bool find_mode(tp_mode_interval *own, const tp_plan_mode *mode, const tp_filter_case *of,
                      tp_near edges[][2][3]) {
  cone c;
  set_cone(&c, mode, of, edges);
  const tp_near_interval none = {.empty = true};
  tp_near_interval perhaps = none, perhaps_with_rays = none;
  own->all = own->with_rays = own->pulled = none;
  for (int k = 0; k < mode->triple_count; k++) {
    tp_near_interval triple;
    if (!span_triple(&triple, &c, mode->triples[k].of)) return false;
    tp_near_interval_unite(triple.perhaps ? &perhaps : &own->all, &triple);
    if (!mode->triples[k].all_rays) continue;
    tp_near_interval_unite(triple.perhaps ? &perhaps_with_rays : &own->with_rays, &triple);
  }
  tp_near_interval_add_perhaps(&own->all, &perhaps);
  tp_near_interval_add_perhaps(&own->with_rays, &perhaps_with_rays);
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
  tp_near_interval_settle(own);
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

bool tp_onset_filter_modes(tp_onset_filter *found, const tp_filter_case *of) {
  const tp_contact_plan *plan = of->plan;
  const bool strong = of->capacities->acts;
  tp_near edges[TP_PLAN_POINTS][2][3];
  for (long k = 0; k < plan->point_count && !strong; k++) {
    tp_shape_edge(edges[k][0], of->shape, (tp_cone_edge){k, false}, of->friction);
    tp_shape_edge(edges[k][1], of->shape, (tp_cone_edge){k, true}, of->friction);
  }
  found->plan = plan;
  bool told =
      strong ? tp_strong_leaving_find(&found->leaves, of) : find_leaving(&found->leaves, of);
  for (int k = 0; k < plan->mode_count && told; k++) {
    tp_mode_interval *own = found->modes + k;
    told = strong ? tp_strong_mode_find(own, plan->modes + k, of)
                  : find_mode(own, plan->modes + k, of, edges);
  }
  return told;
}

bool tp_onset_filter_find(tp_onset_filter *found, const tp_filter_case *of) {
  found->never = true;
  found->has_perhaps = false;
  if (!tp_onset_filter_modes(found, of) || !take(found, &found->leaves)) return false;
  for (int k = 0; k < found->plan->mode_count; k++) {
    if (!take(found, &found->modes[k].all)) return false;
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
    const tp_mode_interval *own = found->modes + k;
    const int start = side > 0 ? side_of(&own->with_rays, tangent) : -1;
    const bool perhaps = side > 0 && start <= 0 && side_of(&own->pulled, tangent) >= 0;
    told = side != 0 && start != 0 && !perhaps;
    *moves = *moves || side > 0;
    if (start > 0) *beginnings |= 1U << found->plan->modes[k].mechanism;
  }
  return told;
}

/* All of what opens everything, and of the k-th mode behind it. */
static const tp_near_interval *interval_of(const tp_onset_filter *o, int k) {
  return k == 0 ? &o->leaves : &o->modes[k - 1].all;
}

/* The least lower end above a tilt that no interval holds. */
static bool find_above(bool *never, tp_near *end, const tp_onset_filter *o, tp_near tangent) {
  tp_near perhaps = {INFINITY, 0};
  *never = true;
  for (int k = 0; k <= o->plan->mode_count; k++) {
    const tp_near_interval *own = interval_of(o, k);
    if (own->empty) continue;
    if (side_of(own, tangent) >= 0) return false;
    if (!own->has_low || tp_near_sign(tp_near_sub(own->low, tangent)) < 0) continue;
    if (own->perhaps) {
      perhaps = isinf(perhaps.value) ? own->low : tp_near_lesser(perhaps, own->low);
      continue;
    }
    *end = *never ? own->low : tp_near_lesser(*end, own->low);
    *never = false;
  }
  return isinf(perhaps.value) || (!*never && tp_near_sign(tp_near_sub(perhaps, *end)) > 0);
}

/* From a tilt that some hold down through those that meet. */
static bool find_below(tp_near *end, const tp_onset_filter *o, tp_near tangent) {
  static const double beside = 0x1p-30;
  tp_near at = tangent;
  *end = tangent;
  for (int step = 0; step <= o->plan->mode_count + 1; step++) {
    bool held = false;
    for (int k = 0; k <= o->plan->mode_count; k++) {
      const tp_near_interval *own = interval_of(o, k);
      const int side = own->empty ? -1 : side_of(own, at);
      if (side == 0 || (side > 0 && !own->has_low)) return false;
      if (side < 0 || tp_near_sign(tp_near_sub(*end, own->low)) <= 0) continue;
      held = true;
      *end = own->low;
    }
    if (!held) return step > 0;
    at = tp_near_sub(*end, (tp_near){beside * fabs(end->value), 0});
  }
  return false;
}

bool tp_onset_filter_end(bool *never, tp_near *end, const tp_onset_filter *found, tp_near tangent,
                         bool moves) {
  *never = false;
  return moves ? find_below(end, found, tangent) : find_above(never, end, found, tangent);
}
