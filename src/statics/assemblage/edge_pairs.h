/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Edges of different blocks whose boxes meet, each pair once, and blocks all within others. */

#ifndef TP_ASSEMBLAGE_EDGE_PAIRS_H
#define TP_ASSEMBLAGE_EDGE_PAIRS_H

#include "assemblage/assemblage.h"

/* A corner of an outline with its neighbours; three points of the lattice. */
typedef struct tp_block_corner {
  long before, point, next;
} tp_block_corner;

/* The edge from a corner to the next. */
typedef struct tp_edge_of_block {
  long block;
  tp_block_corner corner;
} tp_edge_of_block;

typedef tp_status tp_edge_pair_call(void *context, const tp_edge_of_block *edge,
                                    const tp_edge_of_block *other, tp_message *message);
/* The first corner of a block lies strictly within the other one. */
typedef tp_status tp_edge_within_call(void *context, long block, long other, tp_message *message);

/* Until a call fails; `context` is the assemblage. */
TP_MUST_USE tp_status tp_edge_pairs_each(tp_assemblage *assemblage, tp_edge_pair_call *pair,
                                         tp_edge_within_call *within, tp_message *message);

#endif
