/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The lines of the file of an accelerogram, shared by the readers of its formats. What stands in
 * the file is not quoted: it may be any file, which the scene names by mistake. */

#ifndef TP_SCENE_RECORD_SOURCE_H
#define TP_SCENE_RECORD_SOURCE_H

#include "plane/polyline.h"

#include <stdio.h>

enum { TP_RECORD_LINE = 1 << 13, TP_RECORD_MOST = 10000000 /* samples: 1 GB as exact numbers */ };

typedef struct tp_record_source {
  const char *path;
  FILE *file;
  char line[TP_RECORD_LINE];
  size_t length; /* of the line, without its end */
  int number;    /* of the line, from 1 */
  tp_message *message;
} tp_record_source;

/* The next line; `*more` is false at the end of the file. */
TP_MUST_USE tp_status tp_record_next(tp_record_source *source, bool *more);
/* At a column of the present line, counted from 0. */
tp_status tp_record_fail(const tp_record_source *source, size_t column, const char *what);
/* One more sample, which is read from `length` characters of the line from `at` on. */
TP_MUST_USE tp_status tp_record_value(fmpq_t value, const tp_record_source *source, size_t at,
                                      size_t length);
TP_MUST_USE tp_status tp_record_append(tp_polyline *record, const tp_record_source *source,
                                       const fmpq_t time, const fmpq_t acceleration, size_t at);

#endif
