/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Libraries that the program loads when it needs them, not at every start. */

#ifndef TP_CLI_LIBRARY_H
#define TP_CLI_LIBRARY_H

/* Why there is none. */
typedef struct tp_cli_why {
  char text[300];
} tp_cli_why;

/* What the library has by the name of `call`. The library lies beside the program, as it is built;
 * where it lies seen from the program, as it is installed, wherever to; else where it was meant to
 * be installed. It is of the program's version to the last digit, as both know what no public
 * header says, and stays loaded. NULL: `why` tells. */
void *tp_cli_load_call(const char *library, const char *call, tp_cli_why *why);

#endif
