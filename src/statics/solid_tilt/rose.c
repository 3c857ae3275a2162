/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reaches H n / a of all edges are found once; towards an azimuth the largest of their products
 * with it counts. */

#include "solid_tilt/rose.h"

#include "solid_tilt/stance.h"

#include "number/near_angle.h"

#include <stdlib.h>

void tp_solid_band_clear(tp_solid_band *band) {
  free(band->support);
  free(band->rose);
}

/* ---- friction ----------------------------------------------------------------------------------
 */

/* The lesser of toppling and sliding, and which it is. */
static tp_mechanism choose(tp_bounded *critical, const tp_rose_question *q, tp_bounded toppling) {
  *critical = toppling;
  if (!q->has_friction) return TP_TOPPLES;
  /* the decimal that the double names lies within half a unit of its last place */
  const tp_near sliding = {q->friction_angle_deg, q->friction_angle_deg * DBL_EPSILON / 2};
  const tp_near topples = {toppling.value, toppling.error};
  *critical = tp_near_bounded(tp_near_lesser(sliding, topples));
  const int side = tp_near_sign(tp_near_sub(topples, sliding));
  if (side < 0) *critical = toppling;
  return side < 0 ? TP_TOPPLES : side > 0 ? TP_SLIDES : TP_MECHANISM_UNDECIDED;
}

/* ---- the rose ----------------------------------------------------------------------------------
 */

/* H (n / a) of an edge, east and north. */
typedef struct reach {
  tp_near east, north;
} reach;

static void set_reaches(reach *reaches, const tp_rose_question *q, const tp_support_edge *edges,
                        long count) {
  const tp_rest_plane *plane = &q->above->plane;
  const tp_near height = tp_centre_height(q->centre, plane, tp_solid_accuracy);
  const tp_near rise = tp_near_div(height, tp_near_norm(plane->near_up));
  for (long k = 0; k < count; k++) {
    tp_near outward[3], east, north;
    tp_rest_plane_outward(outward, q->centre->surface, plane, edges[k].from, edges[k].to);
    tp_map_components(&east, &north, &q->above->frame, outward);
    const tp_near arm =
        tp_centre_arm(q->centre, plane, edges[k].from, edges[k].to, tp_solid_accuracy);
    const tp_near factor = tp_near_div(rise, arm);
    reaches[k] = (reach){tp_near_times(east, factor), tp_near_times(north, factor)};
  }
}

static tp_near angle_towards(const reach *reaches, long count, double azimuth_deg) {
  const tp_near one = {1, 0};
  tp_near east, north, most = {0, 0};
  tp_azimuth_direction(&east, &north, azimuth_deg);
  for (long k = 0; k < count; k++) {
    const tp_near own =
        tp_near_plus(tp_near_times(reaches[k].east, east), tp_near_times(reaches[k].north, north));
    most = k == 0 ? own : tp_near_larger(most, own);
  }
  return tp_near_arctangent(tp_near_div(one, most));
}

/* Of a scene's stance: the tilt at which it moves towards the azimuth of its tilt. */
static void set_critical(tp_solid_band *result, const tp_rose_question *q, const reach *reaches) {
  tp_solid_stance *own = &result->stance;
  own->has_critical = true;
  if (q->loads->azimuth_deg < 0) {
    own->critical_deg = result->critical_deg;
    own->critical_mechanism = result->mechanism;
    return;
  }
  const tp_near angle = angle_towards(reaches, (long)result->corner_count, q->loads->azimuth_deg);
  own->critical_mechanism = choose(&own->critical_deg, q, tp_near_bounded(angle));
}

static tp_status set_rose(tp_solid_band *result, const tp_rose_question *q,
                          const tp_support_edge *edges, bool *told, tp_message *message) {
  const long count = (long)result->corner_count;
  reach *reaches = malloc((size_t)count * sizeof *reaches);
  result->rose = calloc(q->azimuths + 1, sizeof *result->rose);
  if (reaches == NULL || result->rose == NULL) {
    free(reaches);
    return tp_fail_memory(message, "the rose of a solid");
  }
  set_reaches(reaches, q, edges, count);
  result->rose_count = q->azimuths;
  for (size_t k = 0; k < q->azimuths; k++) {
    tp_solid_azimuth *own = result->rose + k;
    own->azimuth_deg = 360.0 * (double)k / (double)q->azimuths;
    const tp_near angle = angle_towards(reaches, count, own->azimuth_deg);
    own->toppling_deg = tp_near_bounded(angle);
    own->mechanism = choose(&own->critical_deg, q, own->toppling_deg);
    if (!tp_tilt_is_told(angle)) *told = false;
  }
  if (q->loads != NULL) set_critical(result, q, reaches);
  free(reaches);
  return TP_OK;
}

/* ---- at the tilt of a scene --------------------------------------------------------------------
 */

static tp_status set_stance(tp_solid_band *result, const tp_rose_question *q,
                            const tp_support_edge *edges, bool *told, tp_message *message) {
  const tp_rest_plane *plane = &q->above->plane;
  const size_t count = result->corner_count;
  const tp_near rise = tp_near_div(tp_centre_height(q->centre, plane, tp_solid_accuracy),
                                   tp_near_norm(plane->near_up));
  tp_stance_edge *own = malloc(count * sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "the support of a solid");
  for (size_t k = 0; k < count; k++) {
    tp_near outward[3], east, north;
    const int from = edges[k].from, to = edges[k].to;
    tp_rest_plane_outward(outward, q->centre->surface, plane, from, to);
    tp_map_components(&east, &north, &q->above->frame, outward);
    own[k] = (tp_stance_edge){tp_centre_arm(q->centre, plane, from, to, tp_solid_accuracy),
                              tp_near_times(east, rise), tp_near_times(north, rise)};
    if (!tp_near_tells(own[k].arm, tp_solid_accuracy)) *told = false;
  }
  tp_stance_find(result, q->loads, own, count, q->has_friction, q->friction_angle_deg);
  free(own);
  return TP_OK;
}

/* ---- a band ------------------------------------------------------------------------------------
 */

static tp_status set_corners(tp_solid_band *result, const tp_rose_question *q,
                             const tp_solid_support *support, tp_message *message) {
  result->touching = (size_t)support->touching;
  result->corner_count = (size_t)support->count;
  result->support = calloc(result->corner_count + 1, sizeof *result->support);
  if (result->support == NULL) return tp_fail_memory(message, "the support of a solid");
  for (size_t k = 0; k < result->corner_count; k++) {
    tp_near way[3], east, north;
    for (int axis = 0; axis < 3; axis++) {
      way[axis] = tp_near_sub(tp_surface_near(q->centre->surface, support->corners[k], axis),
                              q->centre->near[axis]);
    }
    tp_map_components(&east, &north, &q->above->frame, way);
    result->support[k] =
        (tp_solid_corner){east.value * q->metres_per_step, north.value * q->metres_per_step};
  }
  return TP_OK;
}

static void set_height(tp_solid_band *result, const tp_rose_question *q, bool *told) {
  const tp_rest_plane *plane = &q->above->plane;
  const tp_near scale = {q->metres_per_step, q->metres_per_step * DBL_EPSILON};
  const tp_near height = tp_centre_height(q->centre, plane, tp_solid_accuracy);
  const tp_near metres = tp_near_mul(tp_near_div(height, tp_near_norm(plane->near_up)), scale);
  result->height_m = tp_near_bounded(metres);
  if (!tp_near_tells(metres, 100 * tp_solid_accuracy)) *told = false;
}

static tp_status set_tilts(tp_solid_band *result, const tp_rose_question *q,
                           const tp_solid_support *support, bool *told, tp_message *message) {
  const long count = support->count;
  tp_support_edge *edges = malloc((size_t)count * sizeof *edges);
  if (edges == NULL) return tp_fail_memory(message, "the support of a solid");
  for (long k = 0; k < count; k++) {
    edges[k] = (tp_support_edge){support->corners[k], support->corners[(k + 1) % count]};
  }
  const int side = tp_foot_side(q->centre, &q->above->plane, edges, count);
  tp_status status = TP_OK;
  if (side == 2) *told = false;
  result->stands = side == 1;
  if (result->stands) {
    tp_tilt_least(&result->least, q->centre, &q->above->plane, &q->above->frame, edges, count,
                  told);
    result->mechanism = choose(&result->critical_deg, q, result->least.tilt_deg);
    status = set_rose(result, q, edges, told, message);
  }
  if (status == TP_OK && q->loads != NULL) status = set_stance(result, q, edges, told, message);
  free(edges);
  return status;
}

tp_status tp_rose_of_band(tp_solid_band *result, const tp_rose_question *question,
                          const fmpq_t band, bool *told, tp_message *message) {
  tp_solid_support support;
  tp_status status = tp_solid_support_init(&support, question->above, band)
                         ? TP_OK
                         : tp_fail_memory(message, "the support of a solid");
  if (status == TP_OK) status = set_corners(result, question, &support, message);
  if (status == TP_OK) set_height(result, question, told);
  if (status == TP_OK && support.count >= 3) {
    status = set_tilts(result, question, &support, told, message);
  }
  tp_solid_support_clear(&support);
  return status;
}
