/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Up to where no motion can begin, from where the blocks lie on: along a divisor of strength or a
 * tilt. */

#ifndef TP_BLOCK_SYSTEM_STANDING_H
#define TP_BLOCK_SYSTEM_STANDING_H

#include "block_system/moving.h"
#include "contact_modes/arranged.h"
#include "contact_modes/exclusion.h"
#include "contact_modes/virtual_motion.h"

/* What an exclusion is asked of, as blocks are arranged. */
typedef struct tp_standing_state {
  tp_near *friction, *cohesion, *bond, *loads;
  bool has_bond;
} tp_standing_state;

typedef struct tp_standing_search {
  const tp_arranged *arranged;
  tp_known_proofs *known; /* of blocks as they are arranged */
  tp_moving_state *state; /* linear, or by strength, between two of x: proofs are of all between */
  const void *context;
  bool loads_vary; /* between two of x: it is a tilt, or joints pull, by a strength that is divided
                    */
  long most_work;  /* in all */
  long work;       /* so far */
  long proof_work; /* of the last proof that was found; 0: of none */
  long try_work;   /* that a try of an interval may take */
  bool by_virtual_motions; /* modes were too many once, and a virtual motion proved it */
  int virtual_in_vain;     /* virtual motions that were sought and not found */
  tp_virtual_known virtual_known;
  tp_blocks_at at;
  tp_standing_state ends[2];
  tp_mode_set *left_arranged;
  tp_mode_set *left; /* by contact: what an exclusion left; all 0: nothing of the kind */
} tp_standing_search;

TP_MUST_USE tp_status tp_standing_init(tp_standing_search *standing, const tp_arranged *arranged,
                                       tp_known_proofs *known, tp_moving_state *state,
                                       const void *context, tp_message *message);
void tp_standing_clear(tp_standing_search *standing);

/* Is every motion excluded for all numbers from `from` to `to`? */
TP_MUST_USE tp_status tp_standing_prove(bool *proven, tp_standing_search *standing, double from,
                                        double to, tp_message *message);

/* The greatest x below `limit` up to which it is, from `from` where it is, to such a width. */
TP_MUST_USE tp_status tp_standing_extend(double *x, tp_standing_search *standing, double from,
                                         double limit, double width, tp_message *message);

#endif
