/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Below a table of scenes, of one block or of many: a line for each number that was set and for
 * each note, which begins with the name of its scene. */

#include "report/table_notes.h"

#include "output/encode.h"
#include "report/settings.h"

#include <stdlib.h>

static void add_name(tp_text *t, const char *title) {
  tp_text_add(t, "- ");
  tp_encode_markdown(t, title != NULL ? title : "a scene");
}

void tp_table_notes(tp_text *t, const char *title, const tp_settings *settings,
                    const tp_notes *notes) {
  for (size_t k = 0; k < settings->count; k++) {
    char *text = tp_text_setting(settings->items + k);
    add_name(t, title);
    tp_text_add(t, ", set: ");
    tp_encode_markdown(t, text != NULL ? text : "");
    tp_text_add(t, "\n");
    t->failed = t->failed || text == NULL;
    free(text);
  }
  for (size_t k = 0; k < notes->count; k++) {
    const tp_note *note = notes->items + k;
    add_name(t, title);
    tp_text_add(t, ", %s: ", tp_note_kind_name(note->kind));
    tp_encode_markdown(t, note->text);
    if (note->place[0] != '\0') {
      tp_text_add(t, " (");
      tp_encode_markdown(t, note->place);
      tp_text_add(t, ")");
    }
    tp_text_add(t, "\n");
  }
}
