/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A file that appears whole or not at all: it is written under another name beside it, then
 * renamed, by a thread that takes no signals meanwhile, so that nothing is left behind where the
 * program is ended. As `cp` does, it writes to where a link leads, keeps the owner and the mode of
 * a file that is there, refuses one that may not be written, and writes to a pipe or a device in
 * place. So it does with a file of several names, and where the folder takes no new file or the
 * owner cannot be kept: then after the room for it was reserved. */

#ifndef TP_OUTPUT_FILE_H
#define TP_OUTPUT_FILE_H

#include "topple_figure.h"

/* Files that are read, and must not be written to, by whatever name. */
typedef struct tp_file_sources {
  size_t count;
  const char *const *paths;
} tp_file_sources;

TP_MUST_USE tp_status tp_file_write(const char *path, const char *bytes, size_t length,
                                    tp_file_sources sources, tp_message *message);

/* The same with consent (topple_figure.h), which may be given by nobody: then it is not asked for.
 */
TP_MUST_USE tp_status tp_file_write_if(const char *path, const char *bytes, size_t length,
                                       tp_file_sources sources, tp_figure_consent consent,
                                       tp_message *message);

/* A new file beside `path`, which no other run has, and its name, to be freed; its descriptor, or
 * -1. */
int tp_file_create_beside(char **name, const char *path);

/* A file to add to, made where there is none; its descriptor, which writes from the beginning on.
 * What is there is left as it is, and so the caller looks at it first. Like the above it goes to
 * where a link leads, and refuses one that leads nowhere. */
TP_MUST_USE tp_status tp_file_open_to_add(int *descriptor, const char *path, tp_message *message);

#endif
