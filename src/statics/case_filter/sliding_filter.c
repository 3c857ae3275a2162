/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The motion down-dip along a facet has the run t_x and the rise -t_y: i = atan2(rise, run). With
 * r = rise / run, a = tan(tilt) and f = tan(phi), tan(tilt - i) = (a - r) / (1 + a r) and
 * tan(phi + i) = (f + r) / (1 - f r). Under loads b, what the base bears over the weight and
 * cos(tilt), b . t drives along the facet against f b . n (evaluation/loaded_sliding.c). */

#include "case_filter/sliding_filter.h"

/* Sign of one facet's slope r less another's; 2 where open. */
static int compare(const tp_case_told *told, int facet, int other) {
  const tp_case_filter *f = told->filter;
  const tp_contact_plan *plan = &f->plan;
  const long a = f->facets[facet].point, b = f->facets[other].point;
  if (plan->points[a].axis == plan->points[b].axis) return 0; /* all runs are positive */
  const tp_shape_point *p = told->of.shape->points + a, *q = told->of.shape->points + b;
  const int sign =
      tp_near_sign(tp_near_minus(tp_near_times(q->ty, p->tx), tp_near_times(p->ty, q->tx)));
  return sign != 0 ? sign : 2;
}

/* The steepest rise of all, or of the facets that reach down-dip of the centroid: -1 of none, -2
 * where open. */
static int steepest(const tp_case_told *told, bool all) {
  const tp_case_filter *f = told->filter;
  int best = -1;
  for (int k = 0; k < f->facet_count; k++) {
    const int side = tp_near_sign(told->of.shape->points[f->facets[k].down_dip].x);
    if (!all && side == 0) return -2;
    if (!all && side > 0) continue;
    const int order = best < 0 ? 1 : compare(told, k, best);
    if (order == 2) return -2;
    if (order > 0) best = k;
  }
  return best;
}

static tp_near slope_of(const tp_case_told *told, int facet) {
  const tp_case_filter *f = told->filter;
  const tp_shape_point *p = told->of.shape->points + f->facets[facet].point;
  return f->facets[facet].is_level ? (tp_near){0, 0} : tp_near_neg(tp_near_div(p->ty, p->tx));
}

/* Where it would slide on level ground, it wedges itself between its facets, and all of them
 * count. */
static int find_facet(const tp_case_told *told) {
  const int best = steepest(told, false);
  if (best == -2) return best;
  if (best < 0) return steepest(told, true);
  const tp_near slope = slope_of(told, best);
  if (tp_near_is_zero(slope) || tp_near_sign(slope) > 0) return best;
  const int rest = tp_near_sign(tp_near_plus(told->of.friction, slope));
  return rest > 0 ? best : rest < 0 ? steepest(told, true) : -2;
}

/* Does sliding down-dip along it, by -t, press on no other facet? 2 where open. */
static int opens(const tp_case_told *told, int facet) {
  const tp_case_filter *f = told->filter;
  const tp_shape_point *own = told->of.shape->points + f->facets[facet].point;
  for (int k = 0; k < f->facet_count; k++) {
    const long at = f->facets[k].point;
    if (f->plan.points[at].axis == f->plan.points[f->facets[facet].point].axis) continue;
    const tp_shape_point *p = told->of.shape->points + at;
    const int sign =
        tp_near_sign(tp_near_minus(tp_near_times(own->tx, p->ty), tp_near_times(own->ty, p->tx)));
    if (sign <= 0) return sign < 0 ? 0 : 2;
  }
  return 1;
}

/* By the weight alone. */
static bool by_angles(tp_sliding_told *s, const tp_case_told *told, int facet, tp_near tangent) {
  static const tp_near one = {1, 0};
  const tp_near slope = slope_of(told, facet);
  const tp_near needed = tp_near_minus(tangent, slope);
  const tp_near level = tp_near_plus(one, tp_near_times(tangent, slope));
  const tp_near rest = tp_near_minus(one, tp_near_times(told->of.friction, slope));
  const int needs = tp_near_sign(needed), upright = tp_near_sign(rest);
  const bool open = needs == 0 && !tp_near_is_zero(needed);
  if (open || upright == 0 || tp_near_sign(level) <= 0) return false;
  s->has_critical = upright > 0;
  if (s->has_critical) s->critical = tp_near_div(tp_near_plus(told->of.friction, slope), rest);
  s->is_level = told->filter->facets[facet].is_level;
  s->shear = needs > 0 ? TP_FOS_NUMBER : TP_FOS_NO_OVERTURNING;
  const bool overturns = upright > 0 && !tp_near_is_zero(tangent);
  s->rough = overturns ? TP_FOS_NUMBER : TP_FOS_NO_OVERTURNING;
  if (needs > 0) {
    s->by_shear = tp_near_div(tp_near_times(told->of.friction, level), needed);
  }
  if (overturns) {
    s->by_roughness =
        tp_near_div(tp_near_plus(told->of.friction, slope), tp_near_times(rest, tangent));
  }
  return true;
}

/* Along the facet, and against it. */
static void resolve(tp_near *along, tp_near *against, const tp_near borne[3],
                    const tp_shape_point *p) {
  *along = tp_near_plus(tp_near_times(borne[0], p->tx), tp_near_times(borne[1], p->ty));
  *against = tp_near_minus(tp_near_times(borne[1], p->tx), tp_near_times(borne[0], p->ty));
}

/* What drives less what resists, over the weight and cos(tilt). */
static tp_near excess(const tp_case_told *told, const tp_near borne[3], const tp_shape_point *p) {
  tp_near along, against;
  resolve(&along, &against, borne, p);
  return tp_near_minus(along, tp_near_times(told->of.friction, against));
}

/* Of the whole contact, times the length of t. */
static tp_near cohesion_of(const tp_case_told *told, const tp_shape_point *p) {
  const tp_near own = told->capacities.cohesion;
  if (!told->capacities.acts || tp_near_is_zero(own)) return (tp_near){0, 0};
  return tp_near_times(own, tp_near_length(p->tx, p->ty));
}

/* It begins to slide where the excess rises through zero above level ground. */
static bool find_start(tp_sliding_told *s, const tp_case_told *told, const tp_shape_point *p) {
  const tp_filter_load *sum = &told->of.loads->sum;
  const tp_tilt_form over = {excess(told, sum->at, p), excess(told, sum->rise, p),
                             tp_near_minus(excess(told, sum->fixed, p), cohesion_of(told, p))};
  tp_tilt_change change = {.level = tp_near_sign(over.level), .upright = tp_near_sign(over.rise)};
  if (told->of.loads->stays ? !tp_tilt_form_change(&change, &over) : change.upright == 0) {
    return false;
  }
  s->has_critical = change.upright > 0;
  if (s->has_critical) {
    s->critical =
        told->of.loads->stays ? change.tangent : tp_near_neg(tp_near_div(over.level, over.rise));
  }
  return change.level < 0;
}

/* What drives along the facet, and what passive loads hold there: resistance. */
static bool find_drive(tp_near *drives, tp_near *held, const tp_case_told *told,
                       const tp_shape_point *p, tp_near tangent) {
  const tp_filter_loads *loads = told->of.loads;
  const tp_near secant = tp_tilt_secant(tangent);
  *held = (tp_near){0, 0};
  for (int k = 0; k < loads->count; k++) {
    const tp_near *own = loads->items[k].fixed;
    if (!loads->items[k].passive) continue;
    const tp_near along = tp_near_times(
        secant, tp_near_plus(tp_near_times(own[0], p->tx), tp_near_times(own[1], p->ty)));
    const int sign = tp_near_sign(along);
    if (sign == 0 && !tp_near_is_zero(along)) return false;
    if (sign < 0) *held = tp_near_minus(*held, along);
  }
  *drives = tp_near_plus(*drives, *held);
  return true;
}

static bool by_forces(tp_sliding_told *s, const tp_case_told *told, int facet, tp_near tangent) {
  const tp_shape_point *p = told->of.shape->points + told->filter->facets[facet].point;
  tp_near borne[3], along, against, held;
  tp_filter_loads_at(borne, told->of.loads, tangent);
  resolve(&along, &against, borne, p);
  if (!find_start(s, told, p) || !find_drive(&along, &held, told, p, tangent)) return false;
  const int drives = tp_near_sign(along);
  if (tp_near_sign(against) <= 0 || (drives == 0 && !tp_near_is_zero(along))) return false;
  s->is_level = true; /* the factor is one, whatever the facet's angle */
  s->rough = TP_FOS_NO_OVERTURNING;
  s->shear = drives > 0 ? TP_FOS_NUMBER : TP_FOS_NO_OVERTURNING;
  if (drives <= 0) return true;
  const tp_near cohesion = tp_near_times(tp_tilt_secant(tangent), cohesion_of(told, p));
  const tp_near resists =
      tp_near_plus(tp_near_times(told->of.friction, against), tp_near_plus(held, cohesion));
  s->by_shear = tp_near_div(resists, along);
  return true;
}

bool tp_sliding_filter_start(bool *starts, tp_near *critical, const tp_case_told *told) {
  tp_sliding_told s;
  const int facet = find_facet(told);
  if (facet < 0 ||
      !find_start(&s, told, told->of.shape->points + told->filter->facets[facet].point)) {
    return false;
  }
  *starts = s.has_critical;
  *critical = s.critical;
  return true;
}

bool tp_sliding_filter(tp_sliding_told *s, const tp_case_told *told, tp_near tangent) {
  const int facet = find_facet(told);
  if (facet < 0) return false;
  const int free = opens(told, facet);
  s->counts = free == 1;
  return free != 2 && (told->of.loads->called_for ? by_forces(s, told, facet, tangent)
                                                  : by_angles(s, told, facet, tangent));
}
