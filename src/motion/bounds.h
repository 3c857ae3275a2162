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

#ifndef TP_BOUNDS_H
#define TP_BOUNDS_H

#include "motion/generators.h"
#include "motion/mode_filter.h"

typedef struct tp_bound {
  tp_vector h;
  tp_source source;
  bool ray_and_edge; /* the pair is */
  bool lower;        /* where doubles chose it: it ends the tilts from below */
  unsigned rays;     /* bit k: M times the k-th ray of the mode lies in the plane */
  arb_t held;        /* h . w >= held, below zero or above by cohesion and bonds */
} tp_bound;

typedef struct tp_bounds {
  long count, room;
  tp_bound *items;
  tp_mode_tilts tilts; /* as told in doubles: unless open, none but the planes that matter are here,
                          each of which the loads leave */
  tp_generators generators;
} tp_bounds;

/* Into `bounds`, which may hold those of another mode; `strength` is that of the mode, or NULL. */
TP_MUST_USE tp_motion_outcome tp_bounds_find(tp_bounds *bounds, const tp_mode_filter *filter,
                                             const tp_motion_question *question,
                                             const tp_normals *normals, const tp_twists *twists,
                                             const tp_mode *mode, const tp_strength *strength);
void tp_bounds_clear(tp_bounds *bounds);

#endif
