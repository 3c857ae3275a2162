/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Names of the blocks of a slope, by the strips between joints that their centroids lie in. */

#ifndef TP_JOINTING_NAMES_H
#define TP_JOINTING_NAMES_H

#include "jointing/cut_blocks.h"
#include "jointing/cuts.h"

/* In the order of their strips, set by set, each counted from 1 from the first block on: B3-2 is in
 * the third strip of the first set and the second of the second one, B3-2.2 the next that has the
 * same strips. Ground comes first. */
TP_MUST_USE tp_status tp_cut_blocks_name(tp_cut_blocks *blocks, const tp_cuts *cuts,
                                         tp_message *message);

#endif
