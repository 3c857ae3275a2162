/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The load cases of a scene that topple solve is given. */

#ifndef TP_CLI_SOLVE_CASES_H
#define TP_CLI_SOLVE_CASES_H

#include "cli/solve_words.h"

/* A scene as it is solved: of one that has cases, all of them, and the scene of the one that
 * governs. */
typedef struct tp_cli_solved {
  tp_scene *scene;
  tp_solution *solution;
  tp_load_cases *cases; /* NULL: it has none, or one was chosen; else the first has the solution */
} tp_cli_solved;

/* Read the scene; and where it has cases, of which none is chosen, solve them. */
TP_MUST_USE tp_status tp_cli_solve_cases(tp_cli_solved *solved, const char *path,
                                         const tp_solve_words *words,
                                         const tp_solve_options *options, tp_message *message);

/* An option, or NULL, of one load case, where there are several. */
TP_MUST_USE tp_status tp_cli_refuse_one_case(const char *path, const char *option,
                                             tp_message *message);

void tp_cli_solved_clear(tp_cli_solved *solved);

/* The table of scenes of one block: a row a case, in the order of their table. */
TP_MUST_USE tp_status tp_cli_print_rows(const tp_solve_words *words, const tp_cli_solved *solved,
                                        size_t count, int *ended);

#endif
