/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* An outline map (outline_map.h), and what it is made of in the making. */

#ifndef TP_CASE_FILTER_OUTLINE_MAPPING_H
#define TP_CASE_FILTER_OUTLINE_MAPPING_H

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
typedef struct tp_mapped_point {
  int vertex, from, to; /* from -1: (1, 0) */
  bool is_level;
} tp_mapped_point;

typedef struct tp_outline_map {
  int variable_count, vertex_count, point_count, sign_count;
  tp_direction towards;
  tp_near_affine first_x, first_y;                   /* of the first vertex, */
  tp_near_affine x[TP_MAP_POINTS], y[TP_MAP_POINTS]; /* and of all points from there */
  tp_mapped_point points[TP_PLAN_POINTS];
  tp_map_sign signs[TP_MAP_SIGNS];
  double metres_per_unit;
} tp_outline_map;

/* What is mapped, exactly. */
typedef struct tp_outline_mapping {
  tp_outline_map *map;
  const tp_problem *problem;
  const tp_contact_plan *plan;
  const tp_affine_scene *scene;
  fmpq *variables;            /* as the scene has them */
  tp_affine x[TP_MAP_POINTS]; /* and the values of these */
  tp_affine y[TP_MAP_POINTS];
  fmpq *own_x, *own_y;
  int left_end, right_end; /* points at which the base ends; -1: at the contact */
  bool fits;
} tp_outline_mapping;

#endif
