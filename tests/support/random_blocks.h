/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Random outlines of doubles for the calls on many blocks, of every kind that they tell apart. */

#ifndef TP_TEST_RANDOM_BLOCKS_H
#define TP_TEST_RANDOM_BLOCKS_H

#include "random_polygons.h"

#include <stdbool.h>
#include <stddef.h>

enum { BLOCK_MOST = 200 };

/* Whole numbers, and where they lie as doubles: (x, y) * scale + offset, exactly. */
typedef struct random_block {
  polygon whole;
  bool counter_clockwise;
  size_t count; /* of xy: the first vertex may be repeated at the end */
  double xy[2 * BLOCK_MOST];
} random_block;

/* Are the results of two runs the same, byte by byte? */
bool same_bytes(const void *one, const void *other, size_t size);

/* A star, a rough underside, one at 45 degrees in places, teeth with upright walls, one that leans
 * over its base; at home, far off, tiny or huge; either way round, begun anywhere, mirrored. */
void draw_block(random_block *block, random_numbers *state);

#endif
