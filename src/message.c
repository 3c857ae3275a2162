/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "message.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void tp_place_text(char *text, size_t size, tp_place place) {
  if (place.file == NULL) {
    text[0] = '\0';
  } else if (place.line <= 0) {
    snprintf(text, size, "%s", place.file);
  } else if (place.column <= 0) {
    snprintf(text, size, "%s:%d", place.file, place.line);
  } else {
    snprintf(text, size, "%s:%d:%d", place.file, place.line, place.column);
  }
}

tp_status tp_fail(tp_message *message, tp_status status, tp_place place, const char *format, ...) {
  if (message == NULL) return status;
  char where[512];
  tp_place_text(where, sizeof where, place);
  const size_t size = sizeof message->text;
  const int head = snprintf(message->text, size, "%s%s", where, where[0] != '\0' ? ": " : "");
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(message->text + head, size - (size_t)head, format, arguments);
  va_end(arguments);
  return status;
}

tp_status tp_fail_memory(tp_message *message, const char *what) {
  return tp_fail(message, TP_OUT_OF_MEMORY, (tp_place){0}, "out of memory while building %s", what);
}
