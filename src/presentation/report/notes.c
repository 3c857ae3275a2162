/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Notes, cautions and settings wrapped at 80 columns with a hanging indent, counted in characters
 * of UTF-8; the same as JSON. */

#include "report/notes.h"

#include "common/host.h"
#include "output/encode.h"
#include "report/settings.h"

#include <stdlib.h>
#include <string.h>

enum { INDENT = 9, WIDTH = 80 };

/* Characters of UTF-8. */
static size_t width_of(const char *text, size_t length) {
  size_t width = 0;
  for (size_t k = 0; k < length; k++) width += ((unsigned char)text[k] & 0xc0) != 0x80;
  return width;
}

/* Word by word, on as many lines as it takes; `*column` is where the line stands. */
static void add_words(tp_text *t, const char *words, size_t *column) {
  while (*words != '\0') {
    const size_t length = strcspn(words, " "), width = width_of(words, length);
    const bool begins = *column == INDENT;
    if (!begins && *column + 1 + width > WIDTH) {
      tp_text_add(t, "\n%*s", INDENT, "");
      *column = INDENT;
    } else if (!begins) {
      tp_text_add(t, " ");
      ++*column;
    }
    tp_text_add(t, "%.*s", (int)length, words);
    *column += width;
    words += length + strspn(words + length, " ");
  }
}

void tp_text_settings(tp_text *t, const tp_settings *settings) {
  for (size_t k = 0; k < settings->count; k++) {
    char *text = tp_text_setting(settings->items + k);
    size_t column = INDENT;
    tp_text_add(t, "%-*s", INDENT, "Set");
    if (text != NULL) add_words(t, text, &column);
    tp_text_add(t, "\n");
    t->failed = t->failed || text == NULL;
    free(text);
  }
}

void tp_text_notes(tp_text *t, const tp_notes *notes) {
  for (size_t k = 0; k < notes->count; k++) {
    const tp_note *note = notes->items + k;
    size_t column = INDENT;
    tp_text_add(t, "%-*s", INDENT, note->kind == TP_CAUTION ? "Caution" : "Note");
    add_words(t, note->text, &column);
    if (note->place[0] != '\0') {
      tp_text place = {0};
      tp_text_add(&place, "(");
      tp_encode_plain(&place, note->place);
      tp_text_add(&place, ")");
      if (!place.failed) add_words(t, place.data, &column);
      t->failed = t->failed || place.failed;
      tp_text_drop(&place);
    }
    tp_text_add(t, "\n");
  }
}

tp_status tp_report_notes(char **text, const tp_solution *solution) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, solution);
  tp_text t = {0};
  tp_text_add(&t, "%s", "");
  tp_text_settings(&t, &solution->settings);
  tp_text_notes(&t, &solution->notes);
  return tp_text_finish(&t, text);
}
