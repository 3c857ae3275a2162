/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The contact of a case in doubles with bounds (number/near.h), about the block's centroid,
 * down-dip towards -x; any one unit of length. What is zero by the plan is so exactly. */

#ifndef TP_CASE_FILTER_SHAPE_H
#define TP_CASE_FILTER_SHAPE_H

#include "case_filter/contact_plan.h"
#include "plane/contact_rows.h"

typedef struct tp_shape_point {
  tp_near x, y;               /* from the centroid */
  tp_near tx, ty;             /* along its facet, up-dip */
  tp_near normal[3], slip[3]; /* its rows (plane/contact_rows.h) */
} tp_shape_point;

typedef struct tp_case_shape {
  tp_near area;     /* of a block that varies */
  tp_near gyration; /* square of its radius */
  tp_shape_point points[TP_PLAN_POINTS];
  tp_near inertia[TP_PLAN_RAYS][3]; /* M r = (v_x, v_y, k^2 omega) of each ray */
} tp_case_shape;

/* The rows of its points, from their x, y and t. */
void tp_shape_set_rows(tp_case_shape *shape, int point_count);

/* A ray of the plan, made anew from the rows. */
void tp_shape_ray(tp_near ray[3], const tp_case_shape *shape, const tp_plan_ray *own);

/* M r of the k-th ray. */
void tp_shape_set_inertia(tp_case_shape *shape, int k, const tp_near ray[3]);

/* From the points' x, y, t and the gyration the rest; false where the motions are not certainly
 * those of the plan. */
bool tp_shape_complete(tp_case_shape *shape, const tp_contact_plan *plan);

/* The edge of a point's friction cone as (f_x, f_y, moment), with tan(phi). */
static inline void tp_shape_edge(tp_near force[3], const tp_case_shape *shape, tp_cone_edge edge,
                                 tp_near friction) {
  const tp_shape_point *p = shape->points + edge.point;
  tp_sparse_cone_row(force, p->normal, p->slip, &friction, edge.against);
}

/* k^2 M^-1 h of a point: what loads do to how it opens. */
static inline void tp_shape_response(tp_near response[3], const tp_case_shape *shape, long point) {
  const tp_near *normal = shape->points[point].normal;
  response[0] = tp_near_times(normal[0], shape->gyration);
  response[1] = tp_near_times(normal[1], shape->gyration);
  response[2] = normal[2];
}

#endif
