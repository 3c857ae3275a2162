/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Table of precisions (arithmetic of the sums and bits of what follows) and the loop over them from
 * the cheapest on, limited by the level and the digits asked for (docs/mechanics.md section 10). */

#include "number/ladder.h"

#include "number/ball.h"

#include <string.h>

static const tp_rung rungs[] = {
    {TP_LEVEL_DOUBLE, 64},  {TP_LEVEL_COMPENSATED, 128},        {TP_LEVEL_BALL, TP_BALL_BITS},
    {TP_LEVEL_EXACT, 320},  {TP_LEVEL_EXACT, TP_SETTLING_BITS}, {TP_LEVEL_EXACT, 5120},
    {TP_LEVEL_EXACT, 20480}};
/* From TP_SETTLING_BITS on a rung has four times the bits of the one before. The highest, unless
 * more digits are asked for, is one above it. */
enum { RUNGS = sizeof rungs / sizeof rungs[0], MOST_BITS = 4 * TP_SETTLING_BITS };

/* Some more for what follows the sums: a number that loses SPARE bits to cancellation and roundings
 * is still certain to its digits. */
static long bits_for(int digits) {
  enum { SPARE = 32 };
  return (long)tp_digits_bits(digits) + SPARE;
}

long tp_ladder_most_bits(int digits) {
  enum { AMPLE = 8 }; /* times what the digits take: beyond it a number is undecided */
  const long ample = AMPLE * bits_for(digits);
  return ample > MOST_BITS ? ample : MOST_BITS;
}

/* Doubles have a rung of their own; balls may have any number of bits. */
static bool is_allowed(tp_rung rung, tp_level highest, int digits) {
  if (rung.level > highest && highest < TP_LEVEL_BALL) return false;
  return rung.bits <= tp_ladder_most_bits(digits);
}

tp_status tp_ladder_climb(tp_ladder_step step, void *context, tp_level highest, int digits,
                          tp_rung *reached) {
  for (int k = 0; k < RUNGS; k++) {
    const bool last = k + 1 == RUNGS || !is_allowed(rungs[k + 1], highest, digits);
    if (rungs[k].bits < bits_for(digits) && !last) continue;
    bool certain = false;
    *reached = rungs[k];
    if (reached->level > highest) reached->level = highest;
    const tp_status status = step(context, *reached, &certain);
    if (status != TP_OK) return status;
    if (certain) return TP_OK;
    if (last) return TP_UNDECIDED;
  }
  return TP_UNDECIDED;
}
