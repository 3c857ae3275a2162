/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "stability/onset.h"

#include "motion/windows.h"
#include "number/ball.h"
#include "stability/friction.h"
#include "stability/loaded.h"
#include "stability/onset_question.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void tp_onset_found_init(tp_onset_found *found) {
  arb_init(found->degrees);
  found->at_tilt = TP_NO;
}

void tp_onset_found_clear(tp_onset_found *found) {
  arb_clear(found->degrees);
}

void tp_onset_clear(tp_onset *onset) {
  free(onset->windows);
  for (size_t k = 0; k < onset->motion_count; k++) free(onset->motions[k].contacts);
  free(onset->motions);
  *onset = (tp_onset){.kind = TP_ONSET_NOT_ASKED};
}

/* One case at work. */
typedef struct asking {
  tp_evaluation *e;
  tp_case *result;
  tp_onset_found *found;
  tp_motion_question *q;
  tp_motions motions;
  tp_motion_windows windows;
} asking;

static void leave_open(asking *a, bool too_dear) {
  tp_onset *onset = &a->result->onset;
  onset->kind = TP_ONSET_UNDECIDED;
  onset->mechanism = TP_MECHANISM_UNDECIDED;
  onset->too_dear = too_dear;
  a->found->at_tilt = TP_OPEN;
  if (!too_dear && !tp_evaluation_is_last_rung(a->e)) a->e->certain = false;
}

/* The centre of a ray's rotation, (-v_y, v_x) / theta, in metres of the scene. */
static void set_centre(asking *a, long ray) {
  tp_evaluation *e = a->e;
  tp_onset *onset = &a->result->onset;
  const tp_ray *own = a->motions.twists.rays + ray;
  onset->has_centre = own->axis < 0;
  if (!onset->has_centre) return;
  const tp_lattice *l = &e->problem->lattice;
  const double log2_size = (double)l->bits + log2(fmpq_get_d(l->step_m));
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  arb_div(x, own->twist.of + 1, own->twist.of + 2, e->rung.bits);
  arb_neg(x, x);
  arb_div(y, own->twist.of, own->twist.of + 2, e->rung.bits);
  if (a->result->towards == TP_TOWARDS_RIGHT) arb_neg(x, x);
  tp_loaded_metres(x, y, e);
  onset->centre_x_m = tp_evaluation_result_within(e, x, log2_size);
  onset->centre_y_m = tp_evaluation_result_within(e, y, log2_size);
  arb_clear(x);
  arb_clear(y);
}

static bool fill_windows(asking *a) {
  const tp_motion_windows *w = &a->windows;
  tp_onset *onset = &a->result->onset;
  onset->windows = calloc((size_t)w->count + 1, sizeof *onset->windows);
  if (onset->windows == NULL) return false;
  onset->window_count = (size_t)w->count;
  for (long k = 0; k < w->count; k++) {
    const tp_motion_window *from = w->items + k;
    tp_window *own = onset->windows + k;
    own->from_below = from->from.endless;
    own->to_above = from->to.endless;
    own->begins = from->mechanism;
    if (!own->from_below) own->from_deg = tp_evaluation_result(a->e, from->from.degrees);
    if (!own->to_above) own->to_deg = tp_evaluation_result(a->e, from->to.degrees);
  }
  return true;
}

/* The window that holds level ground, or else the first above it; -1 where there is none, -2 where
 * that is open. */
static long first_window(const asking *a) {
  arb_t level;
  arb_init(level);
  long found = -1;
  for (long k = 0; k < a->windows.count && found == -1; k++) {
    const tp_motion_window *w = a->windows.items + k;
    const tp_answer holds = tp_window_holds(w, level);
    const bool above = !w->from.endless && arb_is_positive(w->from.degrees);
    if (holds == TP_YES || above) {
      found = k;
    } else if (holds == TP_OPEN) { /* its lower end is level ground, or its upper one */
      found =
          !w->from.endless && arb_contains_zero(w->from.degrees) && a->q->judge.settled ? k : -2;
    }
  }
  arb_clear(level);
  return found;
}

static void set_angle(asking *a, const tp_motion_window *w) {
  tp_onset *onset = &a->result->onset;
  const tp_limit *limit = &a->result->limit;
  onset->mechanism = w->mechanism;
  onset->tie = w->tie;
  onset->tied_with = w->tied_with;
  onset->kind = w->from.endless ? TP_ONSET_NOWHERE : TP_ONSET_AT_ANGLE;
  if (w->from.endless) return;
  arb_set(a->found->degrees, w->from.degrees);
  onset->critical_angle_deg = tp_evaluation_result(a->e, w->from.degrees);
  if (w->has_ray) set_centre(a, w->ray);
  const double error = onset->critical_angle_deg.error + limit->critical_angle_deg.error;
  const double below = limit->critical_angle_deg.value - onset->critical_angle_deg.value;
  onset->below_limit =
      limit->kind == TP_LIMIT_INTERLOCKED || (limit->kind == TP_LIMIT_AT_ANGLE && below > error);
}

/* Can a motion begin at the scene's tilt? */
static void look_at_tilt(asking *a) {
  const tp_quantity *tilt = &a->e->problem->scene->tilt_angle_deg;
  arb_t degrees;
  arb_init(degrees);
  arb_set_fmpq(degrees, tilt->value, a->e->rung.bits);
  a->found->at_tilt = TP_NO;
  for (long k = 0; k < a->windows.count && a->found->at_tilt == TP_NO && tilt->given; k++) {
    a->found->at_tilt = tp_window_holds(a->windows.items + k, degrees);
  }
  if (a->found->at_tilt == TP_OPEN && !tp_evaluation_is_last_rung(a->e)) a->e->certain = false;
  arb_clear(degrees);
}

static bool describe(asking *a) {
  tp_onset *onset = &a->result->onset;
  if (!fill_windows(a)) return false;
  const long first = first_window(a);
  if (first == -2) {
    leave_open(a, false);
    return true;
  }
  if (first >= 0) {
    set_angle(a, a->windows.items + first);
  } else {
    onset->kind = TP_ONSET_NEVER;
    onset->mechanism = TP_STANDS;
  }
  look_at_tilt(a);
  return true;
}

static tp_motion_outcome find(asking *a) {
  tp_motion_outcome outcome = tp_motions_init(&a->motions, a->q);
  if (outcome != TP_MOTION_PROVEN) return outcome;
  outcome = tp_windows_init(&a->windows, &a->motions, &a->q->judge);
  if (outcome == TP_MOTION_PROVEN) {
    if (!describe(a)) outcome = TP_MOTION_OUT_OF_MEMORY;
    tp_windows_clear(&a->windows);
  }
  tp_motions_clear(&a->motions);
  return outcome;
}

bool tp_evaluate_onset(tp_evaluation *e, tp_case *result, tp_onset_found *found) {
  tp_onset_clear(&result->onset);
  tp_onset_asked asked;
  if (!tp_onset_asked_init(&asked, e, result->towards)) return false;
  arb_t friction;
  arb_init(friction);
  tp_friction_at(friction, e, friction);
  tp_friction_tangent(asked.cones.friction, friction, e->rung.bits);
  arb_clear(friction);
  asking a = {.e = e, .result = result, .found = found, .q = &asked.question};
  tp_work_begin(e->work, tp_cones_column_count(&asked.cones));
  const tp_motion_outcome outcome = find(&a);
  if (outcome == TP_MOTION_OPEN || outcome == TP_MOTION_TOO_DEAR) {
    leave_open(&a, outcome == TP_MOTION_TOO_DEAR);
  }
  tp_onset_asked_clear(&asked);
  return outcome != TP_MOTION_OUT_OF_MEMORY;
}
