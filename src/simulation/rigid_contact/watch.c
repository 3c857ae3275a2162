/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Watched numbers evaluated along the quintic Hermite polynomial of a step, and the first sign
 * change refined by root finding (number/root.h) with steps from the same beginning. */

#include "rigid_contact/watch.h"

#include "number/root.h"
#include "rigid_contact/along.h"

#include <math.h>
#include <string.h>

enum { MOST_SAMPLES = 100 };

/* How far below zero a number may be at the begin of a step that is to go on: what the signs of the
 * law were judged by (law.h). */
static const double force_slack = 2e-11;

/* Of a gap that is as it was, up to some hundred times the extent from where the block began. */
static const double gap_rounding = 1e-13;

/* A gap that is as good as zero, a thousandth of what is closed; and to what a time is found. */
static const double flat_gap = 1e-15, least_width = 1e-15;

/* What shares of a step by its polynomial are told apart by: an event that is no more than this
 * before a gap closes may be behind it. */
static const double told_share = 1e-6;

/* A contact goes on a little farther than where it would not be taken for one (gap.h). */
static const double end_slack = 1.1 * TP_FACE_SLACK;

/* One number that is watched. */
typedef struct watched {
  tp_watched what;
  long number;
  double slack; /* of a gap */
  bool beyond;  /* the end of its face (along.h) */
} watched;

/* ---- the numbers ---- */

static double slip_of(const tp_smooth_moment *m, const tp_smooth *smooth, long k,
                      const tp_motion_state *state) {
  return -smooth->pressing[k].side * tp_gap_speed(m->gaps[k].along, state->speed);
}

static tp_slack_gap slack_gap_of(const tp_watch *w, const watched *own) {
  return (tp_slack_gap){&w->system->shapes, w->system->pairs + own->number, own->slack,
                        own->beyond};
}

static double value_of(const tp_watch *w, const watched *own, double time,
                       const tp_motion_state *state) {
  tp_smooth_moment moment;
  if (own->what == TP_WATCH_OVERTURN) return w->overturn - fabs(state->place[2]);
  if (own->what == TP_WATCH_LEAVE) return tp_contact_system_overlap(w->system, state);
  if (own->what == TP_WATCH_GAP) {
    const tp_turned_block block = tp_turned_block_at(state);
    const tp_slack_gap gap = slack_gap_of(w, own);
    return tp_slack_gap_width(&gap, &block);
  }
  if (own->what == TP_WATCH_MARGIN || own->what == TP_WATCH_ARC) {
    const tp_gap gap = tp_gap_at(&w->system->shapes, &w->smooth->pressing[own->number].pair, state);
    return (own->what == TP_WATCH_MARGIN ? gap.margin : gap.arc_margin) + end_slack;
  }
  if (!tp_smooth_at(&moment, w->smooth, time, state)) return -1;
  if (own->what == TP_WATCH_SLIP) {
    return slip_of(&moment, w->smooth, own->number, state) + TP_NO_SPEED;
  }
  double least = INFINITY;
  for (int k = 0; k < moment.solution.count; k++) {
    if (moment.solution.edges[k].contact != own->number) continue;
    least = fmin(least, moment.solution.factors[k]);
  }
  return least + force_slack;
}

/* ---- where a number changes its sign ---- */

typedef struct looking {
  const tp_watch *watch;
  const tp_along *along;
  const watched *own;
  tp_gap_span found;
  double sampled; /* the step that was done last, and where it led */
  double numbers[TP_MOTION_NUMBERS];
  tp_watch_end *first; /* of all numbers */
} looking;

/* No look is needed behind what has been found already. */
static double until(const looking *of) {
  return of->first->step / of->watch->step;
}

static bool look(looking *of) {
  for (int k = 1; k <= TP_LOOKS; k++) {
    const double share = (double)k / TP_LOOKS;
    of->found = (tp_gap_span){(double)(k - 1) / TP_LOOKS, share};
    if (of->found.sound >= until(of)) return false;
    const double time = of->watch->time + share * of->watch->step;
    if (value_of(of->watch, of->own, time, of->along->looks + k) < 0) return true;
  }
  return false;
}

/* ---- when it does ---- */

static bool go(double numbers[TP_MOTION_NUMBERS], const tp_watch *w, double step) {
  memcpy(numbers, w->numbers, sizeof w->numbers);
  if (step == 0) return true;
  return tp_extrapolate(numbers, tp_smooth_rates, w->smooth, w->time, w->numbers, step,
                        w->tolerance)
      .reached;
}

static bool sample(double *value, void *context, double step) {
  looking *of = context;
  of->sampled = step;
  if (!go(of->numbers, of->watch, step)) return false;
  const tp_motion_state state = tp_smooth_state(of->numbers);
  *value = value_of(of->watch, of->own, of->watch->time + step, &state);
  return true;
}

static bool find_between(double *step, looking *of, tp_root_end low, tp_root_end high) {
  const tp_root_search search = {.value = sample,
                                 .context = of,
                                 .flat = of->own->what == TP_WATCH_GAP ? flat_gap : 0,
                                 .width = least_width,
                                 .most = MOST_SAMPLES};
  tp_root root;
  if (!tp_root_find(&root, &search, low, high)) return false;
  *step = root.high;
  return true;
}

/* The step after which it is below zero; false where the true motion does not come to that. Where
 * it is so at the begin already: 0. */
static bool locate(double *step, looking *of) {
  tp_root_end low = {of->found.sound * of->watch->step, 0},
              high = {of->found.below * of->watch->step, 0};
  if (!sample(&high.value, of, high.x) || !(high.value < 0)) return false;
  if (!sample(&low.value, of, low.x)) return false;
  if (!(low.value > 0) && low.x > 0) {
    low.x = 0;
    if (!sample(&low.value, of, 0)) return false;
  }
  *step = 0;
  return !(low.value > 0) || find_between(step, of, low, high);
}

/* Of a gap: from close by where the polynomial closes it, as a rule. */
static bool locate_closing(double *step, looking *of, double share) {
  const double whole = of->watch->step;
  tp_root_end low = {fmax(of->found.sound, share - told_share) * whole, 0},
              high = {fmin(of->found.below, share + told_share) * whole, 0};
  const bool between = share > of->found.sound && sample(&low.value, of, low.x) && low.value > 0 &&
                       sample(&high.value, of, high.x) && high.value < 0;
  return (between && find_between(step, of, low, high)) || locate(step, of);
}

/* A contact closes only where both parts face each other. */
static bool faces(const tp_watch *w, long pair, const double *numbers) {
  const tp_motion_state state = tp_smooth_state(numbers);
  const tp_gap gap = tp_gap_at(&w->system->shapes, w->system->pairs + pair, &state);
  return tp_gap_faces(&gap);
}

/* Is it the first that changes its sign? */
static void take_first(looking *of, double step) {
  const watched *own = of->own;
  if (step >= of->first->step) return;
  if (of->sampled != step && !go(of->numbers, of->watch, step)) return;
  if (own->what == TP_WATCH_GAP && !faces(of->watch, own->number, of->numbers)) return;
  of->first->what = own->what;
  of->first->number = own->number;
  of->first->step = step;
  of->first->time = of->watch->time + step;
  memcpy(of->first->numbers, of->numbers, sizeof of->numbers);
}

static void consider(looking *of, const watched *own) {
  double step;
  of->own = own;
  if (look(of) && locate(&step, of)) take_first(of, step);
}

/* Is a gap that is below zero behind the first event still open at it? */
static bool is_open_at_first(const looking *of) {
  if (of->first->what == TP_WATCH_NOTHING || of->found.below < until(of)) return false;
  const tp_motion_state state = tp_smooth_state(of->first->numbers);
  return value_of(of->watch, of->own, of->first->time, &state) > 0;
}

static void consider_gap(looking *of, const watched *own, double share) {
  double step;
  of->own = own;
  if (!is_open_at_first(of) && locate_closing(&step, of, share)) take_first(of, step);
}

static bool presses(const tp_smooth *smooth, const tp_gap_pair *pair) {
  for (int k = 0; k < smooth->count; k++) {
    if (tp_pair_is(&smooth->pressing[k].pair, pair)) return true;
  }
  return false;
}

/* The gap of a pair, by its number among those that are near, if it can close in this step: a gap
 * changes by no more than the block moves. One that touches closes where it is deeper than before
 * by what is closed. */
static bool can_close(watched *own, const looking *of, double moves, long near) {
  const tp_watch *w = of->watch;
  const long number = w->system->near[near];
  const tp_gap_pair *pair = w->system->pairs + number;
  if (!tp_gap_in_reach(&w->system->shapes, pair, of->along->blocks, moves)) return false;
  if (presses(w->smooth, pair)) return false;
  const tp_gap gap = tp_gap_moving(&w->system->shapes, pair, of->along->blocks);
  if (gap.width > moves) return false;
  if (gap.width < 0 && gap.margin < -TP_FACE_SLACK && pair->kind != TP_CORNER_ON_CORNER) {
    *own = (watched){TP_WATCH_GAP, number, 0, true};
    return true;
  }
  if (gap.width < (pair->touching ? -TP_DEEPEST_GAP : 0)) return false;
  const bool leaves = tp_gap_speed(gap.across, of->along->looks[0].speed) > 2 * TP_NO_SPEED;
  const double more = leaves ? gap_rounding : TP_CLOSED_GAP;
  *own = (watched){TP_WATCH_GAP, number, pair->touching ? more + fmax(0, -gap.width) : 0, false};
  return true;
}

/* The share of the step at which a gap closes by the polynomial, if both parts face each other
 * there, by all that the polynomial may be off. */
static bool closes_by(double *share, looking *of, const watched *own, double moves, double least) {
  const tp_slack_gap gap = slack_gap_of(of->watch, own);
  if (!tp_gap_span_find(&of->found, of->along, &gap, least)) return false;
  *share = tp_gap_span_share(&of->found, of->along, &gap);
  const tp_motion_state state = tp_along_at(of->along, *share);
  const tp_gap there = tp_gap_at(gap.shapes, gap.pair, &state);
  return fmin(there.margin, there.arc_margin) > -(1e-6 + 1e-3 * moves);
}

/* Those up to one of the looks. The one that the polynomial closes first comes first: of the others
 * few are left then. */
static void consider_pairs(looking *of, int looks) {
  const tp_watch *w = of->watch;
  const double moves = TP_CLOSED_GAP + tp_along_reach(of->along, looks);
  double least = fmin(until(of) + told_share, (double)looks / TP_LOOKS), share;
  watched own, first = {TP_WATCH_NOTHING, 0, 0, false};
  tp_gap_span found = {0, 0};
  tp_contact_system_near(w->system, of->along->looks, moves);
  for (long k = 0; k < w->system->near_count; k++) {
    if (!can_close(&own, of, moves, k) || !closes_by(&share, of, &own, moves, least)) continue;
    if (share >= least) continue;
    least = share;
    first = own;
    found = of->found;
  }
  if (first.what == TP_WATCH_NOTHING) return;
  of->found = found;
  consider_gap(of, &first, least);
  for (long k = 0; k < w->system->near_count; k++) {
    if (!can_close(&own, of, moves, k) || own.number == first.number) continue;
    if (closes_by(&share, of, &own, moves, until(of))) consider_gap(of, &own, share);
  }
}

static void consider_all(looking *of) {
  const tp_watch *w = of->watch;
  for (int k = 0; k < w->smooth->count; k++) {
    const tp_pressing *own = w->smooth->pressing + k;
    consider(of, &(watched){TP_WATCH_FORCE, k, 0, false});
    if (!own->sticks && !own->pinned) consider(of, &(watched){TP_WATCH_SLIP, k, 0, false});
    consider(of, &(watched){TP_WATCH_MARGIN, k, 0, false});
    consider(of, &(watched){TP_WATCH_ARC, k, 0, false});
  }
  consider(of, &(watched){TP_WATCH_LEAVE, 0, 0, false});
  if (w->overturn > 0) consider(of, &(watched){TP_WATCH_OVERTURN, 0, 0, false});
  /* most closings come early in a step, and few pairs are that near */
  consider_pairs(of, TP_LOOKS / 4);
  if (until(of) > 0.25) consider_pairs(of, TP_LOOKS);
}

tp_watch_end tp_watch_step(const tp_watch *watch) {
  const double least_step = 1e-13;
  tp_watch own = *watch;
  tp_watch_end end = {.what = TP_WATCH_FAILED};
  tp_along along;
  memcpy(along.from, own.numbers, sizeof along.from);
  /* what is left to a time at which something is due may be shorter */
  for (; own.step > least_step || own.step == watch->step; own.step /= 2) {
    const tp_step_answer answer = tp_extrapolate(along.to, tp_smooth_rates, own.smooth, own.time,
                                                 own.numbers, own.step, own.tolerance);
    end.columns = answer.columns;
    const tp_motion_state at = tp_smooth_state(along.to);
    if (!answer.reached || !tp_contact_system_covers(own.system, &at)) continue;
    if (!tp_smooth_rates(along.from_rates, own.smooth, own.time, along.from)) return end;
    if (!tp_smooth_rates(along.to_rates, own.smooth, own.time + own.step, along.to)) return end;
    along.step = own.step;
    tp_along_look(&along);
    end.what = TP_WATCH_NOTHING;
    end.time = own.time + own.step;
    end.step = own.step;
    memcpy(end.numbers, along.to, sizeof end.numbers);
    looking of = {.watch = &own, .along = &along, .first = &end};
    consider_all(&of);
    return end;
  }
  return end;
}
