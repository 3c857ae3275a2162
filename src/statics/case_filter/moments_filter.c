/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Moments about a pivot, over the weight and cos(tilt): of the weight alone by its arms, x / y over
 * tan(tilt) (docs/mechanics.md section 3); of loads what stabilises over what overturns, each with
 * the sign of its moment, but what an active one holds back is taken from what overturns (section
 * 5). */

#include "case_filter/moments_filter.h"

/* What a bond holds. */
static tp_near bond_of(const tp_filter_case *of, const tp_filter_pivot *pivot) {
  if (!of->capacities->acts || !of->capacities->bonds) return (tp_near){0, 0};
  return tp_capacities_bond_moment(of->capacities, of->plan, of->shape, pivot->point);
}

static void moment_of_all(tp_tilt_form *moment, const tp_filter_case *of,
                          const tp_filter_pivot *pivot) {
  const tp_shape_point *p = of->shape->points + pivot->point;
  tp_filter_load_moment(moment, &of->loads->sum, p->x, p->y);
  moment->fixed = tp_near_plus(moment->fixed, bond_of(of, pivot));
}

bool tp_filter_turns(tp_filter_turning *turning, const tp_filter_case *of,
                     const tp_filter_pivot *pivot) {
  tp_tilt_form moment;
  moment_of_all(&moment, of, pivot);
  if (of->loads->stays) {
    tp_tilt_change change;
    const bool told = tp_tilt_form_change(&change, &moment);
    *turning = (tp_filter_turning){change.upright > 0, change.tangent};
    return told && change.level > 0;
  }
  if (tp_near_sign(moment.level) <= 0 || tp_near_sign(moment.rise) >= 0) return false;
  *turning = (tp_filter_turning){false, tp_near_div(moment.level, tp_near_neg(moment.rise))};
  return true;
}

/* What holds and what drives, by sums of moments. */
typedef struct balance {
  tp_near stabilising, overturning;
} balance;

/* A moment on the side of its sign, if it is none of nothing. */
static bool weigh(balance *b, tp_near holds, bool active) {
  const int sign = tp_near_sign(holds);
  if (sign > 0 && !active) {
    b->stabilising = tp_near_plus(b->stabilising, holds);
  } else if (sign != 0) {
    b->overturning = tp_near_minus(b->overturning, holds);
  }
  return sign != 0 || tp_near_is_zero(holds);
}

static bool weigh_all(balance *b, const tp_filter_case *of, const tp_filter_pivot *pivot,
                      tp_near tangent) {
  const tp_shape_point *p = of->shape->points + pivot->point;
  const tp_near secant = tp_tilt_secant(tangent);
  for (int k = 0; k < of->loads->count; k++) {
    const tp_filter_load *own = of->loads->items + k;
    tp_tilt_form m;
    tp_filter_load_moment(&m, own, p->x, p->y);
    const bool told =
        k == 0 ? weigh(b, m.level, false) && weigh(b, tp_near_times(m.rise, tangent), false)
               : weigh(b, tp_tilt_form_at(&m, tangent, secant), own->active);
    if (!told) return false;
  }
  b->stabilising = tp_near_plus(b->stabilising, tp_near_times(secant, bond_of(of, pivot)));
  return true;
}

/* The weight by its two components, then each load, then the bond (evaluation/loaded_balance.c). */
static bool balance_of(tp_fos_told *fos, const tp_filter_case *of, const tp_filter_pivot *pivot,
                       tp_near tangent) {
  balance b = {{0, 0}, {0, 0}};
  if (!weigh_all(&b, of, pivot, tangent)) return false;
  const int sign = tp_near_sign(b.overturning);
  *fos = (tp_fos_told){.state = sign > 0 ? TP_FOS_NUMBER : TP_FOS_NO_OVERTURNING};
  if (sign > 0) fos->value = tp_near_div(b.stabilising, b.overturning);
  return sign != 0 || tp_near_is_zero(b.overturning);
}

/* By the weight alone: nothing overturns on level ground. */
static tp_fos_told by_arms(const tp_tilt_form *moment, tp_near tangent) {
  if (tp_near_is_zero(tangent)) return (tp_fos_told){TP_FOS_NO_OVERTURNING, tangent};
  const tp_near turned = tp_near_mul(tp_near_neg(moment->rise), tangent);
  return (tp_fos_told){TP_FOS_NUMBER, tp_near_div(moment->level, turned)};
}

bool tp_moments_filter(tp_filter_way *way, const tp_case_told *told, const tp_filter_state *s,
                       const tp_filter_pivot *pivot) {
  tp_tilt_form moment;
  moment_of_all(&moment, &told->of, pivot);
  *way = (tp_filter_way){.fos = by_arms(&moment, s->tangent),
                         .definition = TP_FOS_BY_MOMENTS,
                         .mechanism = TP_TOPPLES};
  return !told->of.loads->called_for || balance_of(&way->fos, &told->of, pivot, s->tangent);
}
