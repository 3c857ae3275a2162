/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What cells of a workbook refer to: its first worksheet, the texts that they share, and which of
 * their styles show a date (ECMA-376, part 1, 18.8.30: formats 14 to 22 and 45 to 47, and those of
 * the workbook's own that have a letter of dates outside quotes and brackets). */

#include "common/grow.h"
#include "common/message.h"
#include "xlsx/book.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- the first worksheet -----------------------------------------------------------------------
 */

typedef struct finding {
  char id[64]; /* of the relation of the first worksheet */
} finding;

static void start_workbook(tp_parse *p, const char *name, const char **attributes) {
  finding *own = p->context;
  if (strcmp(name, "workbookPr") == 0) {
    const char *since = tp_book_attribute(attributes, "date1904");
    p->book->since_1904 = since != NULL && (since[0] == '1' || since[0] == 't');
  }
  if (strcmp(name, "sheet") != 0 || own->id[0] != '\0') return;
  const char *id = tp_book_attribute(attributes, "id");
  if (id != NULL) snprintf(own->id, sizeof own->id, "%s", id);
}

static void start_relation(tp_parse *p, const char *name, const char **attributes) {
  const finding *own = p->context;
  tp_book *book = p->book;
  if (strcmp(name, "Relationship") != 0) return;
  const char *id = tp_book_attribute(attributes, "Id");
  const char *target = tp_book_attribute(attributes, "Target");
  if (id == NULL || target == NULL || strcmp(id, own->id) != 0) return;
  snprintf(book->sheet, sizeof book->sheet, "%s%s", target[0] == '/' ? "" : "xl/",
           target[0] == '/' ? target + 1 : target);
}

static void end_nothing(tp_parse *p, const char *name) {
  (void)p;
  (void)name;
}

tp_status tp_book_find_sheet(tp_book *book) {
  finding own = {.id = ""};
  tp_parse workbook = {.book = book, .context = &own, .start = start_workbook, .end = end_nothing};
  tp_parse relations = {.book = book, .context = &own, .start = start_relation, .end = end_nothing};
  tp_status status = tp_book_parse(&workbook, "xl/workbook.xml", true);
  if (status == TP_OK) status = tp_book_parse(&relations, "xl/_rels/workbook.xml.rels", true);
  if (status == TP_OK && book->sheet[0] == '\0') {
    return tp_refuse(book->message, TP_FAULT_FORMAT, (tp_place){book->path, 0, 0},
                     "the workbook has no worksheet");
  }
  return status;
}

/* ---- shared texts ------------------------------------------------------------------------------
 */

static void start_string(tp_parse *p, const char *name, const char **attributes) {
  bool *phonetic = p->context; /* a reading aid beside the text, which is not of it */
  (void)attributes;
  if (strcmp(name, "si") == 0) p->text.length = 0;
  if (strcmp(name, "rPh") == 0) *phonetic = true;
  p->collects = strcmp(name, "t") == 0 && !*phonetic;
}

static void end_string(tp_parse *p, const char *name) {
  tp_book *book = p->book;
  bool *phonetic = p->context;
  p->collects = false;
  if (strcmp(name, "rPh") == 0) *phonetic = false;
  if (strcmp(name, "si") != 0) return;
  char **strings =
      tp_grow(book->strings, (long)book->string_count, &book->string_room, sizeof *strings);
  char *own = strndup(p->text.data != NULL ? p->text.data : "", p->text.length);
  if (strings != NULL) book->strings = strings;
  if (strings == NULL || own == NULL) {
    free(own);
    tp_parse_stop(p, NULL);
    return;
  }
  strings[book->string_count++] = own;
}

tp_status tp_book_read_strings(tp_book *book) {
  bool phonetic = false;
  tp_parse parse = {.book = book, .context = &phonetic, .start = start_string, .end = end_string};
  return tp_book_parse(&parse, "xl/sharedStrings.xml", false);
}

/* ---- styles ------------------------------------------------------------------------------------
 */

enum { FORMATS = 256 };

typedef struct formats {
  size_t count;
  long dates[FORMATS]; /* numbers of the workbook's own formats that show dates */
  bool in_cells;       /* within the styles of cells */
} formats;

static bool shows_date(const char *code) {
  bool quoted = false;
  for (; *code != '\0'; code++) {
    if (*code == '"') quoted = !quoted;
    if (*code == '[') code += strcspn(code, "]");
    if (*code == '\0') return false;
    if (*code == '\\' && code[1] != '\0') {
      code++;
    } else if (!quoted && strchr("yYdDhHsS", *code) != NULL) {
      return true;
    }
  }
  return false;
}

static bool is_date(const formats *f, long number) {
  if ((number >= 14 && number <= 22) || (number >= 45 && number <= 47)) return true;
  for (size_t k = 0; k < f->count; k++) {
    if (f->dates[k] == number) return true;
  }
  return false;
}

static void start_style(tp_parse *p, const char *name, const char **attributes) {
  formats *f = p->context;
  tp_book *book = p->book;
  const char *number = tp_book_attribute(attributes, "numFmtId");
  const char *code = tp_book_attribute(attributes, "formatCode");
  if (strcmp(name, "numFmt") == 0 && number != NULL && code != NULL && f->count < FORMATS) {
    if (shows_date(code)) f->dates[f->count++] = strtol(number, NULL, 10);
  }
  if (strcmp(name, "cellXfs") == 0) f->in_cells = true;
  if (strcmp(name, "xf") != 0 || !f->in_cells) return;
  bool *dates = tp_grow(book->is_date, (long)book->style_count, &book->style_room, sizeof *dates);
  if (dates == NULL) {
    tp_parse_stop(p, NULL);
    return;
  }
  book->is_date = dates;
  dates[book->style_count++] = number != NULL && is_date(f, strtol(number, NULL, 10));
}

static void end_style(tp_parse *p, const char *name) {
  formats *f = p->context;
  if (strcmp(name, "cellXfs") == 0) f->in_cells = false;
}

tp_status tp_book_read_styles(tp_book *book) {
  formats own = {.count = 0};
  tp_parse parse = {.book = book, .context = &own, .start = start_style, .end = end_style};
  return tp_book_parse(&parse, "xl/styles.xml", false);
}
