/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Corners of outlines that lie near corners and edges of other blocks, found in doubles from a
 * local origin: distances are off by some 1e-16 of the size of all. */

#ifndef TP_ASSEMBLAGE_CORNER_SEARCH_H
#define TP_ASSEMBLAGE_CORNER_SEARCH_H

#include "assemblage/given_block.h"

/* Vertex of the outline of a block; the edge from it leads to corner `next`. */
typedef struct tp_outline_corner {
  double x, y;
  long block, vertex, next;
} tp_outline_corner;

typedef struct tp_corner_search {
  long count;
  tp_outline_corner *corners; /* block by block, in the order of their outlines */
  long *by_x;                 /* sorted */
} tp_corner_search;

TP_MUST_USE tp_status tp_corner_search_init(tp_corner_search *search, const tp_given_block *given,
                                            long count, tp_message *message);
void tp_corner_search_clear(tp_corner_search *search);

/* What is near: a corner, and another corner of another block, or the edge that begins there, at
 * the share `along` of its length, within (0, 1). */
typedef struct tp_near_corner {
  long corner, other;
  double along, distance;
} tp_near_corner;
typedef tp_status tp_near_corner_call(void *context, const tp_near_corner *near,
                                      tp_message *message);

/* Each pair of corners once; each corner with each edge of another block. */
TP_MUST_USE tp_status tp_near_corners_each(const tp_corner_search *search, double reach,
                                           tp_near_corner_call *call, void *context,
                                           tp_message *message);
TP_MUST_USE tp_status tp_near_edges_each(const tp_corner_search *search, double reach,
                                         tp_near_corner_call *call, void *context,
                                         tp_message *message);

#endif
