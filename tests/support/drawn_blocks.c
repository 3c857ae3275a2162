/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "drawn_blocks.h"

#include <math.h>
#include <string.h>

double all_xy[2 * BLOCKS * BLOCK_MOST];
size_t first_of[BLOCKS + 1];

static void spoil(random_block *block, long which) {
  switch (which % 5) {
  case 0:
    block->xy[3] = NAN;
    break;
  case 1:
    block->count = 2;
    break;
  case 2:
    block->count = 0;
    break;
  case 3: /* a vertex given twice */
    block->xy[4] = block->xy[2];
    block->xy[5] = block->xy[3];
    break;
  default: /* all on one line */
    for (size_t k = 0; k < block->count; k++) block->xy[2 * k + 1] = 0;
    break;
  }
}

tp_outlines draw_blocks(void) {
  random_numbers state = random_numbers_from(random_seed());
  for (long k = 0; k < BLOCKS; k++) {
    random_block block;
    draw_block(&block, &state);
    if (k % BAD_EVERY == BAD_EVERY - 1) spoil(&block, k / BAD_EVERY);
    memcpy(all_xy + 2 * first_of[k], block.xy, 2 * block.count * sizeof *all_xy);
    first_of[k + 1] = first_of[k] + block.count;
  }
  return tp_outlines_ragged(all_xy, BLOCKS, first_of);
}
