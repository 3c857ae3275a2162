/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Governing factor in doubles with bounds: moments about each admissible pivot (docs/mechanics.md
 * section 3), sliding and strength, the least of those that count; any undecided comparison leaves
 * the sample to the full solve. */

#include "case_filter/factor_filter.h"

#include "case_filter/sliding_filter.h"
#include "case_filter/strength_filter.h"

void tp_filter_arms(tp_near *x, tp_near *y, const tp_case_shape *shape,
                    const tp_filter_pivot *pivot) {
  const tp_shape_point *p = shape->points + pivot->point;
  *x = tp_near_neg(p->x);
  *y = tp_near_neg(p->y);
}

/* ---- what governs ------------------------------------------------------------------------------
 */

/* What governs so far. */
typedef struct least {
  bool any, number;
  tp_near fos;
  tp_mechanism mechanism;
  tp_fos_definition definition;
} least;

static void name(least *l, tp_fos_definition definition, tp_mechanism mechanism) {
  l->definition = definition;
  l->mechanism = mechanism;
}

/* A factor against a mechanism, a number or beyond all. Of numbers that are not told apart the
 * first is named; their mechanisms have to be the same. */
static bool take(least *l, tp_fos_state state, tp_near fos, tp_fos_definition definition,
                 tp_mechanism mechanism) {
  if (state != TP_FOS_NUMBER) {
    if (!l->any) name(l, definition, mechanism);
    l->any = true;
    return true;
  }
  if (tp_near_sign(fos) <= 0) return false;
  const int order = l->number ? tp_near_sign(tp_near_sub(fos, l->fos)) : -1;
  if (order == 0 && mechanism != l->mechanism) return false;
  if (order < 0) name(l, definition, mechanism);
  if (order < 0) l->fos = fos;
  if (order == 0) l->fos = tp_near_lesser(l->fos, fos);
  l->any = l->number = true;
  return true;
}

/* What counts; of a block that moves, what is below 1 alone. */
static bool take_counting(least *l, const tp_filter_state *s, const tp_filter_way *own) {
  static const tp_near one = {1, 0};
  const tp_fos_told *fos = &own->fos;
  const bool below = fos->state == TP_FOS_NUMBER && tp_near_sign(tp_near_sub(fos->value, one)) < 0;
  return (s->moves && !below) || take(l, fos->state, fos->value, own->definition, own->mechanism);
}

static bool take_judged(least *l, const tp_case_told *told, const tp_filter_state *s,
                        const tp_filter_way *own) {
  const tp_filter_standing standing = tp_standing_filter(told, s, own);
  return standing == TP_FILTER_EXCLUDED ||
         (standing == TP_FILTER_COUNTS && take_counting(l, s, own));
}

/* Does a mode turn about the point: sticking there, or slipping there alone? */
static bool turns_about(const tp_contact_plan *plan, const tp_plan_mode *mode, long point) {
  const long site = plan->points[point].site;
  bool alone = mode->mechanism != TP_SLIDES && mode->edge_count > 0;
  for (int k = 0; k < mode->edge_count; k++) {
    alone = alone && plan->points[mode->edges[k].point].site == site;
  }
  const tp_plan_ray *ray = plan->rays + mode->rays[0];
  const bool sticks = mode->mechanism == TP_TOPPLES && mode->ray_count == 1 &&
                      ray->kind == TP_RAY_TURNS && plan->points[ray->point].site == site;
  return alone || sticks;
}

/* How it can begin to turn about the pivot, if it can: sticking there, or else slipping. */
static tp_mechanism turn_about(const tp_case_told *told, const tp_filter_pivot *pivot,
                               tp_near tangent) {
  const tp_contact_plan *plan = &told->filter->plan;
  tp_mechanism found = TP_MECHANISM_UNDECIDED;
  for (int k = 0; k < plan->mode_count && found != TP_TOPPLES; k++) {
    if (turns_about(plan, plan->modes + k, pivot->point) &&
        tp_filter_holds(&told->onset.modes[k].with_rays, tangent)) {
      found = plan->modes[k].mechanism;
    }
  }
  return found;
}

static tp_filter_way moments_about(const tp_case_told *told, const tp_filter_state *s,
                                   const tp_filter_pivot *pivot) {
  const bool level = tp_near_is_zero(s->tangent); /* nothing overturns */
  tp_near x, y;
  tp_filter_arms(&x, &y, told->shape, pivot);
  const tp_mechanism turn = s->moves ? turn_about(told, pivot, s->tangent) : TP_MECHANISM_UNDECIDED;
  const bool begins = turn != TP_MECHANISM_UNDECIDED;
  const tp_near fos = level ? s->tangent : tp_near_div(x, tp_near_mul(y, s->tangent));
  return (tp_filter_way){.fos = {level ? TP_FOS_NO_OVERTURNING : TP_FOS_NUMBER, fos},
                         .has_critical = true,
                         .critical = tp_near_div(x, y),
                         .begins = begins,
                         .definition = TP_FOS_BY_MOMENTS,
                         .mechanism = begins ? turn : TP_TOPPLES};
}

/* About the pivot that governs, and then all others that are admissible; `by_moments` is the least
 * of those that count, or else of all. */
static bool take_moments(least *l, tp_fos_told *by_moments, const tp_case_told *told,
                         const tp_filter_state *s) {
  tp_fos_told found[2]; /* by whether they count */
  bool has[2] = {false, false};
  for (int k = -1; k < told->filter->pivot_count; k++) {
    const tp_filter_pivot *pivot = k < 0 ? told->pivot : told->filter->pivots + k;
    if (k >= 0 && (!pivot->admissible || pivot == told->pivot)) continue;
    const tp_filter_way own = moments_about(told, s, pivot);
    const tp_filter_standing standing = tp_standing_filter(told, s, &own);
    const bool counts = standing == TP_FILTER_COUNTS;
    if (standing == TP_FILTER_OPEN || (counts && !take_counting(l, s, &own))) return false;
    found[counts] = (tp_fos_told){own.fos.state,
                                  has[counts] ? tp_near_lesser(found[counts].value, own.fos.value)
                                              : own.fos.value};
    has[counts] = true;
  }
  *by_moments = found[has[true]];
  return true;
}

static bool take_sliding(least *l, tp_fos_told *by_shear, const tp_case_told *told,
                         const tp_filter_state *s) {
  tp_sliding_told sliding;
  if (!tp_sliding_filter(&sliding, told, s->tangent)) return false;
  *by_shear = (tp_fos_told){sliding.shear, sliding.by_shear};
  if (!sliding.counts) return true;
  tp_filter_way own = {.fos = *by_shear,
                       .has_critical = sliding.has_critical,
                       .critical = sliding.critical,
                       .begins = s->moves && (s->beginnings & 1U << TP_SLIDES) != 0,
                       .definition = TP_FOS_BY_SHEAR,
                       .mechanism = TP_SLIDES};
  if (!take_judged(l, told, s, &own)) return false;
  if (sliding.is_level) return true;
  own.fos = (tp_fos_told){sliding.rough, sliding.by_roughness};
  own.definition = TP_FOS_BY_ROUGHNESS;
  return take_judged(l, told, s, &own);
}

/* What begins at the onset, where that is one mechanism alone. */
static bool find_beginning(tp_mechanism *mechanism, const tp_case_told *told) {
  static const double beside = 0x1p-30;
  const tp_near at = tp_near_mul(told->onset.tangent, (tp_near){1 + beside, 0});
  bool moves = false;
  unsigned beginnings = 0;
  if (!tp_onset_filter_look(&moves, &beginnings, &told->onset, at) || beginnings == 0) return false;
  int first = TP_SLIDES;
  while ((beginnings & 1U << first) == 0) first++;
  *mechanism = (tp_mechanism)first;
  return beginnings == 1U << first;
}

/* Of a block that stands whatever its strength: by the tilt, if that is less than what governs by
 * then. */
static bool take_tilt(least *l, const tp_case_told *told, const tp_filter_state *s) {
  if (told->never || tp_near_is_zero(s->tangent)) return true;
  const tp_near fos = tp_near_div(told->onset.tangent, s->tangent);
  const int order = l->number ? tp_near_sign(tp_near_sub(fos, l->fos)) : -1;
  if (order == 0) l->fos = tp_near_lesser(l->fos, fos);
  if (order >= 0) return true;
  tp_mechanism mechanism = TP_MECHANISM_UNDECIDED;
  return find_beginning(&mechanism, told) && take(l, TP_FOS_NUMBER, fos, TP_FOS_BY_TILT, mechanism);
}

/* Do the modes that hold the tilt lead up to the end of all tilts? */
static bool goes_on(const tp_onset_filter *o, tp_near tangent) {
  static const double beside = 0x1p-30;
  tp_near at = tangent;
  for (int step = 0; step <= o->plan->mode_count; step++) {
    tp_near most = at;
    for (int k = 0; k < o->plan->mode_count; k++) {
      const tp_near_interval *own = &o->modes[k].all;
      if (!tp_filter_holds(own, at)) continue;
      if (!own->has_high) return true;
      if (tp_near_sign(tp_near_sub(own->high, most)) > 0) most = own->high;
    }
    if (tp_near_sign(tp_near_sub(most, at)) <= 0) return false;
    at = tp_near_mul(most, (tp_near){1 + beside, 0});
  }
  return false;
}

/* Does the window that holds the tilt begin at the onset and go on to the end of all tilts? */
static bool is_in_last_window(const tp_case_told *told, tp_near tangent) {
  return tp_filter_begins_from(told, told->onset.tangent, tangent) == TP_FILTER_COUNTS &&
         goes_on(&told->onset, tangent);
}

/* Of a block that moves whatever its strength, in the window that begins at the onset and goes on:
 * by the tilt. */
static bool take_onset(least *l, const tp_case_told *told, const tp_filter_state *s) {
  if (told->never || !is_in_last_window(told, s->tangent)) return false;
  return take(l, TP_FOS_NUMBER, tp_near_div(told->onset.tangent, s->tangent), TP_FOS_BY_TILT,
              s->mover);
}

/* Of a block that moves what comes nearer to 1; where no change of strength stops it, and nothing
 * else would, the tilt. */
static bool take_strength(least *l, const tp_case_told *told, const tp_filter_state *s) {
  tp_strength_told own;
  const double most =
      l->number && !s->moves ? (l->fos.value + l->fos.error) * (1 + 0x1p-30) : INFINITY;
  if (!tp_strength_filter_find(&own, &told->filter->plan, told->shape, told->friction, s->tangent,
                               s->moves, most)) {
    return false;
  }
  if (own.found && own.farther) return true;
  if (!own.found && s->moves) return l->number || take_onset(l, told, s);
  if (!own.found) return take_tilt(l, told, s);
  const bool raised = own.share.value > 1;
  const tp_near fos = raised == s->moves ? tp_near_div((tp_near){1, 0}, own.share) : own.share;
  if (!s->moves) return take(l, TP_FOS_NUMBER, fos, TP_FOS_BY_REDUCTION, own.mechanism);
  const int order = l->number ? tp_near_sign(tp_near_sub(fos, l->fos)) : 1;
  if (order == 0) {
    l->fos = tp_near_larger(l->fos, fos);
    return l->mechanism == s->mover;
  }
  if (order < 0) return true;
  name(l, TP_FOS_BY_REDUCTION, s->mover);
  l->fos = fos;
  l->any = l->number = true;
  return true;
}

/* Where the tilt tells beside a change of strength, as at an end of a window that strength does not
 * move, balls do: that of a gap or of a window that begins at the onset and goes on is known. */
static bool is_told_without_tilt(const least *l, const tp_case_told *told,
                                 const tp_filter_state *s) {
  if (!l->number || told->never || tp_near_is_zero(s->tangent)) return true;
  if (s->moves && !is_in_last_window(told, s->tangent)) return false;
  const tp_near fos = tp_near_div(told->onset.tangent, s->tangent);
  const int order = tp_near_sign(tp_near_sub(fos, l->fos));
  return (s->moves ? order <= 0 : order >= 0) ||
         tp_strength_filter_moves_onset(&told->filter->plan, told->shape, told->friction,
                                        told->onset.tangent);
}

/* Between windows of motion, where the tilt may tell, balls do. */
static bool lies_between_windows(const tp_case_told *told, const tp_filter_state *s) {
  return !s->moves && !told->never &&
         tp_near_sign(tp_near_sub(told->onset.tangent, s->tangent)) <= 0;
}

bool tp_factor_filter(tp_case_told_at *at, const tp_case_told *told, const tp_filter_state *s) {
  least l = {.any = false};
  if (lies_between_windows(told, s) || !take_moments(&l, &at->by_moments, told, s) ||
      !take_sliding(&l, &at->by_shear, told, s) || !take_strength(&l, told, s) ||
      !is_told_without_tilt(&l, told, s)) {
    return false;
  }
  if (!l.any) name(&l, TP_FOS_BY_REDUCTION, TP_MECHANISM_UNDECIDED);
  at->fos = (tp_fos_told){l.number ? TP_FOS_NUMBER : TP_FOS_NO_OVERTURNING, l.fos};
  at->fos_mechanism = l.mechanism;
  at->fos_definition = l.definition;
  return true;
}
