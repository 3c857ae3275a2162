/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Growing list of notes and cautions; each owns its place and its text, which is made plain. */

#include "common/notes.h"

#include "common/outside.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void note_clear(tp_note *note) {
  free(note->place);
  free(note->text);
}

/* Room for `count` more; the first of them, or NULL. */
static tp_note *grow(tp_notes *notes, size_t count) {
  tp_note *items = realloc(notes->items, (notes->count + count) * sizeof *items);
  if (items == NULL) return NULL;
  notes->items = items;
  return items + notes->count;
}

/* Take the note, for which there is room, unless one of its texts could not be made. */
static tp_status keep(tp_notes *notes, tp_note own, tp_message *message) {
  if (own.place == NULL || own.text == NULL) {
    note_clear(&own);
    return tp_fail_memory(message, "a note");
  }
  notes->items[notes->count++] = own;
  return TP_OK;
}

/* The whole text, to be freed; NULL when memory is exhausted. */
static char *print(const char *format, va_list arguments) {
  va_list again;
  va_copy(again, arguments);
  const int length = vsnprintf(NULL, 0, format, again);
  va_end(again);
  char *text = length < 0 ? NULL : malloc((size_t)length + 1);
  if (text != NULL) vsnprintf(text, (size_t)length + 1, format, arguments);
  return text;
}

tp_status tp_notes_add(tp_notes *notes, tp_message *message, tp_note_kind kind, tp_place place,
                       const char *format, ...) {
  if (grow(notes, 1) == NULL) return tp_fail_memory(message, "a note");
  va_list arguments;
  va_start(arguments, format);
  char *text = print(format, arguments);
  va_end(arguments);
  const tp_note own = {kind, tp_place_new(place), text != NULL ? tp_plain_new(text) : NULL};
  free(text);
  return keep(notes, own, message);
}

tp_status tp_notes_append(tp_notes *notes, const tp_notes *more, tp_message *message) {
  if (more->count == 0) return TP_OK;
  if (grow(notes, more->count) == NULL) return tp_fail_memory(message, "a note");
  tp_status status = TP_OK;
  for (size_t k = 0; k < more->count && status == TP_OK; k++) {
    const tp_note *own = more->items + k;
    status = keep(notes, (tp_note){own->kind, strdup(own->place), strdup(own->text)}, message);
  }
  return status;
}

void tp_notes_clear(tp_notes *notes) {
  for (size_t k = 0; k < notes->count; k++) note_clear(notes->items + k);
  free(notes->items);
  *notes = (tp_notes){0};
}
