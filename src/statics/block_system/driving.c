/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Multiples of what drives turn the resultant of weights from the normal of the base to the side;
 * where weights alone act, without cohesion, the limit by its tangent tells the multiple. Else it
 * is that of a program of its own: the linear one of forces (assemblage/force_program.h), in which
 * s is the multiple. */

#include "block_system/driving.h"

#include "block_system/collapse.h"
#include "block_system/governing_case.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BITS = 128 };

void tp_driving_clear(tp_driving *d) {
  for (int axis = 0; axis < 2; axis++) {
    arb_clear(d->rests[axis]);
    arb_clear(d->pushes[axis]);
  }
  free(d->push);
  d->push = NULL;
}

/* ---- loads -------------------------------------------------------------------------------------
 */

/* Gravity points to the side by the sine of the tilt, and across by its cosine. The horizontal part
 * of the earthquake lies along the base by the cosine and lifts by the sine; a part upwards, of
 * 1 - `along`, lifts by the cosine. */
static void set_weights(tp_driving *d, const tp_resultant *r) {
  arb_t sine, cosine, upward;
  arb_init(sine);
  arb_init(cosine);
  arb_init(upward);
  tp_ball_sin_cos(sine, cosine, r->tilt_deg, BITS);
  arb_neg(d->rests[1], cosine);
  arb_set(arb_is_positive(r->tilt_deg) ? d->pushes[0] : d->rests[0], sine);
  arb_addmul(d->pushes[0], r->across, cosine, BITS);
  arb_mul(d->pushes[1], r->across, sine, BITS);
  arb_sub_ui(upward, r->along, 1, BITS);
  arb_addmul(d->pushes[0], upward, sine, BITS);
  arb_submul(d->pushes[1], upward, cosine, BITS);
  arb_clear(sine);
  arb_clear(cosine);
  arb_clear(upward);
}

/* Of other loads those that drive, and of what turns with gravity the part along the base. */
static bool set_push(tp_driving *d, const tp_built_system *s, bool left, tp_near along) {
  const tp_block_loads *others = s->loads + (left ? 1 : 0);
  const long rows = 3 * s->assemblage.free_count;
  bool any = false;
  for (long r = 0; r < rows; r++) {
    d->push[r] = tp_near_plus(others->pushing[r], tp_near_times(others->resting[r].down[0], along));
    any = any || !tp_near_is_zero(d->push[r]);
  }
  return any;
}

static void set_loads(tp_driving *d, const tp_resultant *r) {
  for (int axis = 0; axis < 2; axis++) {
    d->loads.dead[axis] = tp_ball_near_exact(d->rests[axis]);
    d->loads.live[axis] = tp_ball_near_exact(d->pushes[axis]);
  }
  if (!r->left) return;
  d->loads.dead[0] = tp_near_neg(d->loads.dead[0]);
  d->loads.live[0] = tp_near_neg(d->loads.live[0]);
}

tp_status tp_driving_init(tp_driving *d, const tp_built_system *s, const tp_resultant *r,
                          tp_message *message) {
  const tp_block_loads *others = s->loads + (r->left ? 1 : 0);
  memset(d, 0, sizeof *d);
  for (int axis = 0; axis < 2; axis++) {
    arb_init(d->rests[axis]);
    arb_init(d->pushes[axis]);
  }
  set_weights(d, r);
  set_loads(d, r);
  d->drives = !arb_is_zero(d->pushes[0]) || !arb_is_zero(d->pushes[1]);
  if (others->applied == NULL) return TP_OK;
  d->push = calloc(3 * (size_t)s->assemblage.free_count + 1, sizeof *d->push);
  if (d->push == NULL) {
    tp_driving_clear(d);
    return tp_fail_memory(message, "the driving loads");
  }
  const bool down = arb_is_positive(r->tilt_deg);
  d->loads.down[0] = down ? (tp_near){0, 0} : r->loads.down[0];
  d->loads.down[1] = r->loads.down[1];
  d->loads.applied = others->resting;
  d->loads.push = d->push;
  const bool pushed = set_push(d, s, r->left, down ? r->loads.down[0] : (tp_near){0, 0});
  d->drives = d->drives || pushed;
  return TP_OK;
}

/* ---- factor ------------------------------------------------------------------------------------
 */

void tp_driving_at_tangent(arb_t factor, const tp_driving *d, const arb_t tangent) {
  arb_t over;
  arb_init(over);
  arb_mul(over, tangent, d->pushes[1], BITS);
  arb_add(over, over, d->pushes[0], BITS);
  arb_mul(factor, tangent, d->rests[1], BITS);
  arb_add(factor, factor, d->rests[0], BITS);
  arb_neg(factor, factor);
  if (arb_is_positive(over)) {
    arb_div(factor, factor, over, BITS);
  } else {
    arb_pos_inf(factor);
  }
  arb_clear(over);
}

static double factor_at(const tp_driving *d, double tangent) {
  arb_t at;
  arb_init(at);
  arb_set_d(at, tangent);
  tp_driving_at_tangent(at, d, at);
  const double factor = arf_get_d(arb_midref(at), ARF_RND_NEAR);
  arb_clear(at);
  return factor;
}

/* How all begins to move beyond it. */
static tp_status set_mechanism(tp_system_case *own, const tp_built_system *s,
                               const tp_load_bracket *b, tp_message *message) {
  tp_system_case beyond = {.motion_count = (size_t)s->assemblage.count};
  beyond.motions = calloc(beyond.motion_count, sizeof *beyond.motions);
  if (beyond.motions == NULL) return tp_fail_memory(message, "the motions");
  const tp_status status = tp_collapse_motions(beyond.motions, &s->assemblage, b->twists, message);
  own->fos_driving_mechanism = tp_system_case_mechanism(&beyond);
  free(beyond.motions);
  return status;
}

/* Of multiples between two that are proven, each outwards by its rounding. */
static void set_factor(tp_fos *fos, double held, double bound) {
  const double most = fmax(fabs(held), fabs(bound)), rounding = 4 * DBL_EPSILON * most;
  const double value = held + (bound - held) / 2;
  fos->state = bound < 0 ? TP_FOS_UNDEFINED : TP_FOS_NUMBER;
  fos->value = (tp_bounded){.value = value, .error = fmax(bound - value, value - held) + rounding};
}

/* Of a bracket of multiples, or of the tangent of the resultant. Multiples that are held lie
 * between two: where one is not, and a greater one is, none is not. */
static tp_status take(tp_system_case *own, const tp_driving *d, const tp_built_system *s,
                      const tp_load_bracket *b, bool by_tilt, tp_message *message) {
  const double held = by_tilt ? factor_at(d, b->held) : b->held;
  const double bound = by_tilt ? factor_at(d, b->bound) : b->bound;
  const bool farther = own->verdict == TP_SYSTEM_COLLAPSES && b->is_held && held >= 1;
  own->fos_driving.state = farther ? TP_FOS_UNDEFINED : TP_FOS_UNDECIDED;
  if (farther) return TP_OK;
  own->fos_driving_is_least = b->is_held && held > TP_MOST_FACTOR;
  if (own->fos_driving_is_least) {
    own->fos_driving = (tp_fos){TP_FOS_NUMBER, {.value = TP_MOST_FACTOR}};
  }
  if (own->fos_driving_is_least || !b->is_held || !b->is_bounded || isinf(bound)) return TP_OK;
  set_factor(&own->fos_driving, held, bound);
  return set_mechanism(own, s, b, message);
}

/* Where forces hold the blocks at every tilt below 90 degrees, and multiples of what drives would
 * turn the resultant beyond that, as an earthquake lifts: the tilt does not tell how far. */
static bool is_beyond_tilts(const tp_driving *d, const tp_load_bracket *side) {
  return side->is_held && !side->is_bounded && side->held > TP_MOST_LOAD &&
         !(factor_at(d, side->held) > TP_MOST_FACTOR);
}

tp_status tp_driving_factor_find(tp_system_case *own, const tp_driving *d, const tp_built_system *s,
                                 const tp_load_bracket *side, tp_message *message) {
  own->fos_driving.state = TP_FOS_NO_OVERTURNING;
  if (!d->drives) return TP_OK;
  const bool by_tilt = !s->is_measured && !is_beyond_tilts(d, side);
  if (by_tilt) return take(own, d, s, side, true, message);
  const tp_system_state state = {d->loads, 1};
  tp_load_bracket b;
  tp_status status = tp_state_limit_find(&b, s, &state, NULL, message);
  if (status != TP_OK) return status;
  status = take(own, d, s, &b, false, message);
  tp_load_bracket_clear(&b);
  return status;
}

/* ---- motions -----------------------------------------------------------------------------------
 */

/* The multiple that turns the resultant as a tilt does. */
static double factor_at_tilt(const tp_driving *d, const tp_resultant *r, double degrees) {
  static const double right_angle = 90;
  arb_t angle, sine;
  arb_init(angle);
  arb_init(sine);
  arb_set_d(angle, degrees);
  arb_add(angle, angle, r->earthquake_deg, BITS);
  double factor = INFINITY;
  if (arf_cmp_d(arb_midref(angle), right_angle) < 0) {
    tp_ball_sin_cos(sine, angle, angle, BITS);
    arb_div(sine, sine, angle, BITS);
    tp_driving_at_tangent(sine, d, sine);
    factor = arf_get_d(arb_midref(sine), ARF_RND_NEAR);
  }
  arb_clear(angle);
  arb_clear(sine);
  return factor;
}

double tp_driving_of_angles(tp_system_case *own, const tp_driving *d, const tp_resultant *r) {
  double standing = 1;
  if (!d->drives) return standing;
  own->has_standing_fos_driving = own->has_standing_angle;
  if (own->has_standing_angle) {
    /* rounded down, but as they lie it is 1 */
    standing = fmax(1, nextafter(factor_at_tilt(d, r, own->standing_angle_deg), 0));
    own->standing_fos_driving = fmin(standing, TP_MOST_FACTOR);
  }
  if (!own->has_moving_angle) return standing;
  own->moving_fos_driving = nextafter(factor_at_tilt(d, r, own->moving_angle_deg), INFINITY);
  own->has_moving_fos_driving = own->moving_fos_driving <= TP_MOST_FACTOR;
  return standing;
}
