/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Colours of verdicts and cautions in a report on the terminal. */

#ifndef TP_CLI_VERDICT_COLOURS_H
#define TP_CLI_VERDICT_COLOURS_H

/* A report on the standard output, its verdicts and cautions coloured where that is coloured; as
 * tp_cli_print. Colour says nothing that the words do not. */
int tp_cli_print_verdicts(const char *text);

#endif
