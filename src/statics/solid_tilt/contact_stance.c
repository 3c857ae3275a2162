/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The verdict by the loads at the tilt, then both factors: the one on friction by loads that stay,
 * the one on what drives by friction that stays. */

#include "solid_tilt/contact_stance.h"

#include "solid/tilting.h"
#include "solid_tilt/contact_motion.h"

tp_status tp_contacts_fail_memory(const tp_contact_work *w) {
  return tp_fail_memory(w->message, "the contacts of a solid");
}

void tp_contacts_motion(tp_solid_motion *motion, const tp_contact_work *w,
                        const double twist[TP_WRENCH]) {
  tp_contact_motion(motion, &w->points, w->surface, w->given->metres_per_unit, twist);
}

/* ---- what holds --------------------------------------------------------------------------------
 */

static bool is_parallel(const fmpq a[3], const fmpq b[3]) {
  fmpq_t own, other;
  bool same = true;
  fmpq_init(own);
  fmpq_init(other);
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    fmpq_mul(own, a + i, b + j);
    fmpq_mul(other, a + j, b + i);
    same = same && fmpq_equal(own, other);
  }
  fmpq_clear(own);
  fmpq_clear(other);
  return same;
}

static bool faces_as(const fmpq a[3], const fmpq b[3]) {
  for (int k = 0; k < 3; k++) {
    if (fmpq_sgn(a + k) != fmpq_sgn(b + k)) return false;
  }
  return is_parallel(a, b);
}

/* Do the contacts lie on one line, or in one point? */
static bool is_on_line(const tp_friction_cones *cones) {
  fmpq way[3], own[3];
  bool on_line = true, has_way = false;
  for (int k = 0; k < 3; k++) {
    fmpq_init(way + k);
    fmpq_init(own + k);
  }
  for (long n = 1; n < cones->count; n++) {
    for (int k = 0; k < 3; k++) fmpq_sub(own + k, cones->cones[n].at + k, cones->cones[0].at + k);
    on_line = on_line && (!has_way || is_parallel(way, own));
    for (int k = 0; k < 3 && !has_way; k++) fmpq_set(way + k, own + k);
    has_way = !(fmpq_is_zero(way) && fmpq_is_zero(way + 1) && fmpq_is_zero(way + 2));
  }
  for (int k = 0; k < 3; k++) {
    fmpq_clear(way + k);
    fmpq_clear(own + k);
  }
  return on_line;
}

/* Where all contacts face one way nothing is wedged between them: as on a plane. On a point or a
 * line it is balanced at best, and at the limit, where some contact presses with nothing. */
static tp_mechanism held_verdict(const tp_contact_work *w, const tp_hold *hold) {
  const tp_friction_cones *cones = &w->points.cones;
  bool same = !is_on_line(cones) && hold->found.t > 0;
  for (long n = 1; n < cones->count; n++) {
    same = same && faces_as(cones->cones[0].normal, cones->cones[n].normal);
  }
  return same ? TP_STANDS : TP_MAY_MOVE;
}

/* ---- at its tilt -------------------------------------------------------------------------------
 */

/* By what the friction of all contacts may be divided. */
static tp_status find_fos_of_friction(const tp_contact_work *w, const tp_hold_load *load) {
  tp_solid_contacts *own = w->results;
  double beyond[TP_WRENCH];
  tp_hold_factor_kind kind = TP_HOLD_FACTOR_OPEN;
  tp_near factor = {0, INFINITY};
  if (!tp_hold_factor(&kind, &factor, beyond, &w->points.cones, load))
    return tp_contacts_fail_memory(w);
  own->has_fos_friction = kind == TP_HOLD_FACTOR;
  if (!own->has_fos_friction) return TP_OK;
  tp_solid_motion motion;
  own->fos_friction = tp_near_bounded(factor);
  tp_contacts_motion(&motion, w, beyond);
  own->has_fos = true;
  own->fos = own->fos_friction;
  own->fos_mechanism = motion.mechanism;
  return TP_OK;
}

static tp_status set_fos_driving(const tp_contact_work *w, const tp_hold_limit *limit) {
  tp_solid_contacts *own = w->results;
  own->fos_driving_is_open = limit->is_open;
  own->has_fos_driving = !limit->is_open && !limit->is_endless;
  if (!own->has_fos_driving) return TP_OK;
  tp_solid_motion motion;
  own->fos_driving = tp_near_bounded(limit->t);
  tp_contacts_motion(&motion, w, limit->twist);
  own->fos_driving_mechanism = motion.mechanism;
  const bool lesser = !own->has_fos || own->fos_driving.value + own->fos_driving.error <
                                           own->fos.value - own->fos.error;
  if (!lesser) return TP_OK;
  own->has_fos = true;
  own->fos = own->fos_driving;
  own->fos_mechanism = own->fos_driving_mechanism;
  return TP_OK;
}

/* By what the loads that drive it may be multiplied, where those that rest are held: less friction
 * topples nothing, however near to it that is. */
static tp_status find_fos_of_driving(const tp_contact_work *w, tp_hold *hold,
                                     const tp_hold_load *load) {
  tp_hold_load rest, way;
  tp_hold_limit limit = {.is_endless = true};
  tp_hold_side side = TP_HOLD_OPEN;
  double twist[TP_WRENCH];
  tp_hold_load_init(&rest);
  tp_hold_load_init(&way);
  tp_hold_frame_rest(&rest, &w->frame, w->given->scene);
  bool drives = false;
  for (int k = 0; k < 3; k++) {
    fmpq_sub(way.exact + k, load->exact + k, rest.exact + k);
    drives = drives || !fmpq_is_zero(way.exact + k);
  }
  tp_hold_load_settle(&way);
  bool done = !drives || tp_hold_load_side(&side, twist, hold, &rest);
  if (done && side == TP_HOLD_HOLDS) done = tp_hold_limit_find(&limit, hold, &rest, &way);
  if (done && drives && side == TP_HOLD_OPEN) limit = (tp_hold_limit){.is_open = true};
  tp_hold_load_clear(&rest);
  tp_hold_load_clear(&way);
  return done ? set_fos_driving(w, &limit) : tp_contacts_fail_memory(w);
}

static tp_status set_verdict(const tp_contact_work *w, tp_hold *hold, const tp_hold_load *load) {
  tp_solid_contacts *own = w->results;
  double twist[TP_WRENCH];
  tp_hold_side side = TP_HOLD_OPEN;
  if (!tp_hold_load_side(&side, twist, hold, load)) return tp_contacts_fail_memory(w);
  own->has_motion = side == TP_HOLD_MOVES;
  if (own->has_motion) tp_contacts_motion(&own->motion, w, twist);
  own->verdict = side == TP_HOLD_HOLDS   ? held_verdict(w, hold)
                 : side == TP_HOLD_MOVES ? own->motion.mechanism
                                         : TP_MECHANISM_UNDECIDED;
  for (size_t n = 0; n < own->contact_count && side == TP_HOLD_HOLDS; n++) {
    for (int k = 0; k < 3; k++) own->contacts[n].force[k] = hold->found.forces[n][k];
  }
  return TP_OK;
}

tp_status tp_contact_stance_find(tp_contact_work *w) {
  tp_hold_load load;
  tp_hold_load_init(&load);
  tp_hold_frame_scene(&load, &w->frame, w->given->scene);
  tp_status status = set_verdict(w, &w->hold, &load);
  if (status == TP_OK) status = find_fos_of_friction(w, &load);
  if (status == TP_OK) status = find_fos_of_driving(w, &w->hold, &load);
  tp_hold_load_clear(&load);
  return status;
}
