/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene with partial factors, solved in each combination of favourable and unfavourable actions
 * (scene/partial_factors.h); the solution is that of the worst. */

#ifndef TP_STABILITY_COMBINATIONS_H
#define TP_STABILITY_COMBINATIONS_H

#include "scene/scene.h"
#include "topple.h"

/* Has the scene partial factors that are still to be applied? */
bool tp_combinations_asked(const tp_scene *scene);

/* Solve a scene whose factors are applied. */
typedef tp_status tp_combination_solve(tp_solution **solution, const tp_scene *scene,
                                       const tp_solve_options *options, tp_message *message);

TP_MUST_USE tp_status tp_combinations_solve(tp_solution **solution, const tp_scene *scene,
                                            const tp_solve_options *options,
                                            tp_combination_solve *solve, tp_message *message);

#endif
