/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The verdicts of stability/mechanism.c and the least factor of stability/governing.c, of a block
 * under its weight alone that has a limit at an angle. Tangents rise with tilts, so that the order
 * of the two is the same. */

#include "case_filter/sliding_filter.h"

#include "number/near_angle.h"

/* tan(phi) times this, or over it, is as good as any strength, or as none
 * (strength_reduction/reduction.c). */
static const double most_factor = 1e6;

static tp_near tangent_of(tp_near degrees) {
  tp_near sine, cosine;
  if (tp_near_is_zero(degrees)) return degrees;
  tp_near_sin_cos(&sine, &cosine, degrees);
  if (tp_near_sign(cosine) <= 0) return (tp_near){0, INFINITY};
  return tp_near_div(sine, cosine);
}

/* ---- by moments --------------------------------------------------------------------------------
 */

/* The arms of the weight about a pivot: x / y is the tangent of the critical angle. */
static void set_arms(tp_near *x, tp_near *y, const tp_shape *shape, const tp_filter_pivot *pivot) {
  const tp_shape_point *p = shape->points + pivot->point;
  *x = tp_near_neg(p->x);
  *y = tp_near_neg(p->y);
}

/* The admissible pivot with the least critical angle. Each must stand level, and topple below 90
 * degrees. */
static bool find_pivot(tp_case_told *told) {
  const tp_case_filter *f = told->filter;
  tp_near least = {0, 0};
  told->pivot = NULL;
  for (int k = 0; k < f->pivot_count; k++) {
    tp_near x, y;
    if (!f->pivots[k].admissible) continue;
    set_arms(&x, &y, told->shape, f->pivots + k);
    if (tp_near_sign(x) <= 0 || tp_near_sign(y) <= 0) return false;
    const tp_near tangent = tp_near_div(x, y);
    const int order = told->pivot == NULL ? -1 : tp_near_sign(tp_near_sub(tangent, least));
    if (order == 0) return false;
    if (order > 0) continue;
    least = tangent;
    told->pivot = f->pivots + k;
  }
  told->moments_deg = tp_near_arctangent(least);
  return told->pivot != NULL;
}

/* ---- at any tilt -------------------------------------------------------------------------------
 */

/* The shape of a block that varies, and where its pivots lie. */
static bool take_shape(tp_case_told *told, tp_near_outline *outline, const tp_near *variables) {
  const tp_case_filter *f = told->filter;
  told->shape = f->varies ? &told->own : &f->shape;
  return !f->varies || (tp_outline_map_shape(&told->own, outline, &f->map, &f->plan, variables) &&
                        tp_shape_complete(&told->own, &f->plan));
}

static tp_near coordinate(const tp_case_filter *f, tp_near own, bool varies, tp_bounded given) {
  const double unit = f->map.metres_per_unit;
  if (!varies) return (tp_near){given.value, given.error};
  return tp_near_mul(own, (tp_near){unit, unit * DBL_EPSILON});
}

static void place_pivot(tp_case_told *told, const tp_near_outline *outline) {
  const tp_case_filter *f = told->filter;
  const int at = f->varies ? f->map.points[told->pivot->point].vertex : 0;
  const bool x = f->varies && f->map.x[at].varies, y = f->varies && f->map.y[at].varies;
  told->pivot_x_m = coordinate(f, outline->x[at], x, told->pivot->x_m);
  told->pivot_y_m = coordinate(f, outline->y[at], y, told->pivot->y_m);
}

bool tp_case_filter_tell(tp_case_told *told, const tp_case_filter *f, tp_near friction_deg,
                         const tp_near *variables) {
  static const tp_near level = {0, 0};
  tp_near_outline outline;
  outline.x[0] = outline.y[0] = level;
  told->filter = f;
  told->friction = tangent_of(friction_deg);
  if (tp_near_sign(told->friction) <= 0 || !take_shape(told, &outline, variables) ||
      !find_pivot(told)) {
    return false;
  }
  place_pivot(told, &outline);
  tp_edge_set edges;
  tp_limit_filter limit;
  tp_edge_set_init(&edges, &f->plan, told->shape, told->friction);
  if (!tp_limit_filter_find(&limit, &edges) || !tp_limit_filter_holds(&edges, level) ||
      !tp_onset_filter_find(&told->onset, &f->plan, told->shape, told->friction)) {
    return false;
  }
  told->limit = limit.mechanism;
  told->limit_tangent = limit.value;
  told->limit_deg = tp_near_arctangent(limit.value);
  told->never = told->onset.never;
  if (!told->never) told->onset_deg = tp_near_arctangent(told->onset.tangent);
  return true;
}

/* ---- at one ------------------------------------------------------------------------------------
 */

/* Forces hold it on level ground and at the limit, and so between. */
static bool tell_mechanism(tp_case_told_at *at, const tp_case_told *told, tp_near tangent) {
  const int side = tp_near_sign(tp_near_sub(told->limit_tangent, tangent));
  bool moves = false;
  unsigned beginnings = 0;
  if (side == 0 || !tp_onset_filter_look(&moves, &beginnings, &told->onset, tangent)) return false;
  at->mechanism = side < 0 ? told->limit : moves ? TP_MAY_MOVE : TP_STANDS;
  if (side > 0 || beginnings == 0 || (beginnings & 1U << told->limit) != 0) return true;
  int first = TP_SLIDES;
  while ((beginnings & 1U << first) == 0) first++;
  at->mechanism = (tp_mechanism)first;
  return true;
}

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

/* By strength reduction. No strength holds a block that topples by its moments: then these tell. */
static bool take_reduction(least *l, const tp_case_told *told, tp_near tangent) {
  const tp_contact_plan *plan = &told->filter->plan;
  const tp_shape *shape = told->shape;
  tp_limit_filter found;
  if (tp_limit_filter_reduce(&found, plan, shape, tangent)) {
    const tp_near factor = tp_near_div(told->friction, found.value);
    const bool within = factor.value > 2 / most_factor && factor.value < most_factor / 2;
    return within && take(l, TP_FOS_NUMBER, factor, TP_FOS_BY_REDUCTION, found.mechanism);
  }
  tp_edge_set edges;
  const tp_near many = {most_factor, 0};
  tp_edge_set_init(&edges, plan, shape, tp_near_mul(told->friction, many));
  if (tp_limit_filter_is_lost(&edges, tangent)) {
    return l->number && tp_near_sign(tp_near_sub((tp_near){1, 0}, l->fos)) > 0;
  }
  tp_edge_set_init(&edges, plan, shape, tp_near_div(told->friction, many));
  return tp_limit_filter_holds(&edges, tangent) &&
         take(l, TP_FOS_NO_OVERTURNING, (tp_near){0, 0}, TP_FOS_BY_REDUCTION,
              TP_MECHANISM_UNDECIDED);
}

static bool tell_factor(tp_case_told_at *at, const tp_case_told *told, tp_near tangent) {
  least l = {.any = false};
  tp_near x, y;
  tp_sliding_told sliding;
  set_arms(&x, &y, told->shape, told->pivot);
  const bool level = tp_near_is_zero(tangent); /* nothing overturns */
  const tp_near by_moments = level ? tangent : tp_near_div(x, tp_near_mul(y, tangent));
  bool done = take(&l, level ? TP_FOS_NO_OVERTURNING : TP_FOS_NUMBER, by_moments, TP_FOS_BY_MOMENTS,
                   TP_TOPPLES) &&
              tp_sliding_filter(&sliding, told, tangent);
  if (done && sliding.counts) {
    done = take(&l, sliding.shear, sliding.by_shear, TP_FOS_BY_SHEAR, TP_SLIDES) &&
           (sliding.is_level ||
            take(&l, sliding.rough, sliding.by_roughness, TP_FOS_BY_ROUGHNESS, TP_SLIDES));
  }
  done = done && take_reduction(&l, told, tangent);
  at->state = l.number ? TP_FOS_NUMBER : TP_FOS_NO_OVERTURNING;
  at->fos = l.fos;
  at->fos_mechanism = l.mechanism;
  at->fos_definition = l.definition;
  return done;
}

bool tp_case_filter_tell_at(tp_case_told_at *at, const tp_case_told *told, tp_near tilt_deg) {
  const tp_near tangent = tangent_of(tilt_deg);
  return (tp_near_is_zero(tangent) || tp_near_sign(tangent) > 0) &&
         tell_mechanism(at, told, tangent) && tell_factor(at, told, tangent);
}
