/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The number x up to which some forces hold many blocks: of the logarithm of what their strength is
 * divided by, or of the tilt of all in radians. Searched in doubles, then proven on both sides. */

#ifndef TP_BLOCK_SYSTEM_THRESHOLD_H
#define TP_BLOCK_SYSTEM_THRESHOLD_H

#include "assemblage/interior_start.h"
#include "block_system/state_limits.h"

typedef tp_system_state tp_system_state_at(const void *context, double x);

typedef struct tp_threshold_search {
  const tp_built_system *system;
  tp_system_state_at *state;
  const void *context;
  tp_near target;               /* the load, as the live one of the state, that is to be held */
  double from, step, most;      /* looked for from there on by steps, away by no more than that */
  bool divides;                 /* x is the logarithm of a divisor */
  const tp_load_bracket *limit; /* borrowed: of the state at `from`, where it is known; or NULL */
  tp_interior_start *start;     /* borrowed: points of near states, by x */
} tp_threshold_search;

typedef struct tp_threshold {
  bool is_held, is_bounded; /* is there a proof below, above? */
  bool is_never;            /* the latter is there as far below as is looked: none hold them */
  double held, bound;       /* at that x forces hold the blocks, and at that none do */
  tp_load_bracket collapse; /* at `bound`; empty where there is none */
} tp_threshold;

/* TP_OK without proofs where none were found; without one above where all up to the most is held.
 * On failure cleared. */
TP_MUST_USE tp_status tp_threshold_find(tp_threshold *threshold, const tp_threshold_search *search,
                                        tp_message *message);
void tp_threshold_clear(tp_threshold *threshold);

#endif
