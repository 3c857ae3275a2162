/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The limit to the other side is that of the program with the live load turned round. */

#include "block_system/state_limits.h"

#include "assemblage/exact_bracket.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void tp_limits_clear(tp_limits *l) {
  tp_load_bracket_clear(&l->side);
  tp_load_bracket_clear(&l->other);
}

tp_system_state tp_state_reversed(const tp_system_state *state) {
  tp_system_state own = *state;
  for (int axis = 0; axis < 2; axis++) own.loads.live[axis] = tp_near_neg(own.loads.live[axis]);
  return own;
}

tp_status tp_state_program(tp_force_program *program, const tp_built_system *s,
                           const tp_system_state *state, tp_message *message) {
  return tp_built_system_program(program, s, &state->loads, state->divisor, message);
}

static tp_status find_limit(tp_load_bracket *b, const tp_built_system *s,
                            const tp_system_state *state, const tp_bracket_aim *aim,
                            tp_message *message) {
  tp_force_program program;
  tp_status status = tp_state_program(&program, s, state, message);
  if (status != TP_OK) return status;
  status = tp_load_bracket_find(b, &program, aim, message);
  tp_force_program_clear(&program);
  return status;
}

static tp_bracket_aim limit_itself(const tp_interior_from *from) {
  tp_bracket_aim aim = {.share = TP_LIMIT_SHARE, .enough = INFINITY};
  if (from != NULL) aim.from = *from;
  return aim;
}

tp_status tp_state_limit_find(tp_load_bracket *limit, const tp_built_system *s,
                              const tp_system_state *state, const tp_interior_from *from,
                              tp_message *message) {
  const tp_bracket_aim aim = limit_itself(from);
  return find_limit(limit, s, state, &aim, message);
}

/* Is a load held; is one the other way? */
static tp_bracket_aim held_to_side(tp_near load, const tp_interior_from *from) {
  tp_bracket_aim aim = limit_itself(from);
  aim.enough = load.value + load.error;
  return aim;
}

static tp_bracket_aim held_to_other(tp_near load) {
  return held_to_side(tp_near_neg(load), NULL);
}

static tp_status find_limits(tp_limits *l, const tp_built_system *s, const tp_system_state *state,
                             const tp_bracket_aim *aim, tp_near load, tp_message *message) {
  const tp_system_state other = tp_state_reversed(state);
  const tp_bracket_aim aim_of_other = held_to_other(load);
  memset(l, 0, sizeof *l);
  tp_status status = find_limit(&l->side, s, state, aim, message);
  if (status == TP_OK) status = find_limit(&l->other, s, &other, &aim_of_other, message);
  if (status != TP_OK) tp_limits_clear(l);
  return status;
}

tp_status tp_state_limit_decide(tp_load_bracket *limit, const tp_built_system *s,
                                const tp_system_state *state, tp_near load, tp_message *message) {
  const bool is_held = limit->is_held && limit->held >= load.value + load.error;
  if (is_held || tp_load_exceeds(limit, load) || !tp_exact_bracket_is_quick(&s->assemblage)) {
    return TP_OK;
  }
  tp_force_program program;
  tp_status status = tp_state_program(&program, s, state, message);
  if (status != TP_OK) return status;
  tp_contact_strength *strengths = tp_built_system_strengths(s, state->divisor);
  status = strengths == NULL
               ? tp_fail_memory(message, "the joints")
               : tp_exact_bracket_narrow(limit, &program, strengths, &state->loads, message);
  free(strengths);
  tp_force_program_clear(&program);
  return status;
}

tp_status tp_limits_decide(tp_limits *l, const tp_built_system *s, const tp_system_state *state,
                           tp_near load, tp_message *message) {
  if (tp_limits_fail(l, load)) return TP_OK;
  const tp_system_state other = tp_state_reversed(state);
  const tp_status status = tp_state_limit_decide(&l->side, s, state, load, message);
  if (status != TP_OK || tp_limits_fail(l, load)) return status;
  return tp_state_limit_decide(&l->other, s, &other, tp_near_neg(load), message);
}

tp_status tp_limits_find(tp_limits *l, const tp_built_system *s, const tp_system_state *state,
                         tp_near load, const tp_interior_from *from, tp_message *message) {
  const tp_bracket_aim aim = limit_itself(from);
  return find_limits(l, s, state, &aim, load, message);
}

tp_status tp_limits_try(tp_limits *l, const tp_built_system *s, const tp_system_state *state,
                        tp_near load, const tp_interior_from *from, tp_message *message) {
  const tp_bracket_aim aim = held_to_side(load, from);
  tp_status status = find_limits(l, s, state, &aim, load, message);
  if (status != TP_OK) return status;
  status = tp_limits_decide(l, s, state, load, message);
  if (status != TP_OK) tp_limits_clear(l);
  return status;
}

/* Forces that hold one load and forces that hold one the other way hold, mixed, all between. */
bool tp_limits_hold(const tp_limits *l, tp_near load) {
  return l->side.is_held && l->other.is_held && l->side.held >= load.value + load.error &&
         l->other.held >= -(load.value - load.error);
}

bool tp_load_exceeds(const tp_load_bracket *b, tp_near load) {
  return b->is_bounded && b->bound < load.value - load.error;
}

bool tp_limits_fail(const tp_limits *l, tp_near load) {
  return tp_load_exceeds(&l->side, load) || tp_load_exceeds(&l->other, tp_near_neg(load));
}
