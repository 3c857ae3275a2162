/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The shear that the cohesion of a joint may exert, besides friction, as a motion begins with modes
 * of a node: nothing where it is all open, all of it against a slip, anything between where it
 * sticks. */

#ifndef TP_CONTACT_MODES_COHESIVE_SHEAR_H
#define TP_CONTACT_MODES_COHESIVE_SHEAR_H

#include "contact_modes/node.h"

/* Along t, on the first block: no less, no more. */
typedef struct tp_cohesive_shear {
  tp_near least, most;
} tp_cohesive_shear;

tp_cohesive_shear tp_cohesive_shear_of(const tp_modes_node *node, const tp_modes_question *question,
                                       long contact);

/* Can its cohesion be anything else than one number? */
static inline bool tp_cohesive_shear_varies(tp_cohesive_shear s) {
  return s.least.value != s.most.value || s.least.error != s.most.error;
}

#endif
