/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The loads under which a mode can begin: the cone C of M a - sum f over its twists a and its
 * forces f, M a being what accelerates the block, by the half-spaces h . w >= 0 that bound it.
 *
 * C is spanned by M r for its rays and by -e for its edges; a plane through two of those with all
 * others on one side bounds it. The loads lie in C also where forces alone balance them: those that
 * move lie in C less some of its bounding planes, and come as close to these as one likes, so that
 * but for loads that stay within a plane all that counts is C. A plane therefore notes which rays
 * lie in it. */

#ifndef TP_MOTION_BOUNDS_H
#define TP_MOTION_BOUNDS_H

#include "motion/bound_plane.h"

typedef struct tp_bounds {
  long count, room;
  tp_bound *items;
  tp_mode_tilts tilts; /* as told in doubles: unless open, none but the planes that matter are here,
                          each of which the loads leave, and h of none as yet */
  tp_chosen_planes chosen;
  tp_generators generators;
} tp_bounds;

/* Into `bounds`, which may hold those of another mode; `strength` is that of the mode, or NULL. */
TP_MUST_USE tp_motion_outcome tp_bounds_find(tp_bounds *bounds, const tp_mode_filter *filter,
                                             const tp_motion_question *question,
                                             const tp_normals *normals, const tp_twists *twists,
                                             const tp_mode *mode, const tp_strength *strength);
/* h of one of those that doubles have chosen. */
TP_MUST_USE tp_motion_outcome tp_bounds_evaluate(tp_bounds *bounds, long k,
                                                 const tp_motion_question *question,
                                                 const tp_normals *normals, const tp_twists *twists,
                                                 const tp_mode *mode);
void tp_bounds_clear(tp_bounds *bounds);

#endif
