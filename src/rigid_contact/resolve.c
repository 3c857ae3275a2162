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

static const tp_law_solution *choose(tp_dynamics *d, const candidates *of, const tp_law *law) {
  const tp_law_solution *best = NULL;
  double best_violation = 0;
  for (int k = 0; k < of->count; k++) {
    if (of->count == 1) return of->items;
    tp_touching_set_smooth(&d->smooth, &d->touching, law, of->items + k);
    double violation = violation_of(d, &d->smooth, law, &d->touching);
    if (violation > -followed_slack) violation = 0;
    if (best != NULL && violation <= best_violation) continue;
    best = of->items + k;
    best_violation = violation;
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
  if (!tp_rest_motions(&law, keep, &of)) return TP_RESOLVED_NO_MEMORY;
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

/* An approach from a fall no higher than the least bounce is stopped. */
static double restitution_of(const tp_dynamics *d) {
  double fastest = 0;
  for (long k = 0; k < d->touching.count; k++) {
    fastest = fmax(fastest, -d->touching.items[k].approach);
  }
  return fastest * fastest / 2 > d->settings->least_bounce ? d->settings->restitution : 0;
}

static bool tell_closing(tp_dynamics *d) {
  for (long k = 0; k < d->touching.count; k++) {
    const tp_touching_contact *own = d->touching.items + k;
    if (own->approach >= -2 * TP_NO_SPEED) continue;
    if (!tp_record_event(d, TP_EVENT_CLOSES, own, -own->approach)) return false;
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

static tp_resolved strike(tp_dynamics *d, double restitution) {
  tp_impact impact;
  if (!tell_closing(d)) return TP_RESOLVED_NO_MEMORY;
  if (!tp_impact_find(&impact, &d->touching, &d->system, &d->state, restitution)) {
    return no_mode(d, "impact");
  }
  d->account.impacts++;
  if (impact.restitution < restitution) d->account.lowered_restitution = true;
  d->lost += impact.energy_lost;
  memcpy(d->state.speed, impact.speed, sizeof impact.speed);
  return collect(d);
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

/* Takes their speeds from them, and those of contacts that press, by the least loss of energy. */
static tp_resolved close_returning(bool *any, tp_dynamics *d, const tp_law_solution *mode) {
  double returning[TP_LAW_EDGES][3], rows[2 * TP_LAW_EDGES][3];
  const int count = find_returning(returning, d, mode);
  *any = count > 0;
  if (count == 0) return TP_RESOLVED_MOVES;
  int row_count = 0;
  for (int k = 0; k < d->smooth.count; k++) {
    const tp_gap gap = tp_gap_at(&d->system.shapes, &d->smooth.pressing[k].pair, &d->state);
    memcpy(rows[row_count++], gap.across, sizeof gap.across);
  }
  memcpy(rows + row_count, returning, sizeof rows[0] * (size_t)count);
  d->lost += tp_motion_energy(&d->system, d->state.speed);
  tp_smooth_stop(d->state.speed, &d->system, (const double(*)[3])rows, row_count + count);
  d->lost -= tp_motion_energy(&d->system, d->state.speed);
  d->account.accumulated += count;
  for (long k = 0; k < d->touching.count; k++) {
    const tp_touching_contact *own = d->touching.items + k;
    if (own->approach <= 2 * TP_NO_SPEED) continue;
    if (fabs(tp_gap_speed(own->gap.across, d->state.speed)) > 2 * TP_NO_SPEED) continue;
    if (!tp_record_event(d, TP_EVENT_ACCUMULATES, own, 0)) return TP_RESOLVED_NO_MEMORY;
  }
  return collect(d);
}

/* ---- all of it ---- */

/* A mode for the contacts as they are, or none: then it has struck once more, without approach. */
static tp_resolved find_mode(const tp_law_solution **mode, candidates *of, tp_law *law,
                             tp_dynamics *d) {
  for (int tried = 0; tried < 2; tried++) {
    *law = tp_touching_accelerations(&d->touching, &d->system, d->time);
    of->count = 0;
    tp_law_search(law, keep, of);
    *mode = choose(d, of, law);
    if (*mode != NULL) return TP_RESOLVED_MOVES;
    /* Painleve: forces without bound stop the slip at once. */
    d->account.paradox = true;
    const tp_resolved struck = strike(d, 0);
    if (struck != TP_RESOLVED_MOVES) return struck;
  }
  return no_mode(d, "motion");
}

static tp_resolved told(tp_dynamics *d) {
  return tp_record_phases(d, true) ? TP_RESOLVED_MOVES : TP_RESOLVED_NO_MEMORY;
}

tp_resolved tp_resolve(tp_dynamics *d) {
  tp_resolved done = collect(d);
  for (int round = 0; round < MOST_IMPACTS && done == TP_RESOLVED_MOVES; round++) {
    if (tp_touching_closes(&d->touching)) {
      done = strike(d, restitution_of(d));
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
    if (done != TP_RESOLVED_MOVES) return done;
    set_mode(d, &law, mode);
    done = close_returning(&any, d, mode);
    if (done != TP_RESOLVED_MOVES || any) continue;
    return told(d);
  }
  return done == TP_RESOLVED_MOVES ? no_mode(d, "end of impacts") : done;
}
