/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene of many blocks solved: for each direction the limits to both sides,
 * verdict, factor of safety, the collapse, and the motions that can begin before it. */

#include "block_system/beginnings.h"
#include "block_system/collapse.h"
#include "block_system/driving.h"
#include "block_system/goodman_bray.h"
#include "block_system/load_results.h"
#include "block_system/resultant.h"
#include "block_system/system.h"
#include "common/notes.h"
#include "number/ball.h"

#include <math.h>
#include <string.h>

typedef struct solving {
  const tp_built_system *s;
  const tp_solve_options *options;
  tp_motions_sought motions;
  tp_block_system *system;
} solving;

/* One direction. */
typedef struct direction {
  const solving *x;
  tp_system_case *own;
  tp_resultant resultant;
  tp_driving driving;
  tp_limits limits;      /* as the blocks lie */
  tp_threshold strength; /* by the logarithm of the factor */
  tp_threshold tilt;     /* where loads are measured: in radians */
} direction;

static void judge(direction *d) {
  const tp_near target = d->resultant.target;
  d->own->verdict = d->resultant.beyond                  ? TP_SYSTEM_UNDECIDED
                    : tp_limits_fail(&d->limits, target) ? TP_SYSTEM_COLLAPSES
                    : tp_limits_hold(&d->limits, target) ? TP_SYSTEM_CAN_HOLD
                                                         : TP_SYSTEM_UNDECIDED;
}

/* ---- limit -------------------------------------------------------------------------------------
 */

static tp_system_limit kind_of(const tp_load_bracket *b) {
  if (b->is_held && b->is_bounded) return TP_SYSTEM_LIMIT_NUMBER;
  return b->is_held && b->held > TP_MOST_LOAD ? TP_SYSTEM_INTERLOCKED : TP_SYSTEM_LIMIT_UNDECIDED;
}

static tp_bounded between(double low, double high) {
  const double value = low + (high - low) / 2;
  return (tp_bounded){.value = value,
                      .error = nextafter(fmax(high - value, value - low), INFINITY)};
}

static tp_system_state state_at_tilt(const void *context, double tilt) {
  return (tp_system_state){tp_resultant_at(context, tilt), 1};
}

/* Where loads are measured the tilt is no load of the program. */
static tp_status find_tilt(direction *d, tp_message *message) {
  static const double right_angle = 1.5707963, step = 0.2; /* radians */
  const double from =
      fmax(-right_angle, fmin(right_angle, d->own->tilt_angle_deg.value * right_angle / 90));
  const tp_threshold_search search = {.system = d->x->s,
                                      .state = state_at_tilt,
                                      .context = &d->resultant,
                                      .target = d->resultant.target,
                                      .from = from,
                                      .step = step,
                                      .most = right_angle - from};
  const tp_status status = tp_threshold_find(&d->tilt, &search, message);
  if (status != TP_OK) return status;
  const double degrees = 180 / acos(-1), round = 1e-13;
  /* held, but not proven to be the most: that all tilts up to 90 degrees are is another thing */
  const bool held_to_end = d->tilt.is_held && d->tilt.held >= search.from + search.most;
  d->own->limit = d->tilt.is_held && d->tilt.is_bounded ? TP_SYSTEM_LIMIT_NUMBER
                  : held_to_end                         ? TP_SYSTEM_INTERLOCKED
                                                        : TP_SYSTEM_LIMIT_UNDECIDED;
  if (d->own->limit == TP_SYSTEM_LIMIT_NUMBER) {
    d->own->critical_angle_deg = between(d->tilt.held * degrees, d->tilt.bound * degrees);
    d->own->critical_angle_deg.error += round;
  }
  return TP_OK;
}

static tp_status set_limit(direction *d, tp_message *message) {
  const tp_load_bracket *b = &d->limits.side;
  tp_system_case *own = d->own;
  const tp_system_limit kind = kind_of(b);
  if (d->x->s->is_measured) {
    own->has_acceleration = kind == TP_SYSTEM_LIMIT_NUMBER && b->held >= 0;
    if (own->has_acceleration) own->critical_acceleration_g = between(b->held, b->bound);
    return find_tilt(d, message);
  }
  own->limit = kind;
  if (kind != TP_SYSTEM_LIMIT_NUMBER) return TP_OK;
  own->critical_angle_deg = tp_resultant_tilt_deg(&d->resultant, b->held, b->bound);
  own->has_acceleration =
      tp_resultant_acceleration(&own->critical_acceleration_g, &d->resultant, b->held, b->bound) &&
      own->critical_acceleration_g.value >= 0;
  return TP_OK;
}

/* ---- factor ------------------------------------------------------------------------------------
 */

static tp_system_state state_at_strength(const void *context, double logarithm) {
  const tp_resultant *r = context;
  return (tp_system_state){r->loads, exp(logarithm)};
}

static tp_status find_factor(direction *d, tp_message *message) {
  const tp_threshold *found = &d->strength;
  const tp_threshold_search search = {.system = d->x->s,
                                      .state = state_at_strength,
                                      .context = &d->resultant,
                                      .target = d->resultant.target,
                                      .from = 0,
                                      .step = log(2),
                                      .most = log(TP_MOST_FACTOR),
                                      .limit = &d->limits.side};
  tp_fos *fos = &d->own->fos;
  fos->state = TP_FOS_NOT_ASKED;
  if (!d->x->options->strength_reduction || d->resultant.beyond) return TP_OK;
  const tp_status status = tp_threshold_find(&d->strength, &search, message);
  fos->state = found->is_held    ? TP_FOS_NUMBER
               : found->is_never ? TP_FOS_UNDEFINED
                                 : TP_FOS_UNDECIDED;
  if (status != TP_OK || !found->is_held) return status;
  d->own->fos_is_least = !found->is_bounded;
  fos->value = found->is_bounded ? between(exp(found->held), exp(found->bound))
                                 : (tp_bounded){.value = exp(found->held)};
  return TP_OK;
}

static tp_status find_factor_on_loads(direction *d, tp_message *message) {
  d->own->fos_driving.state = TP_FOS_NOT_ASKED;
  if (!d->x->options->strength_reduction || d->resultant.beyond) return TP_OK;
  return tp_driving_factor_find(d->own, &d->driving, d->x->s, &d->limits.side, message);
}

/* ---- collapse ----------------------------------------------------------------------------------
 */

/* With less strength where there is a factor; else at the limit. */
static tp_status set_collapse(direction *d, tp_message *message) {
  const bool reduced = d->strength.is_bounded && !d->strength.is_never;
  const bool measured = d->x->s->is_measured;
  const tp_load_bracket *b = reduced    ? &d->strength.collapse
                             : measured ? &d->tilt.collapse
                                        : &d->limits.side;
  if (!b->is_held || !b->is_bounded) return TP_OK;
  const tp_system_state state = reduced    ? state_at_strength(&d->resultant, d->strength.bound)
                                : measured ? state_at_tilt(&d->resultant, d->tilt.bound)
                                           : state_at_strength(&d->resultant, 0);
  d->own->has_forces = tp_system_is_weighed(d->x->system);
  d->own->motion_count = d->x->system->block_count;
  d->own->force_count = d->x->system->contact_count;
  const double scale = reduced || measured ? d->resultant.along_normal : cos(atan(b->held));
  return tp_collapse_describe(d->own, d->x->s, b, &state, scale, message);
}

/* ---- motions -----------------------------------------------------------------------------------
 */

static tp_status find_motions(direction *d, tp_message *message) {
  const tp_system_case *own = d->own;
  const bool has_tilt = own->limit == TP_SYSTEM_LIMIT_NUMBER;
  const tp_beginnings_task task = {
      .system = d->x->s,
      .resultant = &d->resultant,
      .driving = &d->driving,
      .asks_factor = d->x->options->strength_reduction,
      .verdict_alone = d->x->motions == TP_MOTIONS_AS_THEY_LIE,
      .held_factor =
          d->strength.is_bounded && !d->strength.is_never ? exp(d->strength.bound) : INFINITY,
      .held_tilt_deg =
          has_tilt ? own->critical_angle_deg.value + own->critical_angle_deg.error : INFINITY};
  return tp_beginnings_find(d->own, &task, message);
}

/* ---- cases -------------------------------------------------------------------------------------
 */

static tp_status solve_direction(direction *d, tp_message *message) {
  const tp_system_state as_it_lies = state_at_strength(&d->resultant, 0);
  d->own->tilt_angle_deg = tp_ball_bounded(d->resultant.tilt_deg);
  tp_status status = tp_limits_find(&d->limits, d->x->s, &as_it_lies, d->resultant.target, message);
  if (status == TP_OK) judge(d);
  if (status == TP_OK) status = set_limit(d, message);
  if (status == TP_OK) status = find_factor(d, message);
  if (status == TP_OK) status = find_factor_on_loads(d, message);
  if (status == TP_OK) status = set_collapse(d, message);
  if (status == TP_OK) {
    status = tp_load_results_set(d->own, d->x->s, &d->resultant, message);
  }
  if (status == TP_OK) status = tp_support_find(d->own, d->x->s, &d->resultant, message);
  if (status == TP_OK && d->x->motions != TP_MOTIONS_NONE) status = find_motions(d, message);
  if (status != TP_OK) return status;
  return tp_goodman_bray_find(&d->own->goodman_bray, d->x->s, &d->resultant,
                              tp_system_is_weighed(d->x->system), message);
}

static tp_status solve_case(const solving *x, bool left, tp_message *message) {
  direction d = {.x = x};
  tp_status status = tp_system_case_add(x->system, &d.own, message);
  if (status == TP_OK) {
    d.own->towards = left ? TP_TOWARDS_LEFT : TP_TOWARDS_RIGHT;
    status = tp_resultant_init(&d.resultant, x->s->scene, left, x->s->is_measured,
                               x->s->loads[left ? 1 : 0].applied, message);
  }
  if (status != TP_OK) return status;
  status = tp_driving_init(&d.driving, x->s, &d.resultant, message);
  if (status == TP_OK) {
    status = solve_direction(&d, message);
    tp_driving_clear(&d.driving);
  }
  d.own->has_required_fos = x->system->has_required_fos;
  if (d.own->has_required_fos) {
    d.own->meets_required = tp_system_case_meets(d.own, x->system->required_fos.value);
  }
  tp_limits_clear(&d.limits);
  tp_threshold_clear(&d.strength);
  tp_threshold_clear(&d.tilt);
  tp_resultant_clear(&d.resultant);
  return status;
}

/* Strength alone says nothing of columns that topple. */
static tp_status note_undriven(const solving *x, tp_message *message) {
  tp_block_system *own = x->system;
  bool undriven = false;
  for (size_t k = 0; k < own->case_count; k++) {
    undriven = undriven || (own->cases[k].fos_driving.state == TP_FOS_NO_OVERTURNING &&
                            own->cases[k].limit != TP_SYSTEM_INTERLOCKED);
  }
  if (!undriven || !own->has_required_fos) return TP_OK;
  return tp_notes_add(&own->notes, message, TP_CAUTION, x->s->scene->required_fos.place,
                      "no load drives the blocks to a side along x: the factor is of strength "
                      "alone, and how near they are to toppling is told by the greatest tilt and "
                      "the critical acceleration; say 'slope: {dip_deg: ...}' and draw x along it "
                      "where they stand on one");
}

static tp_status solve_cases(const solving *x, tp_message *message) {
  const tp_scene *scene = x->s->scene;
  tp_status status = TP_OK;
  if (tp_scene_asks_side(scene, true)) status = solve_case(x, true, message);
  if (status == TP_OK && tp_scene_asks_side(scene, false)) status = solve_case(x, false, message);
  return status == TP_OK ? note_undriven(x, message) : status;
}

tp_status tp_block_system_solve_as_given(tp_block_system **system, const tp_scene *scene,
                                         const tp_solve_options *options, tp_motions_sought motions,
                                         tp_message *message) {
  if (scene->many.count == 0) {
    return tp_refuse(message, TP_FAULT_KEY, scene->block.place,
                     "this scene is of one block: tp_solve takes it");
  }
  tp_built_system built;
  tp_status status = tp_built_system_init(&built, scene, message);
  if (status != TP_OK) return status;
  solving x = {.s = &built, .options = options, .motions = motions};
  status = tp_block_system_describe(&x.system, &built, message);
  if (status == TP_OK) status = solve_cases(&x, message);
  if (status == TP_OK) {
    *system = x.system;
  } else {
    tp_block_system_free(x.system);
  }
  tp_built_system_clear(&built);
  return status;
}
