/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the base has to bear of the loads that turn with the tilt as the weight does: the weight
 * itself, an earthquake, water that stands along the face, its uplift, surcharges. Over the weight
 * and cos(tilt) each is at + t rise with t = tan(tilt), as (f_x, f_y, moment) about the centroid in
 * the unit of the shape (shape.h), the opposite of what acts on the block (load/wrench.h). */

#ifndef TP_CASE_FILTER_FILTER_LOADS_H
#define TP_CASE_FILTER_FILTER_LOADS_H

#include "case_filter/shape.h"

enum { TP_FILTER_LOADS = 8 };

typedef struct tp_filter_load {
  tp_near at[3], rise[3];
} tp_filter_load;

typedef struct tp_filter_loads {
  bool called_for; /* any besides the weight */
  bool turns;      /* their moment about the centroid is not zero throughout */
  int count;       /* the weight first */
  tp_filter_load items[TP_FILTER_LOADS], sum;
} tp_filter_loads;

/* The weight alone. */
void tp_filter_loads_init(tp_filter_loads *loads);
/* One more; false where there is no room for it. */
TP_MUST_USE bool tp_filter_loads_add(tp_filter_loads *loads, const tp_filter_load *load);

/* All of them at a tilt: (t, 1, 0) of the weight alone. */
static inline void tp_filter_loads_at(tp_near force[3], const tp_filter_loads *loads,
                                      tp_near tangent) {
  const tp_filter_load *sum = &loads->sum;
  force[0] = tangent;
  force[1] = sum->at[1];
  force[2] = sum->at[2];
  for (int k = 0; k < 3 && loads->called_for; k++) {
    force[k] = tp_near_plus(sum->at[k], tp_near_times(tangent, sum->rise[k]));
  }
}

/* Their power on a twist, level + t rise. */
static inline void tp_filter_loads_power(tp_near *level, tp_near *rise,
                                         const tp_filter_loads *loads, const tp_near twist[3]) {
  *level = loads->called_for ? tp_sparse_dot(twist, loads->sum.at) : twist[1];
  *rise = loads->called_for ? tp_sparse_dot(twist, loads->sum.rise) : twist[0];
}

/* Moment about a point that holds the block back: level - t rise, the point from the centroid. */
void tp_filter_load_arms(tp_near *level, tp_near *rise, const tp_filter_load *load, tp_near x,
                         tp_near y);

/* A case with the numbers of a sample. */
typedef struct tp_filter_case {
  const tp_contact_plan *plan;
  const tp_case_shape *shape;
  const tp_filter_loads *loads;
  tp_near friction; /* tan(phi) */
} tp_filter_case;

#endif
