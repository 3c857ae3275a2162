/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The contact of a problem as friction cones, with the base as the scene has it or otherwise. */

#ifndef TP_STATIC_LIMIT_LIMIT_CONES_H
#define TP_STATIC_LIMIT_LIMIT_CONES_H

#include "evaluation/evaluation.h"
#include "linear_program/cones.h"
#include "static_limit/limit_beyond.h"

/* Would the forces of the base be others if it ended at the toe where it goes on, or went on
 * (static_limit/limit_beyond.h) where it ends? False when memory is exhausted. */
TP_MUST_USE bool tp_limit_base_matters(bool *matters, const tp_problem *problem,
                                       tp_direction towards);

/* In lattice units, or under loads in metres, x mirrored towards the right; tan(phi) is left at
 * zero, but for facets with a friction of their own. A facet's two ends come one after the other. A
 * point's site is the number of its contact point, or a higher one of its own past the toe.
 * Cohesion and bonds act on the contact that the scene has, not past its end. False when memory is
 * exhausted. */
TP_MUST_USE bool tp_limit_cones_init(tp_cones *cones, const tp_evaluation *evaluation,
                                     tp_direction towards, bool otherwise);

/* As the onset asks: with the contact that the scene has, and behind its points those with the
 * friction of facets beside (problem/facet_friction.h), which are of no facet. */
TP_MUST_USE bool tp_limit_cones_init_beside(tp_cones *cones, const tp_evaluation *evaluation,
                                            tp_direction towards);

/* Of a base that ends at the toe, two of its points and behind them what it would have more if it
 * went on. False when memory is exhausted. */
TP_MUST_USE bool tp_limit_cones_added(tp_cones *cones, const tp_evaluation *evaluation,
                                      tp_direction towards, const tp_cones *own,
                                      const long points[2]);

/* Of a base that goes on, would the facet of the contact be there if it ended at the toe? */
bool tp_limit_keeps_facet(const tp_problem *problem, tp_direction towards, long facet);

#endif
