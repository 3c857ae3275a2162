/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How deep the poses of a solid are: by how much its centroid has to rise for it to roll into a
 * pose with the centroid lower.
 *
 * Over the sphere of directions downwards let h be the height of the centroid over the base. Its
 * minima are the poses. Within the directions in which one vertex is lowest h falls away from that
 * of the vertex, so that the lowest ways run along those in which an edge of the hull touches:
 * between two facets over their edge, h rises to the distance of the centroid from that edge where
 * the foot lies within both, else to the larger of both heights. With edges in the order of that
 * height, what they join is joined (Kruskal 1956); the minimum that is less deep ends there: its
 * persistence is the rise to it (Edelsbrunner, Letscher and Zomorodian 2002). Which of two poses is
 * the less deep is decided by their exact heights where bounds do not separate them: the other
 * one has a persistence of another size. A pass is off by its bound, and the lowest way to a pose
 * by the largest bound of any pass.
 *
 * Where each point of the surface moves by t at most, h over the same centroid changes by t at
 * most, and so a pose of a persistence above 2 t has one left (Cohen-Steiner, Edelsbrunner and
 * Harer 2007). Cost: n log n of the sides of facets. */

#ifndef TP_SOLID_PERSISTENCE_H
#define TP_SOLID_PERSISTENCE_H

#include "solid/hull_heights.h"

typedef struct tp_persistence {
  bool is_left; /* a pose, and there is another one with the centroid lower */
  tp_near rise; /* as the surface's `near` */
} tp_persistence;

/* For each facet, to be freed; `is_pose` has one for each. `*told` becomes false where the level
 * does not decide which of two poses is the lower one. */
TP_MUST_USE tp_status tp_persistences_find(tp_persistence **persistences,
                                           const tp_hull_heights *over, const bool *is_pose,
                                           bool *told, tp_message *message);

#endif
