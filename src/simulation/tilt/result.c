/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Moves the history into the result, sums up energies and times, and draws outline and base with
 * chords for arcs. */

#include "tilt/result.h"

#include <math.h>
#include <stdlib.h>

static void summarise(tp_tilt_case *own) {
  const bool has_balance = own->moment_count == 0 || !isnan(own->moments[0].energy_balance_j);
  for (size_t k = 0; k < own->moment_count; k++) {
    const tp_tilt_moment *m = own->moments + k;
    own->kinetic_energy_j = fmax(own->kinetic_energy_j, m->kinetic_energy_j);
    own->energy_balance_j = fmax(own->energy_balance_j, fabs(m->energy_balance_j));
    own->ended_s = fmax(own->ended_s, m->time_s);
    own->ended_deg = m->angle_deg;
  }
  if (!has_balance) own->energy_balance_j = NAN;
  for (size_t k = 0; k < own->event_count; k++) {
    own->ended_s = fmax(own->ended_s, own->events[k].time_s);
    own->ended_deg = fmax(own->ended_deg, own->events[k].angle_deg);
  }
}

void tp_tilt_result_take(tp_tilt_case *own, tp_history *history, const tp_rigid_body *body) {
  own->event_count = history->event_count;
  own->events = history->events;
  own->moment_count = history->moment_count;
  own->moments = history->moments;
  own->reaction_count = history->reaction_count;
  own->reactions = history->reactions;
  *history = (tp_history){.event_count = 0};
  own->centroid_x_m = body->origin.x;
  own->centroid_y_m = body->origin.y;
  own->energy_scale_j = body->mass_kg * TP_GRAVITY_M_S2 * body->extent_m;
  summarise(own);
}

/* ---- outlines ----------------------------------------------------------------------------------
 */

/* Chords of an edge: one of a straight one. */
static size_t chord_count(const tp_edge *edge, double longest) {
  if (!edge->arc) return 1;
  const double chord = hypot(edge->to.x - edge->from.x, edge->to.y - edge->from.y);
  const double angle = 2 * asin(fmin(1, chord / (2 * edge->radius)));
  return 1 + (size_t)fmin(64, edge->radius * angle / longest + 4 * angle);
}

/* The k-th of its points; the last is the first of the next edge. */
static tp_xy chord_point(const tp_edge *edge, size_t k, size_t count) {
  if (k == 0) return edge->from;
  const tp_xy p = {edge->from.x - edge->centre.x, edge->from.y - edge->centre.y},
              q = {edge->to.x - edge->centre.x, edge->to.y - edge->centre.y};
  const double angle = atan2(p.x * q.y - p.y * q.x, p.x * q.x + p.y * q.y);
  const double turn = angle * (double)k / (double)count;
  return (tp_xy){edge->centre.x + p.x * cos(turn) - p.y * sin(turn),
                 edge->centre.y + p.x * sin(turn) + p.y * cos(turn)};
}

static bool draw(tp_tilt_point **points, size_t *count, const tp_boundary *boundary, tp_xy origin,
                 double longest) {
  size_t room = 0;
  for (long k = 0; k < boundary->count; k++) room += chord_count(boundary->edges + k, longest);
  *points = calloc(room + 1, sizeof **points);
  if (*points == NULL) return false;
  for (long k = 0; k < boundary->count; k++) {
    const tp_edge *edge = boundary->edges + k;
    const size_t chords = chord_count(edge, longest);
    for (size_t j = 0; j < chords; j++) {
      const tp_xy p = chord_point(edge, j, chords);
      (*points)[(*count)++] = (tp_tilt_point){p.x + origin.x, p.y + origin.y};
    }
  }
  return true;
}

bool tp_tilt_result_draw(tp_tilt_case *own, const tp_rigid_body *body) {
  const double longest = body->extent_m / 50;
  return draw(&own->outline, &own->outline_count, &body->outline, body->origin, longest) &&
         draw(&own->base, &own->base_count, &body->base, body->origin, longest);
}

/* ---- statics beside it -------------------------------------------------------------------------
 */

void tp_tilt_result_window(tp_tilt_case *own, const tp_case *statics) {
  own->has_onset = statics->onset.kind == TP_ONSET_AT_ANGLE;
  own->onset_deg = own->has_onset ? statics->onset.critical_angle_deg.value : 0;
  own->has_limit = statics->limit.kind == TP_LIMIT_AT_ANGLE;
  own->limit_deg = own->has_limit ? statics->limit.critical_angle_deg.value : 0;
}

void tp_tilt_result_place(tp_tilt_case *own, double tolerance_deg) {
  if (!own->has_onset || !own->has_limit || !own->has_bracket) return;
  own->place = own->lets_go_at_deg < own->onset_deg - tolerance_deg  ? TP_PLACE_BELOW
               : own->stands_at_deg > own->limit_deg + tolerance_deg ? TP_PLACE_BEYOND
                                                                     : TP_PLACE_WITHIN;
}
