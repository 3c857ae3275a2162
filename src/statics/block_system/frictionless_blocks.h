/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Do blocks stand as they lie without any friction? Then they do whatever friction there is. */

#ifndef TP_BLOCK_SYSTEM_FRICTIONLESS_BLOCKS_H
#define TP_BLOCK_SYSTEM_FRICTIONLESS_BLOCKS_H

#include "block_system/resultant.h"
#include "contact_modes/resting.h"

TP_MUST_USE tp_status tp_frictionless_blocks(bool *stand, const tp_resting *resting,
                                             const tp_resultant *resultant, tp_message *message);

#endif
