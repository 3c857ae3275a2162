/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene of many blocks solved: for each direction the limits to both sides,
 * verdict, factor of safety, the collapse, and the motions that can begin before it. */

#include "block_system/beginnings.h"
#include "block_system/collapse.h"
#include "block_system/driving.h"
#include "block_system/estimate.h"
#include "block_system/goodman_bray.h"
#include "block_system/governing_case.h"
#include "block_system/load_results.h"
#include "block_system/resultant.h"
#include "block_system/system.h"
#include "block_system/system_cautions.h"
#include "block_system/vertical_part.h"
#include "number/ball.h"

#include <math.h>
#include <string.h>

typedef struct solving {
  const tp_built_system *s;
  const tp_solve_options *options;
  tp_motions_sought motions;
  tp_block_system *system;
  bool falls_at_rest; /* and an earthquake holds it in one direction */
  bool has_static[2]; /* by direction, to the right and to the left: the case without earthquake */
  tp_system_case at_rest[2]; /* was solved: verdict and bounds of factors, no lists */
} solving;

/* One direction. */
typedef struct direction {
  solving *x;
  tp_system_case *own;
  tp_resultant resultant;
  tp_driving driving;
  tp_limits limits;                       /* as the blocks lie */
  tp_threshold strength;                  /* by the logarithm of the factor */
  tp_threshold tilt;                      /* where loads are measured: in radians */
  tp_interior_start by_strength, by_tilt; /* what searches of these begin from */
} direction;

/* ---- as they lie ------------------------------------------------------------------------------
 */

static tp_system_state state_at_strength(const void *context, double logarithm) {
  const tp_resultant *r = context;
  return (tp_system_state){r->loads, exp(logarithm)};
}

static void judge(direction *d) {
  const tp_near target = d->resultant.target;
  d->own->verdict = d->resultant.beyond                  ? TP_SYSTEM_UNDECIDED
                    : tp_limits_fail(&d->limits, target) ? TP_SYSTEM_COLLAPSES
                    : tp_limits_hold(&d->limits, target) ? TP_SYSTEM_CAN_HOLD
                                                         : TP_SYSTEM_UNDECIDED;
}

/* Limits to both sides: to the other one as far as what acts before the earthquake shakes, so that
 * it is known whether that is held too. */
static tp_status find_limits(direction *d, tp_message *message) {
  const tp_system_state as_it_lies = state_at_strength(&d->resultant, 0);
  const bool shakes = arb_is_positive(d->resultant.across);
  const tp_near at_rest =
      shakes ? tp_resultant_at_rest(&d->resultant, d->x->s->is_measured) : d->resultant.target;
  const tp_near target = d->resultant.target;
  const tp_interior_from from = {&d->by_strength, 0};
  tp_status status = tp_limits_find(&d->limits, d->x->s, &as_it_lies, at_rest, &from, message);
  if (status == TP_OK && !d->resultant.beyond) {
    status = tp_limits_decide(&d->limits, d->x->s, &as_it_lies, target, message);
  }
  if (status != TP_OK) return status;
  judge(d);
  if (d->own->verdict == TP_SYSTEM_CAN_HOLD && tp_limits_fail(&d->limits, at_rest)) {
    d->x->falls_at_rest = true;
  }
  return TP_OK;
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
                                      .most = right_angle - from,
                                      .start = &d->by_tilt};
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

/* The critical acceleration brings down what is held without it: loads that are held lie between
 * two, so where the scene's is not, and a greater one is, nothing is held without. */
static bool is_held_farther(const direction *d) {
  return d->own->verdict == TP_SYSTEM_COLLAPSES &&
         !tp_load_exceeds(&d->limits.side, d->resultant.target);
}

static tp_status set_limit(direction *d, tp_message *message) {
  const tp_load_bracket *b = &d->limits.side;
  tp_system_case *own = d->own;
  const tp_system_limit kind = kind_of(b);
  if (d->x->s->is_measured) {
    own->has_acceleration = kind == TP_SYSTEM_LIMIT_NUMBER && b->held >= 0 && !is_held_farther(d);
    if (own->has_acceleration) own->critical_acceleration_g = between(b->held, b->bound);
    return find_tilt(d, message);
  }
  own->limit = kind;
  if (kind != TP_SYSTEM_LIMIT_NUMBER) return TP_OK;
  own->critical_angle_deg = tp_resultant_tilt_deg(&d->resultant, b->held, b->bound);
  own->has_acceleration =
      !is_held_farther(d) &&
      tp_resultant_acceleration(&own->critical_acceleration_g, &d->resultant, b->held, b->bound) &&
      own->critical_acceleration_g.value >= 0;
  return TP_OK;
}

/* ---- factor ------------------------------------------------------------------------------------
 */

static tp_status find_factor(direction *d, tp_message *message) {
  const tp_threshold *found = &d->strength;
  const tp_threshold_search search = {.system = d->x->s,
                                      .state = state_at_strength,
                                      .context = &d->resultant,
                                      .target = d->resultant.target,
                                      .from = 0,
                                      .step = log(4),
                                      .most = log(TP_MOST_SEARCHED),
                                      .divides = true,
                                      .limit = &d->limits.side,
                                      .start = &d->by_strength};
  tp_fos *fos = &d->own->fos;
  fos->state = TP_FOS_NOT_ASKED;
  if (!d->x->options->strength_reduction || d->resultant.beyond) return TP_OK;
  const tp_status status = tp_threshold_find(&d->strength, &search, message);
  tp_interior_start_clear(&d->by_strength);
  fos->state = found->is_held    ? TP_FOS_NUMBER
               : found->is_never ? TP_FOS_UNDEFINED
                                 : TP_FOS_UNDECIDED;
  if (status != TP_OK || !found->is_held) return status;
  d->own->fos_is_least = !found->is_bounded;
  const double least = d->own->verdict == TP_SYSTEM_CAN_HOLD ? 1 : 0; /* as they are held */
  fos->value = found->is_bounded
                   ? between(exp(found->held), exp(found->bound))
                   : (tp_bounded){.value = fmax(fmin(exp(found->held), TP_MOST_FACTOR), least)};
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

/* Where that leaves open whether a motion can begin. */
static tp_status estimate(direction *d, tp_message *message) {
  if (d->resultant.beyond) return TP_OK;
  const bool asks_factor = d->x->options->strength_reduction && d->x->motions == TP_MOTIONS_ALL;
  const tp_estimate_task task = {.system = d->x->s,
                                 .resultant = &d->resultant,
                                 .driving = &d->driving,
                                 .strength = &d->strength,
                                 .asks_factor = asks_factor};
  const tp_system_verdict before = d->own->verdict;
  const tp_status status = tp_estimate_find(d->own, &task, message);
  tp_system_case_take_motion(d->own, before);
  return status;
}

/* ---- cases -------------------------------------------------------------------------------------
 */

static tp_status solve_direction(direction *d, tp_message *message) {
  d->own->tilt_angle_deg = tp_ball_bounded(d->resultant.tilt_deg);
  tp_status status = find_limits(d, message);
  if (status == TP_OK) status = set_limit(d, message);
  if (status == TP_OK) status = find_factor(d, message);
  if (status == TP_OK) status = find_factor_on_loads(d, message);
  if (status == TP_OK) status = set_collapse(d, message);
  if (status == TP_OK) {
    status = tp_load_results_set(d->own, d->x->s, &d->resultant, message);
  }
  if (status == TP_OK) status = tp_support_find(d->own, d->x->s, &d->resultant, message);
  tp_system_case_set_bounds(d->own);
  if (status == TP_OK && d->x->motions != TP_MOTIONS_NONE) status = find_motions(d, message);
  if (status == TP_OK && d->x->motions != TP_MOTIONS_NONE) status = estimate(d, message);
  if (status != TP_OK) return status;
  status = tp_goodman_bray_find(&d->own->goodman_bray, d->x->s, &d->resultant,
                                tp_system_is_weighed(d->x->system), message);
  if (status == TP_OK) {
    status = tp_goodman_bray_support(d->own, d->x->s, &d->resultant, message);
  }
  return status == TP_OK && d->x->motions == TP_MOTIONS_ALL
             ? tp_support_onset(d->own, d->x->s, &d->resultant, message)
             : status;
}

/* Of one whose verdict alone is wanted. */
static tp_status solve_verdict(direction *d, tp_message *message) {
  d->own->tilt_angle_deg = tp_ball_bounded(d->resultant.tilt_deg);
  d->own->fos.state = d->own->fos_driving.state = TP_FOS_NOT_ASKED;
  tp_status status = find_limits(d, message);
  tp_system_case_set_bounds(d->own);
  if (status == TP_OK && d->x->motions != TP_MOTIONS_NONE) {
    const tp_beginnings_task task = {.system = d->x->s,
                                     .resultant = &d->resultant,
                                     .driving = &d->driving,
                                     .verdict_alone = true,
                                     .held_factor = INFINITY,
                                     .held_tilt_deg = INFINITY};
    status = tp_beginnings_find(d->own, &task, message);
  }
  d->own->fos_by_strength = d->own->fos_by_driving = (tp_system_bounds){.at_most = INFINITY};
  return status;
}

/* With or without the vertical part of the earthquake, or without all of it. */
static tp_status solve_shaken(tp_system_case *own, solving *x, const tp_resultant_case *of,
                              bool verdict_alone, tp_message *message) {
  const bool left = of->towards_left;
  direction d = {.x = x, .own = own};
  own->towards = left ? TP_TOWARDS_LEFT : TP_TOWARDS_RIGHT;
  tp_status status =
      tp_resultant_init(&d.resultant, x->s->scene, of, x->s->loads[left ? 1 : 0].applied, message);
  if (status != TP_OK) return status;
  status = tp_driving_init(&d.driving, x->s, &d.resultant, message);
  if (status == TP_OK) {
    status = verdict_alone ? solve_verdict(&d, message) : solve_direction(&d, message);
    tp_driving_clear(&d.driving);
  }
  tp_interior_start_clear(&d.by_strength);
  tp_interior_start_clear(&d.by_tilt);
  tp_limits_clear(&d.limits);
  tp_threshold_clear(&d.strength);
  tp_threshold_clear(&d.tilt);
  tp_resultant_clear(&d.resultant);
  return status;
}

/* After the one with it; taken out of the list again. */
static tp_status join_without(solving *x, tp_system_case *with, const tp_resultant_case *of,
                              tp_message *message) {
  tp_resultant_case without_part = *of;
  tp_system_case *without;
  without_part.vertical_acts = false;
  tp_status status = tp_system_case_add(x->system, &without, message);
  if (status == TP_OK) status = solve_shaken(without, x, &without_part, false, message);
  if (status == TP_OK) tp_system_case_join(with, without);
  tp_system_case_drop_last(x->system);
  return status;
}

/* ---- without the earthquake --------------------------------------------------------------------
 */

static bool acts(const tp_quantity *share) {
  return share->given && !fmpq_is_zero(share->value);
}

static bool shakes(const tp_scene *scene) {
  const tp_loads_description *loads = &scene->loads;
  return acts(&loads->horizontal) || acts(&loads->vertical);
}

/* On a slope loads drive down-dip then. */
static bool static_side(const tp_scene *scene, bool left) {
  return scene->frame == TP_FRAME_SLOPE ? scene->slope.left : left;
}

/* Do loads besides weights act, which may drive the blocks to any side? */
static bool has_loads(const tp_loads_description *loads) {
  return loads->anchor_count > 0 || loads->support_count > 0 || loads->pressure_count > 0 ||
         loads->force_count > 0 || loads->water.given;
}

/* Of weights alone an earthquake to the side to which they drive adds to that, and one the other
 * way, where that is a case as well, takes as much: what both leave standing by some factor weights
 * alone do, too. Else, as where an earthquake to one side or a vertical part may hold the blocks,
 * factors are computed without it as well. */
static bool needs_static_factors(const tp_scene *scene) {
  const tp_loads_description *loads = &scene->loads;
  return !tp_scene_asks_side(scene, true) || !tp_scene_asks_side(scene, false) ||
         has_loads(loads) || acts(&loads->vertical) || fmpq_sgn(loads->horizontal.value) < 0;
}

static tp_status find_static(solving *x, bool left, tp_message *message) {
  const bool side = static_side(x->s->scene, left);
  const tp_resultant_case of = {side, x->s->is_measured, .is_static = true};
  tp_system_case *own;
  tp_status status = tp_system_case_add(x->system, &own, message);
  if (status == TP_OK) {
    status = solve_shaken(own, x, &of, !needs_static_factors(x->s->scene), message);
  }
  if (status == TP_OK) {
    x->at_rest[side] = (tp_system_case){.verdict = own->verdict,
                                        .fos_by_strength = own->fos_by_strength,
                                        .fos_by_driving = own->fos_by_driving};
    x->has_static[side] = true;
  }
  tp_system_case_drop_last(x->system);
  return status;
}

static tp_status join_static(tp_system_case *own, solving *x, bool left, tp_message *message) {
  const bool side = static_side(x->s->scene, left);
  if (!shakes(x->s->scene)) return TP_OK;
  const tp_status status = x->has_static[side] ? TP_OK : find_static(x, left, message);
  if (status != TP_OK) return status;
  own->has_static = true;
  own->static_verdict = x->at_rest[side].verdict;
  if (side != left && tp_scene_asks_side(x->s->scene, side)) { /* its factors are of that case */
    own->static_fos_by_strength = own->static_fos_by_driving =
        (tp_system_bounds){.at_most = INFINITY};
    return TP_OK;
  }
  own->static_fos_by_strength = x->at_rest[side].fos_by_strength;
  own->static_fos_by_driving = x->at_rest[side].fos_by_driving;
  return TP_OK;
}

/* ---- all ---------------------------------------------------------------------------------------
 */

/* Where a motion may begin before anything shakes no acceleration is critical, and none is the
 * least with which one begins. */
static void leave_out_accelerations(tp_system_case *own) {
  if (!tp_system_case_moves_at_rest(own)) return;
  own->has_acceleration = own->has_moving_acceleration = false;
}

static tp_status solve_case(solving *x, bool left, tp_message *message) {
  const tp_scene *scene = x->s->scene;
  const tp_vertical_part vertical = tp_scene_vertical_part(scene, x->s->is_measured, left);
  const tp_resultant_case of = {left, x->s->is_measured,
                                .vertical_acts = vertical != TP_VERTICAL_IS_LEFT};
  tp_system_case *own;
  tp_status status = tp_system_case_add(x->system, &own, message);
  if (status == TP_OK) status = solve_shaken(own, x, &of, false, message);
  if (status == TP_OK && vertical == TP_VERTICAL_MAY_ACT) {
    status = join_without(x, own, &of, message);
  }
  if (status == TP_OK) status = join_static(own, x, left, message);
  if (status != TP_OK) return status;
  tp_system_case_set_safety(own);
  leave_out_accelerations(own);
  own->has_required_fos = x->system->has_required_fos;
  if (own->has_required_fos) {
    own->meets_required = tp_system_case_meets(own, x->system->required_fos.value);
  }
  return TP_OK;
}

static tp_status solve_cases(solving *x, tp_message *message) {
  const tp_scene *scene = x->s->scene;
  tp_status status = TP_OK;
  if (tp_scene_asks_side(scene, true)) status = solve_case(x, true, message);
  if (status == TP_OK && tp_scene_asks_side(scene, false)) status = solve_case(x, false, message);
  if (status != TP_OK) return status;
  tp_block_system_set_safety(x->system);
  return tp_system_add_cautions(x->system, scene, x->falls_at_rest, message);
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
