/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Blocks of one outline whose vertices are affine functions of numbers that vary, on their mated
 * base: the contact of each in doubles with bounds.
 *
 * Whether the vertices make a block, which of them touch the base and where: all of that the
 * preparation of a scene (stability/problem.c) tells by signs: of x_i - x_j, y_i - y_j and of the
 * sum and the difference of these, and of the turns of three points, the ends of the base among
 * them. Where each has the sign that it has in the scene at hand, the contact is the same one. */

#ifndef TP_OUTLINE_MAP_H
#define TP_OUTLINE_MAP_H

#include "case_filter/affine.h"
#include "case_filter/shape.h"

enum {
  TP_MAP_VERTICES = 12,
  TP_MAP_POINTS = TP_MAP_VERTICES + 2, /* and the ends of the base */
  TP_MAP_SIGNS = 1024
};

typedef enum tp_map_sign_kind {
  TP_SIGN_X,
  TP_SIGN_Y,
  TP_SIGN_SUM,
  TP_SIGN_DIFFERENCE,
  TP_SIGN_TURN, /* of three points */
  TP_SIGN_ALONG /* (q - p) . t of a facet */
} tp_map_sign_kind;

typedef struct tp_map_sign {
  tp_map_sign_kind kind;
  unsigned char of[4];
  signed char sign;
} tp_map_sign;

/* c_0 + sum c_k v_k */
typedef struct tp_near_affine {
  tp_near of[TP_AFFINE_VARIABLES + 1];
  bool varies;
} tp_near_affine;

/* Of a point of the plan: its vertex, and t: between two vertices, or level. */
typedef struct tp_map_point {
  int vertex, from, to; /* from -1: (1, 0) */
  bool is_level;
} tp_map_point;

typedef struct tp_outline_map {
  int variable_count, vertex_count, point_count, sign_count;
  bool mirrored;
  tp_near_affine x[TP_MAP_POINTS], y[TP_MAP_POINTS];
  tp_map_point points[TP_PLAN_POINTS];
  tp_map_sign signs[TP_MAP_SIGNS];
  double metres_per_unit;
} tp_outline_map;

/* Of a problem whose contact is planned. `*fits` is false where it is none of these. */
TP_MUST_USE tp_status tp_outline_map_init(tp_outline_map *map, bool *fits,
                                          const tp_problem *problem, tp_direction towards,
                                          const tp_contact_plan *plan, const tp_scene_key *keys,
                                          size_t count, tp_message *message);

/* The vertices with values of the variables. */
typedef struct tp_near_outline {
  tp_near x[TP_MAP_POINTS], y[TP_MAP_POINTS];
} tp_near_outline;

/* The shape of the contact, not completed (shape.h); false where it is not certainly the contact of
 * the plan. */
bool tp_outline_map_shape(tp_shape *shape, tp_near_outline *outline, const tp_outline_map *map,
                          const tp_contact_plan *plan, const tp_near *variables);

#endif
