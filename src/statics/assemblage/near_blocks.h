/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Blocks that all but touch: what a hint at the tolerance of a survey is made of. */

#ifndef TP_ASSEMBLAGE_NEAR_BLOCKS_H
#define TP_ASSEMBLAGE_NEAR_BLOCKS_H

#include "assemblage/assemblage.h"

/* Pairs that do not touch and lie within a share of the size of blocks of each other: how many, and
 * the nearest one. */
typedef struct tp_near_blocks {
  long count, block[2];
  double distance; /* scene lengths */
} tp_near_blocks;

TP_MUST_USE tp_status tp_near_blocks_find(tp_near_blocks *near, const tp_assemblage *assemblage,
                                          double share, tp_message *message);

#endif
