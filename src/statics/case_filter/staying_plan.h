/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The loads of a scene that stay with the block as it is tilted: anchors, supports, pressures, and
 * the water and ice of a site. Found once, in balls. */

#ifndef TP_CASE_FILTER_STAYING_PLAN_H
#define TP_CASE_FILTER_STAYING_PLAN_H

#include "case_filter/filter_loads.h"

/* Over the weight of the block with the scene's numbers. */
typedef struct tp_staying_load {
  tp_filter_load load;
  tp_load_number with; /* that it is in proportion to; TP_LOAD_NUMBERS: to none */
} tp_staying_load;

typedef struct tp_staying_plan {
  bool knows_tilt, knows_thickness; /* some are others with another of these */
  bool has_capacity;                /* that of the first anchor must not be above it */
  int count;
  tp_staying_load items[TP_FILTER_LOADS];
} tp_staying_plan;

/* Of a case, its centroid and the shape's unit in metres, x mirrored towards the right. False where
 * memory is exhausted, there is no room for all of them, or one turns with the tilt after all. */
bool tp_staying_plan_init(tp_staying_plan *plan, const tp_evaluation *evaluation,
                          tp_direction towards, const arb_t centroid_x, const arb_t centroid_y,
                          const arb_t unit);

#endif
