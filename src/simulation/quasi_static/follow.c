/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The path followed. A step of the tilt that meets an event, or finds no equilibrium, is halved
 * until it is shorter than the tolerance; then the event is passed, or, where no equilibrium is
 * near, the block is released (drift.h). The cost is some log2(step / tolerance) balances an event,
 * each of a few sums over the facets.
 *
 * Towards a tilt at which the block topples the displacements of stiff springs grow without bound,
 * while the balance is that of the undisplaced block. The tilt of the collapse is a limit, and
 * stays exact. A displacement that is no longer small against the block is none that a block has:
 * the history ends with the last state below `far`. */

#include "quasi_static/follow.h"

#include "quasi_static/drift.h"
#include "quasi_static/record.h"

#include <math.h>

/* Steps of the tilt: some half a degree at the most, so that what a facet does for so long is seen.
 */
static const double longest_step = 1e-2;

/* Steps grow again. */
static const double growth = 2;

/* The history has states up to this displacement of the centroid and turn at the block's extent, in
 * extents. Springs that the weight closes by a tenth of it are refused (run.c). */
static const double far = 0.1;

/* Where a drift stays undecided, at tilts beyond it: farther by so many times, as often as this. */
static const double widening = 4;
enum { MOST_WIDER = 8 };

typedef struct follower {
  const tp_path_model *model;
  const tp_path_settings *settings;
  tp_history *history;
  tp_path_result *result;
  tp_path_state now, next;
  tp_path_state kept; /* the last that is not far, where it is none of the moments yet */
  bool has_kept;
  double step, barrier; /* the next event, or collapse, lies below `barrier` */
  bool memory;
} follower;

static void record_events(follower *f, const tp_path_state *before, const tp_path_state *after) {
  f->memory =
      f->memory && tp_path_record_events(f->history, &f->result->events, before, after, f->model);
}

static bool is_far(const follower *f) {
  const tp_three moved = tp_path_pose_of_centroid(&f->now.pose);
  return !(tp_three_size(&moved) * f->model->closure_m <= far * f->model->body->extent_m);
}

static void record_moment(follower *f) {
  if (f->history == NULL || is_far(f)) return;
  f->has_kept = false;
  f->memory = f->memory && tp_path_record_moment(f->history, &f->now, f->model);
}

/* The last equilibrium that is not far, where it is none of the moments yet. At the first tilt
 * there may be none. */
static void record_last(follower *f) {
  if (!f->has_kept) return;
  f->has_kept = false;
  f->memory = f->memory && tp_path_record_moment(f->history, &f->kept, f->model);
}

static double largest_moved_m(const follower *f) {
  double largest = 0;
  for (long k = 0; k < f->model->count; k++) {
    const tp_xy ends[] = {f->model->facets[k].from, f->model->facets[k].to};
    for (int i = 0; i < 2; i++) {
      const tp_path_frame at = tp_path_frame_at(ends[i]);
      const tp_path_pose moved = tp_path_pose_in(&f->now.pose, &at);
      largest = fmax(largest, hypot(moved.moved.of[0], moved.moved.of[1]));
    }
  }
  return largest * f->model->closure_m;
}

/* Go on from `next`. */
static void accept(follower *f) {
  const tp_path_state kept = f->now;
  f->now = f->next;
  f->next = kept;
  f->result->imbalance = fmax(f->result->imbalance, f->now.imbalance);
  if (f->history == NULL || is_far(f)) return;
  tp_path_state_copy(&f->kept, &f->now, f->model);
  f->has_kept = true;
}

/* The facets that slip and are about to stick are told as stuck: the next step finds them so. */
static void foresee(follower *f) {
  for (long k = 0; k < f->model->count; k++) {
    tp_facet_state *facet = f->next.facets + k;
    const bool slips =
        facet->shear == TP_FACET_SLIPS_ALONG || facet->shear == TP_FACET_SLIPS_AGAINST;
    if (slips && !tp_path_slip_goes_on(&f->next, f->model, k)) facet->shear = TP_FACET_STICKS;
  }
}

/* Let go at `tilt`, where no equilibrium is near, or the first beyond it where what happens is
 * sure: exactly at a limit nothing is. True: the block rests elsewhere, in `next`; else the path
 * has ended. */
static bool let_go(follower *f, double tilt) {
  tp_path_result *result = f->result;
  double beyond = fmax(tilt - f->now.tilt, f->settings->tolerance);
  result->collapses_at = tilt;
  for (int k = 0; k <= MOST_WIDER; k++) {
    const tp_drift_end end = tp_path_drift(&f->next, &result->motion, &f->now, f->model, tilt);
    if (end == TP_DRIFT_RESTS) return true;
    if (end == TP_DRIFT_MOVES_OFF) {
      result->end = TP_RUN_MOVES;
      result->collapses_at = tilt;
      record_last(f);
      f->memory = f->memory && tp_path_record_collapse(f->history, tilt, f->model);
      return false;
    }
    tilt += beyond;
    beyond *= widening;
  }
  result->end = TP_RUN_UNDECIDED;
  return false;
}

/* The first angle: placed there without stress but what is locked in, and loaded at once. Loads in
 * proportion lead to states in proportion, so one step is exact. */
static bool start(follower *f) {
  const double tilt = f->settings->from_angle;
  f->result->stands_to = tilt;
  f->result->solves++;
  f->result->stood = tp_path_state_solve(&f->next, &f->now, f->model, tilt, false) ||
                     (let_go(f, tilt) && f->next.tilt == tilt);
  if (f->result->end != TP_RUN_STANDS) return false;
  foresee(f);
  record_events(f, NULL, &f->next);
  accept(f);
  record_moment(f);
  return f->memory;
}

/* The block comes to rest elsewhere at a tilt without an equilibrium near, or the path ends. */
static void give_way(follower *f, double tilt) {
  if (!let_go(f, tilt)) return;
  if (f->result->jumps++ == 0) f->result->first_jump = f->next.tilt;
  foresee(f);
  record_events(f, &f->now, &f->next);
  f->step = f->next.tilt - f->now.tilt;
  accept(f);
  record_moment(f);
}

/* The next angle of the history, or the last one. */
static double next_stop(const follower *f) {
  const double every = f->settings->moments_every, last = f->settings->to_angle;
  if (!(every > 0)) return last;
  const double next = (floor(f->now.tilt / every * (1 + 1e-12)) + 1) * every;
  return fmin(next, last);
}

static void take_step(follower *f) {
  const double stop = next_stop(f), tolerance = f->settings->tolerance;
  double tilt = f->now.tilt + f->step;
  const bool stops = tilt >= stop;
  if (stops) tilt = stop;
  const double step = tilt - f->now.tilt;
  f->result->solves++;
  const bool found = tp_path_state_solve(&f->next, &f->now, f->model, tilt, true);
  if (found) foresee(f);
  const bool event = found && tp_path_states_differ(&f->now, &f->next, f->model);
  if (found && !event) {
    accept(f);
    if (stops) record_moment(f);
    const double left = f->barrier - f->now.tilt;
    f->step = left > 0 && isfinite(f->barrier) ? left / 2 : fmin(growth * f->step, longest_step);
    return;
  }
  if (step > tolerance) {
    if (found) f->barrier = tilt;
    f->step = step / 2;
    return;
  }
  f->barrier = INFINITY;
  f->step = growth * step;
  if (!found) {
    give_way(f, tilt);
    return;
  }
  record_events(f, &f->now, &f->next);
  accept(f);
  record_moment(f);
}

static bool may_go_on(const follower *f) {
  const tp_path_settings *s = f->settings;
  return f->memory && f->result->events + f->result->jumps < s->most_events &&
         !(s->stop != NULL && s->stop(s->context));
}

static void follow(follower *f) {
  f->result->end = TP_RUN_STANDS;
  if (!start(f)) return;
  while (f->result->end == TP_RUN_STANDS && f->now.tilt < f->settings->to_angle) {
    if (!may_go_on(f)) {
      f->result->end = TP_RUN_UNDECIDED;
      return;
    }
    take_step(f);
    f->result->stands_to = f->now.tilt;
  }
}

void tp_path_follow(tp_path_result *result, const tp_path_model *model,
                    const tp_path_settings *settings, tp_history *history) {
  follower f = {.model = model,
                .settings = settings,
                .history = history,
                .result = result,
                .step = longest_step,
                .barrier = INFINITY,
                .memory = true};
  f.memory = tp_path_state_init(&f.now, model, settings->from_angle) &&
             tp_path_state_init(&f.next, model, settings->from_angle) &&
             tp_path_state_init(&f.kept, model, settings->from_angle);
  if (f.memory) {
    follow(&f);
    if (result->stood) result->moved_m = largest_moved_m(&f);
  }
  tp_path_state_clear(&f.kept);
  tp_path_state_clear(&f.next);
  tp_path_state_clear(&f.now);
  if (!f.memory) result->end = TP_RUN_NO_MEMORY;
}
