/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Files that the program brings along and files that it writes where there were none. */

#ifndef TP_CLI_FILES_H
#define TP_CLI_FILES_H

#include "topple.h"

#include <limits.h>

/* The folder of the example scenes: as the program is installed, wherever to; in the checkout from
 * whose build folder it runs; else where it was meant to be installed. False: there is none. */
bool tp_cli_examples_folder(char folder[PATH_MAX]);

/* The whole of a file with a zero byte at its end, to be freed, and its length. At most 64 MB. */
TP_MUST_USE tp_status tp_cli_read_file(char **text, size_t *length, const char *path,
                                       tp_message *message);

/* A new file with these bytes, and the folders on the way to it. What is there is never replaced:
 * a file of the same bytes is left as it is where `same_will_do`, anything else is refused. A file
 * that cannot be written whole is removed. */
TP_MUST_USE tp_status tp_cli_create_file(const char *path, const char *bytes, size_t length,
                                         bool same_will_do, bool *created, tp_message *message);

/* Would that be refused? Told before anything is written. */
TP_MUST_USE tp_status tp_cli_may_create(const char *path, const char *bytes, size_t length,
                                        bool same_will_do, tp_message *message);

/* The path of a file in a folder; false: it is too long. */
bool tp_cli_join(char path[PATH_MAX], const char *folder, const char *name);

/* The length of the folder's name in a path, with its slash; 0 where it has none. */
size_t tp_cli_folder_length(const char *path);

#endif
