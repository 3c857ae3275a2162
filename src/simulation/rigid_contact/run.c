/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Event-driven run of a rigid block on rigid contacts: smooth steps up to the next event, impacts,
 * choice of the next mode, rest, and the end by time, overturning, loss of the base or budget
 * (docs/rigid_contact.md). */

#include "common/budget.h"
#include "rigid_contact/begin.h"
#include "rigid_contact/watch.h"

#include <math.h>
#include <stdlib.h>

/* Of a step, without dimension; one up to an event that is shorter is none. */
static const double longest_step = 0.25, first_step = 0.05, at_once = 1e-12;

/* After so many steps a run asks whether it is to stop. */
enum { TURNS_A_QUESTION = 64 };

/* Events at one moment: more of them say that modes take turns within rounding. */
enum { MOST_AT_ONCE = 40 };

/* A quarter of a turn, but for so little that a block which lies on its side has made it. */
static const double overturned_turn = 1.5707963267948966 - 1e-6;

tp_rigid_contact_settings tp_rigid_contact_settings_default(void) {
  return (tp_rigid_contact_settings){.tolerance = 1e-13,
                                     .least_bounce = 1e-9,
                                     .most_events = 100000,
                                     .most_steps = 10000000,
                                     .window = TP_WINDOW_MOVES};
}

/* Impacts that follow sooner, as a share of the interval of moments, are not told on both sides. */
static const double least_interval = 0.05;

/* A run and where it is on its way. */
typedef struct progress {
  tp_dynamics *d;
  double impact; /* the time of the last impact that is told on both sides */
  double end, next_moment, step;
  long moments;
  int at_once;
  long turns;
  double work; /* steps, and looks at a block that rests, each with its pairs */
  bool is_over;
  tp_run_end how;
} progress;

/* A step looks at every pair that may touch: it counts for more where these are many. */
static void count_work(progress *p) {
  static const double pairs_of_one = 64;
  p->work += 1 + floor((double)p->d->system.pair_count / pairs_of_one);
}

static double to_seconds(const tp_dynamics *d, double time) {
  return time * d->system.time_unit_s;
}

static bool over(progress *p, tp_run_end how) {
  p->how = how;
  p->is_over = true;
  return false;
}

static bool undecided(progress *p, const char *what) {
  (void)tp_fail(p->d->message, TP_UNDECIDED, (tp_place){0},
                "the motion is not decided at %.9g s: %s", to_seconds(p->d, p->d->time), what);
  return over(p, TP_RUN_UNDECIDED);
}

static tp_run_end end_of_motion(const tp_dynamics *d, tp_run_end otherwise) {
  return d->overturned ? TP_RUN_OVERTURNED : otherwise;
}

/* Moments come at whole multiples of their interval. */
static bool record_due(progress *p) {
  tp_dynamics *d = p->d;
  if (d->time < p->next_moment) return true;
  const double every = d->run->moments_every_s / d->system.time_unit_s;
  p->moments = lround(p->next_moment / every) + 1;
  p->next_moment = (double)p->moments * every;
  return tp_record_moment(d);
}

static double next_kink(const tp_dynamics *d) {
  return tp_drive_next_kink(d->run->drive, to_seconds(d, d->time)) / d->system.time_unit_s;
}

/* ---- at rest ---- */

static bool drive_is_over(const tp_dynamics *d) {
  const tp_drive *drive = d->run->drive;
  const double time_s = to_seconds(d, d->time);
  return drive->shaking == NULL &&
         (drive->speed == 0 || tp_drive_angle(drive, time_s) == drive->final_angle);
}

static double time_to_look(const progress *p) {
  const double kink = next_kink(p->d);
  const double next = fmin(fmin(p->end, p->next_moment), tp_begin_next_look(p->d));
  return kink > p->d->time ? fmin(next, kink) : next;
}

static bool begin_motion(progress *p) {
  tp_dynamics *d = p->d;
  const bool tilted = d->run->drive->shaking == NULL;
  double later;
  if (tp_begin_choose(&later, d) == TP_RESOLVED_NO_MEMORY || !tp_record_phases(d, true)) {
    return over(p, TP_RUN_NO_MEMORY);
  }
  d->resting = false;
  d->moved = true;
  p->step = first_step;
  d->account.in_window = d->account.in_window || d->held;
  if (tilted && !tp_record_event(d, TP_EVENT_COLLAPSES, NULL, 0)) {
    return over(p, TP_RUN_NO_MEMORY);
  }
  if (!tp_record_moment(d)) return over(p, TP_RUN_NO_MEMORY);
  d->time = later;
  return tilted && d->run->until_collapse ? over(p, TP_RUN_MOVES) : true;
}

static bool wait(progress *p) {
  tp_dynamics *d = p->d;
  const tp_run_end rests = end_of_motion(d, d->moved ? TP_RUN_RESTS : TP_RUN_STANDS);
  if (d->time >= p->end || drive_is_over(d)) return over(p, rests);
  const double from = d->time;
  count_work(p);
  d->time = time_to_look(p);
  tp_resolved now = tp_resolve_rest(d);
  if (now == TP_RESOLVED_MOVES) {
    const double moves_at = d->time;
    d->time = from;
    now = tp_begin_find(d, moves_at);
  }
  if (now == TP_RESOLVED_NO_MEMORY) return over(p, TP_RUN_NO_MEMORY);
  if (now == TP_RESOLVED_MOVES) return begin_motion(p);
  return record_due(p) ? true : over(p, TP_RUN_NO_MEMORY);
}

/* ---- in motion ---- */

static bool come_to_rest(progress *p) {
  tp_dynamics *d = p->d;
  d->resting = true;
  tp_begin_wait(d);
  if (!tp_record_phases(d, false) || !tp_record_event(d, TP_EVENT_RESTS, NULL, 0)) {
    return over(p, TP_RUN_NO_MEMORY);
  }
  return tp_record_moment(d) ? true : over(p, TP_RUN_NO_MEMORY);
}

static bool go_on(progress *p) {
  switch (tp_resolve(p->d)) {
  case TP_RESOLVED_MOVES:
    return true;
  case TP_RESOLVED_RESTS:
    return come_to_rest(p);
  case TP_RESOLVED_NOT:
    return over(p, TP_RUN_UNDECIDED);
  case TP_RESOLVED_NO_MEMORY:
    break;
  }
  return over(p, TP_RUN_NO_MEMORY);
}

/* A velocity jumps in an impact: the history has the moments before and after it. */
static bool is_told(progress *p, const tp_watch_end *end) {
  const tp_dynamics *d = p->d;
  const double every = d->run->moments_every_s / d->system.time_unit_s;
  if (end->what != TP_WATCH_GAP || d->run->history == NULL || !(every > 0)) return false;
  if (d->time - p->impact < least_interval * every) return false;
  p->impact = d->time;
  return true;
}

static bool go_on_told(progress *p) {
  if (!tp_record_moment(p->d)) return over(p, TP_RUN_NO_MEMORY);
  if (!go_on(p) || p->d->resting) return !p->is_over;
  return tp_record_moment(p->d) ? true : over(p, TP_RUN_NO_MEMORY);
}

static bool meet(progress *p, const tp_watch_end *end) {
  tp_dynamics *d = p->d;
  if (end->what == TP_WATCH_OVERTURN) {
    d->overturned = true;
    return tp_record_event(d, TP_EVENT_OVERTURNS, NULL, 0) ? true : over(p, TP_RUN_NO_MEMORY);
  }
  if (end->what == TP_WATCH_LEAVE) {
    const bool told = tp_record_event(d, TP_EVENT_LEAVES_BASE, NULL, 0) && tp_record_moment(d);
    return over(p, told ? TP_RUN_LEFT_BASE : TP_RUN_NO_MEMORY);
  }
  d->account.events++;
  if (d->account.events > d->settings->most_events) return undecided(p, "it met the most events");
  p->at_once = end->step > at_once ? 0 : p->at_once + 1;
  if (p->at_once > MOST_AT_ONCE) return undecided(p, "its contacts take turns at one moment");
  return is_told(p, end) ? go_on_told(p) : go_on(p);
}

/* The turn at the end of a step, and where it turned back within the step: there the cubic through
 * turns and angular velocities of both ends has its extreme. */
static void take_turns(const progress *p, const tp_motion_state *from, double from_time) {
  enum { TURN = 2 };
  const tp_dynamics *d = p->d;
  tp_turn_range *range = d->run->turns;
  const double start = d->run->start.turned, length = d->time - from_time;
  if (range == NULL || !(length > 0)) return;
  const double a0 = from->place[TURN], a1 = d->state.place[TURN];
  const double v0 = from->speed[TURN] * length, v1 = d->state.speed[TURN] * length;
  tp_turn_range_take(range, a1 - start, to_seconds(d, d->time));
  if (v0 * v1 >= 0) return;
  const double a = 6 * (a0 - a1) + 3 * (v0 + v1), b = 6 * (a1 - a0) - 4 * v0 - 2 * v1, c = v0;
  /* of a s^2 + b s + c = 0 the root between 0 and 1, where the two ends have different signs */
  const double root = sqrt(fmax(0, b * b - 4 * a * c)), q = -0.5 * (b + copysign(root, b));
  const double first = q != 0 ? c / q : 0, second = a != 0 ? q / a : first;
  const double s = first > 0 && first < 1 ? first : fmin(1, fmax(0, second));
  const double turned =
      a0 + s * (v0 + s * (3 * (a1 - a0) - 2 * v0 - v1 + s * (2 * (a0 - a1) + v0 + v1)));
  tp_turn_range_take(range, turned - start, to_seconds(d, from_time + s * length));
}

/* Up to the next time at which something is due, or the next event. */
static bool move(progress *p) {
  tp_dynamics *d = p->d;
  const tp_motion_state before = d->state;
  const double before_time = d->time;
  const double kink = next_kink(d), due = fmin(fmin(p->end, p->next_moment), kink);
  tp_watch watch = {.system = &d->system,
                    .smooth = &d->smooth,
                    .time = d->time,
                    .step = fmin(p->step, due - d->time),
                    .tolerance = d->settings->tolerance,
                    .overturn = d->overturned ? -INFINITY : overturned_turn};
  tp_smooth_numbers(watch.numbers, &d->state, d->work);
  const bool is_due = watch.step == due - d->time;
  const tp_watch_end end = tp_watch_step(&watch);
  if (end.what == TP_WATCH_FAILED) return undecided(p, "the steps become too short");
  if (end.columns <= 6) p->step = fmin(p->step * 1.5, longest_step);
  if (end.what == TP_WATCH_NOTHING && end.step < watch.step) p->step = end.step;
  if (end.columns >= 8) p->step = fmax(end.step * 0.7, first_step / 100);
  d->account.steps++;
  count_work(p);
  d->time = is_due && end.step == watch.step ? due : end.time;
  d->state = tp_smooth_state(end.numbers);
  d->work = end.numbers[6];
  take_turns(p, &before, before_time);
  tp_touching_open(&d->system, &d->state);
  const double drift = tp_smooth_project(&d->state, &d->smooth);
  d->account.largest_drift = fmax(d->account.largest_drift, drift);
  (void)tp_energy_balance(d);
  if (!tp_contact_system_list(&d->system, &d->state)) return over(p, TP_RUN_NO_MEMORY);
  if (end.what != TP_WATCH_NOTHING) return meet(p, &end);
  if (!record_due(p)) return over(p, TP_RUN_NO_MEMORY);
  if (d->time >= p->end) return over(p, end_of_motion(d, TP_RUN_MOVES));
  return d->time == kink ? go_on(p) : true;
}

static bool is_to_stop(progress *p) {
  const tp_run *run = p->d->run;
  return run->stop != NULL && p->turns++ % TURNS_A_QUESTION == 0 && run->stop(run->context);
}

static void advance(progress *p) {
  tp_dynamics *d = p->d;
  const double most = d->run->most_steps > 0 ? d->run->most_steps : (double)d->settings->most_steps;
  if (p->work >= most) {
    (void)undecided(p, "it took the most steps");
  } else if (is_to_stop(p)) {
    (void)undecided(p, "it was stopped");
  } else {
    (void)(d->resting ? wait(p) : move(p));
  }
}

/* From rest. */
static bool begin_at_rest(progress *p) {
  tp_dynamics *d = p->d;
  d->resting = true;
  if (!tp_touching_collect(&d->touching, &d->system, &d->state) || !tp_record_phases(d, false)) {
    return over(p, TP_RUN_NO_MEMORY);
  }
  tp_begin_wait(d);
  const tp_resolved now = tp_resolve_rest(d);
  if (now == TP_RESOLVED_MOVES) return begin_motion(p);
  if (now == TP_RESOLVED_NO_MEMORY || !tp_record_moment(d)) return over(p, TP_RUN_NO_MEMORY);
  return true;
}

static bool begin(progress *p) {
  tp_dynamics *d = p->d;
  d->first_energy = tp_motion_energy(&d->system, d->state.speed);
  d->moved = d->first_energy > 0;
  if (!d->moved) return begin_at_rest(p);
  if (!go_on(p)) return false;
  return tp_record_moment(d) ? true : over(p, TP_RUN_NO_MEMORY);
}

tp_run_end tp_rigid_contact_run(tp_body_state *last, tp_rigid_contact_account *account,
                                const tp_run *run, const tp_rigid_contact_settings *settings,
                                tp_message *message) {
  tp_dynamics d = {.run = run, .settings = settings, .message = message};
  progress p = {.d = &d, .step = first_step, .next_moment = INFINITY};
  if (!tp_contact_system_init(&d.system, run->body, run->drive, &run->start)) {
    if (!d.system.too_many) return TP_RUN_NO_MEMORY;
    (void)tp_fail(message, TP_UNDECIDED, (tp_place){0},
                  "more than %d pairs of corners and faces may touch; give block and base fewer "
                  "points",
                  TP_BUDGET_RIGID_PAIRS);
    return TP_RUN_UNDECIDED;
  }
  d.state = tp_motion_of(&d.system, &run->start);
  d.smooth.system = &d.system;
  p.end = run->longest_s / d.system.time_unit_s;
  if (run->moments_every_s > 0) p.next_moment = run->moments_every_s / d.system.time_unit_s;
  (void)begin(&p);
  while (!p.is_over) advance(&p);
  d.account.evaluations = d.smooth.evaluations;
  if (last != NULL) *last = tp_motion_told(&d.system, &d.state);
  if (account != NULL) *account = d.account;
  if (run->steps != NULL) *run->steps = p.work;
  tp_touching_clear(&d.touching);
  tp_contact_system_clear(&d.system);
  free(d.known);
  return p.how;
}
