/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Formats a message as place, then text, cut to the size of the struct and made plain as one piece
 * (common/outside.h). */

#include "common/message.h"

#include "common/outside.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A path that is too long loses its beginning, so that the place in it stays. */
void tp_place_text(char *text, size_t size, tp_place place) {
  char numbers[32] = "";
  if (place.file == NULL) {
    text[0] = '\0';
    return;
  }
  if (place.line > 0 && place.column > 0) {
    snprintf(numbers, sizeof numbers, ":%d:%d", place.line, place.column);
  } else if (place.line > 0) {
    snprintf(numbers, sizeof numbers, ":%d", place.line);
  }
  static const char ellipsis[] = "…";
  const size_t room = size - 1 - strlen(numbers);
  const bool fits = strlen(place.file) <= room;
  snprintf(text, size, "%s%s%s", fits ? "" : ellipsis,
           tp_tail_of(place.file, fits ? room : room - strlen(ellipsis)), numbers);
}

char *tp_place_new(tp_place place) {
  enum { NUMBERS = 64 };
  const size_t size = NUMBERS + (place.file != NULL ? strlen(place.file) : 0);
  char *text = malloc(size);
  if (text != NULL) tp_place_text(text, size, place);
  return text;
}

static void set_place(tp_message *message, tp_place place) {
  char file[sizeof message->file];
  tp_place_text(file, sizeof file, (tp_place){place.file, 0, 0});
  tp_plain_text(message->file, sizeof message->file, file);
  message->line = place.file != NULL ? place.line : 0;
  message->column = message->line > 0 ? place.column : 0;
  message->system_error = 0;
  message->fault = TP_FAULT_NONE;
}

/* The whole message is made plain, so that nothing of what it quotes acts on a terminal. */
static void write_text(tp_message *message, tp_place place, const char *format, va_list arguments) {
  set_place(message, place);
  char text[2 * sizeof message->text];
  tp_place_text(text, sizeof message->text / 2, place);
  size_t head = strlen(text);
  if (head > 0) head += (size_t)snprintf(text + head, sizeof text - head, ": ");
  const int length = vsnprintf(text + head, sizeof text - head, format, arguments);
  if (length >= 0 && head + (size_t)length >= sizeof text) { /* plain, the rest might fit */
    strcpy(text + tp_whole_characters(text, sizeof text - sizeof "…"), "…");
  }
  tp_plain_text(message->text, sizeof message->text, text);
}

tp_status tp_fail(tp_message *message, tp_status status, tp_place place, const char *format, ...) {
  if (message == NULL) return status;
  va_list arguments;
  va_start(arguments, format);
  write_text(message, place, format, arguments);
  va_end(arguments);
  return status;
}

tp_status tp_refuse(tp_message *message, tp_fault fault, tp_place place, const char *format, ...) {
  if (message == NULL) return TP_BAD_INPUT;
  va_list arguments;
  va_start(arguments, format);
  write_text(message, place, format, arguments);
  va_end(arguments);
  message->fault = fault;
  return TP_BAD_INPUT;
}

tp_status tp_fail_because(tp_message *message, tp_status status, int why) {
  if (message != NULL) message->system_error = why;
  return status;
}

tp_status tp_fail_file(tp_message *message, const char *path, const char *what, int why) {
  const tp_status status = why == ENOMEM ? TP_OUT_OF_MEMORY : TP_SYSTEM_FAILED;
  const tp_place place = {path, 0, 0};
  return tp_fail_because(
      message, tp_fail(message, status, place, "cannot be %s: %s", what, strerror(why)), why);
}

tp_status tp_fail_memory(tp_message *message, const char *what) {
  return tp_fail(message, TP_OUT_OF_MEMORY, (tp_place){0}, "out of memory while building %s", what);
}
