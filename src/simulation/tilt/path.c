/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Ramp and steps of the quasi-static engine, each a call of quasi_static/path.h, with the results
 * converted to degrees and scene coordinates. */

#include "tilt/path.h"

#include "common/clock.h"
#include "quasi_static/path.h"
#include "tilt/bracket.h"

#include <math.h>

/* A tilt of 90 degrees is beyond what the path takes: the friction of a base that stands upright
 * holds nothing. */
static const double most_deg_of_path = 89.999;

static tp_status run(tp_path_result *result, tp_tilting *tilting, double from_deg, double to_deg,
                     tp_history *history) {
  const tp_tilt_settings *s = tilting->settings;
  tp_path_settings path = tp_path_settings_default();
  path.normal_pa_m = s->normal_stiffness_pa_m;
  path.shear_pa_m = s->shear_stiffness_pa_m;
  path.from_angle = tp_tilt_radians(from_deg);
  path.to_angle = tp_tilt_radians(to_deg);
  path.tolerance = tilting->path_tolerance_deg > 0
                       ? tp_tilt_radians(tilting->path_tolerance_deg)
                       : fmin(path.tolerance, tp_tilt_radians(s->tolerance_deg) / 4);
  path.weight_moves = tilting->weight_moves;
  if (history != NULL) {
    path.moments_every = tp_tilt_radians(s->until_deg) / (double)(tilting->options->moments - 1);
  }
  path.tractions = tilting->tractions;
  path.asks_softening = s->stiffness_given && history != NULL;
  path.stop = tilting->options->stop;
  path.context = tilting->options->context;
  const double began = tp_clock_now();
  const tp_status status = tp_path_run(result, tilting->body, &path, history, tilting->message);
  tilting->own->seconds += tp_clock_now() - began;
  tilting->own->runs++;
  if (status != TP_OK || result->end != TP_RUN_NO_MEMORY) return status;
  return tp_fail_memory(tilting->message, "the path");
}

/* What a path that is told came to beside its angles. */
static void take_path(tp_tilt_case *own, const tp_path_result *result) {
  own->has_softening = result->has_softening;
  own->softening_deg = result->has_softening ? tp_tilt_degrees(result->softening) : 0;
  own->jumps = (size_t)result->jumps;
  own->first_jump_deg = result->jumps > 0 ? tp_tilt_degrees(result->first_jump) : 0;
}

static void take_motion(tp_tilt_case *own, const tp_path_result *result,
                        const tp_rigid_body *body) {
  own->has_mechanism = true;
  own->mechanism = result->motion.mechanism;
  own->has_centre = result->motion.has_centre;
  own->centre_x_m = result->motion.centre.x + body->origin.x;
  own->centre_y_m = result->motion.centre.y + body->origin.y;
}

static tp_tilt_end end_of(const tp_path_result *result, const tp_tilting *tilting) {
  if (result->end == TP_RUN_STANDS) return TP_TILT_STANDS;
  if (result->end != TP_RUN_UNDECIDED) return TP_TILT_COLLAPSES;
  return tp_tilting_stopped(tilting) ? TP_TILT_STOPPED : TP_TILT_OPEN;
}

static tp_status ramp(tp_tilting *tilting) {
  tp_tilt_case *own = tilting->own;
  const double from = tilting->settings->from_deg;
  const double until = fmax(from, fmin(tilting->settings->until_deg, most_deg_of_path));
  tp_path_result result;
  const tp_status status = run(&result, tilting, from, until, &tilting->history);
  if (status != TP_OK) return status;
  own->end = end_of(&result, tilting);
  take_path(own, &result);
  own->stands_at_deg = own->end == TP_TILT_STANDS ? until : tp_tilt_degrees(result.stands_to);
  own->lets_go_at_deg =
      own->end == TP_TILT_COLLAPSES ? tp_tilt_degrees(result.collapses_at) : until;
  own->has_bracket = own->end == TP_TILT_COLLAPSES && (result.stood || from == 0);
  if (!result.stood && from > 0)
    own->stands_at_deg = NAN; /* nothing holds it where it is set down */
  own->converged = own->end == TP_TILT_STANDS ||
                   (own->end == TP_TILT_COLLAPSES && isnan(own->stands_at_deg)) ||
                   (own->has_bracket &&
                    own->lets_go_at_deg - own->stands_at_deg <= tilting->settings->tolerance_deg);
  if (own->end == TP_TILT_COLLAPSES) take_motion(own, &result, tilting->body);
  tp_tilting_tell(tilting, own->stands_at_deg, own->lets_go_at_deg);
  return TP_OK;
}

/* Set down at one tilt. */
static tp_status look(tp_tilt_verdict *verdict, tp_tilting *tilting, double angle_deg) {
  tp_path_result result;
  const tp_status status = run(&result, tilting, angle_deg, angle_deg, NULL);
  if (status != TP_OK) return status;
  *verdict = result.end == TP_RUN_STANDS      ? TP_VERDICT_STANDS
             : result.end != TP_RUN_UNDECIDED ? TP_VERDICT_MOVES
             : tp_tilting_stopped(tilting)    ? TP_VERDICT_STOPPED
                                              : TP_VERDICT_OPEN;
  if (*verdict == TP_VERDICT_MOVES) take_motion(tilting->own, &result, tilting->body);
  return TP_OK;
}

/* Set down at the greatest tilt at which it stands; where it is displaced too far there to be a
 * moment, at one below it. */
static tp_status record_highest(tp_tilting *tilting) {
  enum { MOST = 40 };
  const double highest_deg = tilting->own->stands_at_deg;
  double below_deg = tilting->settings->tolerance_deg;
  double angle_deg = highest_deg;
  tp_path_result highest;
  tp_status status = TP_OK;
  for (int k = 0; k < MOST; k++) {
    tp_history_clear(&tilting->history);
    status = run(&highest, tilting, angle_deg, angle_deg, &tilting->history);
    if (status == TP_OK && k == 0) take_path(tilting->own, &highest);
    if (status != TP_OK || tilting->history.moment_count > 0 || !(angle_deg > 0)) break;
    angle_deg = fmax(0, highest_deg - below_deg);
    below_deg *= 2;
  }
  return status;
}

static tp_status steps(tp_tilting *tilting, double least_deg, double most_deg) {
  const double until = fmin(tilting->settings->until_deg, most_deg_of_path);
  tp_tilt_case *own = tilting->own;
  own->end = TP_TILT_STANDS;
  const tp_status status = tp_tilting_bracket(tilting, look, least_deg, most_deg, until);
  if (status != TP_OK || own->end != TP_TILT_STANDS) return status;
  if (own->has_bracket) own->end = TP_TILT_COLLAPSES;
  if (own->has_bracket && own->lets_go_at_deg == 0) return TP_OK;
  return record_highest(tilting);
}

tp_status tp_tilting_path(tp_tilting *tilting, double least_deg, double most_deg) {
  return tilting->settings->protocol == TP_TILT_STEPS ? steps(tilting, least_deg, most_deg)
                                                      : ramp(tilting);
}
