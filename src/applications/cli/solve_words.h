/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The options of topple solve, read. */

#ifndef TP_CLI_SOLVE_WORDS_H
#define TP_CLI_SOLVE_WORDS_H

#include "cli/solve_asked.h"

/* As they are where none is given. */
tp_solve_words tp_solve_words_default(void);

extern const struct argp tp_solve_parser;

#endif
