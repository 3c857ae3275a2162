/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One run at a factor on the shaking, and bisection between two factors with different outcomes. */

#include "tilt/overturning.h"

#include "tilt/settings.h"

#include <math.h>

tp_status tp_overturning_look(tp_tilt_verdict *verdict, tp_overturning *o, double factor) {
  tp_tilting *tilting = o->tilting;
  const double angle = tp_tilt_radians(tilting->settings->release_deg);
  const tp_drive drive = {.angle = angle, .final_angle = angle, .shaking = tilting->shaking};
  const tp_run run = {.drive = &drive,
                      .longest_s =
                          tp_tilt_duration(tilting->settings, tilting->body) + tilting->shaking_s};
  tp_body_state last;
  tp_run_end end = TP_RUN_UNDECIDED;
  o->shaking->factor = factor;
  const tp_status status = tp_tilting_run(&end, &last, tilting, &run);
  *verdict = end == TP_RUN_OVERTURNED || end == TP_RUN_LEFT_BASE ? TP_VERDICT_MOVES
             : end != TP_RUN_UNDECIDED                           ? TP_VERDICT_STANDS
             : tp_tilting_stopped(tilting)                       ? TP_VERDICT_STOPPED
                                                                 : TP_VERDICT_OPEN;
  tilting->own->converged = *verdict == TP_VERDICT_STANDS || *verdict == TP_VERDICT_MOVES;
  return status;
}

tp_status tp_overturning_narrow(double between[2], tp_overturning *o, tp_tilt_verdict upper,
                                double tolerance) {
  tp_status status = TP_OK;
  while (status == TP_OK && between[1] - between[0] > tolerance * between[1]) {
    const double middle = 0.5 * (between[0] + between[1]);
    tp_tilt_verdict verdict = TP_VERDICT_OPEN;
    status = tp_overturning_look(&verdict, o, middle);
    if (status != TP_OK || !o->tilting->own->converged) break;
    between[verdict == upper] = middle;
  }
  return status;
}
