/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Is a block held by ground in front of its toe, a step or a bench, that may be gone? */

#ifndef TP_STABILITY_FRONT_GROUND_H
#define TP_STABILITY_FRONT_GROUND_H

#include "stability/half_tolerance.h"

/* Solves the scene once more without the ground in front of the toe, for each direction in which
 * the contact begins with a facet that rises against the motion by more than 45 degrees, or in
 * which a base that goes on past a mated sole holds the block. Adds a caution with the factor
 * without that ground where it is lower by more than a hundredth, or the block moves without it.
 * TP_OUT_OF_MEMORY alone is a failure. */
TP_MUST_USE tp_status tp_front_ground_check(tp_solution *solution, const tp_scene *scene,
                                            const tp_solve_options *options,
                                            tp_half_tolerance_solve *solve, tp_message *message);

#endif
