/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The loads of a scene as functions of the numbers that vary with its samples: found once, in
 * balls; of a sample in doubles with bounds. */

#ifndef TP_CASE_FILTER_LOAD_PLAN_H
#define TP_CASE_FILTER_LOAD_PLAN_H

#include "case_filter/staying_plan.h"
#include "onset/onset_question.h"

/* The key of a scene that it stands at. */
const char *tp_load_number_key(tp_load_number number);

typedef struct tp_planned_surcharge {
  tp_near x, y; /* of its middle from the centroid */
  tp_near kn_m; /* a metre of thickness */
} tp_planned_surcharge;

typedef struct tp_load_plan {
  bool called_for, shakes, has_water, lifts;
  int surcharge_count;
  tp_near numbers[TP_LOAD_NUMBERS];           /* as the scene has them */
  tp_near weight_kn_m;                        /* of the block, a metre of thickness, with them */
  tp_near metres_per_unit, metres_per_length; /* of the shape, of the scene */
  tp_near heel_x, heel_y, joint, top;         /* the heel from the centroid, the length of the joint
                                                 down-dip of it, how high the block stands over it; m */
  tp_planned_surcharge surcharges[TP_FILTER_LOADS];
  tp_staying_plan staying;
} tp_load_plan;

/* Do all loads of a scene turn with the tilt as the weight does, or stay with the block? */
bool tp_load_plan_fits(const tp_scene *scene);

/* Of a case of such a scene, the shape's unit being 2^unit lattice steps; false where there is no
 * room for all of them. */
bool tp_load_plan_init(tp_load_plan *plan, const tp_evaluation *evaluation,
                       const tp_onset_asked *asked, tp_direction towards, slong unit);

/* Do they depend on the outline of the block, other than by its weight? */
bool tp_load_plan_knows_outline(const tp_load_plan *plan);

/* The weight of a sample whose block has the scene's outline, kN a metre of thickness. */
tp_near tp_load_plan_weight(const tp_load_plan *plan, const tp_near numbers[TP_LOAD_NUMBERS]);

/* Those of a sample; false where its numbers are none that every such scene takes. */
TP_MUST_USE bool tp_load_plan_evaluate(tp_filter_loads *loads, const tp_load_plan *plan,
                                       const tp_near numbers[TP_LOAD_NUMBERS]);

#endif
