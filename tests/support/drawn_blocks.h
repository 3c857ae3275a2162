/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Random blocks one after the other in one array, as the calls on many blocks are given them. Of
 * every seventh something is wrong. */

#ifndef TP_TEST_DRAWN_BLOCKS_H
#define TP_TEST_DRAWN_BLOCKS_H

#include "random_blocks.h"

#include "topple.h"

enum { BLOCKS = 3000, BAD_EVERY = 7 };

extern double all_xy[2 * BLOCKS * BLOCK_MOST];
extern size_t first_of[BLOCKS + 1];

/* The same ones at every call. */
tp_outlines draw_blocks(void);

#endif
