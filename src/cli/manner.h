/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* In which manner every command speaks: --quiet, --color. */

#ifndef TP_CLI_MANNER_H
#define TP_CLI_MANNER_H

#include <argp.h>
#include <stdbool.h>

/* The options, as a child of the parser of every command. What they say is kept for the process. */
extern const struct argp_child tp_cli_manner_options[];

/* Nothing is to go to the standard output, and no progress is told. */
bool tp_cli_is_quiet(void);

/* Is what goes to that file coloured? Where --color does not say, a terminal is, unless NO_COLOR is
 * set and not empty, or TERM is dumb. */
bool tp_cli_colours(int file);

/* A report on the standard output, its verdicts and cautions coloured where that is coloured; as
 * tp_cli_print. Colour says nothing that the words do not. */
int tp_cli_print_verdicts(const char *text);

#endif
