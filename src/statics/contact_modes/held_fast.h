/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Is a block at rest because of what its contacts with blocks at rest say: ends that do not enter
 * these, ends that stay closed, slips to one side? Decided exactly. */

#ifndef TP_CONTACT_MODES_HELD_FAST_H
#define TP_CONTACT_MODES_HELD_FAST_H

#include "contact_modes/node.h"

/* `block` is the number of a free one that is not known to be at rest. */
bool tp_modes_is_held_fast(const tp_modes_node *node, const tp_resting *resting, long block);

#endif
