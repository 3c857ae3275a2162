/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Results that belong together are taken together: a factor and its collapse, a motion and when it
 * begins. What is proven of all, as that no motion begins, is proven where both cases say so. */

#include "block_system/vertical_part.h"

#include "block_system/estimate.h"
#include "block_system/governing_case.h"
#include "block_system/resultant.h"

#include <math.h>

static bool is_up_dip(const tp_scene *scene, bool towards_left) {
  fmpq_t tilt;
  fmpq_init(tilt);
  tp_scene_side_tilt(tilt, scene, towards_left);
  const bool up = fmpq_sgn(tilt) < 0;
  fmpq_clear(tilt);
  return up;
}

tp_vertical_part tp_scene_vertical_part(const tp_scene *scene, bool is_measured,
                                        bool towards_left) {
  const tp_quantity *vertical = &scene->loads.vertical;
  const bool is_tilted = scene->tilt_angle_deg.given || scene->towards_left != scene->towards_right;
  const bool lies_in_place = tp_scene_lies_in_place(scene) || !is_tilted;
  if (!vertical->given || !lies_in_place) return TP_VERTICAL_COUNTS;
  const int sign = fmpq_sgn(vertical->value);
  if (sign != 0 && (is_measured || is_up_dip(scene, towards_left))) return TP_VERTICAL_MAY_ACT;
  return sign < 0 ? TP_VERTICAL_IS_LEFT : TP_VERTICAL_COUNTS;
}

#define SWAP(type, a, b)                                                                           \
  do {                                                                                             \
    type kept = (a);                                                                               \
    (a) = (b);                                                                                     \
    (b) = kept;                                                                                    \
  } while (0)

/* From the safest on. */
static int rank(tp_system_verdict verdict) {
  static const tp_system_verdict verdicts[] = {TP_SYSTEM_STANDS, TP_SYSTEM_CAN_HOLD,
                                               TP_SYSTEM_UNDECIDED, TP_SYSTEM_MAY_MOVE,
                                               TP_SYSTEM_COLLAPSES};
  int own = 0;
  while (verdicts[own] != verdict) own++;
  return own;
}

/* ---- factors and limit -------------------------------------------------------------------------
 */

/* What is left open may be anything; none at all is the least. */
static int openness(const tp_fos *fos) {
  return fos->state == TP_FOS_UNDEFINED ? 2 : fos->state == TP_FOS_UNDECIDED ? 1 : 0;
}

/* Is the other one, `least` if it is only known to be exceeded, less safe? */
static bool is_less(const tp_fos *other, bool least, const tp_fos *own, bool own_least) {
  if (openness(other) != openness(own)) return openness(other) > openness(own);
  if (other->state != TP_FOS_NUMBER) return false;
  if (own->state != TP_FOS_NUMBER || own_least) return own->state != TP_FOS_NUMBER || !least;
  return !least && other->value.value < own->value.value;
}

static int limit_rank(tp_system_limit limit) {
  return limit == TP_SYSTEM_LIMIT_UNDECIDED ? 2 : limit == TP_SYSTEM_LIMIT_NUMBER ? 1 : 0;
}

static bool has_less_limit(const tp_system_case *other, const tp_system_case *own) {
  if (other->limit != own->limit) return limit_rank(other->limit) > limit_rank(own->limit);
  return own->limit == TP_SYSTEM_LIMIT_NUMBER &&
         other->critical_angle_deg.value < own->critical_angle_deg.value;
}

/* With the velocities and the forces of its factor; where there is none, of its limit. */
static void join_factors(tp_system_case *own, tp_system_case *other, bool *without) {
  const bool less = is_less(&other->fos, other->fos_is_least, &own->fos, own->fos_is_least);
  const bool less_limit = has_less_limit(other, own);
  const tp_system_case *least = less ? other : own;
  const bool reduced = least->fos.state == TP_FOS_NUMBER && !least->fos_is_least;
  if (less) {
    own->fos = other->fos;
    own->fos_is_least = other->fos_is_least;
  }
  if (less_limit) {
    own->limit = other->limit;
    own->critical_angle_deg = other->critical_angle_deg;
  }
  *without = reduced ? less : less_limit;
  if (!*without) return;
  SWAP(tp_system_motion *, own->motions, other->motions);
  SWAP(tp_system_force *, own->forces, other->forces);
  own->motion_count = other->motion_count;
  own->force_count = other->force_count;
  own->has_forces = other->has_forces;
}

static void join_driving(tp_system_case *own, const tp_system_case *other) {
  if (!is_less(&other->fos_driving, other->fos_driving_is_least, &own->fos_driving,
               own->fos_driving_is_least)) {
    return;
  }
  own->fos_driving = other->fos_driving;
  own->fos_driving_is_least = other->fos_driving_is_least;
  own->fos_driving_mechanism = other->fos_driving_mechanism;
}

static void join_acceleration(tp_system_case *own, const tp_system_case *other) {
  own->has_acceleration = own->has_acceleration && other->has_acceleration;
  if (own->has_acceleration &&
      other->critical_acceleration_g.value < own->critical_acceleration_g.value) {
    own->critical_acceleration_g = other->critical_acceleration_g;
  }
}

/* ---- motions -----------------------------------------------------------------------------------
 */

static void join_standing(tp_system_case *own, const tp_system_case *other) {
  own->has_standing_fos = own->has_standing_fos && other->has_standing_fos;
  own->standing_fos = fmin(own->standing_fos, other->standing_fos);
  own->standing_fos_is_least =
      own->has_standing_fos && own->standing_fos_is_least && other->standing_fos_is_least;
  own->has_standing_fos_driving = own->has_standing_fos_driving && other->has_standing_fos_driving;
  own->standing_fos_driving = fmin(own->standing_fos_driving, other->standing_fos_driving);
  own->has_standing_angle = own->has_standing_angle && other->has_standing_angle;
  own->standing_angle_deg = fmin(own->standing_angle_deg, other->standing_angle_deg);
  own->has_standing_acceleration =
      own->has_standing_acceleration && other->has_standing_acceleration;
  own->standing_acceleration_g = fmin(own->standing_acceleration_g, other->standing_acceleration_g);
}

static void take_least(bool *has, double *least, bool also, double other) {
  if (also && (!*has || other < *least)) *least = other;
  *has = *has || also;
}

/* As they lie before one with less strength. */
static bool starts_sooner(const tp_system_case *other, const tp_system_case *own) {
  if (other->has_start != own->has_start) return other->has_start;
  return other->has_start && other->start.divisor < own->start.divisor;
}

static void join_moving(tp_system_case *own, tp_system_case *other) {
  own->moving_fos_is_most = own->moving_fos_is_most || other->moving_fos_is_most;
  take_least(&own->has_moving_fos, &own->moving_fos, other->has_moving_fos, other->moving_fos);
  take_least(&own->has_moving_fos_driving, &own->moving_fos_driving, other->has_moving_fos_driving,
             other->moving_fos_driving);
  take_least(&own->has_moving_acceleration, &own->moving_acceleration_g,
             other->has_moving_acceleration, other->moving_acceleration_g);
  take_least(&own->has_moving_angle, &own->moving_angle_deg, other->has_moving_angle,
             other->moving_angle_deg);
  if (starts_sooner(other, own)) {
    SWAP(tp_system_start, own->start, other->start);
    own->has_start = true;
  }
}

/* Of one that does not count the other counts. */
static void join_bounds(tp_system_bounds *own, const tp_system_bounds *other) {
  if (!other->counts) return;
  if (!own->counts) {
    *own = *other;
    return;
  }
  if (other->at_most < own->at_most) {
    own->at_most = other->at_most;
    own->mechanism = other->mechanism;
  }
  own->at_least = fmin(own->at_least, other->at_least);
}

/* ---- support -----------------------------------------------------------------------------------
 */

static int support_rank(tp_system_support_state state) {
  return state == TP_SYSTEM_SUPPORT_NONE        ? 3
         : state == TP_SYSTEM_SUPPORT_UNDECIDED ? 2
         : state == TP_SYSTEM_SUPPORT_NUMBER    ? 1
                                                : 0;
}

/* Forces with which no motion can begin in either case; with which one can in one of them. */
static void join_standing_support(tp_system_support *own, const tp_system_support *other) {
  own->was_sought = own->was_sought || other->was_sought;
  own->standing_n_m = fmax(own->standing_n_m, other->standing_n_m);
  own->standing_to_n_m = fmin(own->standing_to_n_m, other->standing_to_n_m);
  own->has_standing =
      own->has_standing && other->has_standing && own->standing_n_m <= own->standing_to_n_m;
  own->moving_n_m =
      fmax(own->has_moving ? own->moving_n_m : 0, other->has_moving ? other->moving_n_m : 0);
  own->has_moving = own->has_moving || other->has_moving;
}

static void join_support(tp_system_case *own, const tp_system_case *other) {
  tp_system_support joined = own->support;
  const bool known = own->support.has_goodman_bray && other->support.has_goodman_bray;
  const double by_method = fmax(own->support.goodman_bray_n_m, other->support.goodman_bray_n_m);
  const int rank_of_own = support_rank(own->support.state),
            rank_of_other = support_rank(other->support.state);
  const bool more = own->support.state == TP_SYSTEM_SUPPORT_NUMBER &&
                    other->support.force_n_m.value > own->support.force_n_m.value;
  if (rank_of_other > rank_of_own || (rank_of_other == rank_of_own && more)) {
    own->support = other->support;
  }
  own->support.has_goodman_bray = known;
  own->support.goodman_bray_n_m = by_method;
  join_standing_support(&joined, &other->support);
  own->support.was_sought = joined.was_sought;
  own->support.has_standing = joined.has_standing;
  own->support.standing_n_m = joined.standing_n_m;
  own->support.standing_to_n_m = joined.standing_to_n_m;
  own->support.has_moving = joined.has_moving;
  own->support.moving_n_m = joined.moving_n_m;
}

void tp_system_case_join(tp_system_case *own, tp_system_case *other) {
  if (rank(other->verdict) > rank(own->verdict)) own->verdict = other->verdict;
  if (other->sought != TP_SYSTEM_SOUGHT) own->sought = other->sought;
  join_factors(own, other, &own->without_vertical);
  join_driving(own, other);
  join_acceleration(own, other);
  join_standing(own, other);
  join_moving(own, other);
  join_bounds(&own->fos_by_strength, &other->fos_by_strength);
  join_bounds(&own->fos_by_driving, &other->fos_by_driving);
  tp_estimate_join(own, other);
  if (own->has_support) join_support(own, other);
}
