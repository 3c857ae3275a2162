/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The result of a scene of many blocks, before anything is solved. */

#ifndef TP_BLOCK_SYSTEM_SYSTEM_H
#define TP_BLOCK_SYSTEM_SYSTEM_H

#include "block_system/built_system.h"

/* Which motions that can begin although forces hold the blocks are looked for: none, so that blocks
 * that do not collapse `can be held`; whether any can as they lie, which tells whether they stand;
 * or also with less strength and at other tilts, the most costly by far. */
typedef enum tp_motions_sought {
  TP_MOTIONS_NONE,
  TP_MOTIONS_AS_THEY_LIE,
  TP_MOTIONS_ALL
} tp_motions_sought;

/* Those that cost little: all of few blocks, of more none. */
tp_motions_sought tp_block_system_cheap_motions(const tp_scene *scene);

/* tp_solve_block_system with so many motions: for many solves in a row. */
TP_MUST_USE tp_status tp_block_system_solve(tp_block_system **system, const tp_scene *scene,
                                            const tp_solve_options *options,
                                            tp_motions_sought motions, tp_message *message);

/* Of one scene, to which partial factors, where it has any, were applied. */
TP_MUST_USE tp_status tp_block_system_solve_as_given(tp_block_system **system,
                                                     const tp_scene *scene,
                                                     const tp_solve_options *options,
                                                     tp_motions_sought motions,
                                                     tp_message *message);

/* Without cases, and with room for three; to be freed by tp_block_system_free. */
TP_MUST_USE tp_status tp_block_system_describe(tp_block_system **system,
                                               const tp_built_system *built, tp_message *message);

/* Does the scene give the unit weights of blocks that are free? */
bool tp_system_is_weighed(const tp_block_system *system);

/* One more case, with room for its motions and forces. */
TP_MUST_USE tp_status tp_system_case_add(tp_block_system *system, tp_system_case **added,
                                         tp_message *message);

/* The last one, with all that it has. */
void tp_system_case_drop_last(tp_block_system *system);

#endif
