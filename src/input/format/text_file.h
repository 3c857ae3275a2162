/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A text file whole in memory, as UTF-8 without a mark at its beginning: UTF-16 with its mark is
 * turned into it, anything else is left as it is. At most 128 MiB. */

#ifndef TP_FORMAT_TEXT_FILE_H
#define TP_FORMAT_TEXT_FILE_H

#include "common/message.h"

typedef struct tp_text_file {
  char *text; /* ends with a NUL that is not counted */
  size_t length;
} tp_text_file;

/* `file` stays untouched on failure; freed by free(file->text). */
TP_MUST_USE tp_status tp_text_file_read(tp_text_file *file, const char *path, tp_message *message);

#endif
