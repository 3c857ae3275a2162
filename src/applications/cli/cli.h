/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The command line: one entry a command, and what all commands share. */

#ifndef TP_CLI_CLI_H
#define TP_CLI_CLI_H

#include "cli/words.h"
#include "topple.h"

#include <argp.h>

enum { TP_EXIT_REFUTED = 1, TP_EXIT_USAGE = 2, TP_EXIT_SYSTEM = 5 };

/* argv[0] is the program's name followed by the command's. Returns the exit status. */
int tp_cli_accuracy(int argc, char **argv);
int tp_cli_chart(int argc, char **argv);
int tp_cli_solve(int argc, char **argv);
int tp_cli_explain(int argc, char **argv);
int tp_cli_examples(int argc, char **argv);
int tp_cli_new(int argc, char **argv);
int tp_cli_derive(int argc, char **argv);
int tp_cli_profile(int argc, char **argv);
int tp_cli_solid(int argc, char **argv);
int tp_cli_study(int argc, char **argv);
int tp_cli_sweep(int argc, char **argv);
int tp_cli_tilt(int argc, char **argv);
int tp_cli_trace(int argc, char **argv);
int tp_cli_verify(int argc, char **argv);

/* Where FLINT and GMP run out of memory the program ends with a message and TP_EXIT_SYSTEM. */
void tp_cli_guard_memory(void);

/* What a command does once its words are read: to compute, and to print. `*ended` is the exit
 * status of what went well, 0 before it begins. */
typedef tp_status tp_cli_work(const void *words, int *ended, tp_message *message);

/* A command: read `words` by their parser, do the work, tell its complaint. The exit status. */
int tp_cli_run(const struct argp *parser, void *words, tp_cli_work *work, int argc, char **argv);

/* tp_report_figure_if, from the library that draws. */
TP_MUST_USE tp_status tp_cli_draw(const char *path, const tp_scene *scene,
                                  const tp_solution *solution, tp_figure_consent consent,
                                  tp_message *message);
/* tp_report_figure_block_system_if, likewise. */
TP_MUST_USE tp_status tp_cli_draw_system(const char *path, const tp_scene *scene,
                                         const tp_block_system *system, tp_figure_consent consent,
                                         tp_message *message);
/* tp_report_figure_solid_if, likewise. */
TP_MUST_USE tp_status tp_cli_draw_solid(const char *path, const tp_solid *solid,
                                        tp_figure_consent consent, tp_message *message);

/* tp_report_sheet and its kin, likewise. */
TP_MUST_USE tp_status tp_cli_write_system_sheet(const char *path, const tp_scene *scene,
                                                const tp_block_system *system,
                                                const tp_sheet_options *options,
                                                tp_message *message);

TP_MUST_USE tp_status tp_cli_write_solid_sheet(const char *path, const tp_scene *scene,
                                               const tp_solid *solid,
                                               const tp_sheet_options *options,
                                               tp_message *message);

TP_MUST_USE tp_status tp_cli_write_sheet(const char *path, const tp_scene *scene,
                                         const tp_solution *solution,
                                         const tp_sheet_options *options, tp_message *message);

TP_MUST_USE tp_status tp_cli_write_study_sheet(const char *path, const tp_study *study,
                                               const tp_study_result *result,
                                               const tp_sheet_options *options,
                                               tp_message *message);
TP_MUST_USE tp_status tp_cli_write_tilt_sheet(const char *path, const tp_scene *scene,
                                              const tp_tilt_test *test,
                                              const tp_sheet_options *options, tp_message *message);

/* tp_report_sheet_batch and tp_report_figures_batch, likewise. */
TP_MUST_USE tp_status tp_cli_write_batch_page(const char *path, const tp_batch *batch,
                                              size_t figures, tp_message *message);
TP_MUST_USE tp_status tp_cli_write_batch_figures(const char *folder, const char *ending,
                                                 const tp_batch *batch, tp_message *message);

/* The complaint of a status on stderr unless it is TP_OK; the exit status, which is `ended` then.
 */
int tp_cli_end(tp_status status, const tp_message *message, int ended);

/* Of two exit statuses the one that tells more: the system, bad input, a design factor that is not
 * met, undecided, done. */
int tp_cli_graver(int one, int other);

/* Write a whole report to stdout: 0, or TP_EXIT_SYSTEM with a message. */
int tp_cli_print(const char *text);

/* Write a report, which is freed, where `status`, of its making, is TP_OK and nothing failed
 * before. Returns that status. */
tp_status tp_cli_print_report(tp_status status, char *report, int *ended);

#endif
