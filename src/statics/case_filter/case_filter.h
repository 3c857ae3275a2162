/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a row of a study tells of a case, in doubles with proven bounds (number/near.h), where these
 * decide all of it: the governing pivot and its critical angle by moments, both limits, the
 * mechanism and the governing factor of safety at any tilts. For a block on a contact with one
 * friction angle, cohesion and bonds (capacities.h), under its weight and loads that turn with the
 * tilt as that does or stay with the block (filter_loads.h), that stands on level ground; for
 * others, and where a double is too short, it tells nothing, and the ladder does.
 *
 * What scenes share is prepared once (contact_plan.h), by any number of threads read at once. */

#ifndef TP_CASE_FILTER_CASE_FILTER_H
#define TP_CASE_FILTER_CASE_FILTER_H

#include "case_filter/limit_filter.h"
#include "case_filter/load_plan.h"
#include "case_filter/onset_filter.h"
#include "case_filter/outline_map.h"

/* A point of the contact: candidate pivot. */
typedef struct tp_filter_pivot {
  long point; /* of the plan, at it */
  bool admissible;
  tp_bounded x_m, y_m;
} tp_filter_pivot;

/* A facet of the contact, one in a point included. */
typedef struct tp_filter_facet {
  long point, down_dip; /* of the plan: one with its direction, and its end down-dip */
  bool is_level;
} tp_filter_facet;

typedef struct tp_case_filter {
  tp_contact_plan plan;
  tp_case_shape shape;  /* of the scene as it is */
  tp_contact_rest rest; /* points that the plan leaves out */
  tp_near tilt_deg;     /* of the scene as it is, its dip included */
  bool rests;           /* the state without the earthquake counts, too */
  tp_load_plan loads;
  tp_capacity_plan capacities;
  size_t variable_count; /* by which the block varies */
  bool varies;           /* it does, by this map: */
  tp_outline_map map;
  int pivot_count, facet_count;
  tp_filter_pivot pivots[TP_PLAN_POINTS];
  tp_filter_facet facets[TP_PLAN_POINTS];
} tp_case_filter;

/* Of a scene that tilts one way, or lies on a slope whose dip is its tilt, in which the block
 * varies with the numbers at so many keys, beside friction, tilt and what loads depend on;
 * `*filter` stays NULL where it is none for a filter. What of the scene is no block on a base is
 * told by a solve of it, not here. */
TP_MUST_USE tp_status tp_case_filter_new(tp_case_filter **filter, const tp_scene *scene,
                                         const tp_scene_key *keys, size_t count,
                                         tp_message *message);

/* The numbers of a sample. */
typedef struct tp_case_sample {
  tp_near friction_deg;
  tp_near numbers[TP_LOAD_NUMBERS];
  const tp_near *variables; /* at the keys */
  bool at_rest;             /* without the earthquake */
} tp_case_sample;

/* At any tilt. */
typedef struct tp_case_told {
  const tp_case_filter *filter;
  tp_case_sample sample; /* of which this is, with these variables */
  tp_near variables[TP_AFFINE_VARIABLES];
  tp_filter_case of; /* the filter's shape, or this: */
  tp_case_shape own;
  tp_filter_loads loads;
  tp_filter_capacities capacities;
  tp_near pivot_x_m, pivot_y_m;
  tp_near moments_deg, limit_deg, limit_tangent, onset_deg;
  const tp_filter_pivot *pivot; /* that governs, */
  bool never_topples;           /* about which it does not: moments_deg is none */
  tp_mechanism limit;
  bool never; /* no motion can begin at any tilt */
  tp_onset_filter onset;
} tp_case_told;

/* False where doubles do not tell. */
TP_MUST_USE bool tp_case_filter_tell(tp_case_told *told, const tp_case_filter *filter,
                                     const tp_case_sample *sample);

/* What the block does at a tilt from 0 to below 90 degrees; false where doubles do not tell. */
TP_MUST_USE bool tp_case_filter_tell_mechanism(tp_mechanism *mechanism, const tp_case_told *told,
                                               tp_near tilt_deg);

/* A factor of safety: a number, or nothing overturns. */
typedef struct tp_fos_told {
  tp_fos_state state;
  tp_near value; /* where it is a number */
} tp_fos_told;

/* At one. */
typedef struct tp_case_told_at {
  tp_mechanism mechanism;
  tp_fos_told fos; /* that governs */
  tp_mechanism fos_mechanism;
  tp_fos_definition fos_definition;
  tp_fos_told by_moments, by_shear; /* as tp_case_fos_moments, tp_case_fos_sliding */
} tp_case_told_at;

/* With its factors, likewise. Where the state without the earthquake is the less safe one, `told`
 * becomes that. */
TP_MUST_USE bool tp_case_filter_tell_at(tp_case_told_at *at, tp_case_told *told, tp_near tilt_deg);

#endif
