/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene, and the files that it names, watched: something is done again whenever one of them
 * changes. */

#ifndef TP_CLI_WATCH_H
#define TP_CLI_WATCH_H

#include "topple.h"

/* Does it once; false ends the watch. */
typedef bool tp_cli_again(void *context);

/* Until the work says so, or a signal comes (cli/signals.h). Folders are watched by inotify, so
 * that a file that an editor replaces under its name is seen, and files are looked at once a second
 * for what inotify does not tell, as on a network. Changes that follow each other at once count as
 * one.
 */
TP_MUST_USE tp_status tp_cli_watch(const char *scene, tp_cli_again *again, void *context,
                                   tp_message *message);

#endif
