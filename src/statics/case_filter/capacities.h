/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Cohesion and bonds of a contact (linear_program/cones.h) as forces of the base on the block over
 * its weight, in the unit of the shape (shape.h): a straight line of facets bears a shear of either
 * sense along it, a facet a pull at its middle, both up to a bound. They stay as the block is
 * tilted: over the weight and cos(tilt) they are 1 / cos(tilt) times as much. */

#ifndef TP_CASE_FILTER_CAPACITIES_H
#define TP_CASE_FILTER_CAPACITIES_H

#include "case_filter/load_plan.h"

enum { TP_PLAN_CAPACITIES = TP_PLAN_POINTS / 2 };

typedef struct tp_capacity_plan {
  bool acts;           /* some may be there */
  bool slips;          /* no facet stands in the way of what slips */
  bool weighs_outline; /* the weight is that of the outline, which varies: */
  int count;
  int points[TP_PLAN_CAPACITIES]; /* the first ends of facets with a length; the next are the other
                                   */
  int line_of[TP_PLAN_POINTS]; /* of each point the first one on the straight line of its facet */
} tp_capacity_plan;

/* Of a facet. */
typedef struct tp_filter_capacity {
  int point, line;
  tp_near length;
  tp_near
      shear[3]; /* of all facets on its line, where it is the first of these, along t; or zeros */
  tp_near pull[3]; /* along -n at its middle; zeros where there is no bond */
} tp_filter_capacity;

/* Those of a sample. */
typedef struct tp_filter_capacities {
  bool acts, bonds;
  const int *line_of;
  tp_near bond, cohesion; /* over the weight: of a unit of length, of all lengths */
  int count;
  tp_filter_capacity items[TP_PLAN_CAPACITIES];
} tp_filter_capacities;

/* Of a case whose plan and shape are known. False where the block varies and facets on one line may
 * leave it, or where the weight does not follow from its outline. */
bool tp_capacity_plan_init(tp_capacity_plan *capacities, const tp_evaluation *evaluation,
                           const tp_onset_asked *asked, const tp_contact_plan *plan, bool varies);

/* Those of a sample with its shape, a unit of which is so many metres; false where doubles do not
 * tell. */
TP_MUST_USE bool tp_capacities_evaluate(tp_filter_capacities *own,
                                        const tp_capacity_plan *capacities,
                                        const tp_load_plan *loads, const tp_contact_plan *plan,
                                        const tp_case_shape *shape, double metres_per_unit,
                                        const tp_near numbers[TP_LOAD_NUMBERS]);

/* With a share of their strength. */
void tp_capacities_scale(tp_filter_capacities *scaled, const tp_filter_capacities *own,
                         double share);

/* The moment of the bond about a point, from the centroid, of all that opens as the block turns
 * about it down-dip (evaluation/loaded_bond.h). */
tp_near tp_capacities_bond_moment(const tp_filter_capacities *own, const tp_contact_plan *plan,
                                  const tp_case_shape *shape, long point);

/* Does the line of a capacity pass through a site by construction? */
bool tp_capacity_meets(const tp_filter_capacities *own, const tp_contact_plan *plan, int capacity,
                       long site);

#endif
