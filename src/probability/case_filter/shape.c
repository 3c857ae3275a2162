/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Is the cone K of another scene the one of the plan? Each ray r of the plan is made anew: a slide
 * along its facet, a turn about its point, or what two normal lines h have in common. Where h . r
 * is above zero for each point that the plan has it leave, and zero by what the ray is made of for
 * the others, r is a ray of the new K, and two rays of one face still share that face's line. The
 * faces of a cone in space are a closed ring, so that there are no others; where K has a line in
 * it, its rays are slides and turns, whose signs tell the same. With the signs of all slips the
 * modes are those of the plan, too. */

#include "case_filter/shape.h"

static void set_ray(tp_near ray[3], const tp_case_shape *shape, const tp_plan_ray *own) {
  static const tp_near zero = {0, 0}, one = {1, 0};
  const tp_shape_point *p = shape->points + own->point;
  if (own->kind == TP_RAY_SLIDES) {
    ray[0] = p->tx;
    ray[1] = p->ty;
    ray[2] = zero;
  } else if (own->kind == TP_RAY_TURNS) {
    ray[0] = p->y;
    ray[1] = tp_near_neg(p->x);
    ray[2] = one;
  } else {
    const tp_shape_point *q = shape->points + own->other;
    const tp_near h[3] = {tp_near_neg(p->ty), p->tx, p->along};
    const tp_near k[3] = {tp_near_neg(q->ty), q->tx, q->along};
    tp_near_vector_cross(ray, h, k);
  }
  for (int e = 0; e < 3 && own->sense < 0; e++) ray[e] = tp_near_neg(ray[e]);
}

/* Along the normal of a point's facet, and along the facet. */
static tp_near opening(const tp_near ray[3], const tp_shape_point *p) {
  return tp_near_plus(tp_near_minus(tp_near_times(ray[1], p->tx), tp_near_times(ray[0], p->ty)),
                      tp_near_times(ray[2], p->along));
}

static tp_near slip(const tp_near ray[3], const tp_shape_point *p) {
  return tp_near_plus(tp_near_plus(tp_near_times(ray[0], p->tx), tp_near_times(ray[1], p->ty)),
                      tp_near_times(ray[2], p->about));
}

static bool is_of_plan(const tp_near ray[3], const tp_case_shape *shape,
                       const tp_contact_plan *plan, const tp_plan_ray *own) {
  for (int k = 0; k < plan->point_count; k++) {
    const tp_shape_point *p = shape->points + k;
    if (own->opens[k] != 0) {
      if (tp_near_sign(opening(ray, p)) != own->opens[k]) return false;
    } else if (own->slips[k] != 0 && tp_near_sign(slip(ray, p)) != own->slips[k]) {
      return false;
    }
  }
  return true;
}

bool tp_shape_complete(tp_case_shape *shape, const tp_contact_plan *plan) {
  for (int k = 0; k < plan->point_count; k++) {
    tp_shape_point *p = shape->points + k;
    p->along = tp_near_plus(tp_near_times(p->tx, p->x), tp_near_times(p->ty, p->y));
    p->about = tp_near_minus(tp_near_times(p->x, p->ty), tp_near_times(p->y, p->tx));
  }
  for (int k = 0; k < plan->ray_count; k++) {
    tp_near ray[3];
    set_ray(ray, shape, plan->rays + k);
    if (!is_of_plan(ray, shape, plan, plan->rays + k)) return false;
    shape->inertia[k][0] = ray[0];
    shape->inertia[k][1] = ray[1];
    shape->inertia[k][2] = tp_near_times(ray[2], shape->gyration);
  }
  return true;
}

/* n + t tan(phi) with n = (-t_y, t_x); its moment q x n + tan(phi) q x t, q x n = t . q. */
void tp_shape_edge(tp_near force[3], const tp_case_shape *shape, tp_plan_edge edge,
                   tp_near friction) {
  const tp_shape_point *p = shape->points + edge.point;
  const tp_near along = edge.against ? tp_near_neg(friction) : friction;
  force[0] = tp_near_minus(tp_near_times(along, p->tx), p->ty);
  force[1] = tp_near_plus(tp_near_times(along, p->ty), p->tx);
  force[2] = tp_near_plus(p->along, tp_near_times(along, p->about));
}
