/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Implicit Euler steps of the damped motion with growing step length, until it is at rest or
 * steady; a steady motion is handed to motion_of.c. */

#include "quasi_static/drift.h"

#include <math.h>

/* Time is in units in which springs give way in some 1. Steps grow twofold, then fourfold and so
 * on, until one finds no balance and is cut to a quarter. */
static const double first_step = 0.1, least_step = 1e-9, least_growth = 1.5, growth_grows = 1.25,
                    most_growth = 16, cut = 0.25;

/* At rest with forces out of balance below this share of the weight; a steady motion has more: its
 * tilt is beyond a limit by the tolerance of a path, 1e-10 at least. */
static const double at_rest = 1e-12;

/* Steady where direction and speed change by less than this from one step to the next, in which it
 * goes at least half of all its way. */
static const double steady = 1e-7;

/* Where the weight moves with the block the motion is never steady: it is off for good when it has
 * gone so far, in extents of the block. */
static const double far = 0.1;

enum { MOST_STEPS = 400 };

typedef struct drift {
  tp_three load;
  double time, growth; /* of the next step */
  double last_time;
  tp_path_pose move;                /* in it */
  tp_three velocity, last_velocity; /* of the centroid */
} drift;

static bool is_steady(const tp_three *now, const tp_three *before, const tp_three *moved,
                      double time) {
  double change = 0;
  for (int k = 0; k < 3; k++) change += fabs(now->of[k] - before->of[k]);
  return change <= steady * tp_three_size(now) &&
         tp_three_size(moved) <= 2 * time * tp_three_size(now);
}

/* Without the drag, which is known only as well as a small motion beside a large displacement. */
static bool is_at_rest(const tp_path_state *state, const drift *d, const tp_path_model *model) {
  const tp_balance balance = {
      .model = model, .lines = &state->lines, .load = d->load, .strains = state->strains};
  tp_imbalance at;
  tp_balance_at(&at, &balance, &state->pose, NULL);
  return tp_three_size(&at.force) <= at_rest + at.rounding;
}

/* The next pose after a time, searched for from where the last step leads, then from where it is.
 */
static bool solve_step(tp_path_pose *pose, const tp_balance *balance, const drift *d) {
  double left;
  const tp_path_pose before = *pose;
  if (d->last_time > 0) {
    const tp_path_pose move = tp_path_pose_in(&d->move, &pose->frame);
    tp_path_pose_add(pose, balance->over_time / d->last_time, &move.moved);
    if (tp_balance_solve(pose, &left, balance)) return true;
  }
  *pose = before;
  return tp_balance_solve(pose, &left, balance);
}

static bool is_off(const tp_path_state *state, const tp_path_model *model, const tp_three *velocity,
                   const tp_three *before, double time) {
  const tp_three moved = tp_path_pose_of_centroid(&state->pose);
  if (model->moves > 0) return tp_three_size(&moved) * model->moves > far;
  return is_steady(velocity, before, &moved, time);
}

/* One step, with which `time` grows or is cut; false: it was. */
static bool advance(tp_path_state *state, drift *d, const tp_path_model *model) {
  const tp_path_frame frame = tp_path_state_frame(state, model);
  tp_path_lines_set(&state->lines, model, &frame);
  const tp_balance balance = {.model = model,
                              .lines = &state->lines,
                              .load = d->load,
                              .strains = state->strains,
                              .over_time = d->time};
  tp_path_pose next = tp_path_pose_in(&state->pose, &frame);
  if (!solve_step(&next, &balance, d)) {
    d->time *= cut;
    d->growth = least_growth;
    return false;
  }
  d->last_velocity = d->velocity;
  d->move = (tp_path_pose){.frame = frame, .moved = next.since};
  d->velocity = tp_path_pose_of_centroid(&d->move);
  for (int k = 0; k < 3; k++) d->velocity.of[k] /= d->time;
  d->last_time = d->time;
  d->time *= d->growth;
  d->growth = fmin(growth_grows * d->growth, most_growth);
  tp_path_state_take(state, &next, &balance);
  return true;
}

tp_drift_end tp_path_drift(tp_path_state *to, tp_path_motion *motion, const tp_path_state *from,
                           const tp_path_model *model, double tilt) {
  drift d = {.load = tp_path_load(model, tilt), .time = first_step, .growth = least_growth};
  tp_path_state_copy(to, from, model);
  to->tilt = tilt;
  for (int k = 0; k < MOST_STEPS && d.time > least_step; k++) {
    if (!advance(to, &d, model)) continue;
    if (is_at_rest(to, &d, model)) {
      return tp_path_state_solve(to, to, model, tilt, false) ? TP_DRIFT_RESTS : TP_DRIFT_UNDECIDED;
    }
    if (is_off(to, model, &d.velocity, &d.last_velocity, d.last_time) &&
        (tp_path_motion_of(motion, to, model, &d.velocity) || model->moves > 0)) {
      return TP_DRIFT_MOVES_OFF;
    }
  }
  return TP_DRIFT_UNDECIDED;
}
