/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The contact of a problem as friction cones, with the base as the scene has it or otherwise. */

#ifndef TP_LIMIT_CONES_H
#define TP_LIMIT_CONES_H

#include "limit/cones.h"
#include "stability/evaluation.h"

/* Does the base go on past the down-dip end of the contact? */
bool tp_limit_base_beyond_toe(const tp_problem *problem, tp_direction towards);

/* Would the forces of the base be others if it ended at the toe where it goes on, or went on (along
 * the teeth of a toothed block, level otherwise) where it ends? */
bool tp_limit_base_matters(const tp_problem *problem, tp_direction towards);

/* In lattice units, or under loads in metres, x mirrored towards the right; tan(phi) is left at
 * zero. A facet's two ends come one after the other. A point's site is twice the number of its
 * contact point, plus one for the up-dip side of a rounded corner. False when memory is exhausted.
 */
TP_MUST_USE bool tp_limit_cones_init(tp_cones *cones, const tp_evaluation *evaluation,
                                     tp_direction towards, bool otherwise);

#endif
