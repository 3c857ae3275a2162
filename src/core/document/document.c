/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Growing list of passages and table cells with their texts; a failed allocation is remembered and
 * ends the document as a whole. */

#include "document/document.h"

#include "output/encode.h"
#include "output/translate.h"

#include <stdlib.h>
#include <string.h>

static void passage_clear(tp_passage *passage) {
  for (size_t k = 0; k < passage->table.cell_count; k++) free(passage->table.cells[k]);
  free(passage->table.cells);
  free(passage->picture.svg);
  free(passage->picture.png);
  free(passage->text);
  free(passage->beside);
}

void tp_document_clear(tp_document *d) {
  for (size_t k = 0; k < d->count; k++) passage_clear(d->passages + k);
  free(d->passages);
  free(d->title);
  free(d->company);
  tp_logo_clear(&d->logo);
  free(d->foot);
  memset(d, 0, sizeof *d);
}

/* What a text holds; NULL when memory is exhausted. */
static char *taken(tp_document *d, tp_text *text) {
  char *own = NULL;
  tp_text_append(text, "", 0);
  d->failed = tp_text_finish(text, &own) != TP_OK || d->failed;
  return own;
}

static void set(tp_document *d, char **text, tp_text *from) {
  free(*text);
  *text = taken(d, from);
}

void tp_document_set_title(tp_document *d, tp_text *title) {
  set(d, &d->title, title);
}

void tp_document_set_foot(tp_document *d, tp_text *foot) {
  set(d, &d->foot, foot);
}

const char *tp_document_say(const tp_document *d, const char *english) {
  return tp_say(d->language, english);
}

void tp_document_set_decimals(const tp_document *d, tp_text *text) {
  if (d->comma && text->data != NULL) tp_language_set_commas(text->data);
}

void tp_document_set_letterhead(tp_document *d, const char *company, tp_logo logo) {
  tp_text text = {0};
  d->logo = logo;
  if (company == NULL || company[strspn(company, " ")] == '\0') return;
  tp_encode_plain(&text, company);
  set(d, &d->company, &text);
}

/* NULL when memory is exhausted. */
static tp_passage *new_passage(tp_document *d, tp_passage_kind kind) {
  if (d->count == d->room) {
    const size_t room = 2 * d->room + 32;
    tp_passage *passages = realloc(d->passages, room * sizeof *passages);
    d->failed = d->failed || passages == NULL;
    if (passages == NULL) return NULL;
    d->passages = passages;
    d->room = room;
  }
  tp_passage *own = d->passages + d->count++;
  *own = (tp_passage){.kind = kind};
  return own;
}

void tp_document_take(tp_document *d, tp_passage_kind kind, int level, tp_text *text) {
  tp_passage *own = new_passage(d, kind);
  if (own == NULL) {
    tp_text_drop(text);
    return;
  }
  own->level = level;
  if (kind == TP_PASSAGE_EQUATION) tp_document_set_decimals(d, text); /* it is all our own */
  own->text = taken(d, text);
}

/* In the language of the document. */
static void tell(tp_text *own, tp_document *d, const char *english) {
  tp_text plain = {0};
  tp_encode_plain(&plain, english);
  if (plain.data != NULL) tp_translate(own, d->language, d->comma, plain.data);
  own->failed = own->failed || plain.failed;
  tp_text_drop(&plain);
}

void tp_document_tell(tp_document *d, tp_passage_kind kind, int level, tp_text *english) {
  tp_text own = {0};
  if (english->data != NULL) tell(&own, d, english->data);
  own.failed = own.failed || english->failed;
  tp_text_drop(english);
  tp_document_take(d, kind, level, &own);
}

void tp_document_add(tp_document *d, tp_passage_kind kind, const char *format, ...) {
  tp_text text = {0};
  va_list arguments;
  va_start(arguments, format);
  tp_text_add_list(&text, tp_say(d->language, format), arguments);
  va_end(arguments);
  tp_document_set_decimals(d, &text);
  tp_document_take(d, kind, 0, &text);
}

void tp_document_heading(tp_document *d, int level, const char *format, ...) {
  tp_text text = {0};
  va_list arguments;
  va_start(arguments, format);
  tp_text_add_list(&text, tp_say(d->language, format), arguments);
  va_end(arguments);
  tp_document_set_decimals(d, &text);
  tp_document_take(d, TP_PASSAGE_HEADING, level, &text);
}

void tp_document_table(tp_document *d, tp_table_kind kind, size_t columns, unsigned numeric,
                       const char *caption) {
  tp_text text = {0};
  tp_text_add(&text, "%s", tp_say(d->language, caption));
  tp_document_take(d, TP_PASSAGE_TABLE, 0, &text);
  if (d->failed) return;
  d->passages[d->count - 1].table =
      (tp_table){.kind = kind, .columns = columns, .numeric = numeric};
}

static void take_cell(tp_document *d, tp_text *text) {
  char *own = taken(d, text);
  if (d->failed) {
    free(own);
    return;
  }
  tp_table *table = &d->passages[d->count - 1].table;
  if (table->cell_count == table->room) {
    const size_t room = 2 * table->room + 4 * table->columns;
    char **cells = realloc(table->cells, room * sizeof *cells);
    d->failed = cells == NULL;
    if (cells == NULL) {
      free(own);
      return;
    }
    table->cells = cells;
    table->room = room;
  }
  table->cells[table->cell_count++] = own;
}

void tp_document_cell(tp_document *d, const char *format, ...) {
  tp_text text = {0};
  va_list arguments;
  va_start(arguments, format);
  tp_text_add_list(&text, tp_say(d->language, format), arguments);
  va_end(arguments);
  tp_document_set_decimals(d, &text);
  take_cell(d, &text);
}

void tp_document_outside_cell(tp_document *d, const char *outside) {
  tp_text text = {0};
  tp_encode_plain(&text, outside);
  take_cell(d, &text);
}

void tp_document_told_cell(tp_document *d, const char *english) {
  tp_text own = {0};
  tell(&own, d, english);
  take_cell(d, &own);
}

void tp_document_word(tp_document *d, const char *english) {
  tp_text text = {0};
  tp_text_add(&text, "%s", tp_say(d->language, english));
  take_cell(d, &text);
}

void tp_document_take_cell(tp_document *d, tp_text *text) {
  tp_document_set_decimals(d, text);
  take_cell(d, text);
}

void tp_document_page(tp_document *d) {
  (void)new_passage(d, TP_PASSAGE_PAGE);
}

void tp_document_mark_row(tp_document *d) {
  if (d->failed) return;
  tp_table *table = &d->passages[d->count - 1].table;
  table->has_mark = true;
  table->mark = tp_table_rows(table);
}

void tp_document_figure(tp_document *d, tp_picture picture, const char *caption,
                        const char *alternative) {
  tp_text text = {0}, beside = {0};
  tp_text_add(&text, "%s", tp_say(d->language, caption));
  tp_text_add(&beside, "%s", tp_say(d->language, alternative));
  tp_document_take(d, TP_PASSAGE_FIGURE, 0, &text);
  char *own = taken(d, &beside);
  if (d->count == 0 || d->passages[d->count - 1].kind != TP_PASSAGE_FIGURE) {
    free(own);
    free(picture.svg);
    free(picture.png);
    return;
  }
  d->passages[d->count - 1].beside = own;
  d->passages[d->count - 1].picture = picture;
}

void tp_document_sketch(tp_document *d, tp_picture picture, const char *caption,
                        const char *alternative) {
  tp_document_figure(d, picture, caption, alternative);
  if (d->count > 0) d->passages[d->count - 1].fills = true;
}

static size_t head_rows(const tp_table *table) {
  return table->kind == TP_TABLE_OF_COLUMNS ? 1 : 0;
}

size_t tp_table_rows(const tp_table *table) {
  const size_t rows = table->columns > 0 ? table->cell_count / table->columns : 0;
  return rows > head_rows(table) ? rows - head_rows(table) : 0;
}

const char *tp_table_cell(const tp_table *table, size_t row, size_t column) {
  return table->cells[(row + head_rows(table)) * table->columns + column];
}

const char *tp_table_head(const tp_table *table, size_t column) {
  return table->cells[column];
}
