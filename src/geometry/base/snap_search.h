/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What is found while a block is moved onto its profile (base/snap.h): for each vertex of either
 * body its foot, the nearest point of the other within the distance; then where vertices go, and
 * which points of the profile are taken into edges. */

#ifndef TP_BASE_SNAP_SEARCH_H
#define TP_BASE_SNAP_SEARCH_H

#include "base/snap.h"

/* The nearest point of the other body to a vertex, by an edge and a share of it. */
typedef struct tp_snap_foot {
  tp_closeness_pair pair;
  fmpq_t share, square;
  int side;
  long corner; /* of the block alone: the nearest point of the profile that it fits; or -1 */
  fmpq_t corner_square;
} tp_snap_foot;

/* A point of the profile to be taken into an edge. */
typedef struct tp_snap_taken {
  long edge, point;
} tp_snap_taken;

typedef struct tp_snap_search {
  const tp_closeness *near;
  const tp_polyline *outline, *ring;
  fmpq_t limit; /* the square of w */
  long count, capacity;
  tp_snap_foot *feet;
  long *of_vertex, *of_point; /* the foot of a vertex; or -1 */
  bool *has_vertex;           /* of a point of the profile: a vertex lies in it */
  long taken_count, taken_capacity;
  tp_snap_taken *points;
} tp_snap_search;
static inline long tp_snap_next(const tp_snap_search *s, long vertex) {
  return vertex + 1 == s->outline->count ? 0 : vertex + 1;
}

static inline long tp_snap_before(const tp_snap_search *s, long vertex) {
  return (vertex == 0 ? s->outline->count : vertex) - 1;
}

/* Visits pairs that lie within the distance; `context` is the search. False without memory. */
bool tp_snap_take(void *context, const tp_closeness_pair *pair, double distance);

/* Does the vertex of a foot lie in the other body? */
bool tp_snap_is_inside(const tp_snap_search *s, const tp_snap_foot *f);

/* Corners that fit corners; then each vertex to its foot, and the extent of what touches. */
TP_MUST_USE bool tp_snap_settle_corners(tp_snap_search *s);
void tp_snap_normalise(tp_snap_search *s);
TP_MUST_USE bool tp_snap_move_vertices(tp_snap *snap, const tp_snap_search *s);
void tp_snap_find_extent(tp_snap *snap, const tp_snap_search *s);

/* Points of the profile that become vertices of an edge, and the outline with them. */
TP_MUST_USE bool tp_snap_list_points(tp_snap_search *s);
TP_MUST_USE bool tp_snap_build(tp_snap *snap, const tp_snap_search *s);

#endif
