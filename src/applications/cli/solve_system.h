/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene of many blocks that topple solve is given. */

#ifndef TP_CLI_SOLVE_SYSTEM_H
#define TP_CLI_SOLVE_SYSTEM_H

#include "cli/solve_cases.h"

/* Options of a scene of one block are refused where there are many, and the other way about. */
TP_MUST_USE tp_status tp_cli_check_system(const char *path, const tp_solve_words *words,
                                          bool of_many, tp_message *message);

/* What is of one load case, where a scene of many blocks has several and none was chosen. */
TP_MUST_USE tp_status tp_cli_check_cases_of_many(const char *path, const tp_solve_words *words,
                                                 tp_message *message);

/* A table is of scenes of one block, or of many. */
TP_MUST_USE tp_status tp_cli_check_kinds(bool *of_many, const tp_cli_solved *solved,
                                         const char **paths, size_t count, tp_message *message);

/* Solved, printed, and judged by its factor. */
TP_MUST_USE tp_status tp_cli_solve_system(const tp_scene *scene, const tp_solve_words *words,
                                          int *ended, tp_message *message);

/* Several in one table, with all load cases of each, judged each by its path or the name of its
 * case. */
TP_MUST_USE tp_status tp_cli_solve_systems(const tp_cli_solved *scenes, const char **paths,
                                           size_t count, const tp_solve_words *words, int *ended,
                                           tp_message *message);

#endif
