/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple chart KIND */

#include "cli/chart_options.h"
#include "cli/cli.h"

#include <stdlib.h>

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
  return tp_chart_map(chart, &a->map, message);
}

static tp_status print(const tp_chart *chart, bool json, int *written) {
  char *text = NULL;
  const tp_status status =
      json ? tp_report_chart_json(&text, chart) : tp_report_chart_csv(&text, chart);
  if (status == TP_OK) *written = tp_cli_print(text);
  free(text);
  return status;
}

int tp_cli_chart(int argc, char **argv) {
  tp_chart_arguments a = {.fos = tp_chart_fos_options_default(),
                          .mechanisms = tp_chart_mechanisms_options_default(),
                          .map = {.y = {"tilt", {0, 90}}}};
  const int refused = tp_cli_parse(&tp_chart_parser, argc, argv, &a);
  if (refused != 0) return refused;
  tp_chart *chart = NULL;
  tp_message message = {""};
  int written = 0;
  tp_status status = compute(&chart, &a, &message);
  if (status == TP_OK) {
    status = a.output != NULL ? tp_report_chart_file(chart, a.output, a.format, &message)
                              : print(chart, a.json, &written);
  }
  tp_chart_free(chart);
  return tp_cli_end(status, &message, written);
}
