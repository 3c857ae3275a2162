/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* At an event more than one mode can fit within rounding: the one that ended, and that which takes
 * over. Each is followed for a moment so short that it goes nowhere, and so long that what it
 * violates shows; the one that violates least is taken. */

#include "rigid_contact/dynamics.h"
#include "rigid_contact/impact.h"
#include "rigid_contact/rest.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_FOLLOWED = 32, MOST_IMPACTS = 50 };

/* For how long a mode is followed; and what it may violate meanwhile, per time. */
static const double followed_time = 1e-5, followed_slack = 1e-7;

/* Below this no number of the speed says that the block moves. */
static const double at_rest = 4 * TP_NO_SPEED;

typedef struct candidates {
  int count;
  tp_law_solution items[MOST_FOLLOWED];
} candidates;

static bool keep(void *context, const tp_law_solution *solution) {
  candidates *own = context;
  own->items[own->count++] = *solution;
  return own->count < MOST_FOLLOWED;
}

/* ---- which mode takes over ---- */

/* The worst of what a mode violates after being followed: forces that pull, slips that turn,
 * contacts that close; 0 where nothing is. */
static double violation_of(const tp_dynamics *d, tp_smooth *smooth, const tp_law *law,
                           const tp_touching *t) {
  double from[TP_MOTION_NUMBERS], numbers[TP_MOTION_NUMBERS];
  tp_smooth_moment moment;
  tp_smooth_numbers(from, &d->state, 0);
  if (!tp_extrapolate(numbers, tp_smooth_rates, smooth, d->time, from, followed_time, 1e-13)
           .reached) {
    return -INFINITY;
  }
  const tp_motion_state state = tp_smooth_state(numbers);
  if (!tp_smooth_at(&moment, smooth, d->time + followed_time, &state)) return -INFINITY;
  double worst = 0;
  for (int k = 0; k < moment.solution.count; k++) {
    worst = fmin(worst, moment.solution.factors[k] / followed_time);
    const tp_pressing *own = smooth->pressing + moment.solution.edges[k].contact;
    if (own->sticks || own->pinned) continue;
    const long of = moment.solution.edges[k].contact;
    const double slip = tp_gap_speed(moment.gaps[of].along, state.speed);
    worst = fmin(worst, -own->side * slip / followed_time);
  }
  for (long k = 0; k < law->count; k++) {
    const tp_gap gap = tp_gap_at(&d->system.shapes, &t->items[t->of_law[k]].pair, &state);
    worst = fmin(worst, tp_gap_speed(gap.across, state.speed) / followed_time);
  }
  return worst;
}

static void set_mode(tp_dynamics *d, const tp_law *law, const tp_law_solution *mode) {
  d->law = *law;
  d->solution = *mode;
  d->account.paradox = d->account.paradox || mode->paradox;
  tp_touching_set_smooth(&d->smooth, &d->touching, law, mode);
}

/* The one that violates least when it is followed, and by how much. */
static const tp_law_solution *choose(double *violation, tp_dynamics *d, const candidates *of,
                                     const tp_law *law) {
  const tp_law_solution *best = NULL;
  *violation = -INFINITY;
  for (int k = 0; k < of->count; k++) {
    tp_touching_set_smooth(&d->smooth, &d->touching, law, of->items + k);
    double own = violation_of(d, &d->smooth, law, &d->touching);
    if (own > -followed_slack) own = 0;
    if (best != NULL && own <= *violation) continue;
    best = of->items + k;
    *violation = own;
  }
  return best;
}

/* ---- rest ---- */

static bool is_held(bool *held, const tp_law *law) {
  double *factors = malloc(sizeof *factors * (size_t)(2 * law->count + 1));
  if (factors == NULL) return false;
  *held = tp_rest_forces(factors, law);
  free(factors);
  return true;
}

static double size_of(const tp_dynamics *d, const double x[3]) {
  return tp_motion_energy(&d->system, x);
}

tp_resolved tp_resolve_rest(tp_dynamics *d) {
  const tp_law law = tp_touching_accelerations(&d->touching, &d->system, d->time);
  candidates of = {0};
  bool held = false;
  tp_touching *t = &d->touching;
  if (t->can_stay_count < 0) t->can_stay_count = tp_rest_list(t->can_stay, &law);
  tp_rest_motions(&law, t->can_stay, t->can_stay_count, keep, &of);
  if (of.count == 0) return TP_RESOLVED_RESTS;
  if (!is_held(&held, &law)) return TP_RESOLVED_NO_MEMORY;
  if (held && d->settings->window == TP_WINDOW_STANDS) return TP_RESOLVED_RESTS;
  const tp_law_solution *best = of.items;
  for (int k = 1; k < of.count; k++) {
    if (size_of(d, of.items[k].x) > size_of(d, best->x)) best = of.items + k;
  }
  d->held = held;
  set_mode(d, &law, best);
  return TP_RESOLVED_MOVES;
}

static bool is_slow(const double speed[3]) {
  return fabs(speed[0]) + fabs(speed[1]) + fabs(speed[2]) <= at_rest;
}

/* Brings it to rest, with what is left of its speed. */
static void stop(tp_dynamics *d) {
  d->lost += tp_motion_energy(&d->system, d->state.speed);
  for (int e = 0; e < 3; e++) d->state.speed[e] = 0;
}

/* ---- impacts ---- */

static tp_resolved collect(tp_dynamics *d) {
  return tp_touching_collect(&d->touching, &d->system, &d->state) ? TP_RESOLVED_MOVES
                                                                  : TP_RESOLVED_NO_MEMORY;
}

/* From higher than the least bounce; what is not, is stopped, and not told. */
static bool is_fall(const tp_dynamics *d, double approach) {
  return approach < 0 && approach * approach / 2 > d->settings->least_bounce;
}

static double restitution_of(const tp_dynamics *d) {
  for (long k = 0; k < d->touching.count; k++) {
    if (is_fall(d, d->touching.items[k].approach)) return d->settings->restitution;
  }
  return 0;
}

/* A closing that would bounce no higher than the least bounce ends bounces that accumulate. */
static bool tell_closing(tp_dynamics *d, double restitution) {
  const bool ends = restitution < d->settings->restitution;
  for (long k = 0; k < d->touching.count; k++) {
    const tp_touching_contact *own = d->touching.items + k;
    if (own->approach >= -2 * TP_NO_SPEED) continue;
    if (is_fall(d, own->approach) && !tp_record_event(d, TP_EVENT_CLOSES, own, -own->approach)) {
      return false;
    }
    if (!ends) continue;
    d->account.accumulated++;
    if (!tp_record_event(d, TP_EVENT_ACCUMULATES, own, 0)) return false;
  }
  return true;
}

static tp_resolved no_mode(const tp_dynamics *d, const char *what) {
  (void)tp_fail(d->message, TP_UNDECIDED, (tp_place){0},
                "no %s of rigid contacts with Coulomb friction fits at %.9g s; use the springs "
                "(method: springs)",
                what, d->time * d->system.time_unit_s);
  return TP_RESOLVED_NOT;
}

static tp_resolved take(tp_dynamics *d, const tp_impact *impact) {
  d->account.impacts++;
  d->lost += impact->energy_lost;
  memcpy(d->state.speed, impact->speed, sizeof impact->speed);
  return collect(d);
}

static tp_resolved strike(tp_dynamics *d) {
  tp_impact impact;
  const double restitution = restitution_of(d);
  if (!tell_closing(d, restitution)) return TP_RESOLVED_NO_MEMORY;
  if (!tp_impact_find(&impact, &d->touching, &d->system, &d->state, restitution)) {
    return no_mode(d, "impact");
  }
  if (impact.restitution < restitution) d->account.lowered_restitution = true;
  return take(d, &impact);
}

/* ---- contacts that leave by less than the least bounce ---- */

/* The rows of those that are to stay closed: they leave, and come back from no higher. */
static int find_returning(double (*rows)[3], tp_dynamics *d, const tp_law_solution *mode) {
  int count = 0;
  for (long k = 0; k < d->touching.count && count < TP_LAW_EDGES; k++) {
    const tp_touching_contact *own = d->touching.items + k;
    const double rise = own->approach;
    const double fall = -tp_gap_speed(own->gap.across, mode->x) - own->gap.across_rate;
    if (rise <= 2 * TP_NO_SPEED || fall <= 0) continue;
    if (rise * rise > 2 * fall * d->settings->least_bounce) continue;
    memcpy(rows[count++], own->gap.across, sizeof own->gap.across);
  }
  return count;
}

/* Takes their speeds from them by the least loss of energy that lets what presses and sticks do so.
 */
static tp_resolved close_returning(bool *any, tp_dynamics *d, const tp_law_solution *mode) {
  double returning[TP_LAW_EDGES][3], rows[3 * TP_LAW_EDGES][3];
  const int count = find_returning(returning, d, mode);
  *any = count > 0;
  if (count == 0) return TP_RESOLVED_MOVES;
  int row_count = 0;
  for (int k = 0; k < d->smooth.count; k++) {
    const tp_gap gap = tp_gap_at(&d->system.shapes, &d->smooth.pressing[k].pair, &d->state);
    memcpy(rows[row_count++], gap.across, sizeof gap.across);
    if (d->smooth.pressing[k].sticks) memcpy(rows[row_count++], gap.along, sizeof gap.along);
  }
  memcpy(rows + row_count, returning, sizeof rows[0] * (size_t)count);
  d->lost += tp_motion_energy(&d->system, d->state.speed);
  tp_smooth_stop(d->state.speed, &d->system, (const double(*)[3])rows, row_count + count);
  d->lost -= tp_motion_energy(&d->system, d->state.speed);
  *any = false;
  for (long k = 0; k < d->touching.count; k++) {
    const tp_touching_contact *own = d->touching.items + k;
    if (own->approach <= 2 * TP_NO_SPEED) continue;
    if (fabs(tp_gap_speed(own->gap.across, d->state.speed)) > 2 * TP_NO_SPEED) continue;
    *any = true;
    d->account.accumulated++;
    if (!tp_record_event(d, TP_EVENT_ACCUMULATES, own, 0)) return TP_RESOLVED_NO_MEMORY;
  }
  return *any ? collect(d) : TP_RESOLVED_MOVES;
}

/* ---- all of it ---- */

/* A mode for the contacts as they are; `*mode` NULL: there is none, and impulses have stopped the
 * slip that has none (Painleve). */
static tp_resolved find_mode(const tp_law_solution **mode, candidates *of, tp_law *law,
                             tp_dynamics *d) {
  tp_impact impact;
  *law = tp_touching_accelerations(&d->touching, &d->system, d->time);
  of->count = 0;
  tp_law_search(law, keep, of);
  double violation;
  *mode = choose(&violation, d, of, law);
  if (*mode != NULL && violation == 0) return TP_RESOLVED_MOVES;
  /* None of few contacts goes on: all that there are. */
  of->count = 0;
  tp_law_search_all(law, keep, of);
  *mode = choose(&violation, d, of, law);
  if (*mode != NULL) return TP_RESOLVED_MOVES;
  d->account.paradox = true;
  if (!tp_impact_jam(&impact, &d->touching, &d->system, &d->state)) return no_mode(d, "motion");
  return take(d, &impact);
}

static tp_resolved told(tp_dynamics *d) {
  return tp_record_phases(d, true) ? TP_RESOLVED_MOVES : TP_RESOLVED_NO_MEMORY;
}

tp_resolved tp_resolve(tp_dynamics *d) {
  tp_resolved done = collect(d);
  for (int round = 0; round < MOST_IMPACTS && done == TP_RESOLVED_MOVES; round++) {
    if (tp_touching_closes(&d->touching)) {
      done = strike(d);
      continue;
    }
    if (is_slow(d->state.speed)) {
      done = tp_resolve_rest(d);
      if (done == TP_RESOLVED_RESTS) stop(d);
      if (done != TP_RESOLVED_MOVES) return done;
      d->account.in_window = d->account.in_window || d->held;
      return told(d);
    }
    candidates of;
    tp_law law;
    const tp_law_solution *mode;
    bool any;
    done = find_mode(&mode, &of, &law, d);
    if (done != TP_RESOLVED_MOVES || mode == NULL) continue;
    set_mode(d, &law, mode);
    done = close_returning(&any, d, mode);
    if (done != TP_RESOLVED_MOVES || any) continue;
    return told(d);
  }
  return done == TP_RESOLVED_MOVES ? no_mode(d, "end of impacts") : done;
}
