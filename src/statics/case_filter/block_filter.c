/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Points of contact are both ends of each edge of the underside; differences of doubles are exact
 * but for one rounding, and zero where two are the same, so that level facets stay level. Positions
 * are differences from a point near by, so that the bounds do not grow with the distance of a block
 * from the origin, as in map coordinates. */

#include "case_filter/block_filter.h"

#include "case_filter/near_plan.h"
#include "case_filter/thin_contact.h"

#include <math.h>

/* A coordinate from the centroid, by way of the point near by. */
static tp_near from_centroid(double own, double origin, tp_near centroid) {
  const double apart = own - origin;
  return tp_near_sub((tp_near){apart, fabs(apart) * DBL_EPSILON}, centroid);
}

/* The k-th, from the centroid; towards the right x is mirrored, and up-dip is the other way along.
 * Only facets that run up-dip. */
static bool set_point(tp_shape_point *p, const tp_block_underside *u, int k, tp_direction towards) {
  const int facet = k / 2, vertex = facet + k % 2;
  p->x = from_centroid(u->x[vertex], u->origin_x, u->centroid_x);
  p->y = from_centroid(u->y[vertex], u->origin_y, u->centroid_y);
  tp_facet_direction(p, u, facet);
  if (tp_near_sign(p->tx) <= 0) return false;
  if (towards == TP_TOWARDS_LEFT) return true;
  p->x = tp_near_neg(p->x);
  p->ty = tp_near_neg(p->ty);
  return true;
}

static bool set_points(tp_case_shape *shape, const tp_block_underside *u, tp_direction towards) {
  bool done = true;
  for (int k = 0; k < 2 * (u->count - 1) && done; k++) {
    done = set_point(shape->points + k, u, k, towards);
  }
  return done;
}

/* The first facet in the direction of this one, or this; -1 where that is open. */
static int axis_of(const tp_case_shape *shape, int facet) {
  const tp_shape_point *own = shape->points + 2 * (size_t)facet;
  for (int other = 0; other < facet; other++) {
    const tp_near cross = tp_facets_cross(own, shape->points + 2 * (size_t)other);
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
static void set_pivot(tp_case_filter *f, const tp_block_underside *u, tp_direction towards,
                      int point) {
  const int vertex = towards == TP_TOWARDS_LEFT ? 0 : u->count - 1;
  f->pivot_count = 1;
  f->pivots[0] = (tp_filter_pivot){.point = point,
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

/* ---- many facets -------------------------------------------------------------------------------
 */

/* All points in doubles. False of facets so short that products of them are no numbers. */
static bool set_rest(tp_contact_rest *rest, const tp_block_underside *u, tp_direction towards) {
  static const double least = 1e-100;
  const double way = towards == TP_TOWARDS_LEFT ? 1 : -1;
  bool long_enough = true;
  double apart = 0; /* from the point near by */
  rest->count = 2 * (u->count - 1);
  rest->far = 0;
  for (int k = 0; k < rest->count; k++) {
    const int facet = k / 2, vertex = facet + k % 2;
    const double x = u->x[vertex] - u->origin_x, y = u->y[vertex] - u->origin_y;
    apart = fmax(apart, fmax(fabs(x), fabs(y)));
    rest->x[k] = way * (x - u->centroid_x.value);
    rest->y[k] = y - u->centroid_y.value;
    rest->tx[k] = u->x[facet + 1] - u->x[facet];
    rest->ty[k] = way * (u->y[facet + 1] - u->y[facet]);
    rest->far = fmax(rest->far, fmax(fabs(rest->x[k]), fabs(rest->y[k])));
    long_enough = long_enough && rest->tx[k] >= least;
  }
  rest->off = fmax(u->centroid_x.error, u->centroid_y.error) + apart * DBL_EPSILON;
  return long_enough;
}

/* May a point's facet be parallel to another of the few? By the slopes of theirs alone. */
static bool may_be_parallel(int point, double slope, const tp_thin_contact *few,
                            const double *slopes) {
  static const double apart = 1e-12;
  for (int k = 0; k < few->count; k++) {
    const bool own = few->points[k] / 2 == point / 2;
    if (!own && fabs(slope - slopes[k]) <= apart * fabs(slope)) return true;
  }
  return false;
}

/* Keeps of all points those that are none of the few, nor add anything to them. */
static void drop_from_rest(tp_contact_rest *rest, const tp_thin_contact *thin,
                           const tp_block_underside *u, double friction) {
  const int count = rest->count;
  bool few[TP_REST_POINTS] = {false};
  double slopes[TP_PLAN_POINTS];
  for (int k = 0; k < thin->count; k++) {
    const int point = thin->points[k];
    few[point] = true;
    slopes[k] = rest->ty[point] / rest->tx[point];
  }
  rest->count = 0;
  for (int k = 0; k < count; k++) {
    const bool parallel = may_be_parallel(k, rest->ty[k] / rest->tx[k], thin, slopes);
    if (few[k] || (parallel && tp_point_lies_between(u, k, thin->points, thin->count, friction))) {
      continue;
    }
    rest->x[rest->count] = rest->x[k];
    rest->y[rest->count] = rest->y[k];
    rest->tx[rest->count] = rest->tx[k];
    rest->ty[rest->count++] = rest->ty[k];
  }
}

/* An axis is that of the first point on it. */
static bool set_axes(tp_contact_plan *plan, const tp_case_shape *shape) {
  for (int k = 0; k < plan->point_count; k++) {
    plan->points[k].axis = k;
    for (int before = 0; before < k; before++) {
      const bool same = plan->points[before].facet == plan->points[k].facet;
      const tp_near cross = tp_facets_cross(shape->points + before, shape->points + k);
      const bool parallel = same || tp_near_is_zero(cross);
      if (!parallel && tp_near_sign(cross) == 0) return false;
      if (!parallel) continue;
      plan->points[k].axis = plan->points[before].axis;
      break;
    }
  }
  return true;
}

static int place_of(const tp_thin_contact *thin, int point) {
  int k = 0;
  while (thin->points[k] != point) k++;
  return k;
}

/* Those of which one may be the steepest. */
static void set_few_facets(tp_case_filter *f, const tp_block_underside *u,
                           const tp_thin_contact *thin, tp_direction towards) {
  f->facet_count = thin->facet_count;
  for (int k = 0; k < thin->facet_count; k++) {
    const int facet = thin->facets[k], down_dip = towards == TP_TOWARDS_LEFT ? 0 : 1;
    f->facets[k] = (tp_filter_facet){.point = place_of(thin, 2 * facet),
                                     .down_dip = place_of(thin, 2 * facet + down_dip),
                                     .is_level = u->y[facet] == u->y[facet + 1]};
  }
}

/* All other facets rise no more towards down-dip than one of the few, of which the first lies
 * down-dip of the centroid if any does: that governs in their place, or stands in the way of it. */
static bool are_less_steep(const tp_case_filter *f, const tp_block_underside *u,
                           const tp_thin_contact *thin, tp_direction towards) {
  for (int k = 0; k < u->count - 1; k++) {
    if (k == thin->facets[0] || k == thin->facets[thin->facet_count - 1]) continue;
    const int down_dip = towards == TP_TOWARDS_LEFT ? 0 : 1;
    tp_shape_point own;
    if (!set_point(&own, u, 2 * k + down_dip, towards)) return false;
    const int side = tp_near_sign(own.x);
    bool less = false;
    for (int few = 0; few < f->facet_count && side != 0; few++) {
      const tp_filter_facet *other = f->facets + few;
      const bool stands_for = side > 0 || tp_near_sign(f->shape.points[other->down_dip].x) < 0;
      const tp_near cross = tp_facets_cross(f->shape.points + other->point, &own);
      less = less || (stands_for && (tp_near_is_zero(cross) || tp_near_sign(cross) > 0));
    }
    if (!less) return false;
  }
  return true;
}

static bool opens_rest(const tp_case_filter *f) {
  bool opens = true;
  for (int k = 0; k < f->plan.ray_count && opens; k++) {
    tp_near ray[3];
    tp_shape_ray(ray, &f->shape, f->plan.rays + k);
    opens = tp_contact_rest_opens(&f->rest, ray);
  }
  return opens;
}

static bool find_few(tp_case_filter *f, const tp_block_underside *u, tp_direction towards,
                     double friction) {
  const bool left = towards == TP_TOWARDS_LEFT;
  const int toe = left ? 0 : 2 * (u->count - 1) - 1;
  tp_thin_contact thin;
  if (!set_rest(&f->rest, u, towards) ||
      !tp_thin_contact_find(&thin, &f->rest, friction, toe, left)) {
    return false;
  }
  drop_from_rest(&f->rest, &thin, u, friction);
  f->plan.point_count = thin.count;
  for (int k = 0; k < thin.count; k++) {
    const int point = thin.points[k], facet = point / 2;
    if (!set_point(f->shape.points + k, u, point, towards)) return false;
    f->plan.points[k] = (tp_plan_point){facet + point % 2, facet, 0, true};
  }
  if (!set_axes(&f->plan, &f->shape)) return false;
  tp_shape_set_rows(&f->shape, thin.count);
  set_pivot(f, u, towards, place_of(&thin, toe));
  set_few_facets(f, u, &thin, towards);
  return are_less_steep(f, u, &thin, towards) &&
         tp_near_plan_find_ring(&f->plan, &f->shape, thin.ring, thin.ring_count, u->count - 1) &&
         opens_rest(f);
}

/* ---- all of it ---------------------------------------------------------------------------------
 */

bool tp_block_filter_init(tp_case_filter *f, const tp_block_underside *u, tp_direction towards,
                          double friction) {
  enum { FEW = 4 };
  const int facets = u->count - 1;
  if (facets < 1 || facets > TP_REST_FACETS) return false;
  f->shape.gyration = u->gyration;
  f->varies = f->rests = false;
  f->variable_count = 0;
  f->loads = (tp_load_plan){.called_for = false};
  f->capacities.acts = false;
  f->rest.count = 0;
  if (facets > FEW) return find_few(f, u, towards, friction);
  if (!set_points(&f->shape, u, towards) || !set_plan(&f->plan, &f->shape, facets)) return false;
  set_pivot(f, u, towards, towards == TP_TOWARDS_LEFT ? 0 : f->plan.point_count - 1);
  set_facets(f, u, towards);
  return true;
}
