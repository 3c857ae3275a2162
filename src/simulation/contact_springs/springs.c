/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A run from its settings: checks, stable step, settlement, steps with observations at fixed
 * intervals, and the end by rest, collapse, overturning or loss of the base
 * (docs/tilt_springs.md). */

#include "contact_springs/springs.h"

#include "contact_springs/record.h"
#include "contact_springs/settlement.h"
#include "contact_springs/watch.h"

#include <math.h>

/* Of the longest stable step: where none is given, and the most that may be given, as the bound is
 * sharp for a single contact. */
static const double share_chosen = 0.2;

/* Rounded corners are points of the block: the radius is below this share of its extent. */
static const double most_rounding_share = 0.01;

/* What has moved by less than the first of the block's extent, or by a hundred times what springs
 * give under its weight on the whole contact, as they do near a limit, lies where it was; what has
 * moved by the last of its extent does not. */
static const double moved_share = 1e-4, near_limit = 100, most_share = 1e-2;

/* Observations in a window of the watch; steps between two times that `stop` is asked. */
enum { OBSERVATIONS = 8, STEPS_UNASKED = 100000 };

static tp_spring_stiffness stiffness_of(const tp_spring_settings *s) {
  return (tp_spring_stiffness){s->normal_pa_m, s->shear_pa_m, s->rounding_m};
}

/* ---- settings
 * --------------------------------------------------------------------------------------------- */

double tp_springs_stable_step(const tp_spring_settings *settings, const tp_rigid_body *body) {
  const double least = tp_spring_least_area(body);
  const tp_stepper stepper = {.body = body,
                              .contacts = {.normal_pa_m = settings->normal_pa_m,
                                           .shear_pa_m = settings->shear_pa_m,
                                           .least_area_m2 = least}};
  return tp_stepper_stable_step(&stepper);
}

double tp_springs_step(const tp_spring_settings *settings, const tp_rigid_body *body) {
  return settings->time_step_s > 0 ? settings->time_step_s
                                   : share_chosen * tp_springs_stable_step(settings, body);
}

tp_status tp_springs_check(const tp_spring_settings *s, const tp_rigid_body *body, tp_place place,
                           tp_message *message) {
  if (!(s->normal_pa_m > 0) || !(s->shear_pa_m > 0) || isinf(s->normal_pa_m) ||
      isinf(s->shear_pa_m)) {
    return tp_refuse(message, TP_FAULT_RANGE, place,
                     "the springs of contacts need a normal and a shear stiffness above zero; the "
                     "paper's are 1000 and 10 GPa/m");
  }
  if (!(s->damping >= 0) || !(s->damping < 1)) {
    return tp_refuse(
        message, TP_FAULT_RANGE, place,
        "local damping takes a share of the unbalanced force: give one from 0 to below "
        "1, not %g",
        s->damping);
  }
  if (!(s->rounding_m > 0) || s->rounding_m > most_rounding_share * body->extent_m) {
    return tp_refuse(message, TP_FAULT_RANGE, place,
                     "the rounding of corners on springs must be above 0 and at most %.3g m, a "
                     "hundredth of the block's extent; the paper's is 1e-7 m",
                     most_rounding_share * body->extent_m);
  }
  const double longest = tp_springs_stable_step(s, body);
  if (!(s->time_step_s >= 0) || s->time_step_s > longest) {
    return tp_refuse(
        message, TP_FAULT_RANGE, place,
        "steps of %g s are not stable with these springs: the longest that is has %.3g "
        "s; %.1g s would do, and so would leaving it out",
        s->time_step_s, longest, share_chosen * longest);
  }
  return TP_OK;
}

/* ---- a run
 * -----------------------------------------------------------------------------------------------
 */

typedef struct running {
  const tp_run *run;
  const tp_spring_settings *settings;
  tp_stepper stepper;
  tp_spring_watch watch;
  tp_spring_record record;
  bool has_settled, collapsed, ever_collapsed, overturned;
  tp_body_state settled; /* where it was then; else where the run starts */
  double observed_every_s;
  long unasked;
  double steps;
} running;

/* Did it move, but for what its springs give? On a table that is not shaken a block that settled
 * has moved where it ever collapsed: how far soft springs give before that tells nothing. */
static bool has_moved(const running *r) {
  const tp_body_state *state = &r->stepper.state;
  const double extent = r->run->body->extent_m;
  if (r->ever_collapsed) return true;
  if (r->has_settled && r->run->drive->shaking == NULL) return false;
  const tp_xy moved = tp_xy_minus(state->moved, r->settled.moved);
  const double turned = fabs(state->turned - r->settled.turned);
  const double gives = fmax(moved_share * extent, near_limit * r->watch.give_m);
  return hypot(moved.x, moved.y) + turned * extent > fmin(gives, most_share * extent);
}

/* Is no part of the block above the base? */
static bool is_beside_base(const running *r) {
  double left = INFINITY, right = -INFINITY, base_left = INFINITY, base_right = -INFINITY;
  const tp_rigid_body *body = r->run->body;
  for (long k = 0; k < body->outline.count; k++) {
    const double x = tp_rigid_body_place(&r->stepper.state, body->outline.edges[k].from).x;
    left = fmin(left, x);
    right = fmax(right, x);
  }
  for (long k = 0; k < body->base.count; k++) {
    base_left = fmin(base_left, body->base.edges[k].from.x);
    base_right = fmax(base_right, body->base.edges[k].from.x);
  }
  return right < base_left || left > base_right;
}

static bool fit_step(running *r, tp_message *message) {
  tp_stepper *s = &r->stepper;
  const double longest = tp_stepper_stable_step(s);
  if (r->settings->time_step_s == 0) {
    s->step_s = fmin(s->step_s, share_chosen * longest);
    return true;
  }
  if (s->step_s <= longest) return true;
  (void)tp_fail(message, TP_UNDECIDED, (tp_place){0},
                "at %g s more contacts closed than steps of %g s are stable with: give %.1g s",
                s->time_s, s->step_s, share_chosen * longest);
  return false;
}

/* Steps up to a time; false when memory is exhausted or the step does not fit, which `*end` says.
 */
static bool step_until(running *r, double time_s, tp_spring_watch_news *news, tp_run_end *end,
                       tp_message *message) {
  tp_stepper *s = &r->stepper;
  *news = TP_WATCH_NOTHING;
  while (s->time_s < time_s) {
    if (!tp_stepper_evaluate(s)) {
      *end = TP_RUN_NO_MEMORY;
      return false;
    }
    if (s->contacts.changed && !fit_step(r, message)) {
      *end = TP_RUN_UNDECIDED;
      return false;
    }
    if (r->run->most_steps > 0 && r->steps >= r->run->most_steps) {
      (void)tp_fail(message, TP_UNDECIDED, (tp_place){0},
                    "at %g s its runs have taken %.3g steps, the most there are: softer springs, "
                    "longer steps or a shorter time take fewer",
                    s->time_s, r->steps);
      *end = TP_RUN_UNDECIDED;
      return false;
    }
    tp_stepper_advance(s);
    tp_turn_range_take(r->run->turns, s->state.turned - r->run->start.turned, s->time_s);
    r->unasked++;
    r->steps++;
    const tp_spring_watch_news own = tp_spring_watch_step(&r->watch, s);
    if (own != TP_WATCH_NOTHING) *news = own;
  }
  return true;
}

static bool asked_to_stop(running *r) {
  if (r->run->stop == NULL || r->unasked < STEPS_UNASKED) return false;
  r->unasked = 0;
  return r->run->stop(r->run->context);
}

/* What the watch tells, and what the whole block does: true where the run ends. */
static bool take_news(running *r, tp_spring_watch_news news, tp_run_end *end) {
  const tp_stepper *s = &r->stepper;
  bool done = true, ends = false;
  if (news == TP_WATCH_COLLAPSES && !r->collapsed) {
    r->collapsed = r->ever_collapsed = true;
    done = tp_spring_record_block(&r->record, s, TP_EVENT_COLLAPSES, fmax(0, r->watch.begun_s));
    if (r->run->until_collapse) *end = TP_RUN_MOVES, ends = true;
  }
  if (news == TP_WATCH_QUIET) {
    if (r->collapsed) done = tp_spring_record_block(&r->record, s, TP_EVENT_RESTS, s->time_s);
    r->collapsed = false;
    if (s->steady) {
      *end = r->overturned ? TP_RUN_OVERTURNED : has_moved(r) ? TP_RUN_RESTS : TP_RUN_STANDS;
      ends = true;
    }
  }
  if (done && !r->overturned && fabs(s->state.turned - r->run->start.turned) > acos(0)) {
    r->overturned = true;
    done = tp_spring_record_block(&r->record, s, TP_EVENT_OVERTURNS, s->time_s);
  }
  if (done && !ends && is_beside_base(r)) {
    done = tp_spring_record_block(&r->record, s, TP_EVENT_LEAVES_BASE, s->time_s);
    *end = TP_RUN_LEFT_BASE;
    ends = true;
  }
  if (!done) *end = TP_RUN_NO_MEMORY;
  return ends || !done;
}

/* A block that still creeps is not known to rest: where that alone is asked, it counts as one that
 * begins to move. */
static tp_run_end end_of_time(const running *r) {
  if (r->overturned) return TP_RUN_OVERTURNED;
  if (r->collapsed) return TP_RUN_MOVES;
  if (r->watch.resting == 0) return r->run->until_collapse ? TP_RUN_MOVES : TP_RUN_UNDECIDED;
  return has_moved(r) ? TP_RUN_RESTS : TP_RUN_STANDS;
}

static tp_run_end go(running *r, tp_message *message) {
  tp_stepper *s = &r->stepper;
  tp_run_end end = TP_RUN_UNDECIDED;
  tp_spring_watch_news news;
  double observed = 0;
  while (s->time_s < r->run->longest_s) {
    observed += r->observed_every_s;
    if (s->contacts.normal_dashpot > 0 && tp_stepper_is_past_letting_go(s)) {
      s->contacts.normal_dashpot = s->contacts.shear_dashpot = 0;
    }
    if (!step_until(r, fmin(observed, r->run->longest_s), &news, &end, message)) return end;
    if (!tp_spring_record_observe(&r->record, s)) return TP_RUN_NO_MEMORY;
    if (take_news(r, news, &end)) return end;
    if (asked_to_stop(r)) return TP_RUN_UNDECIDED;
  }
  return end_of_time(r);
}

/* From the state where the run starts to the first forces. */
static bool begin(running *r) {
  tp_stepper *s = &r->stepper;
  s->damping = r->settings->damping;
  const tp_settlement settlement = tp_stepper_settle(s, &r->run->start, share_chosen);
  if (settlement == TP_SETTLEMENT_NO_MEMORY) return false;
  r->has_settled = settlement == TP_SETTLEMENT_REACHED;
  r->settled = s->state;
  if (!tp_stepper_evaluate(s)) return false;
  s->step_s = r->settings->time_step_s;
  if (s->step_s == 0) s->step_s = share_chosen * tp_stepper_stable_step(s);
  tp_stepper_put_back(s);
  tp_spring_watch_init(&r->watch, s);
  r->observed_every_s = r->watch.window_s / OBSERVATIONS;
  return tp_spring_record_init(&r->record, r->run, s);
}

tp_run_end tp_springs_run(tp_body_state *last, const tp_run *run,
                          const tp_spring_settings *settings, tp_message *message) {
  running r = {.run = run, .settings = settings};
  tp_run_end end = TP_RUN_NO_MEMORY;
  if (tp_stepper_init(&r.stepper, run->body, run->drive, stiffness_of(settings)) && begin(&r)) {
    end = go(&r, message);
  }
  *last = r.stepper.state;
  if (run->steps != NULL) *run->steps = r.steps;
  tp_spring_record_clear(&r.record);
  tp_stepper_clear(&r.stepper);
  return end;
}
