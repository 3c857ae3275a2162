/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a slope in jointed rock is cut into: blocks with the sets that made their edges. */

#ifndef TP_JOINTING_CUT_BLOCKS_H
#define TP_JOINTING_CUT_BLOCKS_H

#include "scene/scene.h"

typedef struct tp_cut_block {
  TP_OUTSIDE char *name;
  bool ground;
  tp_polyline outline; /* counter-clockwise */
  int *sets;           /* of each edge, as tp_listed_block has them */
  long *strips;        /* of each joint set: how many of its joints are on the side of the toe */
} tp_cut_block;

typedef struct tp_cut_blocks {
  long count, cut_off; /* blocks and ground; cells at the ends that are ground */
  tp_cut_block *blocks;
  bool exact;
  double moved; /* the most that a corner was, in scene lengths */
} tp_cut_blocks;

void tp_cut_blocks_clear(tp_cut_blocks *blocks);

#endif
