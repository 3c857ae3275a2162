/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A block that lies on a slope is shaken both ways, with the vertical part of the earthquake and
 * without it. Each of these earthquakes is a scene of its own, solved by itself, as the block lets
 * go down-dip under one and up-dip under the other; the solution is that of the one that governs,
 * and names the others. What fails counts as worse than what stands, and a lower governing factor
 * as worse than a higher. */

#ifndef TP_EARTHQUAKES_H
#define TP_EARTHQUAKES_H

#include "scene/scene.h"
#include "topple.h"

/* Is it for a scene to be solved under several earthquakes? Bad input where its `direction` says
 * what only a block on a slope can have. */
TP_MUST_USE tp_status tp_earthquakes_asked(bool *several, const tp_scene *scene,
                                           tp_message *message);

/* Solve a scene as it is, with no more than one earthquake. */
typedef tp_status tp_earthquake_solve(tp_solution **solution, const tp_scene *scene,
                                      const tp_solve_options *options, tp_message *message);

/* The solution of the earthquake that governs, each solved by `solve`. */
TP_MUST_USE tp_status tp_earthquakes_solve(tp_solution **solution, const tp_scene *scene,
                                           const tp_solve_options *options,
                                           tp_earthquake_solve *solve, tp_message *message);

/* A copy of the scene under the earthquake that governs its solution; it shares all with the scene,
 * and is not to be cleared. */
void tp_earthquake_scene(tp_scene *shaken, const tp_scene *scene, const tp_solution *solution);

/* What counts of water under an earthquake up-dip. */
TP_MUST_USE tp_status tp_earthquake_note_water(tp_notes *notes, const tp_water_description *water,
                                               tp_message *message);

/* Is a scene that is tilted on a table shaken to one side alone, without having said so? */
bool tp_earthquake_is_one_sided(const tp_scene *scene);

#endif
