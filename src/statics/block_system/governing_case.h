/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The factor of safety of many blocks by the rule of verdict/safety.h: of each case, and over all
 * of them; how its blocks begin to move, and among how many motions are looked for. */

#ifndef TP_BLOCK_SYSTEM_GOVERNING_CASE_H
#define TP_BLOCK_SYSTEM_GOVERNING_CASE_H

#include "topple_block_system.h"
#include "verdict/safety.h"

enum { TP_MOST_MOVING_BLOCKS = 48 }; /* free ones, among which motions are looked for */

/* The bounds of both factors, from what was found of a case: limits of what forces can hold, up to
 * where no motion can begin, and from where on one can; `fos_by_driving.mechanism` is that of the
 * motion with more of what drives, where one was found. */
void tp_system_case_set_bounds(tp_system_case *own);

/* After bounds were changed: where neither more strength nor less of what drives stops a motion
 * that can begin, there is no factor above 0. */
void tp_system_case_settle_bounds(tp_system_case *own);

/* The bounds once a further motion was found, which may have changed the verdict from that before.
 */
void tp_system_case_take_motion(tp_system_case *own, tp_system_verdict before);

/* The safety of a case in the terms of the rule, and `safety` of the struct. */
tp_safety tp_system_case_rule(const tp_system_case *own);
void tp_system_case_set_safety(tp_system_case *own);

/* Which case governs, and the safety over all. */
void tp_block_system_set_safety(tp_block_system *system);

/* Does one govern before the other? */
bool tp_system_case_is_worse(const tp_system_case *one, const tp_system_case *other);

/* Do they collapse as they lie, though forces hold them farther to its side? */
bool tp_system_case_is_held_farther(const tp_system_case *own);

/* The case whose factor governs; a system has one at least. And the one of the most severe verdict,
 * which is another where that is open. */
const tp_system_case *tp_system_governing(const tp_block_system *system);
const tp_system_case *tp_system_most_severe(const tp_block_system *system);

/* How the blocks begin to move in the collapse: slide, topple, both; stands: none is known. */
tp_mechanism tp_system_case_mechanism(const tp_system_case *own);

/* Likewise of the motions of a list. */
tp_mechanism tp_system_motions_mechanism(const tp_system_motion *motions, size_t count);

/* What the blocks do with or without the scene's earthquake, whichever is the more severe; and can
 * a motion begin before it shakes, so that no acceleration is critical? */
tp_system_verdict tp_system_case_worst_verdict(const tp_system_case *own);
bool tp_system_case_moves_at_rest(const tp_system_case *own);

/* Is a motion proven to begin at less than the factor by strength reduction, beyond which
 * that is no news? */
bool tp_system_case_moves_sooner(const tp_system_case *own);

/* Were there too many blocks to look for motions, and do they not stand without friction? */
bool tp_system_case_is_unexamined(const tp_system_case *own);

#endif
