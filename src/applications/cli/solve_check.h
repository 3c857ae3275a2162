/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which options of topple solve go together. */

#ifndef TP_CLI_SOLVE_CHECK_H
#define TP_CLI_SOLVE_CHECK_H

#include "cli/solve_asked.h"

void tp_solve_words_check(tp_solve_words *words, struct argp_state *state);

#endif
