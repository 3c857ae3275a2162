/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A slope in jointed rock cut into blocks, with names by rows and columns from the toe.
 *
 * Corners are exact where all of them have a common denominator of no more than 1024 bits, as those
 * of a few sets without scatter of their dip have. Else they are rounded to a grid of a power of
 * two, 2^-64 of the section, each corner once for all blocks that meet there, and outlines keep
 * every corner of their neighbours: so edges that touch are the same edges. */

#ifndef TP_JOINTING_OUTLINES_H
#define TP_JOINTING_OUTLINES_H

#include "jointing/cut_blocks.h"

/* Ground first, then column by column from the toe. On failure `blocks` is cleared. Bad input: a
 * section that is none, or has no blocks; more of them than is allowed, by their number about. */
TP_MUST_USE tp_status tp_cut_blocks_init(tp_cut_blocks *blocks, const tp_jointed_slope *slope,
                                         tp_message *message);

#endif
