/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The tilt at which a solid that rests on a plane topples about the edges of its support. */

#ifndef TP_SOLID_TILTING_H
#define TP_SOLID_TILTING_H

#include "solid/azimuth.h"
#include "solid/centre.h"

/* An edge of the support, which lies to its left seen from above. */
typedef struct tp_support_edge {
  int from, to;
} tp_support_edge;

/* A relative error that results may have at most, at the level of doubles. */
static const double tp_solid_accuracy = 1e-11;

/* Is an angle in degrees certain to nine digits, or to 1e-10 degrees? */
static inline bool tp_tilt_is_told(tp_near angle) {
  return angle.error <= 100 * tp_solid_accuracy * fabs(angle.value) || angle.error <= 1e-10;
}

/* tan alpha = a / H of an edge: above 0 where the foot of the centroid is certain to be within. */
tp_near tp_tilt_tangent(const tp_centre *centre, const tp_rest_plane *plane, tp_support_edge edge,
                        tp_near height);

/* The least of all edges, which all have the foot within, its azimuth in a frame of the plane;
 * `*told` stays where its numbers are certain to tp_solid_accuracy, else it becomes false. */
void tp_tilt_least(tp_solid_tilt *least, const tp_centre *centre, const tp_rest_plane *plane,
                   const tp_map_frame *frame, const tp_support_edge *edges, long count, bool *told);

/* 1: the foot of the centroid lies within the support, 0: on its border, -1: outside, 2: the level
 * does not tell. */
int tp_foot_side(const tp_centre *centre, const tp_rest_plane *plane, const tp_support_edge *edges,
                 long count);

/* The same by arms about all edges. */
int tp_arms_side(const tp_near *arms, long count);

/* A number as results have it. */
static inline tp_bounded tp_near_bounded(tp_near number) {
  return (tp_bounded){.value = number.value, .error = number.error};
}

#endif
