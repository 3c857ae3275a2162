/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A document as Markdown with tables (GFM) and equations between dollars, as pandoc and the usual
 * hosts read it. */

#include "document/document.h"
#include "document/html_math.h"
#include "output/encode.h"

#include <stdlib.h>
#include <string.h>

static void add_paragraph(tp_text *t, const char *before, const char *text, const char *after) {
  tp_text_add(t, "%s", before);
  tp_encode_markdown(t, text);
  tp_text_add(t, "%s\n\n", after);
}

static void add_rule(tp_text *t, const tp_table *table) {
  for (size_t k = 0; k < table->columns; k++) {
    tp_text_add(t, (table->numeric >> k & 1) != 0 ? "| ---: " : "| --- ");
  }
  tp_text_add(t, "|\n");
}

static void add_table(tp_text *t, const tp_passage *passage) {
  const tp_table *table = &passage->table;
  add_paragraph(t, "", passage->text, "");
  for (size_t k = 0; k < table->columns; k++) {
    tp_text_add(t, "| ");
    if (table->kind == TP_TABLE_OF_COLUMNS) tp_encode_markdown(t, tp_table_head(table, k));
    tp_text_add(t, " ");
  }
  tp_text_add(t, "|\n");
  add_rule(t, table);
  for (size_t row = 0; row < tp_table_rows(table); row++) {
    const char *strong = table->has_mark && table->mark == row ? "**" : "";
    for (size_t k = 0; k < table->columns; k++) {
      const char *cell = tp_table_cell(table, row, k);
      const char *around = *cell != '\0' ? strong : "";
      tp_text_add(t, "| %s", around);
      tp_encode_markdown(t, cell);
      tp_text_add(t, "%s ", around);
    }
    tp_text_add(t, "|\n");
  }
  tp_text_add(t, "\n");
}

static void add_figure(tp_text *t, const tp_passage *passage) {
  if (passage->picture.svg == NULL) return;
  tp_text_add(t, "![");
  tp_encode_markdown(t, passage->beside);
  tp_text_add(t, "](data:image/svg+xml;base64,");
  tp_encode_base64(t, passage->picture.svg, passage->picture.svg_length);
  tp_text_add(t, ")\n\n");
  add_paragraph(t, "", passage->text, "");
}

/* Indented by four blanks, which no line of its own can end. */
static void add_listing(tp_text *t, const tp_passage *passage) {
  const char *at = passage->text;
  while (*at != '\0') {
    const size_t length = strcspn(at, "\n");
    char *line = strndup(at, length);
    t->failed = t->failed || line == NULL;
    tp_text_add(t, "    ");
    if (line != NULL) tp_encode_plain(t, line);
    free(line);
    tp_text_add(t, "\n");
    at += length + (at[length] == '\n');
  }
  tp_text_add(t, "\n");
}

static void add_passage(tp_text *t, const tp_passage *passage) {
  switch (passage->kind) {
  case TP_PASSAGE_HEADING:
    add_paragraph(t, passage->level == 2 ? "## " : "### ", passage->text, "");
    return;
  case TP_PASSAGE_PARAGRAPH:
    add_paragraph(t, "", passage->text, "");
    return;
  case TP_PASSAGE_ANSWER:
  case TP_PASSAGE_CAUTION:
    add_paragraph(t, "> ", passage->text, "");
    return;
  case TP_PASSAGE_EQUATION:
    tp_math_to_markdown(t, passage->text);
    return;
  case TP_PASSAGE_TABLE:
    add_table(t, passage);
    return;
  case TP_PASSAGE_FIGURE:
    add_figure(t, passage);
    return;
  case TP_PASSAGE_LISTING:
    add_listing(t, passage);
    return;
  case TP_PASSAGE_PAGE:
    tp_text_add(t, "---\n\n");
    return;
  }
}

static void add_letterhead(tp_text *t, const tp_document *d) {
  if (d->logo.kind != TP_LOGO_NONE) {
    tp_text_add(t, "![%s](data:image/%s;base64,", tp_say(d->language, "Logo"),
                tp_logo_type(d->logo.kind));
    tp_encode_base64(t, d->logo.bytes, d->logo.length);
    tp_text_add(t, ")\n\n");
  }
  if (d->company != NULL) add_paragraph(t, "", d->company, "");
}

tp_status tp_document_markdown(char **text, const tp_document *d) {
  if (d->failed) return TP_OUT_OF_MEMORY;
  tp_text t = {0};
  add_letterhead(&t, d);
  add_paragraph(&t, "# ", d->title, "");
  for (size_t k = 0; k < d->count; k++) add_passage(&t, d->passages + k);
  add_paragraph(&t, "", d->foot, "");
  return tp_text_finish(&t, text);
}
