/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One motion of very many blocks that is proven to begin: as they are given, or with the strength
 * divided by a little more than an estimate. The work of its proof grows with their number, of
 * columns in a row in proportion, of others as its cube; that of an exclusion grows with the number
 * of combinations of their modes. */

#ifndef TP_BLOCK_SYSTEM_NEAR_MOTION_H
#define TP_BLOCK_SYSTEM_NEAR_MOTION_H

#include "block_system/built_system.h"
#include "block_system/resultant.h"

enum { TP_MOST_NEAR_MOTION_COLUMNS = 300, TP_MOST_NEAR_MOTION_BLOCKS = 128 };

/* Into a case that has the estimate, if there is one: its moving factor, the motion, and its
 * verdict where that begins as the blocks are given. */
TP_MUST_USE tp_status tp_near_motion_find(tp_system_case *one, const tp_built_system *system,
                                          const tp_resultant *resultant, tp_message *message);

#endif
