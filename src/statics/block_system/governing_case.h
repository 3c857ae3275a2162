/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Of the cases of many blocks the one that governs, how its blocks begin to move, and among how
 * many motions are looked for. */

#ifndef TP_BLOCK_SYSTEM_GOVERNING_CASE_H
#define TP_BLOCK_SYSTEM_GOVERNING_CASE_H

#include "topple_block_system.h"

enum { TP_MOST_MOVING_BLOCKS = 48 }; /* free ones, among which motions are looked for */

/* The factor of safety of a case: the lesser of that by strength reduction and that on what drives;
 * this one where no strength holds the blocks and it is a number. */
typedef struct tp_system_factor {
  tp_fos fos;
  bool is_least; /* it is only known to be exceeded */
  tp_fos_definition definition;
} tp_system_factor;
tp_system_factor tp_system_case_factor(const tp_system_case *of);

/* Does one certainly govern before the other? By collapse, by the factor, and where that is the
 * same by how much more tilt it bears. */
bool tp_system_case_is_worse(const tp_system_case *one, const tp_system_case *other);

/* Do they collapse as they lie, though forces hold them farther to its side? */
bool tp_system_case_is_held_farther(const tp_system_case *own);

/* A system has one at least. */
const tp_system_case *tp_system_governing(const tp_block_system *system);

/* How the blocks begin to move in the collapse: slide, topple, both; stands: none is known. */
tp_mechanism tp_system_case_mechanism(const tp_system_case *own);

/* Is a motion proven to begin at less than the factor by strength reduction, beyond which
 * that is no news? */
bool tp_system_case_moves_sooner(const tp_system_case *own);

/* Were there too many blocks to look for motions, and do they not stand without friction? */
bool tp_system_case_is_unexamined(const tp_system_case *own);

#endif
