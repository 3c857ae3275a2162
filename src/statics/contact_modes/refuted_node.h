/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which nodes a proof refutes: not only the one that it was found for, but all within the widest
 * sets of modes for which it is as good. */

#ifndef TP_CONTACT_MODES_REFUTED_NODE_H
#define TP_CONTACT_MODES_REFUTED_NODE_H

#include "contact_modes/node.h"
#include "contact_modes/reactions.h"

/* The sign of a factor that is known between two numbers. */
typedef enum tp_factor_sign {
  TP_FACTOR_NONE,
  TP_FACTOR_NEGATIVE,
  TP_FACTOR_POSITIVE,
  TP_FACTOR_EITHER
} tp_factor_sign;

/* All modes, while the blocks of this node rest that do; where there is cohesion, or a
 * bond, what the node has. */
void tp_refuted_node_begin(tp_modes_node *refuted, const tp_modes_node *node,
                           const tp_modes_question *question);

/* Those in which a reaction with such a factor is one. */
void tp_refuted_node_bears(tp_modes_node *refuted, const tp_resting *resting,
                           const tp_bearing_reaction *reaction, tp_factor_sign sign);

/* Those of which no force resists the accelerations y of the blocks of the node that move. */
void tp_refuted_node_yields(tp_modes_node *refuted, const tp_modes_node *node,
                            const tp_modes_question *question, const tp_near *y);

#endif
