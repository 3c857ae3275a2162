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

void tp_shape_ray(tp_near ray[3], const tp_case_shape *shape, const tp_plan_ray *own) {
  static const tp_near zero = {0, 0};
  const tp_shape_point *p = shape->points + own->point;
  if (own->kind == TP_RAY_SLIDES) {
    ray[0] = p->tx;
    ray[1] = p->ty;
    ray[2] = zero;
  } else if (own->kind == TP_RAY_TURNS) {
    tp_sparse_turn(ray, &p->x, &p->y);
  } else {
    tp_sparse_cross(ray, p->normal, shape->points[own->other].normal);
  }
  if (own->sense < 0) tp_sparse_reverse(ray);
}

static bool is_of_plan(const tp_near ray[3], const tp_case_shape *shape,
                       const tp_contact_plan *plan, const tp_plan_ray *own) {
  for (int k = 0; k < plan->point_count; k++) {
    const tp_shape_point *p = shape->points + k;
    if (own->opens[k] != 0) {
      if (tp_near_sign(tp_sparse_dot(ray, p->normal)) != own->opens[k]) return false;
    } else if (own->slips[k] != 0 && tp_near_sign(tp_sparse_dot(ray, p->slip)) != own->slips[k]) {
      return false;
    }
  }
  return true;
}

void tp_shape_set_rows(tp_case_shape *shape, int point_count) {
  for (int k = 0; k < point_count; k++) {
    tp_shape_point *p = shape->points + k;
    tp_sparse_normal_row(p->normal, &p->x, &p->y, &p->tx, &p->ty);
    tp_sparse_slip_row(p->slip, &p->x, &p->y, &p->tx, &p->ty);
  }
}

/* About the centroid. */
void tp_shape_set_inertia(tp_case_shape *shape, int k, const tp_near ray[3]) {
  shape->inertia[k][0] = ray[0];
  shape->inertia[k][1] = ray[1];
  shape->inertia[k][2] = tp_near_times(ray[2], shape->gyration);
}

bool tp_shape_complete(tp_case_shape *shape, const tp_contact_plan *plan) {
  tp_shape_set_rows(shape, plan->point_count);
  for (int k = 0; k < plan->ray_count; k++) {
    tp_near ray[3];
    tp_shape_ray(ray, shape, plan->rays + k);
    if (!is_of_plan(ray, shape, plan, plan->rays + k)) return false;
    tp_shape_set_inertia(shape, k, ray);
  }
  return true;
}
