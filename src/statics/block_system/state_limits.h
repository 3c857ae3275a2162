/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which loads forces can hold at one state of many blocks. */

#ifndef TP_BLOCK_SYSTEM_STATE_LIMITS_H
#define TP_BLOCK_SYSTEM_STATE_LIMITS_H

#include "block_system/built_system.h"

#define TP_LIMIT_SHARE 1e-6   /* of itself, to which a limit is proven */
#define TP_MOST_FACTOR 1000.0 /* no greater factor of safety is looked for */
/* Where searches for it end, so that TP_MOST_FACTOR is proven after what is taken off for rounding.
 */
#define TP_MOST_SEARCHED (TP_MOST_FACTOR * (1 + 0x1p-40))

/* What acts on the blocks, and what their strength is divided by, at x. */
typedef struct tp_system_state {
  tp_weight_loads loads;
  double divisor;
} tp_system_state;

/* With the live load the other way. */
tp_system_state tp_state_reversed(const tp_system_state *state);

TP_MUST_USE tp_status tp_state_program(tp_force_program *program, const tp_built_system *system,
                                       const tp_system_state *state, tp_message *message);

/* `from` is where a search to the side of the live load begins; NULL: from nothing. */

/* The greatest live load of a state that is held, to TP_LIMIT_SHARE of itself. */
TP_MUST_USE tp_status tp_state_limit_find(tp_load_bracket *limit, const tp_built_system *system,
                                          const tp_system_state *state,
                                          const tp_interior_from *from, tp_message *message);

/* Where a bracket does not tell whether a load is held it is narrowed in rationals, if that is
 * quick. */
TP_MUST_USE tp_status tp_state_limit_decide(tp_load_bracket *limit, const tp_built_system *system,
                                            const tp_system_state *state, tp_near load,
                                            tp_message *message);

/* Limits to the side of the live load and to the other one, there as far as a load asks for. */
typedef struct tp_limits {
  tp_load_bracket side, other;
} tp_limits;

/* On failure cleared. */
TP_MUST_USE tp_status tp_limits_find(tp_limits *limits, const tp_built_system *system,
                                     const tp_system_state *state, tp_near load,
                                     const tp_interior_from *from, tp_message *message);
/* To either side as far as a load asks for. */
TP_MUST_USE tp_status tp_limits_try(tp_limits *limits, const tp_built_system *system,
                                    const tp_system_state *state, tp_near load,
                                    const tp_interior_from *from, tp_message *message);
/* Where they tell neither that a load is held nor that it is not, as below. */
TP_MUST_USE tp_status tp_limits_decide(tp_limits *limits, const tp_built_system *system,
                                       const tp_system_state *state, tp_near load,
                                       tp_message *message);
void tp_limits_clear(tp_limits *limits);

/* Is a load certainly held; certainly not? */
bool tp_limits_hold(const tp_limits *limits, tp_near load);
bool tp_limits_fail(const tp_limits *limits, tp_near load);
bool tp_load_exceeds(const tp_load_bracket *bracket, tp_near load);

#endif
