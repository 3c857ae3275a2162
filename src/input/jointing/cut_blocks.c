/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What blocks that were cut hold, given back. */

#include "jointing/cut_blocks.h"

#include <stdlib.h>
#include <string.h>

void tp_cut_blocks_clear(tp_cut_blocks *blocks) {
  for (long k = 0; k < blocks->count; k++) {
    free(blocks->blocks[k].name);
    tp_polyline_clear(&blocks->blocks[k].outline);
    free(blocks->blocks[k].sets);
    free(blocks->blocks[k].strips);
  }
  free(blocks->blocks);
  memset(blocks, 0, sizeof *blocks);
}
