/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Proofs that nothing holds the block, at a tilt or over an interval of tilts: admissible twists on
 * which the loads do more work than is resisted (Farkas). */

#ifndef TP_CERTIFICATE_INFEASIBLE_H
#define TP_CERTIFICATE_INFEASIBLE_H

#include "certificate/equilibrium.h"
#include "certificate/face.h"

/* Is there no equilibrium under a wrench? Without a push, NULL, by one in doubles, and by doubles
 * alone. Where there is none `*motion` is that of the twist which proves it; NULL: not asked. */
tp_answer tp_infeasible_under(tp_face_motion *motion, const tp_limit_question *question,
                              tp_scaled *scaled, const tp_vector *push, const tp_vector *load);

/* Is there none at the tilt? */
tp_answer tp_infeasible_at(const tp_limit_question *question, tp_scaled *scaled,
                           const tp_vector *push, const arb_t degrees);

/* Is there no equilibrium from the tilt `low` to `high`, both included? Admissible twists that
 * doubles find, each for the tilts between two zeros of v . F - K. */
tp_answer tp_infeasible(const tp_limit_question *question, tp_scaled *scaled, const tp_vector *push,
                        const arb_t low, const arb_t high);

/* The same, from where the loads beat the face onwards, `degrees` excluded. */
tp_answer tp_infeasible_after(const tp_face *face, const tp_limit_question *question,
                              tp_scaled *scaled, const tp_vector *push, const arb_t degrees,
                              const arb_t high);

#endif
