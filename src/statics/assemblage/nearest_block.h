/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How far a block lies from the others, where it touches none. */

#ifndef TP_ASSEMBLAGE_NEAREST_BLOCK_H
#define TP_ASSEMBLAGE_NEAREST_BLOCK_H

#include "assemblage/given_block.h"

/* The block that lies next to one, and how far off, in scene lengths; -1: there is no other. */
long tp_nearest_block(double *distance, const tp_given_block *given, long count, long block);

/* How far a block reaches from its first corner, in scene lengths, rounded. */
double tp_block_extent(const tp_given_block *block);

#endif
