/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Over the weight and cos(tilt) the base has to bear b = b_0 + t b_1 + s b_2, t = tan(tilt), s = 1
 * / cos(tilt), (t, 1, 0) of the weight alone, by edges e with factors that are not negative. Two
 * edges e_i, e_j span a face if their twist v = +-e_i x e_j has v . e > 0 with all edges but those
 * that it is zero for by construction: of a slide the parallel ones, of a turn about a contact
 * point those there. Where v . b = 0 and b = f_i e_i + f_j e_j with f_i, f_j > 0, forces hold;
 * where v . b < 0, none do (Farkas) . Without b_2 the tilts that hold are an interval, which ends
 * there where v . b_1 < 0. With it that is the first tilt that does not where v . b falls through
 * zero there and the tilts up to it are proven to hold, by the apexes of arcs between two of them.
 */

#include "case_filter/limit_filter.h"

#include "case_filter/strong_limit.h"

/* By values alone: what this rules out is not looked at with bounds. */
static bool may_span(const tp_near v[3], const tp_edge_set *set, int i, int j) {
  for (int k = 0; k < set->plan->edge_count; k++) {
    const tp_near *e = set->of[k];
    const double work = v[0].value * e[0].value + v[1].value * e[1].value + v[2].value * e[2].value;
    if (work <= 0 && !tp_edges_hold_third(set, i, j, k)) return false;
  }
  return true;
}

static bool spans(const tp_near v[3], const tp_edge_set *set, int i, int j) {
  for (int k = 0; k < set->plan->edge_count; k++) {
    if (tp_edges_hold_third(set, i, j, k)) continue;
    if (tp_near_sign(tp_sparse_dot(v, set->of[k])) <= 0) return false;
  }
  return tp_contact_rest_yields(set->rest, v, set->friction);
}

/* ---- the limit ---------------------------------------------------------------------------------
 */

/* The tangent at which the power of loads that turn with the tilt falls through zero. */
static bool falls_at(tp_near *tangent, const tp_tilt_form *power) {
  if (tp_near_sign(power->rise) == 0) return false;
  *tangent = tp_near_neg(tp_near_div(power->level, power->rise));
  return true;
}

/* The same of others, that it is above zero on level ground and below it upright. */
static bool falls_once(tp_near *tangent, const tp_tilt_form *power) {
  tp_tilt_change change;
  if (!tp_tilt_form_change(&change, power) || change.level < 0 || change.upright > 0) return false;
  *tangent = change.tangent;
  return true;
}

static bool presses(const tp_edge_set *set, int i, int j, tp_near tangent) {
  tp_near b[3];
  tp_filter_loads_at(b, set->loads, tangent);
  return tp_edges_press(set->of[i], set->of[j], b);
}

static bool is_limit(tp_near *tangent, const tp_edge_set *set, int i, int j) {
  tp_near v[3];
  tp_tilt_form power;
  tp_edges_twist(v, set, i, j);
  tp_filter_loads_power(&power, set->loads, v);
  const bool stays = set->loads->stays;
  const double level = power.level.value + power.fixed.value;
  if (stays ? level < 0 : power.rise.value > 0) {
    tp_sparse_reverse(v);
    power = tp_tilt_form_neg(power);
  }
  return may_span(v, set, i, j) &&
         (stays ? falls_once(tangent, &power) : falls_at(tangent, &power)) && spans(v, set, i, j) &&
         presses(set, i, j, *tangent);
}

bool tp_limit_filter_find(tp_limit_filter *found, const tp_edge_set *set) {
  if (set->capacities->acts) return tp_strong_limit_find(&found->value, &found->mechanism, set);
  const int count = set->plan->edge_count;
  for (int i = 0; i < count; i++) {
    for (int j = i + 1; j < count; j++) {
      if (!is_limit(&found->value, set, i, j)) continue;
      found->mechanism = tp_edges_mechanism(set, i, j);
      return true;
    }
  }
  return false;
}

/* ---- held, or lost -----------------------------------------------------------------------------
 */

/* `scale`: of what cohesion and bonds bear beside the edges. */
static bool are_borne(const tp_edge_set *set, const tp_near b[3], tp_near scale) {
  return set->capacities->acts ? tp_strong_limit_bears(set, b, scale) : tp_edges_bear(set, b);
}

static bool holds(const tp_edge_set *set, tp_near tangent) {
  static const tp_near one = {1, 0};
  tp_near b[3];
  tp_filter_loads_at(b, set->loads, tangent);
  return are_borne(set, b, set->capacities->acts ? tp_tilt_secant(tangent) : one);
}

/* The tilts between two that hold. */
static bool holds_between(const tp_edge_set *set, tp_near low, tp_near high, int halvings) {
  static const tp_near one = {1, 0};
  tp_near apex[3];
  if (!set->loads->stays) return true;
  tp_filter_loads_apex(apex, set->loads, low, high);
  if (are_borne(set, apex, one)) return true;
  const tp_near middle = {low.value + (high.value - low.value) / 2, 0};
  return halvings > 0 && holds(set, middle) && holds_between(set, low, middle, halvings - 1) &&
         holds_between(set, middle, high, halvings - 1);
}

/* Where b lies on a plane of two edges, as by symmetry, three do not tell; but tilts on either side
 * tell of all between. */
bool tp_limit_filter_holds(const tp_edge_set *set, tp_near tangent) {
  static const double aside[] = {0x1p-10, 0x1p-26};
  bool held = holds(set, tangent);
  for (int k = 0; k < 2 && !held; k++) {
    const tp_near low = {tangent.value - aside[k], 0}, high = {tangent.value + aside[k], 0};
    held = tangent.error < aside[k] / 2 && holds(set, low) && holds(set, high) &&
           holds_between(set, low, high, 0);
  }
  return held;
}

bool tp_limit_filter_holds_to(const tp_edge_set *set, tp_near tangent) {
  enum { HALVINGS = 5 };
  static const tp_near level = {0, 0};
  return tp_limit_filter_holds(set, level) && holds_between(set, level, tangent, HALVINGS);
}
