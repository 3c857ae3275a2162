/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which blocks the points and lines of loads lie on, where the scene does not name them, and
 * whether they lie on those that it names: to a millionth of the size of a block, as corners of
 * blocks may be rounded, or moved to touch. */

#ifndef TP_BLOCK_SYSTEM_BLOCK_FACES_H
#define TP_BLOCK_SYSTEM_BLOCK_FACES_H

#include "assemblage/assemblage.h"

/* Blocks at their places, with what they touch. */
typedef struct tp_placed_blocks {
  const tp_scene *scene;
  const tp_assemblage *assemblage;
  const tp_section *sections;
} tp_placed_blocks;

/* Is a point of the scene in a block or on its border? */
bool tp_block_holds(const tp_placed_blocks *blocks, long block, const fmpq_t x, const fmpq_t y);

/* Does a point lie in a block, or beside it by no more than that? */
bool tp_block_is_near(const tp_placed_blocks *blocks, long block, const fmpq_t x, const fmpq_t y);

/* The one block that it lies in so. Refused: none, or several; `what` lies there. */
TP_MUST_USE tp_status tp_block_find_at(long *block, const tp_placed_blocks *blocks, const fmpq_t x,
                                       const fmpq_t y, const char *what, tp_place place,
                                       tp_message *message);

/* A stretch of the line of a load that lies on the outline of a block. */
typedef struct tp_line_stretch {
  long block;
  tp_line_load line;
} tp_line_stretch;

typedef struct tp_line_stretches {
  long count, room;
  tp_line_stretch *items;
} tp_line_stretches;

/* Of one block, or of all where `block` is below zero. Of pressures those on edges that run the
 * same way, with the block to the left; of a surcharge that is to find its blocks those on edges
 * that face up, `up` the direction. `covered`: they make up the line. False when memory is
 * exhausted; to be cleared even so. */
TP_MUST_USE bool tp_line_stretches_find(tp_line_stretches *stretches, bool *covered,
                                        const tp_placed_blocks *blocks, const tp_line_load *line,
                                        long block, const fmpq up[2]);
void tp_line_stretches_clear(tp_line_stretches *stretches);

#endif
