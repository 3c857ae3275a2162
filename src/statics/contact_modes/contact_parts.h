/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the modes of a contact of a node are divided into, each part once. */

#ifndef TP_CONTACT_MODES_CONTACT_PARTS_H
#define TP_CONTACT_MODES_CONTACT_PARTS_H

#include "contact_modes/node.h"

enum { TP_MOST_PARTS = 10 };

/* What a contact is divided into: sets of its own, and of a pair of corners those of its twin. */
typedef struct tp_contact_parts {
  int count;
  long contact, twin;
  tp_mode_set own[TP_MOST_PARTS], of_twin[TP_MOST_PARTS];
} tp_contact_parts;

/* Of a pair of corners by its first side. */
tp_contact_parts tp_contact_parts_of(const tp_modes_node *node, const tp_resting *resting,
                                     long contact);

#endif
