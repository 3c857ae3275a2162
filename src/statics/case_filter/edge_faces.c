/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Of a turn about a contact point the edges there lie in one plane, of a slide the parallel ones;
 * any other two span a plane of their own. */

#include "case_filter/edge_faces.h"

void tp_edge_set_init(tp_edge_set *set, const tp_filter_case *of) {
  set->plan = of->plan;
  set->shape = of->shape;
  set->rest = of->rest;
  set->loads = of->loads;
  set->capacities = of->capacities;
  set->friction = of->friction;
  for (int k = 0; k < set->plan->edge_count; k++) {
    tp_shape_edge(set->of[k], set->shape, set->plan->edges[k], of->friction);
  }
}

bool tp_edges_meet(const tp_edge_set *set, int i, int j) {
  const tp_contact_plan *plan = set->plan;
  return plan->points[plan->edges[i].point].site == plan->points[plan->edges[j].point].site;
}

static bool are_parallel(const tp_contact_plan *plan, int i, int j) {
  const tp_plan_point *a = plan->points + plan->edges[i].point;
  const tp_plan_point *b = plan->points + plan->edges[j].point;
  return a->axis == b->axis && a->along == b->along &&
         plan->edges[i].against == plan->edges[j].against;
}

bool tp_edges_hold_third(const tp_edge_set *set, int i, int j, int third) {
  if (third == i || third == j) return true;
  if (tp_edges_meet(set, i, j)) return tp_edges_meet(set, i, third);
  return are_parallel(set->plan, i, j) && are_parallel(set->plan, i, third);
}

tp_mechanism tp_edges_mechanism(const tp_edge_set *set, int i, int j) {
  return tp_edges_meet(set, i, j)        ? TP_TOPPLES
         : are_parallel(set->plan, i, j) ? TP_SLIDES
                                         : TP_SLIDES_AND_TOPPLES;
}

void tp_edges_twist(tp_near v[3], const tp_edge_set *set, int i, int j) {
  static const tp_near zero = {0, 0};
  if (tp_edges_meet(set, i, j)) {
    const tp_shape_point *p = set->shape->points + set->plan->edges[i].point;
    tp_sparse_turn(v, &p->x, &p->y);
  } else if (are_parallel(set->plan, i, j)) {
    v[0] = set->of[i][1];
    v[1] = tp_near_neg(set->of[i][0]);
    v[2] = zero;
  } else {
    tp_sparse_cross(v, set->of[i], set->of[j]);
  }
}

/* From the largest component of e_i x e_j. */
bool tp_edges_press(const tp_near e_i[3], const tp_near e_j[3], const tp_near b[3]) {
  tp_near c[3], of_i[3], of_j[3];
  tp_sparse_cross(c, e_i, e_j);
  tp_sparse_cross(of_i, b, e_j);
  tp_sparse_cross(of_j, e_i, b);
  int m = 0;
  for (int e = 1; e < 3; e++) {
    if (fabs(c[e].value) > fabs(c[m].value)) m = e;
  }
  const int sign = tp_near_sign(c[m]);
  return sign != 0 && tp_near_sign(of_i[m]) == sign && tp_near_sign(of_j[m]) == sign;
}

static double value_of(const tp_near a[3], const tp_near b[3], const tp_near c[3]) {
  return a[0].value * (b[1].value * c[2].value - b[2].value * c[1].value) +
         a[1].value * (b[2].value * c[0].value - b[0].value * c[2].value) +
         a[2].value * (b[0].value * c[1].value - b[1].value * c[0].value);
}

/* By values alone: what this rules out is not looked at with bounds. */
static bool may_bear(const tp_near *const of[3], const tp_near b[3]) {
  const double whole = value_of(of[0], of[1], of[2]);
  return whole * value_of(b, of[1], of[2]) > 0 && whole * value_of(of[0], b, of[2]) > 0 &&
         whole * value_of(of[0], of[1], b) > 0;
}

static bool bears(const tp_near *const of[3], const tp_near b[3]) {
  int whole = 0;
  for (int k = 0; k < 3; k++) {
    tp_near c[3];
    tp_sparse_cross(c, of[(k + 1) % 3], of[(k + 2) % 3]);
    if (k == 0) whole = tp_near_sign(tp_sparse_dot(c, of[0]));
    if (whole == 0 || tp_near_sign(tp_sparse_dot(c, b)) != whole) return false;
  }
  return true;
}

bool tp_edges_bear(const tp_edge_set *set, const tp_near b[3]) {
  const int count = set->plan->edge_count;
  for (int i = 0; i < count; i++) {
    for (int j = i + 1; j < count; j++) {
      for (int k = j + 1; k < count; k++) {
        const tp_near *const of[3] = {set->of[i], set->of[j], set->of[k]};
        if (may_bear(of, b) && bears(of, b)) return true;
      }
    }
  }
  return false;
}
