/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a motion that is to be proven begins from: one mode a contact, friction, loads, and forces
 * near to its own. */

#ifndef TP_CONTACT_MODES_TRIAL_MODE_H
#define TP_CONTACT_MODES_TRIAL_MODE_H

#include "contact_modes/resting.h"
#include "contact_modes/rigid_groups.h"

/* Of one contact. Ties have two laws at once: an end stays closed and bears nothing; a contact
 * sticks, and all of its friction acts to one side. */
typedef struct tp_trial_mode {
  tp_mode_set mode; /* one: what closes, and what sticks */
  bool idle[2];     /* that end is closed, and bears nothing */
  int spent;        /* friction as if it slipped forward, 1, or back, -1; else 0 */
  bool pulled[2];   /* of a bond: that end pulls, by no more than it has to (tp_trial_is_bonded) */
} tp_trial_mode;

typedef struct tp_beginning_question {
  tp_rigid_groups *groups;     /* of the blocks; kept from one question to the next */
  const tp_near *friction;     /* by contact */
  const tp_near *cohesion;     /* by contact: the force of all of it */
  const tp_near *bond, *piece; /* 2 a contact: the pull at its ends that is part of w, and that of
                                  the piece at each end (block_system/blocks_at.h); NULL: none */
  const tp_near *loads;        /* w by row, about centroids */
  const double *normals, *shears; /* 2 a contact: forces to begin from */
} tp_beginning_question;

/* Does a contact slip with both ends closed, and has it a bond? Then each of its ends bears, with
 * friction, or its bond pulls there, without. */
bool tp_trial_is_bonded(const tp_beginning_question *question, const tp_trial_mode *trial,
                        long contact);

#endif
