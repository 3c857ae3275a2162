/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Do two solutions tell the same of scenes that are related in a known way?
 *
 * Each number is an enclosure of its truth, and the truths are related exactly: what the relation
 * makes of the one enclosure must meet the other. No tolerance is needed. Decisions must be equal;
 * where two mechanisms tie, or two pivots, either may be named first. */

#ifndef TP_TEST_COMPARE_SOLUTIONS_H
#define TP_TEST_COMPARE_SOLUTIONS_H

#include "topple.h"

#include <arb.h>
#include <flint/fmpq.h>

/* In metres (x, y) becomes (MAP_XX x + MAP_XY y + SHIFT_X, MAP_YX x + MAP_YY y + SHIFT_Y), a turn
 * or mirror times LENGTH > 0. */
enum { MAP_XX, MAP_XY, MAP_YX, MAP_YY, SHIFT_X, SHIFT_Y, LENGTH, RELATION_NUMBERS };

typedef struct relation {
  fmpq numbers[RELATION_NUMBERS];
  bool mirrored; /* left and right */
  bool turned; /* block and base on the table: every angle towards the left falls by `turn_deg`, and
                  what depends on the tilt itself cannot be compared */
  arb_t turn_deg;
  bool more_vertices; /* the other has vertices on its edges */
  bool capacities;    /* cohesion or bonds bear a share that no reaction tells */
  bool uncertain;     /* the other is not certain: its numbers must hold, not its decisions */
} relation;

void relation_init(relation *r); /* the same scene */
void relation_clear(relation *r);

/* False, with the first difference in `why`. */
bool solutions_agree(char why[256], const tp_solution *one, const tp_solution *other,
                     const relation *r);

#endif
