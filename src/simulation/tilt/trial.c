/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One run of dynamics with its budget and stop, and its end as stands, moves, undecided or
 * stopped. */

#include "tilt/trial.h"

#include "common/clock.h"
#include "tilt/cost.h"
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
  tp_message message = {.text = ""};
  tp_run own = *run;
  own.body = tilting->body;
  own.stop = tilting->options->stop;
  own.context = tilting->options->context;
  double steps = 0;
  own.steps = &steps;
  own.most_steps = tp_tilting_steps_left(tilting);
  const tp_status dear = tp_tilting_check_cost(tilting, run->longest_s);
  if (dear != TP_OK) return dear;
  const double began = tp_clock_now();
  *end = tilting->engine.run(last, &own, tilting->engine.engine, &message);
  tilting->own->seconds += tp_clock_now() - began;
  tilting->own->runs++;
  tp_tilting_count_steps(tilting, steps);
  if (*end == TP_RUN_NO_MEMORY) return tp_fail_memory(tilting->message, "the simulation");
  if (*end == TP_RUN_UNDECIDED) tilting->why = message;
  return TP_OK;
}

static tp_tilt_verdict verdict_of(tp_run_end end, const tp_tilting *tilting) {
  if (end == TP_RUN_STANDS) return TP_VERDICT_STANDS;
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
  *verdict = verdict_of(end, tilting);
  return status;
}
