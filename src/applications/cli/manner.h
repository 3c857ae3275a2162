/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* In which manner every command speaks, as --quiet and --color say: kept for the process. */

#ifndef TP_CLI_MANNER_H
#define TP_CLI_MANNER_H

#include <stdbool.h>

/* Nothing is to go to the standard output, and no progress is told. */
void tp_cli_be_quiet(void);
bool tp_cli_is_quiet(void);

/* auto, always or never; false: it is none of them. */
bool tp_cli_colour_when(const char *when);

/* Is what goes to that file coloured? Where --color does not say, a terminal is, unless NO_COLOR is
 * set and not empty, or TERM is dumb. */
bool tp_cli_colours(int file);

#endif
