/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Vertices of one body and edges of the other that may be the next to touch: all of which doubles,
 * with their bounds, do not show that another pair touches sooner. The exact stage looks at these
 * alone, so that its cost does not grow with the bodies. */

#ifndef TP_REST_CANDIDATES_H
#define TP_REST_CANDIDATES_H

#include "rest/bodies.h"

/* An exact look at a pair is as dear as some of them in doubles. */
enum { TP_REST_EXACT_LOOKS = 20 };

typedef struct tp_candidate {
  bool of_base; /* a vertex of the base and an edge of the block; else the other way round */
  long vertex, edge;
  double low;   /* it does not touch before this: a height to fall, or a tangent of half an angle */
  double high;  /* if it touches it does so by this */
  bool certain; /* that it touches */
} tp_candidate;

typedef struct tp_candidates {
  long count, capacity;
  tp_candidate *items;
  double best;      /* some pair touches by then for certain */
  double looked_at; /* pairs, and boxes of edges, so far */
  long blind;       /* of which doubles tell no end: `high` is infinite */
  bool too_many;    /* more were to be noted than are kept (budget.h), */
  bool too_blind;   /* or are looked at in exact numbers alone */
} tp_candidates;

void tp_candidates_clear(tp_candidates *candidates);

/* False when memory is exhausted, or they are too many. */
TP_MUST_USE bool tp_candidates_note(tp_candidates *candidates, tp_candidate candidate);

/* Drop those that touch later than the best for certain. */
void tp_candidates_settle(tp_candidates *candidates);

/* Vertices of the base from which edges begin that come within [low, high] of u, and the one after
 * the last: those of the profile by their order, the far corners always. */
void tp_candidates_reach(long *first, long *last, const tp_bodies *bodies, double low, double high);

#endif
