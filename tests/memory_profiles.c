/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "memory_profiles.h"

#include "memory_charts.h"
#include "memory_expect.h"

void measure_profile(void) {
  tp_profile *profile = NULL;
  tp_message message = {""};
  tp_profile_options options = tp_profile_options_default();
  options.step = 0.7;
  options.resampling = TP_RESAMPLE_SPLINE;
  tp_status status =
      tp_profile_of_file(&profile, EXAMPLE("joint_profile.csv"), "mm", &options, &message);
  if (done(status, profile, &message)) {
    char *text = NULL, *json = NULL, *csv = NULL;
    status = tp_report_profile(&text, profile);
    expect_report(status, text);
    status = tp_report_profile_json(&json, profile, true);
    expect_report(status, json);
    status = tp_report_profile_csv(&csv, profile);
    expect_report(status, csv);
    chart_profile(profile);
  }
  tp_profile_free(profile);
}

void measure_base(void) {
  tp_scene *scene = NULL;
  tp_profile *profile = NULL;
  tp_message message = {""};
  tp_profile_options options = tp_profile_options_default();
  options.jcs_mpa = 120;
  tp_status status = tp_scene_read(&scene, EXAMPLE("block_e_valley.yaml"), &message);
  if (done(status, scene, &message)) {
    status = tp_profile_of_scene(&profile, scene, &options, &message);
    (void)done(status, profile, &message);
  }
  tp_profile_free(profile);
  tp_scene_free(scene);
}
