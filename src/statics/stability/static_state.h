/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The state of a block without its earthquake. It counts in addition to every earthquake: a block
 * that fails at rest fails, whatever resistance the earthquake adds. */

#ifndef TP_STABILITY_STATIC_STATE_H
#define TP_STABILITY_STATIC_STATE_H

#include "scene/scene.h"
#include "topple.h"

/* Can the state without the earthquake be the less safe one? Not where the earthquake acts down-dip
 * and horizontally, and nothing else holds or pulls the block: then it only adds driving loads. */
bool tp_static_state_counts(const tp_scene *scene);

/* Solve a scene as it is. */
typedef tp_status tp_static_state_solve(tp_solution **solution, const tp_scene *scene,
                                        const tp_solve_options *options, tp_message *message);

/* Solves the scene without its earthquake, and puts its cases in place of those of `solution` that
 * are less severe, with a caution for each. */
TP_MUST_USE tp_status tp_static_state_join(tp_solution *solution, const tp_scene *scene,
                                           const tp_solve_options *options,
                                           tp_static_state_solve *solve, tp_message *message);

#endif
