/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Messages: what went wrong, where (file:line:column), and what to do. */

#ifndef TP_COMMON_MESSAGE_H
#define TP_COMMON_MESSAGE_H

#include "topple.h"

/* A position in a file; line and column count from 1, 0 says that they are not known. */
typedef struct tp_place {
  const char *file; /* borrowed; NULL: no place */
  int line, column;
} tp_place;

/* Write "file:line:column: text" into the message and return `status`, so that a caller can
 * `return tp_fail(…)`. `message` may be NULL. The whole is made plain (outside.h), whatever the
 * arguments hold; what is quoted is bounded by tp_quote_of, and what does not fit ends in …. */
tp_status tp_fail(tp_message *message, tp_status status, tp_place place, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* As tp_fail for TP_BAD_INPUT, with its kind. */
tp_status tp_refuse(tp_message *message, tp_fault fault, tp_place place, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* As tp_fail for TP_OUT_OF_MEMORY, naming what was being built. */
tp_status tp_fail_memory(tp_message *message, const char *what);

/* A file cannot be `what` ("opened", "read"), for the reason that an errno is: TP_SYSTEM_FAILED, or
 * TP_OUT_OF_MEMORY. */
tp_status tp_fail_file(tp_message *message, const char *path, const char *what, int why);

/* Notes in the message which errno the system gave; returns the status. */
tp_status tp_fail_because(tp_message *message, tp_status status, int why);

/* "file:line:column" into `text` of at least 64 bytes, shorter where parts are not known. Of a long
 * path the end is kept, and the position always. */
void tp_place_text(char *text, size_t size, tp_place place);

/* The same whole, to be freed; empty where there is no place, NULL when memory is exhausted. */
char *tp_place_new(tp_place place);

#endif
