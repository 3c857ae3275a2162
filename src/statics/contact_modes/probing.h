/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which contact to divide next, by trying the parts of all. */

#ifndef TP_CONTACT_MODES_PROBING_H
#define TP_CONTACT_MODES_PROBING_H

#include "contact_modes/branching.h"

/* Is there something to divide, of a block that is not at rest? A pair of corners is divided by its
 * first side. */
bool tp_probing_can_divide(const tp_modes_node *node, const tp_resting *resting, long contact);

/* The contact; -1: there is none. Parts that are refuted are left out; `refuted`: all are. */
TP_MUST_USE tp_status tp_probing_find(long *contact, bool *refuted, tp_branching *b,
                                      tp_message *message);

#endif
