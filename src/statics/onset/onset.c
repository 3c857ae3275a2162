/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Windows of motion of one case (docs/mechanics.md section 6a) with the friction of the scene, or
 * in a fixed point with friction by Barton's law at the onset; then motions at the tilt, ranges and
 * the factor of the onset. */

#include "onset/onset.h"

#include "evaluation/friction.h"
#include "onset/onset_driving.h"
#include "onset/onset_motions.h"
#include "onset/onset_question.h"
#include "onset/onset_ranges.h"
#include "onset/onset_result.h"
#include "onset/onset_strength.h"

#include <stdlib.h>

void tp_onset_found_init(tp_onset_found *found) {
  arb_init(found->degrees);
  found->at_tilt = TP_NO;
}

void tp_onset_found_clear(tp_onset_found *found) {
  arb_clear(found->degrees);
}

static void clear_ranges(tp_onset *onset) {
  free(onset->ranges);
  onset->ranges = NULL;
  onset->range_count = 0;
  onset->has_ranges = false;
}

static void clear_motions(tp_onset *onset) {
  for (size_t k = 0; k < onset->motion_count; k++) free(onset->motions[k].contacts);
  free(onset->motions);
  onset->motions = NULL;
  onset->motion_count = 0;
  onset->has_motions = false;
  onset->beginning_count = 0;
}

void tp_onset_clear(tp_onset *onset) {
  free(onset->windows);
  clear_ranges(onset);
  clear_motions(onset);
  *onset = (tp_onset){.kind = TP_ONSET_NOT_ASKED,
                      .fos = {.state = TP_FOS_NOT_ASKED},
                      .fos_driving = {.state = TP_FOS_NOT_ASKED}};
}

/* One case at work. */
typedef struct asking {
  const tp_evaluation *e;
  tp_certainty *certainty;
  tp_case *result;
  tp_onset_found *found;
  tp_onset_asked asked;
  tp_motion_outcome outcome;
  bool has_windows;
  long first; /* of the windows: tp_onset_first_window */
  tp_motions motions;
  tp_motion_windows windows;
} asking;

static void forget(asking *a) {
  if (!a->has_windows) return;
  tp_windows_clear(&a->windows);
  tp_motions_clear(&a->motions);
  a->has_windows = false;
}

/* The windows with a friction angle; with a judge of few bits as an estimate. */
static bool find_by(asking *a, const arb_t friction, const tp_judge *judge) {
  tp_motion_question q = a->asked.question;
  q.judge = *judge;
  forget(a);
  tp_friction_set_tangent(a->asked.cones.friction, a->e, friction);
  a->outcome = tp_motions_init(&a->motions, &q);
  if (a->outcome != TP_MOTION_PROVEN) return false;
  a->outcome = tp_windows_init(&a->windows, &a->motions, &q.judge);
  if (a->outcome != TP_MOTION_PROVEN) {
    tp_motions_clear(&a->motions);
    return false;
  }
  a->has_windows = true;
  a->first = tp_onset_first_window(&a->windows, &q.judge);
  return true;
}

/* Where the judge would take zeros, first without: what is proven so rests on none. */
static bool find(asking *a, const arb_t friction) {
  const tp_judge *given = &a->asked.question.judge;
  if (given->settled) {
    tp_judge strict = *given;
    strict.settled = false;
    const bool found = find_by(a, friction, &strict);
    if (found ? a->first != TP_WINDOW_OPEN : a->outcome != TP_MOTION_OPEN) return found;
  }
  return find_by(a, friction, given);
}

/* With few bits, by what these tell: all of a search but its proof. */
static bool find_roughly(asking *a, const arb_t friction) {
  enum { FEW_BITS = 128 };
  const tp_judge few = {.bits = FEW_BITS, .precision = FEW_BITS, .settled = true};
  return (a->e->rung.bits > FEW_BITS && find_by(a, friction, &few)) || find(a, friction);
}

/* A friction angle to the onset that it gives (tp_friction_limit). */
static bool onset_of(arb_t tilt, void *context, const arb_t degrees, bool estimate) {
  asking *a = context;
  if (!(estimate ? find_roughly(a, degrees) : find(a, degrees))) return false;
  if (a->first == TP_WINDOW_OPEN) {
    a->outcome = TP_MOTION_OPEN;
    return false;
  }
  const tp_motion_window *w = a->first >= 0 ? a->windows.items + a->first : NULL;
  arb_set_si(tilt, w == NULL ? 90 : -90);
  if (w != NULL && !w->from.endless) arb_set(tilt, w->from.degrees);
  if (estimate) mag_zero(arb_radref(tilt));
  return true;
}

/* With the scene's friction; where that depends on the stress, with that at the onset. */
static void find_onset(asking *a) {
  tp_onset *onset = &a->result->onset;
  arb_t friction, tilt;
  arb_init(friction);
  arb_init(tilt);
  if (tp_friction_is_load_dependent(a->e)) {
    if (!tp_friction_meet(friction, a->e, onset_of, a, false) && a->outcome == TP_MOTION_PROVEN) {
      a->outcome = TP_MOTION_OPEN;
    }
  } else {
    tp_friction_at(friction, a->e, tilt);
    (void)onset_of(tilt, a, friction, false);
  }
  onset->friction_angle_deg = tp_result_of(a->e, friction);
  arb_clear(friction);
  arb_clear(tilt);
}

static void tell_onset(asking *a) {
  const tp_onset_telling t = {a->e,        a->certainty, a->result, &a->asked.question,
                              &a->motions, &a->windows};
  if (a->first >= 0) arb_set(a->found->degrees, a->windows.items[a->first].from.degrees);
  if (!tp_onset_describe(&t, a->first)) a->outcome = TP_MOTION_OUT_OF_MEMORY;
}

/* Where they stay open, or are too dear, the rest is told without them. */
static void set_motions(asking *a, const arb_t tilt) {
  const tp_onset_telling t = {a->e,        a->certainty, a->result, &a->asked.question,
                              &a->motions, &a->windows};
  const tp_motion_outcome outcome = tp_onset_motions(&t, tilt, a->found->at_tilt != TP_NO);
  const bool missing = a->found->at_tilt == TP_YES && a->result->onset.motion_count == 0 &&
                       tp_onset_has_strength(a->e); /* a slide that a bond cannot balance */
  if (outcome == TP_MOTION_PROVEN && !missing) return;
  clear_motions(&a->result->onset);
  if (outcome == TP_MOTION_OUT_OF_MEMORY) a->outcome = outcome;
  if (outcome == TP_MOTION_OPEN && !a->asked.question.judge.settled) a->certainty->open = true;
}

/* Likewise which motions can begin at every tilt, where that was asked for. */
static void set_ranges(asking *a) {
  if (!a->e->tells_ranges) return;
  const tp_onset_telling t = {a->e,        a->certainty, a->result, &a->asked.question,
                              &a->motions, &a->windows};
  const tp_motion_outcome outcome = tp_onset_ranges(&t);
  if (outcome == TP_MOTION_PROVEN) return;
  clear_ranges(&a->result->onset);
  if (outcome == TP_MOTION_OUT_OF_MEMORY) a->outcome = outcome;
  if (outcome == TP_MOTION_OPEN && !a->asked.question.judge.settled) a->certainty->open = true;
}

/* Likewise by how much its strength has to change until that changes. */
static void set_strength(asking *a, const arb_t tilt) {
  if (!tp_onset_asks_strength(a->e)) return;
  const tp_onset_telling t = {a->e,        a->certainty, a->result, &a->asked.question,
                              &a->motions, &a->windows};
  const tp_motion_outcome outcome =
      tp_onset_strength(&t, &a->asked, tilt, a->found->at_tilt != TP_NO);
  if (outcome == TP_MOTION_OUT_OF_MEMORY) a->outcome = outcome;
  if (outcome == TP_MOTION_OPEN && !a->asked.question.judge.settled) a->certainty->open = true;
}

/* By how much the driving loads have to change until that changes. */
static void set_driving(asking *a, const arb_t tilt) {
  const tp_onset_telling t = {a->e,        a->certainty, a->result, &a->asked.question,
                              &a->motions, &a->windows};
  const tp_motion_outcome outcome = tp_onset_driving(&t, &a->asked, tilt, a->found->at_tilt);
  if (outcome == TP_MOTION_OUT_OF_MEMORY) a->outcome = outcome;
  if (outcome == TP_MOTION_OPEN && !a->asked.question.judge.settled) a->certainty->open = true;
}

/* Can a motion begin at the scene's tilt, with the friction there, and which? */
static void look_at_tilt(asking *a) {
  const tp_quantity *given = &a->e->problem->scene->tilt_angle_deg;
  tp_onset *onset = &a->result->onset;
  onset->fos = (tp_fos){.state = given->given ? TP_FOS_NOT_ASKED : TP_FOS_NO_TILT};
  onset->fos_driving = onset->fos;
  if (!given->given) return;
  onset->fos_driving.state = TP_FOS_UNDECIDED;
  if (tp_onset_asks_strength(a->e)) onset->fos.state = TP_FOS_UNDECIDED;
  arb_t tilt, friction;
  arb_init(tilt);
  arb_init(friction);
  arb_set_fmpq(tilt, given->value, a->e->rung.bits);
  tp_friction_at(friction, a->e, tilt);
  if (!tp_friction_is_load_dependent(a->e) || find(a, friction)) {
    for (long k = 0; k < a->windows.count && a->found->at_tilt == TP_NO; k++) {
      a->found->at_tilt = tp_window_holds(a->windows.items + k, tilt);
    }
    if (a->found->at_tilt != TP_OPEN) set_motions(a, tilt);
    set_driving(a, tilt);
    set_strength(a, tilt);
  }
  arb_clear(tilt);
  arb_clear(friction);
}

/* What is open a higher rung may tell, if there is one and work is left for it. */
static void leave_open(asking *a) {
  tp_onset *onset = &a->result->onset;
  free(onset->windows);
  clear_ranges(onset);
  clear_motions(onset);
  *onset = (tp_onset){.kind = TP_ONSET_UNDECIDED,
                      .fos = {.state = TP_FOS_UNDECIDED},
                      .fos_driving = {.state = TP_FOS_UNDECIDED},
                      .mechanism = TP_MECHANISM_UNDECIDED,
                      .friction_angle_deg = onset->friction_angle_deg,
                      .too_dear = a->outcome == TP_MOTION_TOO_DEAR};
  a->found->at_tilt = TP_OPEN;
  if (!onset->too_dear) tp_certainty_leave_open(a->certainty, a->e);
}

/* The asking turned to a further tilt, which takes over its motions and windows. */
static void turn_to(asking *a, const tp_further_tilt *at) {
  a->e = at->e;
  a->certainty = at->certainty;
  a->result = at->result;
  a->found = at->onset;
  a->asked.question.work = at->e->work;
}

static void give_back(asking *a, const asking *own) {
  a->e = own->e;
  a->certainty = own->certainty;
  a->result = own->result;
  a->found = own->found;
  a->asked.question.work = own->asked.question.work;
}

/* The onset at further tilts, which is the same. */
static void tell_at_tilts(asking *a, const tp_further_tilts *tilts) {
  const asking own = *a;
  for (size_t k = 0; k < tilts->count && a->outcome == TP_MOTION_PROVEN; k++) {
    turn_to(a, tilts->items + k);
    tp_onset_clear(&a->result->onset);
    a->result->onset.friction_angle_deg = own.result->onset.friction_angle_deg;
    a->found->at_tilt = TP_NO;
    tell_onset(a);
    if (a->outcome == TP_MOTION_PROVEN) set_ranges(a);
  }
  give_back(a, &own);
}

/* What can begin there. It comes last: where friction depends on the load each has windows of its
 * own. */
static void look_at_tilts(asking *a, const tp_further_tilts *tilts, const tp_work *spent) {
  const asking own = *a;
  for (size_t k = 0; k < tilts->count && a->outcome != TP_MOTION_OUT_OF_MEMORY; k++) {
    const tp_further_tilt *at = tilts->items + k;
    a->outcome = TP_MOTION_PROVEN;
    turn_to(a, at);
    tp_further_begin(at, spent);
    look_at_tilt(a);
    tp_further_end(at);
    if (a->outcome != TP_MOTION_PROVEN) at->certainty->open = true;
  }
  if (a->outcome != TP_MOTION_OUT_OF_MEMORY) a->outcome = own.outcome;
  give_back(a, &own);
}

bool tp_evaluate_onset(const tp_evaluation *e, tp_case *result, tp_onset_found *found,
                       const tp_further_tilts *tilts, tp_cones *cones, tp_certainty *certainty) {
  tp_onset_clear(&result->onset);
  asking a = {.e = e, .certainty = certainty, .result = result, .found = found};
  if (!tp_onset_asked_init(&a.asked, e, result->towards, cones)) return false;
  found->at_tilt = TP_NO;
  a.asked.question.keeps_all = tp_onset_asks_strength(e);
  tp_work_begin(e->work, tp_cones_column_count(&a.asked.cones));
  find_onset(&a);
  if (a.outcome == TP_MOTION_PROVEN) tell_onset(&a);
  if (a.outcome == TP_MOTION_PROVEN) set_ranges(&a);
  if (a.outcome == TP_MOTION_PROVEN) tell_at_tilts(&a, tilts);
  const tp_work spent = e->work != NULL ? *e->work : (tp_work){0};
  if (a.outcome == TP_MOTION_PROVEN) look_at_tilt(&a);
  if (a.outcome == TP_MOTION_PROVEN) look_at_tilts(&a, tilts, &spent);
  if (a.outcome == TP_MOTION_OPEN || a.outcome == TP_MOTION_TOO_DEAR) leave_open(&a);
  const bool is_told = result->onset.tie_bits != 0;
  if (a.outcome == TP_MOTION_PROVEN && a.asked.took_zero && !is_told) {
    tp_certainty_take_zero(certainty, e);
  }
  forget(&a);
  tp_onset_asked_clear(&a.asked);
  return a.outcome != TP_MOTION_OUT_OF_MEMORY;
}
