/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Commands that take long are interrupted by a signal, and end with what is known by then. */

#ifndef TP_CLI_SIGNALS_H
#define TP_CLI_SIGNALS_H

#include <stdbool.h>

/* From now on the first SIGINT, SIGTERM or SIGHUP is noted; a second one ends the program at once.
 */
void tp_cli_catch_signals(void);

/* The signal that was noted, or 0; whether there was one, for calls that ask. */
int tp_cli_signal(void);
bool tp_cli_is_interrupted(void *context);

/* Where one was noted: end by it, as the shell and scripts expect. */
void tp_cli_end_by_signal(void);

#endif
