/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Of each state first what forces hold: the load, divisors of friction, and multiples of what
 * drives with friction that stays. Then what can begin. */

#include "solid_tilt/contact_stance.h"

#include "solid/tilting.h"
#include "solid_tilt/contact_strong.h"

/* ---- weak side ---------------------------------------------------------------------------------
 */

static void weak_init(tp_weak_side *weak) {
  *weak = (tp_weak_side){.side = TP_HOLD_OPEN, .kind = TP_HOLD_FACTOR_OPEN};
  tp_hold_load_init(&weak->load);
  tp_hold_load_init(&weak->rest);
  tp_hold_load_init(&weak->way);
}

static void weak_clear(tp_weak_side *weak) {
  tp_hold_load_clear(&weak->load);
  tp_hold_load_clear(&weak->rest);
  tp_hold_load_clear(&weak->way);
}

/* What rests, what drives, and both. */
static void set_loads(tp_weak_side *weak, const tp_contact_work *w, bool shaken) {
  const tp_scene *scene = w->given->scene;
  tp_hold_frame_rest(&weak->rest, &w->frame, scene);
  tp_hold_frame_drive(&weak->way, &w->frame, scene, shaken);
  for (int k = 0; k < 3; k++) {
    fmpq_add(weak->load.exact + k, weak->rest.exact + k, weak->way.exact + k);
    weak->load.error[k] = weak->rest.error[k] + weak->way.error[k];
    weak->drives = weak->drives || !fmpq_is_zero(weak->way.exact + k);
  }
  tp_hold_load_settle(&weak->load);
}

/* From a load that is held on: beyond it by how many ways more. */
static bool find_further(tp_weak_side *weak, tp_hold *hold) {
  weak->rests = true;
  if (!tp_hold_limit_find(&weak->limit, hold, &weak->load, &weak->way)) return false;
  weak->limit.t = tp_near_add(weak->limit.t, (tp_near){1, 0});
  return true;
}

/* By what the loads that drive it may be multiplied, where those that rest are held: less friction
 * topples nothing, however near to it that is. What is held with these loads alone, as on a face
 * that dips against them, is held up to a multiple as well. */
static bool find_driving(tp_weak_side *weak, tp_hold *hold) {
  tp_hold_side side = TP_HOLD_OPEN;
  double twist[TP_WRENCH];
  weak->limit = (tp_hold_limit){.is_endless = true};
  weak->rests = true;
  if (!weak->drives) return true;
  if (!tp_hold_load_side(&side, twist, hold, &weak->rest)) return false;
  weak->rests = side != TP_HOLD_MOVES;
  weak->limit = (tp_hold_limit){.is_open = true};
  if (side != TP_HOLD_HOLDS && weak->side == TP_HOLD_HOLDS) return find_further(weak, hold);
  return side != TP_HOLD_HOLDS || tp_hold_limit_find(&weak->limit, hold, &weak->rest, &weak->way);
}

static bool find_weak(tp_weak_side *weak, tp_contact_work *w) {
  tp_solid_contacts *own = w->results;
  if (!tp_hold_load_side(&weak->side, weak->twist, &w->hold, &weak->load)) return false;
  weak->least = w->hold.found.t;
  for (size_t n = 0; n < own->contact_count && weak->side == TP_HOLD_HOLDS; n++) {
    for (int k = 0; k < 3; k++) own->contacts[n].force[k] = w->hold.found.forces[n][k];
  }
  return tp_hold_factor(&weak->kind, &weak->factor, weak->beyond, &w->points.cones, &weak->load) &&
         find_driving(weak, &w->hold);
}

static void tell_weak(const tp_contact_work *w, const tp_weak_side *weak) {
  tp_solid_contacts *own = w->results;
  tp_solid_motion motion;
  own->has_motion = weak->side == TP_HOLD_MOVES;
  if (own->has_motion) tp_contacts_motion(&own->motion, w, weak->twist);
  own->has_fos_friction = weak->kind == TP_HOLD_FACTOR;
  if (own->has_fos_friction) own->fos_friction = tp_near_bounded(weak->factor);
  own->fos_driving_is_open = weak->rests && weak->limit.is_open;
  own->has_fos_driving = !weak->limit.is_open && !weak->limit.is_endless;
  if (!own->has_fos_driving) return;
  own->fos_driving = tp_near_bounded(weak->limit.t);
  tp_contacts_motion(&motion, w, weak->limit.twist);
  own->fos_driving_mechanism = motion.mechanism;
}

/* ---- all ---------------------------------------------------------------------------------------
 */

static bool has_earthquake(const tp_scene *scene) {
  const tp_loads_description *loads = &scene->loads;
  return (loads->horizontal.given && !fmpq_is_zero(loads->horizontal.value)) ||
         (loads->vertical.given && !fmpq_is_zero(loads->vertical.value));
}

/* Without its earthquake first, so that the forces told are those with it. */
static tp_status find_states(tp_contact_work *w, tp_strong_side *strong) {
  const tp_scene *scene = w->given->scene;
  tp_solid_contacts *own = w->results;
  const bool shaken = has_earthquake(scene);
  tp_state_ranges states[2] = {{.is_static = shaken}, {.is_static = false}};
  bool done = true;
  for (int k = 0; k < (shaken ? 2 : 1) && done; k++) {
    tp_weak_side weak;
    weak_init(&weak);
    set_loads(&weak, w, !states[k].is_static);
    done = find_weak(&weak, w) && tp_contact_strong_find(states + k, strong, w, &weak);
    if (done && !states[k].is_static) tell_weak(w, &weak);
    weak_clear(&weak);
  }
  if (!done) return tp_contacts_fail_memory(w);
  if (shaken) tp_solid_safety_add(&own->safety, states + 1);
  tp_solid_safety_add(&own->safety, states);
  const tp_motion_verdict verdict = states[shaken ? 1 : 0].verdict;
  own->verdict = own->has_motion                  ? own->motion.mechanism
                 : verdict == TP_VERDICT_STANDS   ? TP_STANDS
                 : verdict == TP_VERDICT_CAN_MOVE ? TP_MAY_MOVE
                 : strong->is_held                ? TP_MAY_MOVE
                                                  : TP_MECHANISM_UNDECIDED;
  own->has_fos = tp_solid_safety_number(&own->fos, &own->fos_mechanism, &own->safety);
  return TP_OK;
}

tp_status tp_contact_stance_find(tp_contact_work *w) {
  tp_strong_side strong;
  bool done = tp_contact_strong_init(&strong, w);
  tp_status status = done ? find_states(w, &strong) : tp_contacts_fail_memory(w);
  if (status == TP_OK && !tp_contact_strong_onsets(&strong, w)) {
    status = tp_contacts_fail_memory(w);
  }
  tp_contact_strong_clear(&strong);
  return status;
}
