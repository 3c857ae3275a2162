/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where the base ends, and what it would add if it went on (docs/mechanics.md section 6).
 *
 * A base that ends below the block's sole goes on along it, mated: over the edges of the underside
 * that are nearer level than upright or go straight on. From there it is the next flank of a
 * toothed base, level ground otherwise. */

#ifndef TP_STATIC_LIMIT_LIMIT_BEYOND_H
#define TP_STATIC_LIMIT_LIMIT_BEYOND_H

#include "problem/problem.h"

/* The contact point farthest down-dip. */
const tp_contact_point *tp_limit_toe(const tp_problem *problem, tp_direction towards);

/* Does the base go on past the down-dip end of the contact? */
bool tp_limit_base_beyond_toe(const tp_problem *problem, tp_direction towards);

/* t of a facet, up-dip; x mirrored towards the right. */
void tp_limit_direction(fmpz_t tx, fmpz_t ty, const tp_lattice *lattice, const tp_facet *facet,
                        tp_direction towards);

/* What a base that ends at the toe would add. */
typedef struct tp_limit_beyond {
  tp_facets sole;      /* along the block's sole, from the toe on */
  bool rises;          /* the flank or the level ground past that presses against its end: */
  tp_outline_point at; /* there, */
  fmpz_t tx, ty;       /* with this direction, as of tp_limit_direction */
} tp_limit_beyond;

/* False when memory is exhausted, and `beyond` is cleared. */
TP_MUST_USE bool tp_limit_beyond_init(tp_limit_beyond *beyond, const tp_problem *problem,
                                      tp_direction towards);
void tp_limit_beyond_clear(tp_limit_beyond *beyond);

#endif
