/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One motion of very many blocks that is proven to begin: as they are given, or with the strength
 * divided by a little more than an estimate. The work of its proof grows with the cube of their
 * number, and not with that of their modes, as that of an exclusion does. */

#ifndef TP_BLOCK_SYSTEM_NEAR_MOTION_H
#define TP_BLOCK_SYSTEM_NEAR_MOTION_H

#include "block_system/built_system.h"
#include "block_system/resultant.h"

enum { TP_MOST_NEAR_MOTION_BLOCKS = 300 };

/* Into a case that has the estimate, if there is one: its moving factor, the motion, and its
 * verdict where that begins as the blocks are given. */
TP_MUST_USE tp_status tp_near_motion_find(tp_system_case *own, const tp_built_system *system,
                                          const tp_resultant *resultant, tp_message *message);

#endif
