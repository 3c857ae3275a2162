/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple chart KIND: computes the chart asked for, then prints or writes it (docs/chart.md). */

#include "cli/chart_options.h"
#include "cli/cli.h"

static tp_status compute_map(tp_chart **chart, const tp_chart_arguments *a, tp_message *message) {
  tp_scene *scene = NULL;
  tp_chart_map_options map = a->map;
  tp_status status = tp_cli_read_scene(&scene, a->scene, &a->settings, message);
  map.scene = scene;
  if (status == TP_OK) status = tp_chart_map(chart, &map, message);
  tp_scene_free(scene);
  return status;
}

static tp_status compute(tp_chart **chart, const tp_chart_arguments *a, tp_message *message) {
  switch (a->kind) {
  case TP_CHART_KIND_FOS:
    return tp_chart_fos(chart, &a->fos, message);
  case TP_CHART_KIND_MECHANISMS:
    return tp_chart_mechanisms(chart, &a->mechanisms, message);
  case TP_CHART_KIND_RANGES:
    return tp_chart_ranges(chart, message);
  case TP_CHART_KIND_MAP:
  case TP_CHART_KINDS:
    break;
  }
  return compute_map(chart, a, message);
}

static tp_status print(const tp_chart *chart, bool json, int *ended) {
  char *text = NULL;
  const tp_status status =
      json ? tp_report_chart_json(&text, chart) : tp_report_chart_csv(&text, chart);
  return tp_cli_print_report(status, text, ended);
}

static tp_status compute_and_tell(const void *words, int *ended, tp_message *message) {
  const tp_chart_arguments *a = words;
  tp_chart *chart = NULL;
  tp_status status = compute(&chart, a, message);
  if (status == TP_OK) {
    status = a->output != NULL ? tp_report_chart_file(a->output, chart, a->format, message)
                               : print(chart, a->json, ended);
  }
  tp_chart_free(chart);
  return status;
}

int tp_cli_chart(int argc, char **argv) {
  tp_chart_arguments a = {.fos = tp_chart_fos_options_default(),
                          .mechanisms = tp_chart_mechanisms_options_default(),
                          .map = tp_chart_map_options_default()};
  return tp_cli_run(&tp_chart_parser, &a, compute_and_tell, argc, argv);
}
