/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A file that appears whole or not at all: written under another name beside it, then renamed. */

#ifndef TP_FILE_H
#define TP_FILE_H

#include "topple.h"

typedef struct tp_file {
  const char *path; /* borrowed */
  char *temporary;
  int descriptor; /* closed on exec */
} tp_file;

TP_MUST_USE tp_status tp_file_open(tp_file *file, const char *path, tp_message *message);
TP_MUST_USE tp_status tp_file_write(const tp_file *file, const char *text, size_t length,
                                    tp_message *message);

/* Keep the file if `status` is TP_OK, else remove what was written; always called after an open
 * that succeeded. Returns `status`, or what went wrong in keeping it. */
TP_MUST_USE tp_status tp_file_close(tp_file *file, tp_status status, tp_message *message);

#endif
