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
  tp_message message = {.text = ""};
  const tp_chart_fos_options options = tp_chart_fos_options_default();
  const tp_status status = tp_chart_fos(&chart, &options, &message);
  report_chart(status, chart, &message);
}

void chart_mechanisms(void) {
  tp_chart *chart = NULL;
  tp_message message = {.text = ""};
  const tp_chart_mechanisms_options options = tp_chart_mechanisms_options_default();
  const tp_status status = tp_chart_mechanisms(&chart, &options, &message);
  report_chart(status, chart, &message);
}

void chart_ranges(void) {
  tp_chart *chart = NULL;
  tp_message message = {.text = ""};
  const tp_status status = tp_chart_ranges(&chart, &message);
  report_chart(status, chart, &message);
}

void chart_profile(const tp_profile *profile) {
  tp_chart *chart = NULL;
  tp_message message = {.text = ""};
  const tp_status status = tp_chart_profile(&chart, profile, &message);
  report_chart(status, chart, &message);
}

/* Of the scene that a call has read with the status; it is freed. */
static void map_of(tp_scene *scene, tp_status status, tp_message message,
                   tp_chart_map_options options) {
  tp_chart *chart = NULL;
  if (!done(status, scene, &message)) return;
  options.scene = scene;
  status = tp_chart_map(&chart, &options, &message);
  report_chart(status, chart, &message);
  tp_scene_free(scene);
}

void chart_map(void) {
  tp_scene *scene = NULL;
  tp_message message = {.text = ""};
  const tp_status status = tp_scene_read(&scene, EXAMPLE("slab_left.yaml"), &message);
  map_of(scene, status, message,
         (tp_chart_map_options){.size = sizeof(tp_chart_map_options),
                                .x = {"block.slab.width", {10, 150}},
                                .y = {"tilt", {0, 90}}});
}

/* Where the slab stands throughout, so that there are no borders, which take most of the time. */
void chart_map_contours(void) {
  static const char slab[] = "topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 2}}\n"
                             "friction_angle_deg: 30\ntilt: {towards: left, angle_deg: 20}\n";
  static const double levels[] = {1.5};
  tp_scene *scene = NULL;
  tp_message message = {.text = ""};
  const tp_status status = tp_scene_read_text(&scene, slab, "slab", &message);
  map_of(scene, status, message,
         (tp_chart_map_options){.size = sizeof(tp_chart_map_options),
                                .x = {"block.slab.width", {0.9, 1.2}},
                                .y = {"friction_angle_deg", {25, 40}},
                                .governing_fos = true,
                                .levels = {1, levels}});
}
