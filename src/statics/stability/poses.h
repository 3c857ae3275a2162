/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* All resting poses of a block on its profile, each with its basins and its verdict: a scene whose
 * base says 'place: all' (docs/rest.md). */

#ifndef TP_STABILITY_POSES_H
#define TP_STABILITY_POSES_H

#include "scene/scene.h"
#include "topple.h"

/* Add them to the solution of the scene, whose block comes to rest as given. */
TP_MUST_USE tp_status tp_poses_find(tp_solution *solution, const tp_scene *scene,
                                    const tp_solve_options *options, tp_message *message);

#endif
