/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "notes.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *tp_note_kind_name(tp_note_kind kind) {
  return kind == TP_CAUTION ? "caution" : "note";
}

/* Room for `count` more; the first of them, or NULL. */
static tp_note *grow(tp_notes *notes, size_t count) {
  tp_note *items = realloc(notes->items, (notes->count + count) * sizeof *items);
  if (items == NULL) return NULL;
  notes->items = items;
  return items + notes->count;
}

tp_status tp_notes_add(tp_notes *notes, tp_message *message, tp_note_kind kind, tp_place place,
                       const char *format, ...) {
  tp_note *note = grow(notes, 1);
  if (note == NULL) return tp_fail_memory(message, "a note");
  char text[2 * sizeof note->text];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  memset(note, 0, sizeof *note);
  note->kind = kind;
  tp_place_text(note->place, sizeof note->place, place);
  tp_plain_text(note->text, sizeof note->text, text);
  notes->count++;
  return TP_OK;
}

tp_status tp_notes_append(tp_notes *notes, const tp_notes *more, tp_message *message) {
  if (more->count == 0) return TP_OK;
  tp_note *first = grow(notes, more->count);
  if (first == NULL) return tp_fail_memory(message, "a note");
  memcpy(first, more->items, more->count * sizeof *first);
  notes->count += more->count;
  return TP_OK;
}

void tp_notes_clear(tp_notes *notes) {
  free(notes->items);
  *notes = (tp_notes){0};
}
