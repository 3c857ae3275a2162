/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Files that a user names, opened to be read.
 *
 * A scene may name any path. A device such as /dev/zero has no end, and a pipe that nobody writes
 * to keeps its reader waiting: both are refused, without being opened. Standard input and what a
 * shell makes of `<(…)` are pipes of the process itself, /dev/stdin and /dev/fd/63, and are read;
 * the readers bound how much they take. */

#ifndef TP_COMMON_INPUT_FILE_H
#define TP_COMMON_INPUT_FILE_H

#include "common/message.h"

#include <stdio.h>

/* Open it to read bytes; the caller closes it. TP_SYSTEM_FAILED where it cannot be opened; bad
 * input where it is no regular file. Of a folder the first read fails. */
TP_MUST_USE tp_status tp_input_open(FILE **file, const char *path, tp_message *message);

/* The check alone, for libraries that open a file by its name. */
TP_MUST_USE tp_status tp_input_check(const char *path, tp_message *message);

#endif
