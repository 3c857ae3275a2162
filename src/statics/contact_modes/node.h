/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A set of modes for each contact, and what is asked of all motions that have modes of these sets.
 * Friction and cohesion may be anything between two numbers, and the loads anything between two. */

#ifndef TP_CONTACT_MODES_NODE_H
#define TP_CONTACT_MODES_NODE_H

#include "contact_modes/mode_set.h"
#include "contact_modes/resting.h"

typedef struct tp_modes_question {
  const tp_resting *resting;
  const tp_near *friction[2]; /* tan(phi) by contact: the least, the greatest */
  const tp_near *cohesion[2]; /* its force by contact: the least, the greatest */
  const tp_near *loads[2];    /* w by row, with the pull of all bonds */
  const tp_near *bond[2];     /* by load: 2 a contact, the pull at each of its ends that is part of
                                 w; NULL: there is none */
  int load_count;             /* 1 or 2 */
  bool weights_alone;         /* are the loads */
} tp_modes_question;

typedef struct tp_modes_node {
  tp_mode_set *sets; /* by contact */
  bool *still;       /* by number of a free block: its acceleration is 0 */
} tp_modes_node;

/* All modes, and no block at rest. False when memory is exhausted. */
TP_MUST_USE bool tp_modes_node_init(tp_modes_node *node, const tp_resting *resting);
void tp_modes_node_clear(tp_modes_node *node);
void tp_modes_node_widen(tp_modes_node *node, const tp_resting *resting);
/* Of all contacts. */
long tp_modes_node_count(const tp_modes_node *node, const tp_resting *resting);

/* Is a block, by its row, at rest or fixed? */
static inline bool tp_modes_rests(const tp_modes_node *node, long row) {
  return row < 0 || node->still[row / 3];
}

#endif
