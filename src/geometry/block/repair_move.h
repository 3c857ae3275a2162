/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A vertex put on the other side of an edge, or away from it: of the four ends of two edges that
 * meet the nearest to the other edge, and where it goes (block/repair.c says why). In rationals;
 * the nearest is decided exactly. */

#ifndef TP_BLOCK_REPAIR_MOVE_H
#define TP_BLOCK_REPAIR_MOVE_H

#include "geom/geom.h"
#include "plane/polyline.h"

/* Scratch of one move: the direction of an edge, where a vertex lies by it, and where it goes. */
typedef struct tp_move {
  long vertex, edge, next; /* the edge runs from one vertex to the next */
  int side;                /* to which it goes, left of the edge above 0 */
  fmpq_t dx, dy, along, across, norm, x, y, distance;
} tp_move;

void tp_move_init(tp_move *move);
void tp_move_clear(tp_move *move);

/* Of the four ends of two edges that meet the nearest to the other edge; false where none will do.
 */
bool tp_move_choose(tp_move *move, const tp_polyline *ring, tp_geom_meeting meeting);

/* Where that vertex goes, (x, y): beside the edge on its side, by digit / 8 or somewhat less, on a
 * grid of thousandths of the digit. */
void tp_move_aim(tp_move *move, const tp_polyline *ring, const fmpq_t digit);

#endif
