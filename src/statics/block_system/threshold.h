/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The number x up to which some forces hold many blocks: of the logarithm of what their strength is
 * divided by, or of the tilt of all in radians. Searched in doubles, then proven on both sides. */

#ifndef TP_BLOCK_SYSTEM_THRESHOLD_H
#define TP_BLOCK_SYSTEM_THRESHOLD_H

#include "block_system/built_system.h"

/* What acts on the blocks, and what their strength is divided by, at x. */
typedef struct tp_system_state {
  tp_weight_loads loads;
  double divisor;
} tp_system_state;

typedef tp_system_state tp_system_state_at(const void *context, double x);

typedef struct tp_threshold_search {
  const tp_built_system *system;
  tp_system_state_at *state;
  const void *context;
  tp_near target;          /* the load, as the live one of the state, that is to be held */
  double from, step, most; /* looked for from there on by steps, away by no more than that */
} tp_threshold_search;

typedef struct tp_threshold {
  bool is_held, is_bounded; /* is there a proof below, above? */
  double held, bound;       /* at that x forces hold the blocks, and at that none do */
  tp_load_bracket collapse; /* at `bound`; empty where there is none */
} tp_threshold;

/* TP_OK without proofs where none were found; without one above where all up to the most is held.
 * On failure cleared. */
TP_MUST_USE tp_status tp_threshold_find(tp_threshold *threshold, const tp_threshold_search *search,
                                        tp_message *message);
void tp_threshold_clear(tp_threshold *threshold);

/* The greatest live load of a state that is held, to 1e-6 of itself. */
TP_MUST_USE tp_status tp_state_limit_find(tp_load_bracket *limit, const tp_built_system *system,
                                          const tp_system_state *state, tp_message *message);

/* Limits to the side of the live load and to the other one, there as far as a load asks for. */
typedef struct tp_limits {
  tp_load_bracket side, other;
} tp_limits;

/* On failure cleared. */
TP_MUST_USE tp_status tp_limits_find(tp_limits *limits, const tp_built_system *system,
                                     const tp_system_state *state, tp_near load,
                                     tp_message *message);
void tp_limits_clear(tp_limits *limits);

/* Is a load certainly held; certainly not? */
bool tp_limits_hold(const tp_limits *limits, tp_near load);
bool tp_limits_fail(const tp_limits *limits, tp_near load);

#endif
