/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "tilt/trial.h"

#include "clock.h"
#include "tilt/settings.h"

#include <math.h>

double tp_tilt_radians(double degrees) {
  return degrees * (M_PI / 180);
}

double tp_tilt_degrees(double radians) {
  return radians * (180 / M_PI);
}

bool tp_tilting_stopped(const tp_tilting *tilting) {
  const tp_tilt_options *o = tilting->options;
  return o->stop != NULL && o->stop(o->context);
}

void tp_tilting_tell(const tp_tilting *tilting, double least_deg, double most_deg) {
  const tp_tilt_options *o = tilting->options;
  if (o->progress != NULL) o->progress(o->context, tilting->own->runs, least_deg, most_deg);
}

tp_status tp_tilting_run(tp_run_end *end, tp_body_state *last, tp_tilting *tilting,
                         const tp_run *run) {
  tp_message message = {""};
  tp_run own = *run;
  own.body = tilting->body;
  own.stop = tilting->options->stop;
  own.context = tilting->options->context;
  const double began = tp_clock_now();
  *end = tilting->engine.run(last, &own, tilting->engine.engine, &message);
  tilting->own->seconds += tp_clock_now() - began;
  tilting->own->runs++;
  if (*end == TP_RUN_NO_MEMORY) return tp_fail_memory(tilting->message, "the simulation");
  if (*end == TP_RUN_UNDECIDED) tilting->why = message;
  return TP_OK;
}

/* Of a run that ends as soon as the block collapses, and did not: has the block only given way on
 * its springs? Near a limit they give a hundred times what they do under the weight on the whole
 * contact; a hundredth of the extent would be another place. A displacement alone is no collapse,
 * but a block that came farther in a leap too short to be one does not stand. */
static bool gave_way(const tp_body_state *last, const tp_tilting *tilting) {
  static const double near_limit = 100, most_share = 0.01;
  const tp_rigid_body *body = tilting->body;
  double area = 0;
  for (long k = 0; k < body->closed_count; k++) {
    area += body->closed[k].share_m * body->thickness_m;
  }
  const double stiffness = area * tilting->settings->shear_stiffness_pa_m;
  if (!(stiffness > 0)) return false;
  const double gives = body->mass_kg * TP_GRAVITY_M_S2 / stiffness;
  const double moved = hypot(last->moved.x, last->moved.y) + fabs(last->turned) * body->extent_m;
  return moved <= fmin(near_limit * gives, most_share * body->extent_m);
}

static tp_tilt_verdict verdict_of(tp_run_end end, const tp_body_state *last,
                                  const tp_tilting *tilting) {
  if (end == TP_RUN_STANDS) return TP_VERDICT_STANDS;
  if (end == TP_RUN_RESTS && gave_way(last, tilting)) return TP_VERDICT_STANDS;
  if (end != TP_RUN_UNDECIDED) return TP_VERDICT_MOVES;
  return tp_tilting_stopped(tilting) ? TP_VERDICT_STOPPED : TP_VERDICT_OPEN;
}

tp_status tp_tilting_try(tp_tilt_verdict *verdict, tp_body_state *last, tp_tilting *tilting,
                         double angle_deg, tp_history *history) {
  const tp_tilt_settings *s = tilting->settings;
  const double angle = tp_tilt_radians(angle_deg),
               speed = s->set_down ? 0 : tp_tilt_radians(s->speed_deg_min) / 60;
  const tp_drive drive = {.angle = s->set_down ? angle : 0, .speed = speed, .final_angle = angle};
  const tp_run run = {
      .drive = &drive,
      .longest_s = tp_tilt_duration(s, tilting->body) + (s->set_down ? 0 : angle / speed),
      .moments_every_s = history == NULL || s->set_down
                             ? 0
                             : angle / speed / (double)(tilting->options->moments - 1),
      .until_collapse = true,
      .history = history};
  tp_run_end end = TP_RUN_UNDECIDED;
  if (tp_tilting_stopped(tilting)) {
    *verdict = TP_VERDICT_STOPPED;
    return TP_OK;
  }
  const tp_status status = tp_tilting_run(&end, last, tilting, &run);
  *verdict = verdict_of(end, last, tilting);
  return status;
}
