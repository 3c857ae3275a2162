/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a block does at a tilt at which it has no equilibrium near where it is: slowed by a drag in
 * proportion to its mass, it comes to rest elsewhere, or moves off for good.
 *
 * C u' = F(u), by implicit steps in time that grow; u may grow without bound, the geometry stays.
 * Where the motion has become steady, u' = v, closures and slips are constant or grow with it, and
 * F = C v with contact forces of Coulomb's law for v: v is an acceleration with which a rigid block
 * begins to move from rest (docs/onset.md), and C v what its weight has too much. */

#ifndef TP_QUASI_STATIC_DRIFT_H
#define TP_QUASI_STATIC_DRIFT_H

#include "quasi_static/state.h"

typedef enum tp_drift_end { TP_DRIFT_RESTS, TP_DRIFT_MOVES_OFF, TP_DRIFT_UNDECIDED } tp_drift_end;

/* From a state to the next one, at the tilt of `to`. Where it moves off, `motion`. */
tp_drift_end tp_path_drift(tp_path_state *to, tp_path_motion *motion, const tp_path_state *from,
                           const tp_path_model *model, double tilt);

/* The motion with which the centroid has a velocity: are its contacts those of the state, the
 * closed ones neither opened nor pressed into, the open ones not pressed into? */
bool tp_path_motion_of(tp_path_motion *motion, const tp_path_state *state,
                       const tp_path_model *model, const tp_three *velocity);

#endif
