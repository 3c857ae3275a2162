/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* An outline map in the making: outline_map.c and outline_signs.c share it, nothing else does. */

#ifndef TP_OUTLINE_MAPPING_H
#define TP_OUTLINE_MAPPING_H

#include "case_filter/outline_map.h"

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

/* The signs that tell the contact, of points and contact that are mapped; `fits` becomes false
 * where one is zero in the scene at hand and may not stay so. */
void tp_outline_mapping_add_signs(tp_outline_mapping *m, tp_direction towards);

#endif
