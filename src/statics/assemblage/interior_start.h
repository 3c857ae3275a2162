/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Points that the interior point method came through, kept for programs of states that differ a
 * little, as of a strength that is searched: from one of them it takes a few steps where from
 * nothing it takes ten to fifty. A point is near enough to begin from, and not so near the edges
 * that it stays there, where its gap is about what the state moves the limit by (Gondzio 1998). */

#ifndef TP_ASSEMBLAGE_INTERIOR_START_H
#define TP_ASSEMBLAGE_INTERIOR_START_H

#include "assemblage/interior_state.h"

enum { TP_KEPT_POINTS = 5 };

typedef struct tp_kept_point {
  double gap, at; /* over the load; of which state. No gap: there is no point */
  double *x, *z;  /* n + 1; of bounded factors x is the share of their bound */
  double *w, *y;  /* n + 1 where any is bounded, else one; rows */
} tp_kept_point;

/* All zero: nothing is kept. */
typedef struct tp_interior_start {
  long n, rows, bounded;
  tp_kept_point points[TP_KEPT_POINTS];
} tp_interior_start;

void tp_interior_start_clear(tp_interior_start *start);

/* Begin a program of the state `at` from the nearest point that will do; false: there is none. */
bool tp_interior_begin(tp_interior *s, tp_interior_start *start, double at);

/* The point at hand, of that gap; false without memory. */
bool tp_interior_keep(tp_interior_start *start, const tp_interior *s, double gap, double at);

#endif
