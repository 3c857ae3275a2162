/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Vertices of a block and points of its profile that come near each other: found in doubles along
 * the profile, which runs from left to right; where doubles do not tell, exactly.
 *
 * A near miss is a vertex that does not touch, and lies from the other body by no more than 1/1000
 * of the block's width or height, whichever is larger, and 1/100 of the shorter edge that ends in
 * it; a point of the profile besides no farther than the block's edge is long. So it lies nearly
 * flush with what it faces, at any scale: of an edge that leaves a contact at more than 0.6 degrees
 * the far end is none. */

#ifndef TP_BASE_CLOSENESS_H
#define TP_BASE_CLOSENESS_H

#include "base/profile.h"

/* Coordinates in doubles, of one unit for x and y. */
typedef struct tp_closeness {
  const tp_section *section;
  const tp_base *base;
  const tp_lattice *lattice;
  long ring, points;       /* of the profile in the lattice */
  double scale_u, scale_v; /* from the lattice's doubles to the unit */
  double unit;             /* in scene lengths */
  double error;            /* of a distance */
  double size;             /* of the block */
} tp_closeness;

/* A vertex of the outline (of the profile, for `of_base`) and an edge of the other body: of the
 * profile, or of the underside, whose edges run to the right or upright; by their first points. */
typedef struct tp_closeness_pair {
  bool of_base;
  long vertex, edge;
} tp_closeness_pair;

/* The base's ring is the chain of the lattice after the section's rings. */
void tp_closeness_init(tp_closeness *near, const tp_section *section, const tp_base *base,
                       const tp_lattice *lattice);

/* How far to look. */
typedef struct tp_closeness_reach {
  double within;        /* the greatest distance */
  double share_of_edge; /* above 0: at most this share of the shorter edge at a vertex of the block,
                           and of a point of the profile at most the length of the edge */
  bool upright;         /* only along y */
} tp_closeness_reach;

/* All pairs whose distance, in doubles, is within reach and the error; false ends the search, and
 * is what it returns then. */
typedef bool (*tp_closeness_visitor)(void *context, const tp_closeness_pair *pair, double distance);
bool tp_closeness_visit(const tp_closeness *near, const tp_closeness_reach *reach,
                        tp_closeness_visitor visitor, void *context);

/* Of the edges that end in a vertex of the outline, or of the profile. */
double tp_closeness_shorter_edge(const tp_closeness *near, bool of_base, long vertex);

/* The nearest point of the edge, as a share of it in [0, 1], the square of the distance from it, in
 * scene lengths, and the side of the edge on which the vertex lies: 1 left of it. Exact. */
void tp_closeness_foot(fmpq_t share, fmpq_t square, int *side, const tp_closeness *near,
                       const tp_closeness_pair *pair);

/* The root of a square, as a double. */
double tp_closeness_root(const fmpq_t square);

typedef struct tp_near_miss {
  long count;             /* of the near misses */
  tp_closeness_pair pair; /* that with the largest gap */
  double gap;             /* scene lengths */
  bool beside;            /* the edge is steep: else above, or below */
} tp_near_miss;

/* Near misses of a block that touches its base; of one that does not (`apart`) what of it and of
 * the profile below it, or above, is nearest to the other, as one. False when memory is exhausted.
 */
TP_MUST_USE bool tp_near_miss_find(tp_near_miss *miss, const tp_closeness *near, bool apart);

/* "vertex 7 of the outline lies 0.1 mm above the base". */
void tp_near_miss_text(char *text, size_t size, const tp_near_miss *miss, const tp_closeness *near);

#endif
