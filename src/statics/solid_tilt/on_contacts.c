/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* From what is proven of loads on cones of friction to results. */

#include "solid_tilt/on_contacts.h"

#include "number/near_angle.h"
#include "solid/tilting.h"
#include "solid_tilt/contact_motion.h"
#include "solid_tilt/least_way.h"

#include <math.h>
#include <stdlib.h>

typedef struct work {
  tp_solid_contacts *results;
  const tp_surface *surface;
  const tp_solid_given *given;
  tp_contact_points points;
  tp_hold hold;
  tp_hold_frame frame;
  tp_level_loads level, tilted;
  tp_message *message;
} work;

static tp_status fail_memory(const work *w) {
  return tp_fail_memory(w->message, "the contacts of a solid");
}

static void set_motion(tp_solid_motion *motion, const work *w, const double twist[TP_WRENCH]) {
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
static tp_mechanism held_verdict(const work *w, const tp_hold *hold) {
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
static tp_status find_fos_of_friction(const work *w, const tp_hold_load *load) {
  tp_solid_contacts *own = w->results;
  double beyond[TP_WRENCH];
  tp_hold_factor_kind kind = TP_HOLD_FACTOR_OPEN;
  tp_near factor = {0, INFINITY};
  if (!tp_hold_factor(&kind, &factor, beyond, &w->points.cones, load)) return fail_memory(w);
  own->has_fos_friction = kind == TP_HOLD_FACTOR;
  if (!own->has_fos_friction) return TP_OK;
  tp_solid_motion motion;
  own->fos_friction = tp_near_bounded(factor);
  set_motion(&motion, w, beyond);
  own->has_fos = true;
  own->fos = own->fos_friction;
  own->fos_mechanism = motion.mechanism;
  return TP_OK;
}

static tp_status set_fos_driving(const work *w, const tp_hold_limit *limit) {
  tp_solid_contacts *own = w->results;
  own->fos_driving_is_open = limit->is_open;
  own->has_fos_driving = !limit->is_open && !limit->is_endless;
  if (!own->has_fos_driving) return TP_OK;
  tp_solid_motion motion;
  own->fos_driving = tp_near_bounded(limit->t);
  set_motion(&motion, w, limit->twist);
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
static tp_status find_fos_of_driving(const work *w, tp_hold *hold, const tp_hold_load *load) {
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
  return done ? set_fos_driving(w, &limit) : fail_memory(w);
}

static tp_status set_verdict(const work *w, tp_hold *hold, const tp_hold_load *load) {
  tp_solid_contacts *own = w->results;
  double twist[TP_WRENCH];
  tp_hold_side side = TP_HOLD_OPEN;
  if (!tp_hold_load_side(&side, twist, hold, load)) return fail_memory(w);
  own->has_motion = side == TP_HOLD_MOVES;
  if (own->has_motion) set_motion(&own->motion, w, twist);
  own->verdict = side == TP_HOLD_HOLDS   ? held_verdict(w, hold)
                 : side == TP_HOLD_MOVES ? own->motion.mechanism
                                         : TP_MECHANISM_UNDECIDED;
  for (size_t n = 0; n < own->contact_count && side == TP_HOLD_HOLDS; n++) {
    for (int k = 0; k < 3; k++) own->contacts[n].force[k] = hold->found.forces[n][k];
  }
  return TP_OK;
}

static tp_status set_stance(const work *w, tp_hold *hold) {
  tp_hold_load load;
  tp_hold_load_init(&load);
  tp_hold_frame_scene(&load, &w->frame, w->given->scene);
  tp_status status = set_verdict(w, hold, &load);
  if (status == TP_OK) status = find_fos_of_friction(w, &load);
  if (status == TP_OK) status = find_fos_of_driving(w, hold, &load);
  tp_hold_load_clear(&load);
  return status;
}

/* ---- towards azimuths --------------------------------------------------------------------------
 */

static tp_status find_way(tp_solid_way *own, work *w, double azimuth_deg) {
  tp_hold_limit limit;
  if (!tp_level_limit(&limit, &w->hold, &w->level, &w->frame, azimuth_deg)) return fail_memory(w);
  own->has_critical = !limit.is_open && !limit.is_endless;
  if (limit.is_endless) own->mechanism = TP_INTERLOCKED;
  if (!own->has_critical) return TP_OK;
  own->critical_deg = tp_near_bounded(tp_near_arctangent(limit.t));
  set_motion(&own->motion, w, limit.twist);
  own->mechanism = own->motion.mechanism;
  return TP_OK;
}

/* Towards the azimuth of the tilt. */
static tp_status find_critical(work *w, double azimuth_deg) {
  tp_solid_contacts *own = w->results;
  tp_solid_way way = {.mechanism = TP_MECHANISM_UNDECIDED};
  const tp_status status = find_way(&way, w, azimuth_deg);
  own->has_critical = way.has_critical;
  own->critical_deg = way.critical_deg;
  own->critical_azimuth_deg = (tp_bounded){.value = azimuth_deg};
  own->critical = way.motion;
  return status;
}

static tp_status find_least(work *w) {
  tp_solid_contacts *own = w->results;
  tp_least_way least;
  if (!tp_least_way_find(&least, &w->hold, &w->level, &w->frame)) return fail_memory(w);
  own->has_critical = least.is_known && !least.is_endless;
  if (!own->has_critical) return TP_OK;
  own->critical_deg = tp_near_bounded(tp_near_arctangent(least.t));
  own->critical_azimuth_deg =
      (tp_bounded){.value = least.azimuth_deg, .error = least.azimuth_error};
  set_motion(&own->critical, w, least.twist);
  return TP_OK;
}

static tp_status find_level(work *w) {
  const tp_quantity *azimuth = &w->given->scene->tilt_azimuth_deg;
  tp_solid_contacts *own = w->results;
  tp_hold_side side;
  double twist[TP_WRENCH];
  if (!tp_hold_load_side(&side, twist, &w->hold, &w->level.load)) return fail_memory(w);
  own->is_held_level = side == TP_HOLD_HOLDS;
  own->way_count = own->is_held_level ? w->given->azimuths : 0;
  if (!own->is_held_level) return TP_OK;
  tp_status status = azimuth->given
                         ? find_critical(w, fmod(tp_surface_nearest(azimuth->value), 360))
                         : find_least(w);
  for (size_t k = 0; k < own->way_count && status == TP_OK; k++) {
    status = find_way(own->ways + k, w, own->ways[k].azimuth_deg);
  }
  return status;
}

/* ---- accelerations -----------------------------------------------------------------------------
 */

static tp_status shake_way(tp_solid_way *own, work *w) {
  tp_hold_limit limit;
  if (!tp_level_limit(&limit, &w->hold, &w->tilted, &w->frame, own->azimuth_deg)) {
    return fail_memory(w);
  }
  own->has_acceleration = !limit.is_open && !limit.is_endless;
  if (!own->has_acceleration) return TP_OK;
  tp_solid_motion motion;
  own->acceleration_g = tp_near_bounded(limit.t);
  set_motion(&motion, w, limit.twist);
  own->acceleration_mechanism = motion.mechanism;
  return TP_OK;
}

/* Towards the azimuth of the scene's earthquake. */
static tp_status shake_ahead(work *w) {
  const tp_quantity *azimuth = &w->given->scene->loads.azimuth_deg;
  tp_solid_contacts *own = w->results;
  if (!azimuth->given) return TP_OK;
  tp_solid_way way = {.azimuth_deg = fmod(tp_surface_nearest(azimuth->value), 360)};
  const tp_status status = shake_way(&way, w);
  own->has_acceleration_ahead = way.has_acceleration;
  own->acceleration_ahead_g = way.acceleration_g;
  return status;
}

/* Where forces hold it at its tilt under its weight alone. */
static tp_status find_shaken(work *w) {
  tp_solid_contacts *own = w->results;
  tp_hold_side side;
  double twist[TP_WRENCH];
  tp_least_way least;
  if (!tp_hold_load_side(&side, twist, &w->hold, &w->tilted.load)) return fail_memory(w);
  if (side != TP_HOLD_HOLDS) return TP_OK;
  if (!tp_least_way_find(&least, &w->hold, &w->tilted, &w->frame)) return fail_memory(w);
  own->has_acceleration = least.is_known && !least.is_endless;
  if (own->has_acceleration) {
    own->acceleration_g = tp_near_bounded(least.t);
    own->acceleration_azimuth_deg =
        (tp_bounded){.value = least.azimuth_deg, .error = least.azimuth_error};
    set_motion(&own->acceleration, w, least.twist);
  }
  tp_status status = shake_ahead(w);
  for (size_t k = 0; k < own->way_count && status == TP_OK; k++) {
    status = shake_way(own->ways + k, w);
  }
  return status;
}

/* ---- all ---------------------------------------------------------------------------------------
 */

static tp_status init_ways(work *w) {
  tp_solid_contacts *own = w->results;
  const size_t count = w->given->azimuths;
  own->ways = calloc(count + 1, sizeof *own->ways);
  if (own->ways == NULL) return fail_memory(w);
  for (size_t k = 0; k < count; k++) {
    own->ways[k] = (tp_solid_way){.azimuth_deg = 360.0 * (double)k / (double)count,
                                  .mechanism = TP_MECHANISM_UNDECIDED};
  }
  return TP_OK;
}

static tp_status find_all(work *w) {
  if (!tp_hold_init(&w->hold, &w->points.cones, 1)) return fail_memory(w);
  tp_status status = set_stance(w, &w->hold);
  if (status == TP_OK) status = init_ways(w);
  if (status == TP_OK) status = find_level(w);
  return status == TP_OK ? find_shaken(w) : status;
}

tp_status tp_on_contacts_solve(tp_solid_contacts *own, tp_notes *notes, const tp_centre *centre,
                               const tp_solid_given *given, tp_message *message) {
  work w = {.results = own, .surface = centre->surface, .given = given, .message = message};
  const size_t count = (size_t)given->contact_count;
  own->contacts = calloc(count + 1, sizeof *own->contacts);
  if (own->contacts == NULL) return fail_memory(&w);
  own->contact_count = count;
  tp_status status =
      tp_contact_points_init(&w.points, own->contacts, centre, given, notes, message);
  if (status == TP_OK) {
    tp_hold_frame_init(&w.frame, given->up);
    tp_level_loads_init(&w.level, &w.frame, NULL);
    tp_level_loads_init(&w.tilted, &w.frame, given->scene);
    status = find_all(&w);
    tp_hold_clear(&w.hold);
    tp_level_loads_clear(&w.level);
    tp_level_loads_clear(&w.tilted);
    tp_hold_frame_clear(&w.frame);
  }
  tp_contact_points_clear(&w.points);
  return status;
}

/* Rows of tables have the stance of the band that governs: on contacts there is none, and its place
 * behind those that are counted has theirs. */
void tp_on_contacts_row(tp_solid_band *row, const tp_solid_contacts *contacts) {
  row->has_stance = true;
  row->stance = (tp_solid_stance){.verdict = contacts->verdict,
                                  .has_fos = contacts->has_fos,
                                  .fos = contacts->fos,
                                  .fos_mechanism = contacts->fos_mechanism,
                                  .has_critical = contacts->has_critical,
                                  .critical_deg = contacts->critical_deg,
                                  .critical_mechanism = contacts->critical.mechanism,
                                  .has_acceleration = contacts->has_acceleration,
                                  .acceleration_g = contacts->acceleration_g,
                                  .acceleration_azimuth_deg = contacts->acceleration_azimuth_deg,
                                  .acceleration_mechanism = contacts->acceleration.mechanism};
}

tp_status tp_on_contacts_find(tp_solid *solid, const tp_centre *centre, const tp_solid_given *given,
                              tp_message *message) {
  solid->has_contacts = given->contact_count > 0;
  if (!solid->has_contacts) return TP_OK;
  const tp_status status =
      tp_on_contacts_solve(&solid->contacts, &solid->notes, centre, given, message);
  if (status == TP_OK) tp_on_contacts_row(solid->bands, &solid->contacts);
  return status;
}

void tp_solid_contacts_clear(tp_solid_contacts *contacts) {
  free(contacts->contacts);
  free(contacts->ways);
  *contacts = (tp_solid_contacts){.contact_count = 0};
}
