/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Points of contact are both ends of each edge of the underside; differences of doubles are exact
 * but for one rounding, and zero where two are the same, so that level facets stay level. */

#include "case_filter/block_filter.h"

#include "case_filter/near_plan.h"

/* a - b */
static tp_near difference(double a, double b) {
  return a == b ? (tp_near){0, 0} : tp_near_sub((tp_near){a, 0}, (tp_near){b, 0});
}

/* From the centroid; towards the right x is mirrored, and up-dip is the other way along. */
static bool set_points(tp_case_shape *shape, const tp_block_underside *u, tp_direction towards) {
  for (int k = 0; k < 2 * (u->count - 1); k++) {
    const int facet = k / 2, vertex = facet + k % 2;
    tp_shape_point *p = shape->points + k;
    p->x = tp_near_sub((tp_near){u->x[vertex], 0}, u->centroid_x);
    p->y = tp_near_sub((tp_near){u->y[vertex], 0}, u->centroid_y);
    p->tx = difference(u->x[facet + 1], u->x[facet]);
    p->ty = difference(u->y[facet + 1], u->y[facet]);
    if (tp_near_sign(p->tx) <= 0) return false;
    if (towards == TP_TOWARDS_LEFT) continue;
    p->x = tp_near_neg(p->x);
    p->ty = tp_near_neg(p->ty);
  }
  return true;
}

/* The first facet in the direction of this one, or this; -1 where that is open. */
static int axis_of(const tp_case_shape *shape, int facet) {
  const tp_shape_point *own = shape->points + 2 * (size_t)facet;
  for (int other = 0; other < facet; other++) {
    const tp_shape_point *p = shape->points + 2 * (size_t)other;
    const tp_near cross =
        tp_near_minus(tp_near_times(own->tx, p->ty), tp_near_times(own->ty, p->tx));
    if (tp_near_is_zero(cross)) return other;
    if (tp_near_sign(cross) == 0) return -1;
  }
  return facet;
}

static bool set_plan(tp_contact_plan *plan, tp_case_shape *shape, int facets) {
  plan->point_count = 2 * facets;
  for (int k = 0; k < facets; k++) {
    const int axis = axis_of(shape, k);
    if (axis < 0) return false;
    plan->points[2 * k] = (tp_plan_point){k, k, axis, true};
    plan->points[2 * k + 1] = (tp_plan_point){k + 1, k, axis, true};
  }
  tp_shape_set_rows(shape, plan->point_count);
  return tp_near_plan_find(plan, shape);
}

/* All other vertices press a facet down as they are turned about (problem/admissible.c). */
static void set_pivot(tp_case_filter *f, const tp_block_underside *u, tp_direction towards) {
  const bool left = towards == TP_TOWARDS_LEFT;
  const int vertex = left ? 0 : u->count - 1;
  f->pivot_count = 1;
  f->pivots[0] = (tp_filter_pivot){.point = left ? 0 : f->plan.point_count - 1,
                                   .admissible = true,
                                   .x_m = {.value = u->x[vertex]},
                                   .y_m = {.value = u->y[vertex]}};
}

static void set_facets(tp_case_filter *f, const tp_block_underside *u, tp_direction towards) {
  f->facet_count = u->count - 1;
  for (int k = 0; k < f->facet_count; k++) {
    const long point = 2 * (long)k;
    f->facets[k] = (tp_filter_facet){.point = point,
                                     .down_dip = towards == TP_TOWARDS_LEFT ? point : point + 1,
                                     .is_level = u->y[k] == u->y[k + 1]};
  }
}

bool tp_block_filter_init(tp_case_filter *f, const tp_block_underside *u, tp_direction towards) {
  const int facets = u->count - 1;
  if (facets < 1 || 2 * facets > TP_PLAN_POINTS) return false;
  f->shape.gyration = u->gyration;
  f->varies = false;
  f->loads = (tp_load_plan){.called_for = false};
  if (!set_points(&f->shape, u, towards) || !set_plan(&f->plan, &f->shape, facets)) return false;
  set_pivot(f, u, towards);
  set_facets(f, u, towards);
  return true;
}
