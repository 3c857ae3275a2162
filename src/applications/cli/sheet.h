/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the program puts on calculation sheets beside results: the date. */

#ifndef TP_CLI_SHEET_H
#define TP_CLI_SHEET_H

#include "cli/cli.h"

typedef struct tp_cli_date {
  char text[32];
} tp_cli_date;

/* The date of now; where SOURCE_DATE_EPOCH is set that one, and no times, so that the same input
 * gives the same bytes. `date` holds what the options point to. */
TP_MUST_USE tp_status tp_cli_sheet_options(tp_sheet_options *options, tp_cli_date *date,
                                           tp_message *message);

/* Solved with what a sheet shows beside what the options say: all pivots, and the account by
 * elements where there is one, which blocks with rounded corners have not. */
TP_MUST_USE tp_status tp_cli_solve_for_sheet(tp_solution **solution, const tp_scene *scene,
                                             const tp_solve_options *options, tp_message *message);

/* The word of --report: refused where it is no name of a sheet. */
void tp_cli_take_sheet(const char **path, const char *word, struct argp_state *state);

/* The value of --language; and it goes with --report. */
void tp_cli_take_language(const char **language, const char *word, const struct argp_state *state);
void tp_cli_check_language(const char *language, const char *report,
                           const struct argp_state *state);

#endif
