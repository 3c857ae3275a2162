/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "springs_stage.h"

#include <check.h>
#include <math.h>

tp_spring_settings paper_springs(void) {
  return (tp_spring_settings){
      .normal_pa_m = 1e12, .shear_pa_m = 1e10, .damping = 0.8, .rounding_m = 1e-7};
}

double radians(double degrees) {
  return degrees * acos(0) / 90;
}

tp_run_end springs_at(const tp_rigid_body *body, double tilt_deg,
                      const tp_spring_settings *settings) {
  const tp_drive drive = {.angle = radians(tilt_deg)};
  const tp_run run = {.body = body, .drive = &drive, .longest_s = 20, .until_collapse = true};
  tp_body_state last;
  tp_message message = {.text = ""};
  return tp_springs_run(&last, &run, settings, &message);
}

double springs_let_go(const tp_rigid_body *body, double low_deg, double high_deg,
                      const tp_spring_settings *settings) {
  while (high_deg - low_deg > 0.01) {
    const double middle = (low_deg + high_deg) / 2;
    const tp_run_end end = springs_at(body, middle, settings);
    if (end == TP_RUN_STANDS || end == TP_RUN_RESTS) {
      low_deg = middle;
    } else {
      high_deg = middle;
    }
  }
  return high_deg;
}

spring_outcome springs_run(const body_stage *s, const tp_drive *drive, const tp_body_state *start,
                           double longest_s, double damping, double time_step_s) {
  spring_outcome o = {0};
  tp_spring_settings springs = paper_springs();
  springs.damping = damping;
  springs.time_step_s = time_step_s;
  const tp_run run = {.body = &s->body,
                      .drive = drive,
                      .start = *start,
                      .longest_s = longest_s,
                      .moments_every_s = longest_s / 100,
                      .history = &o.history};
  tp_message message = {.text = ""};
  o.end = tp_springs_run(&o.last, &run, &springs, &message);
  ck_assert_msg(message.text[0] == '\0', "%s", message.text);
  return o;
}

spring_outcome springs_run_held(const body_stage *s, double tilt_deg, double longest_s) {
  const tp_drive drive = {.angle = radians(tilt_deg)};
  const tp_body_state start = {{0, 0}, 0, {0, 0}, 0};
  return springs_run(s, &drive, &start, longest_s, 0, 0);
}

const tp_tilt_moment *springs_moment(const tp_history *h, double time_s) {
  size_t k = 0;
  while (k + 1 < h->moment_count && h->moments[k].time_s < time_s) k++;
  return h->moments + k;
}
