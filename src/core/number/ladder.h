/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The ladder: one computation at rising prices, climbed only as far as the answer needs.
 *
 * A rung names the arithmetic of the moment sums (double with a bound, compensated double, balls,
 * exact integers) and the working precision of what follows. The computation says after each rung
 * whether all its numbers and decisions are certain. */

#ifndef TP_NUMBER_LADDER_H
#define TP_NUMBER_LADDER_H

#include "topple.h"

/* Bits of the rung of balls; and those from which a ball about zero that is narrow enough (judge.h)
 * is taken for zero: a tie. */
enum { TP_BALL_BITS = 160, TP_SETTLING_BITS = 1280 };

typedef struct tp_rung {
  tp_level level;
  long bits;
} tp_rung;

/* Run at one rung; `*certain` says that no higher rung is needed. A status other than TP_OK ends
 * the climb. */
typedef tp_status (*tp_ladder_step)(void *context, tp_rung rung, bool *certain);

/* Climb until a step is certain, from the first rung whose bits may do for `digits` decimal digits,
 * at levels up to `highest`. TP_UNDECIDED when the last rung was not enough: the results of the
 * last step stand, enclosures all of them. `*reached` is the last rung tried. */
TP_MUST_USE tp_status tp_ladder_climb(tp_ladder_step step, void *context, tp_level highest,
                                      int digits, tp_rung *reached);

/* No rung for so many digits has more bits. */
long tp_ladder_most_bits(int digits);

#endif
