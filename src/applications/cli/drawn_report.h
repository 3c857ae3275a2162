/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A report that goes with a figure: the figure is left behind only if the report is written. */

#ifndef TP_CLI_DRAWN_REPORT_H
#define TP_CLI_DRAWN_REPORT_H

#include "cli/cli.h"

typedef struct tp_cli_drawn_report {
  tp_cli_work *print; /* what prints it, */
  const void *of;     /* of what */
  int *ended;
  tp_status status; /* of the printing */
  tp_message message;
} tp_cli_drawn_report;

/* Prints the report once the figure is ready. */
tp_figure_consent tp_cli_drawn_report_consent(tp_cli_drawn_report *report);

/* How both went: where the report could not be written it is that, not the figure that was left out
 * for want of it. */
TP_MUST_USE tp_status tp_cli_drawn_report_end(const tp_cli_drawn_report *report, tp_status drawn,
                                              tp_message *message);

#endif
