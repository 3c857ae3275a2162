/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A report and a figure, of which neither is left behind without the other: the figure is drawn
 * beside its place, the report printed, and the figure put there if that went well. */

#include "cli/drawn_report.h"

static bool print(void *context) {
  tp_cli_drawn_report *report = context;
  report->status = report->print(report->of, report->ended, &report->message);
  return report->status == TP_OK && *report->ended == 0;
}

tp_figure_consent tp_cli_drawn_report_consent(tp_cli_drawn_report *report) {
  return (tp_figure_consent){print, report};
}

tp_status tp_cli_drawn_report_end(const tp_cli_drawn_report *report, tp_status drawn,
                                  tp_message *message) {
  if (report->status == TP_OK && *report->ended == 0) return drawn;
  *message = report->message;
  return report->status;
}
