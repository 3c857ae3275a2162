/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Runs the convergence test of a scene's settings, reports it, and draws its chart
 * (docs/tilt_converge.md). */

#include "cli/tilt_converge.h"

static tp_status draw(const tp_cli_converge *asked, const tp_tilt_convergence *convergence,
                      tp_message *message) {
  tp_chart *chart = NULL;
  tp_status status = tp_chart_tilt_convergence(&chart, convergence, message);
  if (status == TP_OK) {
    status = tp_report_chart_file(asked->figure, chart, asked->format, message);
  }
  tp_chart_free(chart);
  return status;
}

static void tell_open(const tp_cli_converge *asked, const tp_tilt_convergence *convergence,
                      int *ended) {
  for (size_t k = 0; k < convergence->case_count; k++) {
    const tp_tilt_convergence_case *own = convergence->cases + k;
    if (own->converged) continue;
    tp_cli_complain("%s: tilted towards the %s, the test is not converged over its settings",
                    asked->path, own->towards == TP_TOWARDS_LEFT ? "left" : "right");
    *ended = tp_cli_graver(*ended, tp_status_exit(TP_UNDECIDED));
  }
}

tp_status tp_cli_tilt_converge(const tp_cli_converge *asked, const tp_scene *scene,
                               const tp_tilt_options *options, int *ended, tp_message *message) {
  tp_tilt_convergence *convergence = NULL;
  tp_status status = tp_tilt_converge(&convergence, scene, options, message);
  if (options->progress != NULL) tp_cli_clear_progress();
  if (status == TP_OK) {
    char *report = NULL;
    const tp_status told = asked->json ? tp_report_tilt_convergence_json(&report, convergence)
                                       : tp_report_tilt_convergence(&report, convergence);
    status = tp_cli_print_report(told, report, ended);
  }
  if (status == TP_OK && *ended == 0 && asked->figure != NULL) {
    status = draw(asked, convergence, message);
  }
  if (status == TP_OK && *ended == 0) tell_open(asked, convergence, ended);
  tp_tilt_convergence_free(convergence);
  return status;
}
