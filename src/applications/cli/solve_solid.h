/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple solve of a scene of a solid (docs/solids.md). */

#ifndef TP_CLI_SOLVE_SOLID_H
#define TP_CLI_SOLVE_SOLID_H

#include "cli/solve_words.h"

/* Refuses options that say nothing of a solid. */
TP_MUST_USE tp_status tp_cli_check_solid(const char *path, const tp_solve_words *a,
                                         tp_message *message);

TP_MUST_USE tp_status tp_cli_solve_solid(const tp_scene *scene, const tp_solve_words *a, int *ended,
                                         tp_message *message);

#endif
