/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The command line: one entry a command. */

#ifndef TP_CLI_H
#define TP_CLI_H

#include "cli/words.h"
#include "topple.h"

#include <argp.h>

enum { TP_EXIT_REFUTED = 1, TP_EXIT_USAGE = 2, TP_EXIT_SYSTEM = 5 };

/* argv[0] is the program's name followed by the command's. Returns the exit status. */
int tp_cli_accuracy(int argc, char **argv);
int tp_cli_chart(int argc, char **argv);
int tp_cli_solve(int argc, char **argv);
int tp_cli_derive(int argc, char **argv);
int tp_cli_verify(int argc, char **argv);

/* Where FLINT and GMP run out of memory the program ends with a message and TP_EXIT_SYSTEM. */
void tp_cli_guard_memory(void);

/* Read the words of a command: 0, or the exit status, complained about. */
int tp_cli_parse(const struct argp *parser, int argc, char **argv, void *arguments);

/* tp_report_figure_if, from the library that draws. */
TP_MUST_USE tp_status tp_cli_draw(const char *path, const tp_scene *scene,
                                  const tp_solution *solution, tp_figure_consent consent,
                                  tp_message *message);

/* The end of a command: its complaint on stderr unless the status is TP_OK; the exit status, which
 * is `written` (of tp_cli_print) then. */
int tp_cli_end(tp_status status, const tp_message *message, int written);

/* Write a whole report to stdout: 0, or TP_EXIT_SYSTEM with a message. */
int tp_cli_print(const char *text);

#endif
