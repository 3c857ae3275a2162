/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Libraries that the program loads when it needs them, not at every start. */

#ifndef TP_CLI_LIBRARY_H
#define TP_CLI_LIBRARY_H

/* Beside the program, as it is built; where it lies seen from the program, as it is installed,
 * wherever to; else where it was meant to be installed. It stays loaded. NULL: dlerror tells. */
void *tp_cli_load_library(const char *name);

#endif
