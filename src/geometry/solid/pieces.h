/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A rock of several closed surfaces on one lattice: its own, and those of holes and parts inside.
 * Do they lie as these are to lie? Holes wholly inside, touching neither the rock's surface nor one
 * another, so that what is left is one body whose surface is all there. Parts inside, where they
 * may touch anything over the same triangles, edges or corners, but overlap nothing. */

#ifndef TP_SOLID_PIECES_H
#define TP_SOLID_PIECES_H

#include "solid/surface.h"

typedef struct tp_solid_piece {
  tp_surface surface;
  bool is_hole;
} tp_solid_piece;

/* The first is the rock. Each has passed the gate, also for meeting all others. */
TP_MUST_USE tp_status tp_gate_pieces(const tp_solid_piece *pieces, long count, tp_message *message);

#endif
