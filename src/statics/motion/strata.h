/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The modes in which a block can begin to move (mechanics section 6a): the cone K of twists, cut
 * into pieces on each of which the same contacts stay closed, slip in the same sense, or stick.
 *
 * These are its interior, where every contact opens; on each of its faces, whose points on the
 * normal line slip, the sectors between the twists about one of them; and the rays between all
 * those. A mode is closed: its twists are the sums of its rays with factors that are not negative,
 * and the forces on the block are sums of edges of the friction cones of contacts that are closed
 * within it, the edge against its slip or, where one sticks, both. Of contacts that slide along one
 * direction the two whose forces lie farthest apart stand for all. */

#ifndef TP_MOTION_STRATA_H
#define TP_MOTION_STRATA_H

#include "motion/mode.h"

/* Called for each mode; ends the visit with another outcome than TP_MOTION_PROVEN. */
typedef tp_motion_outcome (*tp_mode_visit)(void *context, const tp_mode *mode);

/* Adds to `twists` the rays of turning about points that stick on a face: those with friction, or
 * with `bonded`, where cohesion can make them stick, all. */
TP_MUST_USE tp_motion_outcome tp_strata_visit(tp_twists *twists, const tp_normals *normals,
                                              bool bonded, tp_mode_visit visit, void *context);

/* The mechanism of one ray: it slides, turns about a contact that sticks, or about another point.
 */
TP_MUST_USE tp_motion_outcome tp_strata_mechanism(tp_mechanism *mechanism, const tp_twists *twists,
                                                  const tp_normals *normals, long ray);

#endif
