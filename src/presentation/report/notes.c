/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Notes, cautions and settings wrapped at 80 columns with a hanging indent, counted in characters
 * of UTF-8; the same as JSON. */

#include "report/notes.h"

#include "common/host.h"
#include "output/encode.h"
#include "output/wrap.h"
#include "report/settings.h"

#include <stdlib.h>
#include <string.h>

enum { INDENT = 9 };

static const tp_wrapping hanging = {.indent = INDENT, .column = INDENT};

void tp_text_settings(tp_text *t, const tp_settings *settings) {
  for (size_t k = 0; k < settings->count; k++) {
    char *text = tp_text_setting(settings->items + k);
    tp_wrapping wrapping = hanging;
    tp_text_add(t, "%-*s", INDENT, "Set");
    if (text != NULL) tp_text_add_wrapped(t, text, &wrapping);
    tp_text_add(t, "\n");
    t->failed = t->failed || text == NULL;
    free(text);
  }
}

void tp_text_notes(tp_text *t, const tp_notes *notes) {
  for (size_t k = 0; k < notes->count; k++) {
    const tp_note *note = notes->items + k;
    tp_wrapping wrapping = hanging;
    tp_text_add(t, "%-*s", INDENT, note->kind == TP_CAUTION ? "Caution" : "Note");
    tp_text_add_wrapped(t, note->text, &wrapping);
    if (note->place[0] != '\0') {
      tp_text place = {0};
      tp_text_add(&place, "(");
      tp_encode_plain(&place, note->place);
      tp_text_add(&place, ")");
      if (!place.failed) tp_text_add_wrapped(t, place.data, &wrapping);
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
