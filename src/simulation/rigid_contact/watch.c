/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Watched numbers evaluated along the quintic Hermite polynomial of a step, and the first sign
 * change refined by root finding (number/root.h) with steps from the same beginning. */

#include "rigid_contact/watch.h"

#include "number/root.h"

#include <math.h>
#include <string.h>

enum { LOOKS = 8, MOST_SAMPLES = 100 };

/* How far below zero a number may be at the begin of a step that is to go on: what the signs of the
 * law were judged by (law.h). */
static const double force_slack = 2e-11;

/* Of a gap that is as it was, up to some hundred times the extent from where the block began. */
static const double gap_rounding = 1e-13;

/* A contact goes on a little farther than where it would not be taken for one (gap.h). */
static const double end_slack = 1.1 * TP_FACE_SLACK;

/* One number that is watched. */
typedef struct watched {
  tp_watched what;
  long number;
  double slack; /* of a gap */
} watched;

/* ---- the state along a step ---- */

/* The polynomial of fifth degree through place, speed and acceleration at both ends. */
static void between(tp_motion_state *state, double share, double step, const double *from,
                    const double *from_rates, const double *to, const double *to_rates) {
  const double s = share, h = step;
  for (int e = 0; e < 3; e++) {
    const double p = from[e], q = to[e], v = h * from[3 + e], w = h * to[3 + e];
    const double a = h * h * from_rates[3 + e], b = h * h * to_rates[3 + e];
    const double d = q - p;
    const double c3 = 10 * d - 6 * v - 4 * w - 1.5 * a + 0.5 * b;
    const double c4 = -15 * d + 8 * v + 7 * w + 1.5 * a - b;
    const double c5 = 6 * d - 3 * v - 3 * w - 0.5 * a + 0.5 * b;
    state->place[e] = p + s * (v + s * (a / 2 + s * (c3 + s * (c4 + s * c5))));
    state->speed[e] = (v + s * (a + s * (3 * c3 + s * (4 * c4 + s * 5 * c5)))) / h;
  }
}

/* ---- the numbers ---- */

static double slip_of(const tp_smooth_moment *m, const tp_smooth *smooth, long k,
                      const tp_motion_state *state) {
  return -smooth->pressing[k].side * tp_gap_speed(m->gaps[k].along, state->speed);
}

/* By how much the block is still above the base; exact where it is nearly not. */
static double overlap_of(const tp_contact_system *system, const tp_motion_state *state) {
  const double x = state->place[0];
  double reach[2];
  if (x > system->base_left && x < system->base_right) {
    return fmin(x - system->base_left, system->base_right - x);
  }
  tp_contact_system_reach(reach, system, state);
  return fmin(reach[1] - system->base_left, system->base_right - reach[0]);
}

static double value_of(const tp_watch *w, const watched *own, double time,
                       const tp_motion_state *state) {
  tp_smooth_moment moment;
  if (own->what == TP_WATCH_OVERTURN) return w->overturn - fabs(state->place[2]);
  if (own->what == TP_WATCH_LEAVE) return overlap_of(w->system, state);
  if (own->what == TP_WATCH_GAP) {
    return tp_gap_at(&w->system->shapes, w->system->pairs + own->number, state).width + own->slack;
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
  const double *to, *from_rates, *to_rates;
  const watched *own;
  double sound, below; /* shares of the step: the last look before it was below zero, and that */
  tp_watch_end *first; /* of all numbers */
} looking;

static tp_motion_state at_share(const looking *of, double share) {
  tp_motion_state state;
  between(&state, share, of->watch->step, of->watch->numbers, of->from_rates, of->to, of->to_rates);
  return state;
}

/* No look is needed behind what has been found already. */
static bool is_behind(const looking *of, double share) {
  return share * of->watch->step >= of->first->step;
}

static bool look(looking *of) {
  for (int k = 1; k <= LOOKS; k++) {
    const double share = (double)k / LOOKS;
    of->sound = (double)(k - 1) / LOOKS;
    of->below = share;
    if (is_behind(of, of->sound)) return false;
    const tp_motion_state state = at_share(of, share);
    const double time = of->watch->time + share * of->watch->step;
    if (value_of(of->watch, of->own, time, &state) < 0) return true;
  }
  return false;
}

/* A gap, and how fast it changes from one look to the next. */
typedef struct gap_look {
  double width, speed;
} gap_look;

static gap_look look_at_gap(const looking *of, double share) {
  const tp_motion_state state = at_share(of, share);
  const tp_gap_pair *pair = of->watch->system->pairs + of->own->number;
  const tp_gap gap = tp_gap_at(&of->watch->system->shapes, pair, &state);
  return (gap_look){gap.width + of->own->slack,
                    tp_gap_speed(gap.across, state.speed) * of->watch->step / LOOKS};
}

/* Where the cubic through two looks is least, as a share of the way from one to the other. */
static double least_between(gap_look a, gap_look b) {
  const double d = b.width - a.width;
  const double c2 = 3 * d - 2 * a.speed - b.speed, c3 = a.speed + b.speed - 2 * d;
  return -a.speed / (c2 + sqrt(fmax(c2 * c2 - 3 * c3 * a.speed, 0)));
}

/* A gap also where it is least between two looks. */
static bool look_for_closing(looking *of) {
  gap_look last = look_at_gap(of, 0);
  for (int k = 1; k <= LOOKS; k++) {
    of->sound = (double)(k - 1) / LOOKS;
    of->below = (double)k / LOOKS;
    if (is_behind(of, of->sound)) return false;
    const gap_look now = look_at_gap(of, of->below);
    if (now.width < 0) return true;
    if (last.speed < 0 && now.speed > 0 && last.width + last.speed < 0) {
      const double least = of->sound + least_between(last, now) / LOOKS;
      if (least > of->sound && least < of->below && look_at_gap(of, least).width < 0) {
        of->below = least;
        return true;
      }
    }
    last = now;
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
  const looking *of = context;
  double numbers[TP_MOTION_NUMBERS];
  if (!go(numbers, of->watch, step)) return false;
  const tp_motion_state state = tp_smooth_state(numbers);
  *value = value_of(of->watch, of->own, of->watch->time + step, &state);
  return true;
}

/* The step after which it is below zero; false where the true motion does not come to that. Where
 * it is so at the begin already: 0. */
static bool locate(double *step, looking *of) {
  const tp_root_search search = {.value = sample, .context = of, .most = MOST_SAMPLES};
  tp_root_end low = {of->sound * of->watch->step, 0}, high = {of->below * of->watch->step, 0};
  tp_root root;
  if (!sample(&high.value, of, high.x) || !(high.value < 0)) return false;
  if (!sample(&low.value, of, low.x)) return false;
  if (!(low.value > 0) && low.x > 0) {
    low.x = 0;
    if (!sample(&low.value, of, 0)) return false;
  }
  *step = 0;
  if (!(low.value > 0)) return true;
  if (!tp_root_find(&root, &search, low, high)) return false;
  *step = root.high;
  return true;
}

/* A contact closes only where both parts face each other. */
static bool faces(const tp_watch *w, long pair, const double *numbers) {
  const tp_motion_state state = tp_smooth_state(numbers);
  const tp_gap gap = tp_gap_at(&w->system->shapes, w->system->pairs + pair, &state);
  return tp_gap_faces(&gap);
}

/* Is it the first that changes its sign? */
static void consider(looking *of, const watched *own) {
  double step, numbers[TP_MOTION_NUMBERS];
  of->own = own;
  const bool gap = own->what == TP_WATCH_GAP;
  if (!(gap ? look_for_closing(of) : look(of)) || !locate(&step, of)) return;
  if (step >= of->first->step || !go(numbers, of->watch, step)) return;
  if (gap && !faces(of->watch, own->number, numbers)) return;
  of->first->what = own->what;
  of->first->number = own->number;
  of->first->step = step;
  of->first->time = of->watch->time + step;
  memcpy(of->first->numbers, numbers, sizeof numbers);
}

static bool presses(const tp_smooth *smooth, const tp_gap_pair *pair) {
  for (int k = 0; k < smooth->count; k++) {
    if (tp_pair_is(&smooth->pressing[k].pair, pair)) return true;
  }
  return false;
}

/* Those that can close in this step: a gap changes by no more than the block moves. One that
 * touches closes where it is deeper than before by what is closed. */
static void consider_pairs(looking *of, const tp_motion_state *begin) {
  const tp_watch *w = of->watch;
  double moves = TP_CLOSED_GAP;
  for (int e = 0; e < 3; e++) {
    moves += w->step * fmax(fabs(begin->speed[e]), fabs(of->to[3 + e]));
    moves += w->step * w->step * fmax(fabs(of->from_rates[3 + e]), fabs(of->to_rates[3 + e]));
  }
  for (long p = 0; p < w->system->pair_count; p++) {
    const tp_gap_pair *pair = w->system->pairs + p;
    if (presses(w->smooth, pair)) continue;
    const tp_gap gap = tp_gap_at(&w->system->shapes, pair, begin);
    if (gap.width > moves || gap.width < (pair->touching ? -TP_DEEPEST_GAP : 0)) continue;
    const bool leaves = tp_gap_speed(gap.across, begin->speed) > 2 * TP_NO_SPEED;
    const double more = leaves ? gap_rounding : TP_CLOSED_GAP;
    const double slack = pair->touching ? more + fmax(0, -gap.width) : 0;
    consider(of, &(watched){TP_WATCH_GAP, p, slack});
  }
}

static void consider_all(looking *of) {
  const tp_watch *w = of->watch;
  const tp_motion_state begin = tp_smooth_state(w->numbers);
  for (int k = 0; k < w->smooth->count; k++) {
    const tp_pressing *own = w->smooth->pressing + k;
    consider(of, &(watched){TP_WATCH_FORCE, k, 0});
    if (!own->sticks && !own->pinned) consider(of, &(watched){TP_WATCH_SLIP, k, 0});
    consider(of, &(watched){TP_WATCH_MARGIN, k, 0});
    consider(of, &(watched){TP_WATCH_ARC, k, 0});
  }
  consider(of, &(watched){TP_WATCH_LEAVE, 0, 0});
  if (w->overturn > 0) consider(of, &(watched){TP_WATCH_OVERTURN, 0, 0});
  consider_pairs(of, &begin);
}

tp_watch_end tp_watch_step(const tp_watch *watch) {
  const double least_step = 1e-13;
  tp_watch own = *watch;
  tp_watch_end end = {.what = TP_WATCH_FAILED};
  double to[TP_MOTION_NUMBERS], from_rates[TP_MOTION_NUMBERS], to_rates[TP_MOTION_NUMBERS];
  /* what is left to a time at which something is due may be shorter */
  for (; own.step > least_step || own.step == watch->step; own.step /= 2) {
    const tp_step_answer answer = tp_extrapolate(to, tp_smooth_rates, own.smooth, own.time,
                                                 own.numbers, own.step, own.tolerance);
    end.columns = answer.columns;
    const tp_motion_state at = tp_smooth_state(to);
    if (!answer.reached || !tp_contact_system_covers(own.system, &at)) continue;
    if (!tp_smooth_rates(from_rates, own.smooth, own.time, own.numbers)) return end;
    if (!tp_smooth_rates(to_rates, own.smooth, own.time + own.step, to)) return end;
    end.what = TP_WATCH_NOTHING;
    end.time = own.time + own.step;
    end.step = own.step;
    memcpy(end.numbers, to, sizeof to);
    looking of = {
        .watch = &own, .to = to, .from_rates = from_rates, .to_rates = to_rates, .first = &end};
    consider_all(&of);
    return end;
  }
  return end;
}
