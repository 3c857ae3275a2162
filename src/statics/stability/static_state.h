/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The state of a block without its earthquake. It counts in addition to every earthquake: a block
 * that fails at rest fails, whatever resistance the earthquake adds. */

#ifndef TP_STABILITY_STATIC_STATE_H
#define TP_STABILITY_STATIC_STATE_H

#include "problem/problem.h"
#include "scene/scene.h"
#include "topple.h"

/* Is the scene shaken, so that there is a state without the earthquake? */
bool tp_static_state_exists(const tp_scene *scene);

/* Does that state have to be solved, whatever the block? Not where the earthquake acts down-dip and
 * horizontally, and nothing else holds or pulls the block: then that depends on the block. */
bool tp_static_state_counts(const tp_scene *scene);

/* Can a block that only an earthquake down-dip and its weight drive be less safe without it? Then a
 * motion up-dip can begin at rest: a facet of its base dips up-dip, the weight passes the up-dip
 * end of the contact, or the base admits a motion in which the weight goes down and the earthquake
 * works against it. `solution` is of the block with its earthquake. */
bool tp_static_state_may_govern(const tp_problem *problem, const tp_solution *solution);

/* A point of a contact from the centroid, with the normal of its facet; down-dip towards -x. */
typedef struct tp_contact_row {
  double x, y, nx, ny;
} tp_contact_row;

/* Do contacts admit a velocity with which the centroid goes down and, along the horizontal, not to
 * the down-dip side? In doubles; true where that is open. */
bool tp_may_move_against(const tp_contact_row *rows, long count, double tilt_tangent);

/* Solve a scene as it is. */
typedef tp_status tp_static_state_solve(tp_solution **solution, const tp_scene *scene,
                                        const tp_solve_options *options, tp_message *message);

/* Solves the scene without its earthquake, and puts its cases in place of those of `*solution` that
 * are less severe, with a caution for each. */
TP_MUST_USE tp_status tp_static_state_join(tp_solution **solution, const tp_scene *scene,
                                           const tp_solve_options *options,
                                           tp_static_state_solve *solve, tp_message *message);

#endif
