/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* First the blocks are let go as they lie; where nothing moves, motions are excluded; then both are
 * followed along the divisor of strength and along the tilt. All searches are of a size that the
 * blocks give, whatever the machine. */

#include "block_system/beginnings.h"

#include "block_system/frictionless_blocks.h"
#include "block_system/from_limit.h"
#include "block_system/governing_case.h"
#include "block_system/onset_window.h"
#include "block_system/standing.h"
#include "block_system/state_limits.h"
#include "block_system/system_start.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Along which number a search goes. */
enum { BY_STRENGTH, BY_TILT, BY_DRIVING, KNOWN };

typedef struct beginnings {
  const tp_beginnings_task *task;
  tp_system_case *own;
  tp_resting resting;
  tp_arranged arranged;
  tp_moving_search moving;      /* along the logarithm of the divisor */
  tp_standing_search standing;  /* likewise */
  tp_known_proofs known[KNOWN]; /* that no motion begins, by search; of all as the blocks lie */
  long proof_work;              /* of the proof that none begins as they lie */
  bool frictionless;            /* blocks are in equilibrium without friction */
  double rest_share;    /* of what rests, where what drives is multiplied beyond all tilts */
  bool is_never_driven; /* however much what drives is multiplied, no motion can begin */
  bool moves;           /* a motion can begin as they lie, and: */
  tp_onset_window by_driving, by_strength; /* where it does, as what drives is multiplied or
                                              strength divided */
  tp_mechanism driven, weakened;           /* the motions there */
} beginnings;

static tp_status state_at_strength(bool *exists, tp_blocks_at *at, const void *context,
                                   double logarithm, tp_message *message) {
  const beginnings *b = context;
  tp_blocks_at_divisor(at, &b->resting, b->task->system, exp(logarithm));
  *exists = true;
  return tp_blocks_at_rest(at, &b->resting, b->task->resultant, message);
}

static tp_status state_at_tilt(bool *exists, tp_blocks_at *at, const void *context, double degrees,
                               tp_message *message) {
  const beginnings *b = context;
  tp_blocks_at_divisor(at, &b->resting, b->task->system, 1);
  return tp_blocks_at_tilt(exists, at, &b->resting, b->task->resultant,
                           b->task->system->is_measured, degrees, message);
}

static tp_status state_at_driving(bool *exists, tp_blocks_at *at, const void *context,
                                  double multiple, tp_message *message) {
  const beginnings *b = context;
  tp_blocks_at_divisor(at, &b->resting, b->task->system, 1);
  *exists = true;
  return tp_resting_loads(at->loads, at->central, &at->weights_alone, &b->resting,
                          &b->task->driving->loads, (tp_near){multiple, 0}, at->tension, message);
}

/* From a multiple of what drives on to all: the share of what rests falls from the inverse of that
 * multiple to nothing. */
static tp_status state_beyond(bool *exists, tp_blocks_at *at, const void *context, double share,
                              tp_message *message) {
  const beginnings *b = context;
  const tp_weight_loads *driven = &b->task->driving->loads;
  tp_weight_loads loads = *driven;
  for (int axis = 0; axis < 2; axis++) {
    const tp_near rests = tp_near_times(driven->dead[axis], (tp_near){b->rest_share, 0});
    loads.dead[axis] = tp_near_plus(driven->live[axis], rests);
    loads.live[axis] = tp_near_neg(rests);
  }
  tp_blocks_at_divisor(at, &b->resting, b->task->system, 1);
  *exists = true;
  return tp_resting_loads(at->loads, at->central, &at->weights_alone, &b->resting, &loads,
                          (tp_near){share, 0}, at->tension, message);
}

/* ---- as they lie -------------------------------------------------------------------------------
 */

static tp_status exclude_as_they_lie(bool *excluded, beginnings *b, tp_message *message) {
  *excluded = false;
  const tp_status status = tp_standing_prove(excluded, &b->standing, 0, 0, message);
  b->proof_work = b->standing.proof_work;
  for (int k = BY_TILT; k < KNOWN && *excluded; k++) {
    tp_known_proofs_copy(b->known + k, b->known + BY_STRENGTH);
  }
  if (status != TP_OK || *excluded || b->standing.left[0] == 0) return status;
  return tp_moving_prove_modes(&b->moving, 0, b->standing.left, message);
}

static void judge(tp_system_case *own, bool stands, bool moves) {
  if (stands && own->verdict != TP_SYSTEM_COLLAPSES) own->verdict = TP_SYSTEM_STANDS;
  if (moves && own->verdict == TP_SYSTEM_CAN_HOLD) own->verdict = TP_SYSTEM_MAY_MOVE;
}

/* ---- along a number ----------------------------------------------------------------------------
 */

static tp_moving_range factors(const beginnings *b) {
  static const double width = 1e-6, step = 1e-3;
  return (tp_moving_range){.from = 0,
                           .least = -log(TP_MOST_FACTOR),
                           .limit = log(fmin(b->task->held_factor, TP_MOST_SEARCHED)),
                           .width = width,
                           .step = step};
}

static tp_moving_range tilts(const beginnings *b) {
  static const double width = 1e-5, step = 1e-2, most = 89; /* degrees */
  const double tilt = b->own->tilt_angle_deg.value;
  return (tp_moving_range){.from = tilt,
                           .least = fmin(tilt, 0),
                           .limit = fmin(b->task->held_tilt_deg, most),
                           .width = width,
                           .step = step};
}

/* ---- all ---------------------------------------------------------------------------------------
 */

/* Let go as they lie; else is all excluded? */
static tp_status try_as_they_lie(bool *excluded, beginnings *b, tp_message *message) {
  *excluded = b->frictionless;
  const tp_status status = tp_moving_try(&b->moving, 0, true, message);
  if (status != TP_OK || b->moving.found || *excluded) return status;
  return exclude_as_they_lie(excluded, b, message);
}

static tp_status search_verdict(beginnings *b, tp_message *message) {
  bool excluded = false;
  const tp_status status = try_as_they_lie(&excluded, b, message);
  judge(b->own, excluded, b->moving.found);
  return status;
}

/* As they lie; else does a motion from beyond a limit reach so far? */
static tp_status find_as_they_lie(beginnings *b, tp_moving_search *turned, tp_message *message) {
  const tp_moving_range factor = factors(b), tilt = tilts(b);
  tp_moving_search *m = &b->moving;
  bool excluded = false;
  tp_status status = try_as_they_lie(&excluded, b, message);
  if (status == TP_OK && !m->found && b->task->asks_factor) {
    status = tp_moving_from_limit(m, &factor, factor.from, message);
  }
  const bool moves = m->x <= 0;
  if (status == TP_OK && moves) status = tp_moving_try(turned, tilt.from, true, message);
  if (status == TP_OK && moves && !turned->found) {
    tp_letting_go_copy(&turned->letting_go, &m->letting_go);
    status = tp_moving_prove(turned, tilt.from, m->proven, message);
  }
  if (status == TP_OK && !turned->found)
    status = tp_moving_from_limit(turned, &tilt, tilt.from, message);
  if (status == TP_OK && turned->x <= tilt.from && m->x > 0) {
    tp_letting_go_copy(&m->letting_go, &turned->letting_go);
    status = tp_moving_prove(m, 0, turned->proven, message);
  }
  judge(b->own, excluded, m->x <= 0);
  return status;
}

static tp_status search_factor(beginnings *b, tp_message *message) {
  const tp_moving_range r = factors(b);
  tp_system_case *own = b->own;
  const bool moves = b->moving.x <= 0;
  tp_status status = TP_OK;
  if (moves || !b->task->asks_factor)
    status = b->moving.found ? tp_system_start_set(own, &b->moving, message) : TP_OK;
  if (status != TP_OK || !b->task->asks_factor) return status;
  if (moves) status = tp_moving_least(&b->moving, &r, message);
  if (status == TP_OK && own->verdict == TP_SYSTEM_STANDS && own->sought == TP_SYSTEM_SOUGHT) {
    double standing = 0;
    status = tp_standing_to_limit(&standing, &b->moving, &b->standing, &r, message);
    own->has_standing_fos = true;
    own->standing_fos = standing > 0 ? fmin(nextafter(exp(standing), 0), TP_MOST_FACTOR) : 1;
    own->standing_fos_is_least = own->standing_fos >= TP_MOST_FACTOR;
  }
  own->has_moving_fos = b->moving.found;
  own->moving_fos = exp(b->moving.x);
  own->moving_fos_is_most = b->moving.x <= r.least;
  return status == TP_OK && b->moving.found && !own->has_start
             ? tp_system_start_set(own, &b->moving, message)
             : status;
}

/* Along another number than strength, with as much work. */
static tp_status init_beside(tp_standing_search *s, beginnings *b, int by, tp_moving_state *state,
                             tp_message *message) {
  tp_status status = tp_standing_init(s, &b->arranged, b->known + by, state, b, message);
  if (status == TP_OK && !tp_virtual_known_copy(&s->virtual_known, &b->standing.virtual_known)) {
    tp_standing_clear(s);
    status = tp_fail_memory(message, "a proof");
  }
  s->loads_vary = true;
  s->most_work = b->standing.most_work;
  s->proof_work = b->proof_work;
  s->by_virtual_motions = b->standing.by_virtual_motions;
  return status;
}

/* What angles say of accelerations where weights alone act. */
static void set_accelerations(tp_system_case *own, const tp_resultant *r) {
  tp_bounded found;
  own->has_standing_acceleration =
      own->has_standing_angle && tp_resultant_acceleration_of(&found, r, own->standing_angle_deg) &&
      found.value - found.error > 0;
  if (own->has_standing_acceleration) {
    own->standing_acceleration_g = nextafter(found.value - found.error, 0);
  }
  own->has_moving_acceleration = own->has_moving_angle &&
                                 tp_resultant_acceleration_of(&found, r, own->moving_angle_deg) &&
                                 found.value + found.error >= 0;
  if (own->has_moving_acceleration) {
    own->moving_acceleration_g = nextafter(found.value + found.error, INFINITY);
  }
}

static tp_status search_tilt(beginnings *b, tp_moving_search *m, tp_message *message) {
  const tp_moving_range r = tilts(b);
  tp_system_case *own = b->own;
  tp_status status = TP_OK;
  if (m->x <= r.from) status = tp_moving_least(m, &r, message);
  /* only weights alone run, between two tilts, along the line between theirs */
  const bool runs_straight = !b->task->system->is_measured;
  if (status == TP_OK && own->verdict == TP_SYSTEM_STANDS && runs_straight) {
    tp_standing_search s;
    double standing = 0;
    status = init_beside(&s, b, BY_TILT, state_at_tilt, message);
    if (status != TP_OK) return status;
    status = tp_standing_to_limit(&standing, m, &s, &r, message);
    own->has_standing_angle = true;
    own->standing_angle_deg = standing;
    tp_standing_clear(&s);
  }
  own->has_moving_angle = m->found;
  own->moving_angle_deg = m->x;
  if (runs_straight) set_accelerations(own, b->task->resultant);
  return status;
}

/* Where weights are measured the tilt does not tell it. */
static tp_status search_multiples(beginnings *b, tp_moving_search *m, tp_standing_search *s,
                                  tp_message *message) {
  static const double width = 1e-6, step = 1e-3;
  tp_system_case *own = b->own;
  const bool bounded = own->fos_driving.state == TP_FOS_NUMBER && !own->fos_driving_is_least;
  const double limit =
      bounded ? own->fos_driving.value.value + own->fos_driving.value.error : TP_MOST_SEARCHED;
  const tp_moving_range r = {
      .from = 1, .least = 1, .limit = fmin(limit, TP_MOST_SEARCHED), .width = width, .step = step};
  double standing = 1;
  tp_status status = bounded ? tp_moving_from_limit(m, &r, r.from, message) : TP_OK;
  if (status == TP_OK) status = tp_standing_to_limit(&standing, m, s, &r, message);
  own->has_standing_fos_driving = status == TP_OK;
  own->standing_fos_driving = standing > 1 ? fmin(nextafter(standing, 0), TP_MOST_FACTOR) : 1;
  own->has_moving_fos_driving = m->found && m->x <= TP_MOST_FACTOR;
  own->moving_fos_driving = m->x;
  return status;
}

/* Weights alone, of blocks that stand up to a multiple next to 90 degrees of tilt: all beyond. */
static tp_status search_beyond(beginnings *b, double multiple, tp_message *message) {
  static const double outwards = 1 + 1e-9, width = 1e-3;
  tp_standing_search s;
  double share = 0;
  tp_status status = init_beside(&s, b, BY_TILT, state_beyond, message);
  if (status != TP_OK) return status;
  b->rest_share = outwards / multiple;
  status = tp_standing_extend(&share, &s, 0, 1, width, message);
  b->is_never_driven = status == TP_OK && share >= 1;
  tp_standing_clear(&s);
  return status;
}

/* By angles. */
static tp_status search_driving_by_tilt(beginnings *b, const tp_moving_search *turned,
                                        tp_message *message) {
  const tp_system_case *own = b->own;
  const double multiple = tp_driving_of_angles(b->own, b->task->driving, b->task->resultant);
  if (own->has_moving_fos_driving) {
    return tp_system_start_mechanism(&b->own->fos_by_driving.mechanism, turned, message);
  }
  const bool to_the_end = own->has_standing_angle && own->limit == TP_SYSTEM_INTERLOCKED &&
                          own->standing_angle_deg >= tilts(b).limit && isfinite(multiple);
  return to_the_end && b->task->driving->drives ? search_beyond(b, multiple, message) : TP_OK;
}

static tp_status search_driving(beginnings *b, const tp_moving_search *turned,
                                tp_message *message) {
  tp_system_case *own = b->own;
  if (!b->task->system->is_measured) return search_driving_by_tilt(b, turned, message);
  if (!b->task->driving->drives || own->verdict != TP_SYSTEM_STANDS || !b->task->asks_factor) {
    return TP_OK;
  }
  tp_moving_search m;
  tp_standing_search s;
  tp_status status = tp_moving_init(&m, &b->resting, state_at_driving, b, message);
  if (status != TP_OK) return status;
  status = init_beside(&s, b, BY_DRIVING, state_at_driving, message);
  if (status == TP_OK) {
    status = search_multiples(b, &m, &s, message);
    tp_standing_clear(&s);
  }
  if (status == TP_OK && own->has_moving_fos_driving) {
    status = tp_system_start_mechanism(&own->fos_by_driving.mechanism, &m, message);
  }
  tp_moving_clear(&m);
  return status;
}

/* ---- next to a motion that can begin as they lie -----------------------------------------------
 */

static bool are_few(const beginnings *b) {
  enum { FEW = 6 };
  return b->resting.rows / 3 <= FEW;
}

/* From the motion as they lie along one of the numbers. */
static tp_status find_window(tp_onset_window *w, tp_mechanism *mechanism, beginnings *b, int by,
                             tp_moving_state *state, tp_message *message) {
  tp_moving_search m;
  tp_standing_search s;
  tp_status status = tp_moving_init(&m, &b->resting, state, b, message);
  if (status != TP_OK) return status;
  memcpy(m.proven, b->moving.proven, (size_t)b->resting.contact_count * sizeof *m.proven);
  tp_letting_go_copy(&m.letting_go, &b->moving.letting_go);
  status = init_beside(&s, b, by, state, message);
  if (status == TP_OK) {
    status = tp_onset_window_find(w, &m, &s, message);
    tp_standing_clear(&s);
  }
  if (status == TP_OK && m.found) status = tp_system_start_mechanism(mechanism, &m, message);
  tp_moving_clear(&m);
  return status;
}

/* Of a limit of what forces hold. */
static double upper_end(const tp_fos *fos) {
  return fos->state == TP_FOS_NUMBER ? fos->value.value + fos->value.error : 1;
}

static tp_status find_windows(beginnings *b, tp_message *message) {
  static const double width = 1e-6;
  const bool few = are_few(b);
  b->moves = true;
  const bool collapses = b->own->verdict == TP_SYSTEM_COLLAPSES;
  const tp_fos *driving = &b->own->fos_driving, *strength = &b->own->fos;
  b->by_driving = (tp_onset_window){.from = collapses ? upper_end(driving) : 1,
                                    .width = width,
                                    .collapses = collapses,
                                    .is_few = few,
                                    .moves = 1};
  b->by_strength = (tp_onset_window){.from = collapses ? log(upper_end(strength)) : 0,
                                     .least = -log(TP_MOST_FACTOR),
                                     .collapses = collapses,
                                     .width = width,
                                     .is_few = few};
  tp_status status = TP_OK;
  if (b->task->driving->drives && driving->state != TP_FOS_UNDEFINED) {
    status = find_window(&b->by_driving, &b->driven, b, BY_DRIVING, state_at_driving, message);
  }
  b->by_strength.reaches = strength->state == TP_FOS_UNDEFINED;
  if (status != TP_OK || b->by_strength.reaches) return status;
  return find_window(&b->by_strength, &b->weakened, b, BY_STRENGTH, state_at_strength, message);
}

/* Where a thousand times as much strength does not stop the motion it is no way to count. */
static void take_windows(beginnings *b) {
  tp_system_bounds *driving = &b->own->fos_by_driving, *strength = &b->own->fos_by_strength;
  const tp_onset_window *d = &b->by_driving, *w = &b->by_strength;
  tp_system_case_set_bounds(b->own);
  if (b->is_never_driven && isinf(driving->at_most)) driving->at_least = INFINITY;
  if (!b->moves) return;
  if (driving->counts && b->task->driving->drives &&
      b->own->fos_driving.state != TP_FOS_UNDEFINED) {
    driving->at_most = fmin(driving->at_most, d->moves);
    driving->at_least = d->has_stands ? fmax(0, nextafter(d->stands, 0)) : 0;
    driving->mechanism = b->driven;
  }
  if (w->reaches) *strength = (tp_system_bounds){.at_most = INFINITY};
  if (strength->counts) {
    strength->at_most = fmin(strength->at_most, nextafter(exp(w->moves), INFINITY));
    strength->at_least = w->has_stands ? nextafter(exp(w->stands), 0) : 0;
    strength->mechanism = b->weakened;
  }
  tp_system_case_settle_bounds(b->own);
}

/* ---- all cases ---------------------------------------------------------------------------------
 */

static tp_status search_both(beginnings *b, tp_message *message) {
  tp_moving_search turned;
  tp_status status = tp_moving_init(&turned, &b->resting, state_at_tilt, b, message);
  if (status != TP_OK) return status;
  status = find_as_they_lie(b, &turned, message);
  const bool moves = b->own->verdict == TP_SYSTEM_MAY_MOVE && b->task->asks_factor;
  if (status == TP_OK && moves) status = find_windows(b, message);
  if (status == TP_OK) status = search_factor(b, message);
  if (status == TP_OK) status = search_tilt(b, &turned, message);
  if (status == TP_OK) status = search_driving(b, &turned, message);
  tp_moving_clear(&turned);
  return status;
}

/* Where no forces hold the blocks, by which motion they go. */
static tp_status search_collapse(beginnings *b, tp_message *message) {
  tp_status status = tp_moving_try(&b->moving, 0, true, message);
  if (status == TP_OK && b->moving.found) {
    status = tp_system_start_set(b->own, &b->moving, message);
  }
  const bool asks = b->task->asks_factor && !b->task->verdict_alone && are_few(b);
  return status == TP_OK && asks ? find_windows(b, message) : status;
}

static tp_status search(beginnings *b, tp_message *message) {
  static const long most_work = 200000000;
  tp_status status = tp_moving_init(&b->moving, &b->resting, state_at_strength, b, message);
  if (status != TP_OK) return status;
  status = tp_arranged_init(&b->arranged, &b->resting, b->task->resultant->left, message);
  if (status == TP_OK) {
    status = tp_standing_init(&b->standing, &b->arranged, b->known + BY_STRENGTH, state_at_strength,
                              b, message);
  }
  for (int k = 0; k < KNOWN && status == TP_OK; k++) {
    status = tp_known_proofs_init(b->known + k, &b->arranged.resting, message);
  }
  b->standing.most_work = most_work;
  b->standing.loads_vary = b->task->system->has_cohesion;
  if (status == TP_OK) {
    status = b->own->verdict == TP_SYSTEM_COLLAPSES ? search_collapse(b, message)
             : b->task->verdict_alone               ? search_verdict(b, message)
                                                    : search_both(b, message);
  }
  tp_standing_clear(&b->standing);
  for (int k = 0; k < KNOWN; k++) tp_known_proofs_clear(b->known + k);
  tp_arranged_clear(&b->arranged);
  tp_moving_clear(&b->moving);
  return status;
}

static tp_system_sought how_far(const tp_built_system *s) {
  return s->assemblage.free_count > TP_MOST_MOVING_BLOCKS ? TP_SYSTEM_SOUGHT_TOO_MANY
                                                          : TP_SYSTEM_SOUGHT;
}

/* Whatever friction there is. */
static void judge_frictionless(beginnings *b) {
  if (!b->frictionless) return;
  judge(b->own, true, false);
  b->own->has_standing_fos = b->own->standing_fos_is_least = true;
  b->own->standing_fos = TP_MOST_FACTOR;
}

tp_status tp_beginnings_find(tp_system_case *own, const tp_beginnings_task *task,
                             tp_message *message) {
  beginnings b = {.task = task, .own = own};
  own->sought = how_far(task->system);
  tp_status status =
      tp_resting_init(&b.resting, &task->system->assemblage, task->system->strengths, message);
  if (status != TP_OK) return status;
  if (own->verdict != TP_SYSTEM_COLLAPSES)
    status = tp_frictionless_blocks(&b.frictionless, &b.resting, task->resultant, message);
  const bool judged = b.frictionless || own->verdict == TP_SYSTEM_COLLAPSES;
  const bool searches = own->sought != TP_SYSTEM_SOUGHT_TOO_MANY && !task->resultant->beyond;
  if (status == TP_OK && searches && !(task->verdict_alone && judged)) {
    status = search(&b, message);
  }
  if (status == TP_OK) judge_frictionless(&b);
  if (status == TP_OK) take_windows(&b);
  if (b.frictionless) own->fos_by_strength.at_least = INFINITY;
  tp_resting_clear(&b.resting);
  return status;
}
