/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The margin between the load and the limit falls with x: its zero is searched by Newton's method,
 * and then proven on both sides, at a distance that grows until both proofs are there. */

#include "block_system/threshold.h"

#include "assemblage/limit_change.h"

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
static const double small_step = 1e-6;  /* of x, over which a slope is taken */

static tp_status find_program(tp_force_program *program, const tp_built_system *s,
                              const tp_system_state *state, tp_message *message) {
  return tp_built_system_program(program, s, &state->loads, state->divisor, message);
}

static tp_status find_limit(tp_load_bracket *b, const tp_built_system *s,
                            const tp_system_state *state, const tp_bracket_aim *aim,
                            tp_message *message) {
  tp_force_program program;
  tp_status status = find_program(&program, s, state, message);
  if (status != TP_OK) return status;
  status = tp_load_bracket_find(b, &program, aim, message);
  tp_force_program_clear(&program);
  return status;
}

static const tp_bracket_aim limit_itself = {limit_share, false, INFINITY};

tp_status tp_state_limit_find(tp_load_bracket *limit, const tp_built_system *s,
                              const tp_system_state *state, tp_message *message) {
  return find_limit(limit, s, state, &limit_itself, message);
}

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

/* How far the limit is above the load, as angles, by what that changes with x, and to what it is
 * known. A search that came to no end is one for what nothing holds. */
typedef struct margin {
  double value, slope, within;
} margin;

static margin margin_of(const tp_load_bracket *b, double change, double load, double share) {
  if (!b->is_settled) return (margin){-INFINITY, NAN, 0};
  if (!b->is_bounded) return (margin){b->is_held ? atan(b->held) - atan(load) : -INFINITY, NAN, 0};
  const double size = 1 + b->bound * b->bound;
  return (margin){atan(b->bound) - atan(load), change / size, tp_load_width(b, share) / size};
}

/* The limit and its slope, from the program a little farther. */
static tp_status find_slope(tp_load_bracket *b, double *slope, const searching *x, double share,
                            const tp_system_state *state, const tp_system_state *farther) {
  const tp_bracket_aim bound = {share, true, INFINITY};
  tp_force_program own, to;
  tp_status status = find_program(&own, x->of->system, state, x->message);
  if (status != TP_OK) return status;
  status = tp_load_bracket_find(b, &own, &bound, x->message);
  if (status == TP_OK && b->is_bounded) {
    status = find_program(&to, x->of->system, farther, x->message);
    if (status == TP_OK) {
      *slope = tp_limit_change(b, &own, &to) / small_step;
      tp_force_program_clear(&to);
    } else {
      tp_load_bracket_clear(b);
    }
  }
  tp_force_program_clear(&own);
  return status;
}

static bool add_margin(margin *least, searching *x, double at, double share, bool to_side) {
  tp_system_state state = x->of->state(x->of->context, at);
  tp_system_state farther = x->of->state(x->of->context, at + small_step);
  if (!to_side) {
    state = reversed(&state);
    farther = reversed(&farther);
  }
  tp_load_bracket b;
  double slope = NAN;
  x->status = find_slope(&b, &slope, x, share, &state, &farther);
  if (x->status != TP_OK) return false;
  const margin own =
      margin_of(&b, slope, to_side ? x->of->target.value : -x->of->target.value, share);
  if (own.value < least->value) *least = own;
  tp_load_bracket_clear(&b);
  return true;
}

static bool find_margin(margin *own, searching *x, double at, double share) {
  *own = (margin){INFINITY, NAN, 0};
  return add_margin(own, x, at, share, true) &&
         (!x->sees_other || add_margin(own, x, at, share, false));
}

/* Where margins of either sign were found. */
typedef struct stretch {
  double held, fails;
} stretch;

/* Away from where it was by a step at most, and within what is looked at. */
static double onwards(const tp_threshold_search *of, double at, double move) {
  const double next = at + fmax(-of->step, fmin(of->step, move));
  return fmin(of->from + of->most, fmax(of->from - of->most, next));
}

/* By Newton's method; where that leads out of the stretch, halving it or a step onwards. Where
 * nothing tells how far away forces are, it looks first whether there are any at all. */
static double next_of(const tp_threshold_search *of, const stretch *s, double at, const margin *m,
                      bool halves) {
  const bool is_within = isfinite(s->held) && isfinite(s->fails);
  if (m->value == -INFINITY && !isfinite(s->held)) return of->from - of->most;
  const double move = m->slope < 0 ? -m->value / m->slope : m->value >= 0 ? INFINITY : -INFINITY;
  const double newton = is_within ? at + move : onwards(of, at, move);
  if (newton > s->held && newton < s->fails && !(halves && is_within)) return newton;
  return is_within ? s->held + (s->fails - s->held) / 2 : newton;
}

typedef enum search_end {
  SEARCH_FOUND,
  SEARCH_HELD, /* up to the most */
  SEARCH_ENDED
} search_end;

/* Far from the zero limits are found to less; and where roundings keep a search from its end. */
static search_end find_zero(double *zero, searching *x) {
  enum { MOST = 60, NEWTON = 12 };
  static const double width = 2e-7, near = 1e-3; /* the first: a fifth of what is proven */
  static const double coarser = 32;
  const tp_threshold_search *of = x->of;
  stretch s = {-INFINITY, INFINITY};
  double at = of->from, share = near, finest = limit_share;
  for (int k = 0; k < MOST; k++) {
    margin m;
    if (!find_margin(&m, x, at, share)) return SEARCH_ENDED;
    if (share > finest && m.value >= 0 && m.value <= m.within) { /* too near to tell */
      share = finest;
      continue;
    }
    if (m.value == -INFINITY && share < near) { /* too close to come to an end */
      share = finest = fmin(near, coarser * share);
      continue;
    }
    if (m.value >= 0) s.held = fmax(s.held, at);
    if (m.value < 0) s.fails = fmin(s.fails, at); /* as a bound is proven however far it is */
    if (m.value >= 0 && at >= of->from + of->most) return SEARCH_HELD;
    if (m.value < 0 && at <= of->from - of->most) return SEARCH_ENDED;
    *zero = next_of(of, &s, at, &m, k >= NEWTON);
    const double move = fabs(*zero - at);
    if ((move < width && share < near) || s.fails - s.held < width) return SEARCH_FOUND;
    share = move < near || k >= NEWTON ? finest : near;
    at = *zero;
  }
  return SEARCH_ENDED;
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
  double zero = x->of->from;
  const search_end end = find_zero(&zero, x);
  if (end == SEARCH_FOUND) return prove(own, x, zero);
  if (end == SEARCH_HELD) (void)prove_held(own, x, zero);
  return x->status;
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
