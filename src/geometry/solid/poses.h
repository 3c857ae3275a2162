/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The poses in which a solid can rest on a plane by itself: the facets of its convex hull that have
 * the foot of the centroid within. From another facet it rolls over the edge that the foot lies
 * farthest beyond; where that edge has the point of the facet nearest to the foot, as it has but
 * where a corner is nearest, it is the edge about which the solid turns. The centroid sinks with
 * every turn, so that each facet leads to a pose.
 *
 * The share of a facet is the solid angle of its triangles seen from the centroid A, B, C,
 * tan(angle / 2) = A . (B x C) / (|A||B||C| + (A.B)|C| + (B.C)|A| + (C.A)|B|)
 * (van Oosterom and Strackee 1983), over 4 pi. */

#ifndef TP_SOLID_POSES_H
#define TP_SOLID_POSES_H

#include "solid/centre.h"
#include "solid/hull_facets.h"

/* All of them, the greatest share first, to be freed. `*told` stays where all is certain to
 * tp_solid_accuracy and every decision is made; else it becomes false, and the poses are none. */
TP_MUST_USE tp_status tp_solid_poses_find(tp_solid_pose **poses, size_t *count,
                                          const tp_centre *centre, const tp_hull_facets *facets,
                                          double metres_per_step, bool *told, tp_message *message);

#endif
