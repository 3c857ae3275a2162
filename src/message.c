/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "message.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* ":line:column" */
static void position_text(char text[32], tp_place place) {
  text[0] = '\0';
  if (place.line > 0 && place.column > 0) {
    snprintf(text, 32, ":%d:%d", place.line, place.column);
  } else if (place.line > 0) {
    snprintf(text, 32, ":%d", place.line);
  }
}

void tp_place_text(char *text, size_t size, tp_place place) {
  static const char left_out[] = "…";
  char position[32];
  if (place.file == NULL) {
    text[0] = '\0';
    return;
  }
  position_text(position, place);
  const char *file = place.file;
  const size_t length = strlen(file), room = size - 1 - strlen(position);
  if (length > room) {
    file += length - (room - strlen(left_out));
    while (((unsigned char)*file & 0xc0) == 0x80) file++; /* from the begin of a letter */
  }
  snprintf(text, size, "%s%s%s", length > room ? left_out : "", file, position);
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
