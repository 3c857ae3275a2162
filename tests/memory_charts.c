/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "memory_charts.h"

#include "memory_expect.h"

static void report_chart(tp_status status, tp_chart *chart, const tp_message *message) {
  if (done(status, chart, message)) {
    char *csv = NULL, *json = NULL;
    status = tp_report_chart_csv(&csv, chart);
    expect_report(status, csv);
    status = tp_report_chart_json(&json, chart);
    expect_report(status, json);
  }
  tp_chart_free(chart);
}

void chart_fos(void) {
  tp_chart *chart = NULL;
  tp_message message = {""};
  const tp_chart_fos_options options = tp_chart_fos_options_default();
  const tp_status status = tp_chart_fos(&chart, &options, &message);
  report_chart(status, chart, &message);
}

void chart_mechanisms(void) {
  tp_chart *chart = NULL;
  tp_message message = {""};
  const tp_chart_mechanisms_options options = tp_chart_mechanisms_options_default();
  const tp_status status = tp_chart_mechanisms(&chart, &options, &message);
  report_chart(status, chart, &message);
}

void chart_ranges(void) {
  tp_chart *chart = NULL;
  tp_message message = {""};
  const tp_status status = tp_chart_ranges(&chart, &message);
  report_chart(status, chart, &message);
}

void chart_profile(const tp_profile *profile) {
  tp_chart *chart = NULL;
  tp_message message = {""};
  const tp_status status = tp_chart_profile(&chart, profile, &message);
  report_chart(status, chart, &message);
}

void chart_map(void) {
  tp_scene *scene = NULL;
  tp_chart *chart = NULL;
  tp_message message = {""};
  tp_status status = tp_scene_read(&scene, EXAMPLE("slab_left.yaml"), &message);
  if (!done(status, scene, &message)) return;
  const tp_chart_map_options options = {.size = sizeof options,
                                        .scene = scene,
                                        .x = {"block.slab.width", {10, 150}},
                                        .y = {"tilt", {0, 90}}};
  status = tp_chart_map(&chart, &options, &message);
  report_chart(status, chart, &message);
  tp_scene_free(scene);
}
