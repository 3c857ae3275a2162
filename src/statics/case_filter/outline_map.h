/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Blocks of one outline whose vertices are affine functions of numbers that vary, on their mated
 * base: the contact of each in doubles with bounds.
 *
 * Whether the vertices make a block, which of them touch the base and where: all of that the
 * preparation of a scene (problem/problem.c) tells by signs: of x_i - x_j, y_i - y_j and of the
 * sum and the difference of these, and of the turns of three points, the ends of the base among
 * them. Where each has the sign that it has in the scene at hand, the contact is the same one. */

#ifndef TP_CASE_FILTER_OUTLINE_MAP_H
#define TP_CASE_FILTER_OUTLINE_MAP_H

#include "case_filter/outline_mapping.h"

/* Of a problem whose contact is planned. `*fits` is false where it is none of these. */
TP_MUST_USE tp_status tp_outline_map_init(tp_outline_map *map, bool *fits,
                                          const tp_problem *problem, tp_direction towards,
                                          const tp_contact_plan *plan, const tp_scene_key *keys,
                                          size_t count, tp_message *message);

/* The points from the first vertex, with values of the variables. */
typedef struct tp_near_outline {
  tp_near x[TP_MAP_POINTS], y[TP_MAP_POINTS];
} tp_near_outline;

/* Where the first vertex is. */
void tp_outline_map_first(tp_near *x, tp_near *y, const tp_outline_map *map,
                          const tp_near *variables);

/* The shape of the contact, not completed (shape.h); false where it is not certainly the contact of
 * the plan. */
bool tp_outline_map_shape(tp_case_shape *shape, tp_near_outline *outline, const tp_outline_map *map,
                          const tp_contact_plan *plan, const tp_near *variables);

#endif
