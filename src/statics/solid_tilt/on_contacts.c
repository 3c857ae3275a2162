/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* From what is proven of loads on cones of friction to results. */

#include "solid_tilt/on_contacts.h"

#include "number/near_angle.h"
#include "solid/tilting.h"
#include "solid_tilt/contact_stance.h"
#include "solid_tilt/least_way.h"

#include <math.h>
#include <stdlib.h>

/* ---- towards azimuths --------------------------------------------------------------------------
 */

static tp_status find_way(tp_solid_way *own, tp_contact_work *w, double azimuth_deg) {
  tp_hold_limit limit;
  if (!tp_level_limit(&limit, &w->hold, &w->level, &w->frame, azimuth_deg))
    return tp_contacts_fail_memory(w);
  own->has_critical = !limit.is_open && !limit.is_endless;
  if (limit.is_endless) own->mechanism = TP_INTERLOCKED;
  if (!own->has_critical) return TP_OK;
  own->critical_deg = tp_near_bounded(tp_near_arctangent(limit.t));
  tp_contacts_motion(&own->motion, w, limit.twist);
  own->mechanism = own->motion.mechanism;
  return TP_OK;
}

/* Towards the azimuth of the tilt. */
static tp_status find_critical(tp_contact_work *w, double azimuth_deg) {
  tp_solid_contacts *own = w->results;
  tp_solid_way way = {.mechanism = TP_MECHANISM_UNDECIDED};
  const tp_status status = find_way(&way, w, azimuth_deg);
  own->has_critical = way.has_critical;
  own->critical_deg = way.critical_deg;
  own->critical_azimuth_deg = (tp_bounded){.value = azimuth_deg};
  own->critical = way.motion;
  return status;
}

static tp_status find_least(tp_contact_work *w) {
  tp_solid_contacts *own = w->results;
  tp_least_way least;
  if (!tp_least_way_find(&least, &w->hold, &w->level, &w->frame)) return tp_contacts_fail_memory(w);
  own->has_critical = least.is_known && !least.is_endless;
  if (!own->has_critical) return TP_OK;
  own->critical_deg = tp_near_bounded(tp_near_arctangent(least.t));
  own->critical_azimuth_deg =
      (tp_bounded){.value = least.azimuth_deg, .error = least.azimuth_error};
  tp_contacts_motion(&own->critical, w, least.twist);
  return TP_OK;
}

static tp_status find_level(tp_contact_work *w) {
  const tp_quantity *azimuth = &w->given->scene->tilt_azimuth_deg;
  tp_solid_contacts *own = w->results;
  tp_hold_side side;
  double twist[TP_WRENCH];
  if (!tp_hold_load_side(&side, twist, &w->hold, &w->level.load)) return tp_contacts_fail_memory(w);
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

static tp_status shake_way(tp_solid_way *own, tp_contact_work *w) {
  tp_hold_limit limit;
  if (!tp_level_limit(&limit, &w->hold, &w->tilted, &w->frame, own->azimuth_deg)) {
    return tp_contacts_fail_memory(w);
  }
  own->has_acceleration = !limit.is_open && !limit.is_endless;
  if (!own->has_acceleration) return TP_OK;
  tp_solid_motion motion;
  own->acceleration_g = tp_near_bounded(limit.t);
  tp_contacts_motion(&motion, w, limit.twist);
  own->acceleration_mechanism = motion.mechanism;
  return TP_OK;
}

/* Towards the azimuth of the scene's earthquake. */
static tp_status shake_ahead(tp_contact_work *w) {
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
static tp_status find_shaken(tp_contact_work *w) {
  tp_solid_contacts *own = w->results;
  tp_hold_side side;
  double twist[TP_WRENCH];
  tp_least_way least;
  if (!tp_hold_load_side(&side, twist, &w->hold, &w->tilted.load))
    return tp_contacts_fail_memory(w);
  if (side != TP_HOLD_HOLDS) return TP_OK;
  if (!tp_least_way_find(&least, &w->hold, &w->tilted, &w->frame))
    return tp_contacts_fail_memory(w);
  own->has_acceleration = least.is_known && !least.is_endless;
  if (own->has_acceleration) {
    own->acceleration_g = tp_near_bounded(least.t);
    own->acceleration_azimuth_deg =
        (tp_bounded){.value = least.azimuth_deg, .error = least.azimuth_error};
    tp_contacts_motion(&own->acceleration, w, least.twist);
  }
  tp_status status = shake_ahead(w);
  for (size_t k = 0; k < own->way_count && status == TP_OK; k++) {
    status = shake_way(own->ways + k, w);
  }
  return status;
}

/* ---- all ---------------------------------------------------------------------------------------
 */

static tp_status init_ways(tp_contact_work *w) {
  tp_solid_contacts *own = w->results;
  const size_t count = w->given->azimuths;
  own->ways = calloc(count + 1, sizeof *own->ways);
  if (own->ways == NULL) return tp_contacts_fail_memory(w);
  for (size_t k = 0; k < count; k++) {
    own->ways[k] = (tp_solid_way){.azimuth_deg = 360.0 * (double)k / (double)count,
                                  .mechanism = TP_MECHANISM_UNDECIDED};
  }
  return TP_OK;
}

static tp_status find_all(tp_contact_work *w) {
  if (!tp_hold_init(&w->hold, &w->points.cones, 1)) return tp_contacts_fail_memory(w);
  tp_status status = tp_contact_stance_find(w);
  if (status == TP_OK) status = init_ways(w);
  if (status == TP_OK) status = find_level(w);
  return status == TP_OK ? find_shaken(w) : status;
}

tp_status tp_on_contacts_solve(tp_solid_contacts *own, tp_notes *notes,
                               const tp_solid_moments *moments, const tp_solid_given *given,
                               tp_message *message) {
  tp_contact_work w = {
      .results = own, .surface = moments->surface, .given = given, .message = message};
  const size_t count = (size_t)given->contact_count;
  own->contacts = calloc(count + 1, sizeof *own->contacts);
  if (own->contacts == NULL) return tp_contacts_fail_memory(&w);
  own->contact_count = count;
  tp_status status =
      tp_contact_points_init(&w.points, own->contacts, moments, given, notes, message);
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
                                  .safety = contacts->safety,
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

tp_status tp_on_contacts_find(tp_solid *solid, const tp_solid_moments *moments,
                              const tp_solid_given *given, tp_message *message) {
  solid->has_contacts = given->contact_count > 0;
  if (!solid->has_contacts) return TP_OK;
  const tp_status status =
      tp_on_contacts_solve(&solid->contacts, &solid->notes, moments, given, message);
  if (status == TP_OK) tp_on_contacts_row(solid->bands, &solid->contacts);
  return status;
}

void tp_solid_contacts_clear(tp_solid_contacts *contacts) {
  free(contacts->contacts);
  free(contacts->ways);
  *contacts = (tp_solid_contacts){.contact_count = 0};
}
