/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The margin between the load and the limit falls with x: its zero is searched by Brent's method,
 * and then proven on both sides, at a distance that grows until both proofs are there. */

#include "block_system/threshold.h"

#include "number/root.h"

#include <math.h>
#include <string.h>

/* ---- limits ------------------------------------------------------------------------------------
 */

void tp_limits_clear(tp_limits *l) {
  tp_load_bracket_clear(&l->side);
  tp_load_bracket_clear(&l->other);
}

static tp_system_state reversed(const tp_system_state *state) {
  tp_system_state own = *state;
  for (int axis = 0; axis < 2; axis++) own.loads.live[axis] = tp_near_neg(own.loads.live[axis]);
  return own;
}

static const double limit_share = 1e-6; /* of itself, to which a limit is proven */

static tp_status find_limit(tp_load_bracket *b, const tp_built_system *s,
                            const tp_system_state *state, const tp_bracket_aim *aim,
                            tp_message *message) {
  tp_force_program program;
  tp_status status = tp_built_system_program(&program, s, &state->loads, state->divisor, message);
  if (status != TP_OK) return status;
  status = tp_load_bracket_find(b, &program, aim, message);
  tp_force_program_clear(&program);
  return status;
}

static const tp_bracket_aim limit_itself = {limit_share, false, INFINITY};

/* Is a load held; is one the other way? */
static tp_bracket_aim held_to_side(tp_near load) {
  return (tp_bracket_aim){limit_share, false, load.value + load.error};
}

static tp_bracket_aim held_to_other(tp_near load) {
  return held_to_side(tp_near_neg(load));
}

static tp_status find_limits(tp_limits *l, const tp_built_system *s, const tp_system_state *state,
                             const tp_bracket_aim *aim, tp_near load, tp_message *message) {
  const tp_system_state other = reversed(state);
  const tp_bracket_aim aim_of_other = held_to_other(load);
  memset(l, 0, sizeof *l);
  tp_status status = find_limit(&l->side, s, state, aim, message);
  if (status == TP_OK) status = find_limit(&l->other, s, &other, &aim_of_other, message);
  if (status != TP_OK) tp_limits_clear(l);
  return status;
}

tp_status tp_limits_find(tp_limits *l, const tp_built_system *s, const tp_system_state *state,
                         tp_near load, tp_message *message) {
  return find_limits(l, s, state, &limit_itself, load, message);
}

/* Forces that hold one load and forces that hold one the other way hold, mixed, all between. */
bool tp_limits_hold(const tp_limits *l, tp_near load) {
  return l->side.is_held && l->other.is_held && l->side.held >= load.value + load.error &&
         l->other.held >= -(load.value - load.error);
}

static bool exceeds(const tp_load_bracket *b, tp_near load) {
  return b->is_bounded && b->bound < load.value - load.error;
}

bool tp_limits_fail(const tp_limits *l, tp_near load) {
  return exceeds(&l->side, load) || exceeds(&l->other, tp_near_neg(load));
}

/* ---- search ------------------------------------------------------------------------------------
 */

typedef struct searching {
  const tp_threshold_search *of;
  bool sees_other; /* the limit to the other side takes part */
  tp_status status;
  tp_message *message;
} searching;

/* An angle near the limit. */
static double angle_of(const tp_load_bracket *b) {
  return atan(b->is_bounded ? b->bound : b->is_held ? b->held : -INFINITY);
}

static bool add_margin(double *value, searching *x, const tp_system_state *state, double load) {
  static const tp_bracket_aim bound = {limit_share, true, INFINITY};
  tp_load_bracket bracket;
  x->status = find_limit(&bracket, x->of->system, state, &bound, x->message);
  if (x->status != TP_OK) return false;
  *value = fmin(*value, angle_of(&bracket) - atan(load));
  tp_load_bracket_clear(&bracket);
  return true;
}

static bool margin(double *value, void *context, double at) {
  searching *x = context;
  const double load = x->of->target.value;
  const tp_system_state state = x->of->state(x->of->context, at), other = reversed(&state);
  *value = INFINITY;
  return add_margin(value, x, &state, load) &&
         (!x->sees_other || add_margin(value, x, &other, -load));
}

/* By steps to where the margin has the other sign; false: not within reach. */
static bool bracket_zero(tp_root_end *low, tp_root_end *high, searching *x) {
  const tp_threshold_search *of = x->of;
  tp_root_end end = {of->from, 0};
  if (!margin(&end.value, x, end.x)) return false;
  *low = *high = end;
  const bool rises = end.value >= 0;
  const double last = of->from + (rises ? of->most : -of->most);
  while (end.x != last) {
    end.x = rises ? fmin(last, end.x + of->step) : fmax(last, end.x - of->step);
    if (!margin(&end.value, x, end.x)) return false;
    *(rises ? high : low) = end;
    if ((end.value >= 0) != rises) return true;
    *(rises ? low : high) = end;
  }
  return false;
}

/* ---- proofs ------------------------------------------------------------------------------------
 */

static bool prove_held(tp_threshold *own, searching *x, double at) {
  const tp_system_state state = x->of->state(x->of->context, at);
  const tp_bracket_aim aim = held_to_side(x->of->target);
  tp_limits l;
  x->status = find_limits(&l, x->of->system, &state, &aim, x->of->target, x->message);
  if (x->status != TP_OK) return false;
  own->is_held = tp_limits_hold(&l, x->of->target);
  own->held = at;
  tp_limits_clear(&l);
  return true;
}

/* Is the limit exceeded? Then the collapse is the one to that side. */
static bool take_bound(tp_threshold *own, searching *x, const tp_system_state *state,
                       tp_near load) {
  x->status = find_limit(&own->collapse, x->of->system, state, &limit_itself, x->message);
  if (x->status != TP_OK) return false;
  own->is_bounded = exceeds(&own->collapse, load);
  if (!own->is_bounded) tp_load_bracket_clear(&own->collapse);
  return true;
}

static bool prove_bound(tp_threshold *own, searching *x, double at) {
  const tp_system_state state = x->of->state(x->of->context, at), other = reversed(&state);
  own->bound = at;
  if (!take_bound(own, x, &state, x->of->target)) return false;
  return own->is_bounded || take_bound(own, x, &other, tp_near_neg(x->of->target));
}

static tp_status prove(tp_threshold *own, searching *x, double zero) {
  static const double first = 1e-6, last = 1e-2, growth = 4;
  for (double away = first; away < last; away *= growth) {
    if (!own->is_held && !prove_held(own, x, zero - away)) break;
    if (!own->is_bounded && !prove_bound(own, x, zero + away)) break;
    if (own->is_held && own->is_bounded) break;
  }
  return x->status;
}

static tp_status search(tp_threshold *own, searching *x) {
  enum { MOST = 60 };
  static const double width = 2e-7, flat = 1e-7; /* a tenth of what is proven */
  const tp_root_search of = {margin, x, flat, width, MOST};
  tp_root_end low, high;
  tp_root root;
  if (!bracket_zero(&low, &high, x)) {
    if (x->status == TP_OK && low.value >= 0) (void)prove_held(own, x, low.x);
    return x->status;
  }
  if (!tp_root_find(&root, &of, low, high)) return x->status;
  return prove(own, x, root.low + (root.high - root.low) / 2);
}

tp_status tp_threshold_find(tp_threshold *own, const tp_threshold_search *of, tp_message *message) {
  memset(own, 0, sizeof *own);
  searching x = {.of = of, .status = TP_OK, .message = message};
  tp_status status = search(own, &x);
  if (status == TP_OK && !own->is_held) {
    tp_threshold_clear(own);
    x.sees_other = true;
    status = search(own, &x);
  }
  if (status != TP_OK) tp_threshold_clear(own);
  return status;
}

void tp_threshold_clear(tp_threshold *own) {
  tp_load_bracket_clear(&own->collapse);
  memset(own, 0, sizeof *own);
}
