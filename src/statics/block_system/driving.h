/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The factor on what drives: by how much the loads that drive blocks to the side of a case can be
 * multiplied until no forces hold them. Strength divided says nothing of a column that topples,
 * which it does however rough its joints are; of one block this is the factor by moments.
 *
 * As by moments the weight counts by its two components, across and along the base (x): of gravity
 * what points to the side drives, what presses on the base or points the other way rests. So do
 * surcharges. An earthquake drives as a whole. Of other loads (block_system/block_loads.h) some
 * drive, bolts never. */

#ifndef TP_BLOCK_SYSTEM_DRIVING_H
#define TP_BLOCK_SYSTEM_DRIVING_H

#include "block_system/built_system.h"
#include "block_system/resultant.h"

typedef struct tp_driving {
  bool drives;           /* there are such loads: */
  arb_t rests[2];        /* if drives: of a weight of one what always acts, in x and y, */
  arb_t pushes[2];       /* and what is multiplied */
  tp_weight_loads loads; /* both, with other loads: the live ones are multiplied; 1 as all lies */
  tp_near *push;         /* of other loads, by row: its own */
} tp_driving;

/* On failure cleared. */
TP_MUST_USE tp_status tp_driving_init(tp_driving *driving, const tp_built_system *system,
                                      const tp_resultant *resultant, tp_message *message);
void tp_driving_clear(tp_driving *driving);

/* With weights and an earthquake alone: the multiple at which their resultant is at an angle from
 * the normal of the base, given by its tangent; an infinity where it does not come so far. */
void tp_driving_at_tangent(arb_t factor, const tp_driving *driving, const arb_t tangent);

/* The factor and the collapse beyond it, into a case of which the limit to the side, as the blocks
 * lie, is `side`: that tells it where weights are not measured. */
TP_MUST_USE tp_status tp_driving_factor_find(tp_system_case *own, const tp_driving *driving,
                                             const tp_built_system *system,
                                             const tp_load_bracket *side, tp_message *message);

/* And what the angles of the case say of it where weights are not measured: up to which multiple no
 * motion can begin, and from which one can. Returns the former, also beyond TP_MOST_FACTOR; 1 where
 * there is none. */
double tp_driving_of_angles(tp_system_case *own, const tp_driving *driving,
                            const tp_resultant *resultant);

#endif
