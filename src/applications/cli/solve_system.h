/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene of many blocks that topple solve is given. */

#ifndef TP_CLI_SOLVE_SYSTEM_H
#define TP_CLI_SOLVE_SYSTEM_H

#include "cli/solve_words.h"

/* Options of a scene of one block are refused. */
TP_MUST_USE tp_status tp_cli_check_system(const char *path, const tp_solve_words *words,
                                          tp_message *message);

/* Solved, printed, and judged by its factor. */
TP_MUST_USE tp_status tp_cli_solve_system(const tp_scene *scene, const tp_solve_words *words,
                                          int *ended, tp_message *message);

#endif
