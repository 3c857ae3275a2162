/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What scenes that differ in numbers alone share of a case: which points of the contact stand on
 * which facets, the kinematic cone K of first-order motions (motion/twists.h) by its rays, and the
 * modes on its faces (motion/strata.h). Found once, exactly, of one scene. Of another one with the
 * same contact it is the same as long as every ray leaves and slips along each point in the same
 * sense (shape.h). */

#ifndef TP_CASE_FILTER_CONTACT_PLAN_H
#define TP_CASE_FILTER_CONTACT_PLAN_H

#include "evaluation/evaluation.h"
#include "linear_program/cones.h"

/* Beyond these a case is left to the ladder. */
enum {
  TP_PLAN_POINTS = 24,
  TP_PLAN_RAYS = 48,
  TP_PLAN_MODES = 96,
  TP_PLAN_EDGES = 8,
  TP_PLAN_TRIPLES = 56
};

/* An end of a facet. Points of one site lie at one place; facets of one axis are parallel, and
 * `along` says whether they point the same way. */
typedef struct tp_plan_point {
  long site, facet, axis;
  bool along;
} tp_plan_point;

typedef enum tp_ray_kind {
  TP_RAY_SLIDES, /* along the facet of a point */
  TP_RAY_TURNS,  /* about a point */
  TP_RAY_LINES   /* keeps two points on their facets, which slip */
} tp_ray_kind;

typedef struct tp_plan_ray {
  tp_ray_kind kind;
  long point, other;
  int sense;                         /* 1, or -1: the other way */
  signed char opens[TP_PLAN_POINTS]; /* each point: 1, or 0: it stays on its facet, */
  signed char slips[TP_PLAN_POINTS]; /* and there it slips along it, -1 back, 0 sticks */
} tp_plan_ray;

/* Three of a mode's rays, counted first, and edges that span a solid. */
typedef struct tp_plan_triple {
  unsigned char of[3];
  bool all_rays;
} tp_plan_triple;

typedef struct tp_plan_mode {
  tp_mechanism mechanism;
  int ray_count;
  long rays[2];
  long line; /* of two rays: a point on the normal line that both keep */
  int edge_count;
  tp_cone_edge edges[TP_PLAN_EDGES];
  int triple_count;
  tp_plan_triple triples[TP_PLAN_TRIPLES];
} tp_plan_mode;

typedef struct tp_contact_plan {
  int point_count, ray_count, mode_count;
  bool opens_all; /* K has an interior: all points can open at once */
  tp_plan_point points[TP_PLAN_POINTS];
  tp_plan_ray rays[TP_PLAN_RAYS];
  tp_plan_mode modes[TP_PLAN_MODES];
  int edge_count; /* all edges of all friction cones, none twice */
  tp_cone_edge edges[2 * TP_PLAN_POINTS];
} tp_contact_plan;

/* The triples of a mode whose rays and edges are known; false where there is no room for them. */
bool tp_plan_mode_set_triples(tp_plan_mode *mode, const tp_contact_plan *plan);

/* Of a case; with friction. `*fits` is false where the plan has no room for it or a ray is none of
 * those kinds. */
TP_MUST_USE tp_status tp_contact_plan_init(tp_contact_plan *plan, bool *fits,
                                           const tp_evaluation *evaluation, tp_direction towards,
                                           tp_message *message);

#endif
