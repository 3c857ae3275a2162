/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Moments about a pivot, over the weight and cos(tilt): of the weight alone by its arms, x / y over
 * tan(tilt) (docs/mechanics.md section 3); of loads what stabilises over what overturns, each with
 * the sign of its moment (section 5). Which motion turns about the pivot is told by the modes. */

#include "case_filter/moments_filter.h"

void tp_filter_arms(tp_near *x, tp_near *y, const tp_filter_case *of,
                    const tp_filter_pivot *pivot) {
  const tp_shape_point *p = of->shape->points + pivot->point;
  tp_filter_load_arms(x, y, &of->loads->sum, p->x, p->y);
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

/* A moment on the side of its sign, if it is none of nothing. */
static bool weigh(tp_near *stabilising, tp_near *overturning, tp_near holds) {
  const int sign = tp_near_sign(holds);
  if (sign > 0) *stabilising = tp_near_plus(*stabilising, holds);
  if (sign < 0) *overturning = tp_near_minus(*overturning, holds);
  return sign != 0 || tp_near_is_zero(holds);
}

/* The weight by its two components, then each load (evaluation/loaded_balance.c). */
static bool balance(tp_fos_told *fos, const tp_filter_case *of, const tp_shape_point *p,
                    tp_near tangent) {
  tp_near stabilising = {0, 0}, overturning = {0, 0};
  for (int k = 0; k < of->loads->count; k++) {
    tp_near level, rise;
    tp_filter_load_arms(&level, &rise, of->loads->items + k, p->x, p->y);
    const tp_near turned = tp_near_neg(tp_near_times(rise, tangent));
    const bool told = k == 0 ? weigh(&stabilising, &overturning, level) &&
                                   weigh(&stabilising, &overturning, turned)
                             : weigh(&stabilising, &overturning, tp_near_plus(level, turned));
    if (!told) return false;
  }
  const bool number = !tp_near_is_zero(overturning);
  *fos = (tp_fos_told){number ? TP_FOS_NUMBER : TP_FOS_NO_OVERTURNING,
                       number ? tp_near_div(stabilising, overturning) : overturning};
  return true;
}

/* By the weight alone: nothing overturns on level ground. */
static tp_fos_told by_arms(tp_near x, tp_near y, tp_near tangent) {
  if (tp_near_is_zero(tangent)) return (tp_fos_told){TP_FOS_NO_OVERTURNING, tangent};
  return (tp_fos_told){TP_FOS_NUMBER, tp_near_div(x, tp_near_mul(y, tangent))};
}

bool tp_moments_filter(tp_filter_way *way, const tp_case_told *told, const tp_filter_state *s,
                       const tp_filter_pivot *pivot) {
  tp_near x, y;
  tp_filter_arms(&x, &y, &told->of, pivot);
  const tp_mechanism turn = s->moves ? turn_about(told, pivot, s->tangent) : TP_MECHANISM_UNDECIDED;
  const bool begins = turn != TP_MECHANISM_UNDECIDED;
  *way = (tp_filter_way){.fos = by_arms(x, y, s->tangent),
                         .has_critical = true,
                         .critical = tp_near_div(x, y),
                         .begins = begins,
                         .definition = TP_FOS_BY_MOMENTS,
                         .mechanism = begins ? turn : TP_TOPPLES};
  return !told->of.loads->called_for ||
         balance(&way->fos, &told->of, told->of.shape->points + pivot->point, s->tangent);
}
