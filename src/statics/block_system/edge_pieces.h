/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which pieces of the edges of a block touch other blocks, as shares of an edge, in rationals. */

#ifndef TP_BLOCK_SYSTEM_EDGE_PIECES_H
#define TP_BLOCK_SYSTEM_EDGE_PIECES_H

#include "assemblage/assemblage.h"

/* From one share of an edge to another. */
typedef struct tp_edge_piece {
  fmpq_t from, to;
} tp_edge_piece;

typedef struct tp_edge_pieces {
  const tp_assemblage *assemblage;
  long *first, *touch;  /* by block: its contacts */
  tp_edge_piece *items; /* of an edge; room for the most contacts of a block */
  long room;
} tp_edge_pieces;

/* False when memory is exhausted; to be cleared even so. */
TP_MUST_USE bool tp_edge_pieces_init(tp_edge_pieces *pieces, const tp_assemblage *assemblage);
void tp_edge_pieces_clear(tp_edge_pieces *pieces);

/* Those of the edge from a point of the lattice to another of a block, in order; how many. */
long tp_edge_pieces_find(tp_edge_pieces *pieces, long block, long from, long to);

/* That of a contact; false: it lies on another edge, or is a corner. */
bool tp_edge_piece_set(tp_edge_piece *piece, const tp_lattice *lattice,
                       const tp_block_contact *contact, long from, long to);

#endif
