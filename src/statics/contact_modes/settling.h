/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a node says of blocks that are at rest, and of contacts between these. */

#ifndef TP_CONTACT_MODES_SETTLING_H
#define TP_CONTACT_MODES_SETTLING_H

#include "contact_modes/node.h"

/* Blocks that are at rest, and modes that this leaves; false: none are left to some contact. */
bool tp_modes_node_settle(tp_modes_node *node, const tp_resting *resting);
bool tp_modes_node_is_still(const tp_modes_node *node, const tp_resting *resting);

#endif
