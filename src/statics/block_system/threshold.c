/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The margin between the load and the limit falls with x: its zero is searched by Newton's method,
 * and then proven on both sides, at a distance that grows until both proofs are there. */

#include "block_system/threshold.h"

#include "assemblage/exact_bracket.h"
#include "assemblage/falling_group.h"
#include "assemblage/limit_change.h"

#include <math.h>
#include <string.h>

/* ---- search ------------------------------------------------------------------------------------
 */

static const double small_step = 1e-6; /* of x, over which a slope is taken */

typedef struct searching {
  const tp_threshold_search *of;
  bool sees_other; /* the limit to the other side takes part */
  bool fails;      /* where it was last asked whether it is held it certainly is not */
  bool is_rough;   /* far away: it is enough to know roughly how far */
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

/* Of a limit, from the program a little farther. */
static tp_status find_slope(double *slope, const tp_load_bracket *b, const tp_force_program *own,
                            const searching *x, const tp_system_state *farther) {
  tp_force_program to;
  const tp_status status = tp_state_program(&to, x->of->system, farther, x->message);
  if (status != TP_OK) return status;
  *slope = tp_limit_change(b, own, &to) / small_step;
  tp_force_program_clear(&to);
  return TP_OK;
}

/* The limit is searched for, but where it is known. */
static tp_status find_change(margin *own, const searching *x, double at, double share,
                             bool to_side) {
  const double load = to_side ? x->of->target.value : -x->of->target.value;
  const tp_bracket_aim bound = {.share = share,
                                .bound_alone = true,
                                .enough = INFINITY,
                                .asks = x->is_rough,
                                .asked = load,
                                .from = {to_side ? x->of->start : NULL, at}};
  tp_system_state state = x->of->state(x->of->context, at);
  tp_system_state farther = x->of->state(x->of->context, at + small_step);
  if (!to_side) {
    state = tp_state_reversed(&state);
    farther = tp_state_reversed(&farther);
  }
  tp_force_program program;
  tp_load_bracket found = {.forces = NULL};
  const bool is_known = x->of->limit != NULL && at == x->of->from && to_side;
  const tp_load_bracket *b = is_known ? x->of->limit : &found;
  double slope = NAN;
  tp_status status = tp_state_program(&program, x->of->system, &state, x->message);
  if (status != TP_OK) return status;
  if (!is_known) status = tp_load_bracket_find(&found, &program, &bound, x->message);
  if (status == TP_OK && b->is_bounded) status = find_slope(&slope, b, &program, x, &farther);
  *own = margin_of(b, slope, load, is_known ? TP_LIMIT_SHARE : share);
  tp_load_bracket_clear(&found);
  tp_force_program_clear(&program);
  return status;
}

static bool add_margin(margin *least, searching *x, double at, double share, bool to_side) {
  margin own;
  x->status = find_change(&own, x, at, share, to_side);
  if (x->status != TP_OK) return false;
  if (own.value < least->value) *least = own;
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

/* Of a divisor by its inverse, as sliding resists in proportion to that: no more than all of it. */
static double newton_move(const tp_threshold_search *of, const margin *m) {
  const double change = -m->value / m->slope;
  if (!of->divides) return change;
  return change < 1 ? -log1p(-change) : INFINITY;
}

/* By Newton's method; where that leads out of the stretch, halving it or a step onwards. Where
 * nothing tells how far away forces are, it looks first whether there are any at all. */
static double next_of(const tp_threshold_search *of, const stretch *s, double at, const margin *m,
                      bool halves) {
  const bool is_within = isfinite(s->held) && isfinite(s->fails);
  if (m->value == -INFINITY && !isfinite(s->held)) return of->from - of->most;
  const double move = m->slope < 0 ? newton_move(of, m) : m->value >= 0 ? INFINITY : -INFINITY;
  const double newton = is_within ? at + move : onwards(of, at, move);
  if (newton > s->held && newton < s->fails && !(halves && is_within)) return newton;
  return is_within ? s->held + (s->fails - s->held) / 2 : newton;
}

typedef enum search_end {
  SEARCH_FOUND,
  SEARCH_HELD,  /* up to the most */
  SEARCH_NEVER, /* down to the least */
  SEARCH_ENDED
} search_end;

/* From `zero` on. Far from it limits are found to less; and where roundings keep a search from its
 * end. In haste the last step is not looked at: it misses by its square. */
static search_end find_zero(double *zero, searching *x, bool in_haste) {
  enum { MOST = 60, NEWTON = 12, ROUGH = 4 };
  static const double width = 2e-7, near = 1e-3; /* the first: a fifth of what is proven */
  static const double coarser = 32;
  const tp_threshold_search *of = x->of;
  stretch s = {-INFINITY, INFINITY};
  double at = *zero, share = in_haste ? near : TP_LIMIT_SHARE, finest = TP_LIMIT_SHARE;
  for (int k = 0; k < MOST; k++) {
    margin m;
    x->is_rough = share > finest && k < ROUGH;
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
    if (m.value < 0 && at <= of->from - of->most) return SEARCH_NEVER;
    *zero = next_of(of, &s, at, &m, k >= NEWTON);
    const double move = fabs(*zero - at), missed = in_haste ? move * move / 2 : move;
    if ((missed < width && share < near) || s.fails - s.held < width) return SEARCH_FOUND;
    share = move < near || k >= NEWTON ? finest : near;
    at = *zero;
  }
  return SEARCH_ENDED;
}

/* ---- proofs ------------------------------------------------------------------------------------
 */

#define NEAREST 1e-6 /* to the zero, of proofs */

static bool prove_held(tp_threshold *own, searching *x, double at) {
  const tp_system_state state = x->of->state(x->of->context, at);
  const tp_interior_from from = {x->of->start, at};
  tp_limits l;
  x->status = tp_limits_try(&l, x->of->system, &state, x->of->target, &from, x->message);
  if (x->status != TP_OK) return false;
  own->is_held = tp_limits_hold(&l, x->of->target);
  own->held = at;
  x->fails = tp_limits_fail(&l, x->of->target);
  tp_limits_clear(&l);
  return true;
}

/* Is the limit exceeded? Then the collapse is the one to that side. */
static bool take_bound(tp_threshold *own, searching *x, const tp_system_state *state, tp_near load,
                       const tp_interior_from *from) {
  x->status = tp_state_limit_find(&own->collapse, x->of->system, state, from, x->message);
  if (x->status == TP_OK) {
    x->status = tp_state_limit_decide(&own->collapse, x->of->system, state, load, x->message);
  }
  if (x->status != TP_OK) return false;
  own->is_bounded = tp_load_exceeds(&own->collapse, load);
  if (!own->is_bounded) tp_load_bracket_clear(&own->collapse);
  return true;
}

static bool prove_bound(tp_threshold *own, searching *x, double at) {
  const tp_system_state state = x->of->state(x->of->context, at), other = tp_state_reversed(&state);
  const tp_interior_from from = {x->of->start, at};
  own->bound = at;
  if (!take_bound(own, x, &state, x->of->target, &from)) return false;
  return own->is_bounded || take_bound(own, x, &other, tp_near_neg(x->of->target), NULL);
}

static bool is_proven(const tp_threshold *own) {
  return own->is_held && own->is_bounded;
}

/* Both proofs, no farther away than that from the zero. */
static void prove(tp_threshold *own, searching *x, double zero, double farthest) {
  static const double growth = 4;
  for (double away = NEAREST; away <= farthest && !is_proven(own); away *= growth) {
    if (!own->is_held && !prove_held(own, x, zero - away)) break;
    if (!own->is_bounded && !prove_bound(own, x, zero + away)) break;
  }
}

/* Between proofs that are far apart, as where little strength more changes the limit by much, as
 * long as one of them is had in the middle. */
static void bring_nearer(tp_threshold *own, searching *x) {
  static const double near_enough = 4 * NEAREST;
  while (is_proven(own) && own->bound - own->held > near_enough) {
    const double middle = own->held + (own->bound - own->held) / 2;
    tp_threshold there = {.is_held = false};
    if (!prove_held(&there, x, middle)) return;
    if (there.is_held) {
      own->held = middle;
      continue;
    }
    if (!prove_bound(&there, x, middle) || !there.is_bounded) return;
    tp_load_bracket_clear(&own->collapse);
    own->collapse = there.collapse;
    own->bound = middle;
  }
}

static tp_status prove_never(tp_threshold *own, searching *x) {
  tp_load_bracket_clear(&own->collapse);
  own->is_never = prove_bound(own, x, x->of->from - x->of->most) && own->is_bounded;
  return x->status;
}

/* Of blocks that hang it is quickly told that they fall however strong joints are; a search among
 * thousands of blocks for what nothing holds takes minutes. */
static bool fall_however_strong(searching *x) {
  const tp_threshold_search *of = x->of;
  bool falls = false;
  if (!of->divides || of->limit == NULL || !tp_load_exceeds(of->limit, of->target)) return false;
  const tp_system_state state = of->state(of->context, of->from - of->most);
  tp_force_program program;
  x->status = tp_state_program(&program, of->system, &state, x->message);
  if (x->status != TP_OK) return false;
  x->status = tp_falling_group_find(&falls, &program, of->target, x->message);
  tp_force_program_clear(&program);
  return falls;
}

/* Where the zero that was found in haste does not do, with care. */
static tp_status search(tp_threshold *own, searching *x) {
  static const double farthest = 0.5;
  own->is_never = own->is_bounded = fall_however_strong(x);
  if (own->is_never) own->bound = x->of->from - x->of->most;
  if (x->status != TP_OK || own->is_never) return x->status;
  double zero = x->of->from;
  search_end end = find_zero(&zero, x, true);
  if (end == SEARCH_NEVER) return prove_never(own, x);
  if (end == SEARCH_FOUND) {
    prove(own, x, zero, NEAREST);
    if (x->status != TP_OK || is_proven(own)) return x->status;
    if (x->fails && tp_exact_bracket_is_quick(&x->of->system->assemblage)) {
      /* by less than is searched for, perhaps however strong joints are */
      if (prove_never(own, x) != TP_OK || own->is_never) return x->status;
    }
    end = find_zero(&zero, x, false);
  }
  if (end == SEARCH_FOUND) {
    prove(own, x, zero, farthest);
    bring_nearer(own, x);
  }
  if (end == SEARCH_HELD && prove_held(own, x, zero) && !own->is_held) return prove_never(own, x);
  return x->status;
}

tp_status tp_threshold_find(tp_threshold *own, const tp_threshold_search *of, tp_message *message) {
  memset(own, 0, sizeof *own);
  searching x = {.of = of, .status = TP_OK, .message = message};
  tp_status status = search(own, &x);
  if (status == TP_OK && !own->is_held && !own->is_never) {
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
