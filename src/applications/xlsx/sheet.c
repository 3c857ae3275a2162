/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A worksheet as CSV, row n on line n, each cell in quotes. A number is written as the shortest
 * decimal of its double, as spreadsheets show it: they store 1.1 as 1.1000000000000001. */

#include "common/message.h"
#include "xlsx/book.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_ROWS = 1000000, MOST_COLUMNS = 256 };

typedef struct sheet {
  tp_text *csv;
  long row;    /* of the line that is being written, from 1 */
  long column; /* of the next cell on it, from 0 */
  long at;     /* the column of the cell that is being read */
  char kind[12];
  size_t style;
} sheet;

/* ---- cells -------------------------------------------------------------------------------------
 */

/* Characters of a text in UTF-8. */
static size_t count_characters(const char *text, size_t length) {
  size_t count = 0;
  for (size_t k = 0; k < length; k++) count += ((unsigned char)text[k] & 0xC0) != 0x80;
  return count;
}

static const char too_long[] = "has a cell of more than 32 767 characters, the most that a "
                               "spreadsheet holds; shorten its text";

/* Within what a cell, and a table, may hold? Else the reading is stopped. */
static bool may_add(tp_parse *p, const sheet *s, const char *text, size_t length) {
  if (length > TP_BOOK_CELL && count_characters(text, length) > TP_BOOK_CELL) {
    tp_parse_stop(p, too_long);
    return false;
  }
  if (s->csv->length + length <= TP_BOOK_BYTES) return true;
  tp_parse_stop(p, "has more than 256 MiB of text in its cells; split the table");
  return false;
}

static void add_text(sheet *s, const char *text, size_t length) {
  for (; s->column < s->at; s->column++) tp_text_append(s->csv, ",", 1);
  tp_text_append(s->csv, "\"", 1);
  for (size_t k = 0; k < length; k++) {
    const char c = (char)(text[k] == '\n' || text[k] == '\r' ? ' ' : text[k]);
    if (c == '"') tp_text_append(s->csv, "\"", 1);
    tp_text_append(s->csv, &c, 1);
  }
  tp_text_append(s->csv, "\"", 1);
}

/* A day as words, which no formula takes for a number (days from civil, era by era of 400 years).
 */
static void add_date(sheet *s, double serial, bool since_1904) {
  static const char *const months[] = {"March",    "April",    "May",       "June",
                                       "July",     "August",   "September", "October",
                                       "November", "December", "January",   "February"};
  enum { DAYS_TO_1899 = 693899, DAYS_TO_1904 = 695361, ERA = 146097 }; /* from 0000-03-01 */
  const long days = (long)floor(serial) + (since_1904 ? DAYS_TO_1904 : DAYS_TO_1899);
  const long of_era = days % ERA;
  const long year_of_era = (of_era - of_era / 1460 + of_era / 36524 - of_era / 146096) / 365;
  const long of_year = of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
  const long month = (5 * of_year + 2) / 153, day = of_year - (153 * month + 2) / 5 + 1;
  const long year = year_of_era + days / ERA * 400 + (month > 9);
  char text[48];
  snprintf(text, sizeof text, "%ld %s %ld", day, months[month], year);
  add_text(s, text, strlen(text));
}

static void add_number(sheet *s, const tp_book *book, const char *text) {
  enum { LEAST = 15, MOST = 17 };
  char *end = NULL, shortest[40];
  const double value = strtod(text, &end);
  if (end == text || *end != '\0' || !isfinite(value)) {
    add_text(s, text, strlen(text));
    return;
  }
  const double last_day = 2958465; /* of the year 9999 */
  if (s->style < book->style_count && book->is_date[s->style] && value >= 0 && value <= last_day) {
    add_date(s, value, book->since_1904);
    return;
  }
  for (int digits = LEAST; digits <= MOST; digits++) {
    snprintf(shortest, sizeof shortest, "%.*g", digits, value);
    if (strtod(shortest, NULL) == value) break;
  }
  add_text(s, shortest, strlen(shortest));
}

static void add_cell(tp_parse *p, sheet *s) {
  const tp_book *book = p->book;
  const char *text = p->text.data != NULL ? p->text.data : "";
  if (p->text.length == 0 || !may_add(p, s, text, p->text.length)) return;
  if (strcmp(s->kind, "s") == 0) {
    char *end = NULL;
    const unsigned long number = strtoul(text, &end, 10);
    if (end == text || number >= book->string_count) {
      tp_parse_stop(p, "has a cell whose text is not among those of the workbook");
      return;
    }
    const char *shared = book->strings[number];
    if (may_add(p, s, shared, strlen(shared))) add_text(s, shared, strlen(shared));
  } else if (strcmp(s->kind, "b") == 0) {
    add_text(s, text[0] == '1' ? "true" : "false", text[0] == '1' ? 4 : 5);
  } else if (s->kind[0] == '\0' || strcmp(s->kind, "n") == 0) {
    add_number(s, book, text);
  } else {
    add_text(s, text, p->text.length);
  }
  s->column = s->at;
  if (s->csv->failed) tp_parse_stop(p, NULL);
}

/* ---- rows --------------------------------------------------------------------------------------
 */

static void start_row(tp_parse *p, sheet *s, const char **attributes) {
  const char *number = tp_book_attribute(attributes, "r");
  const long row = number != NULL ? strtol(number, NULL, 10) : s->row + 1;
  if (row <= s->row || row > MOST_ROWS) {
    tp_parse_stop(p,
                  row > MOST_ROWS ? "has more than a million rows" : "has its rows out of order");
    return;
  }
  for (long k = s->row; k < row && k > 0; k++) tp_text_append(s->csv, "\n", 1);
  if (s->row == 0) {
    for (long k = 1; k < row; k++) tp_text_append(s->csv, "\n", 1);
  }
  s->row = row;
  s->column = 0;
  s->at = -1;
}

/* "AB12" is of the column 27; without a place it is the next. */
static void start_cell(tp_parse *p, sheet *s, const char **attributes) {
  const char *place = tp_book_attribute(attributes, "r");
  const char *kind = tp_book_attribute(attributes, "t");
  const char *style = tp_book_attribute(attributes, "s");
  long at = 0;
  for (; place != NULL && *place >= 'A' && *place <= 'Z' && at <= MOST_COLUMNS; place++) {
    at = 26 * at + (*place - 'A' + 1);
  }
  at = at > 0 ? at - 1 : s->at + 1;
  if (at <= s->at || at >= MOST_COLUMNS || s->row == 0) {
    tp_parse_stop(p, at >= MOST_COLUMNS ? "has a row of more than 256 cells"
                                        : "has its cells out of order");
    return;
  }
  s->at = at;
  snprintf(s->kind, sizeof s->kind, "%s", kind != NULL ? kind : "");
  s->style = style != NULL ? strtoul(style, NULL, 10) : 0;
  p->text.length = 0;
}

static void start_sheet(tp_parse *p, const char *name, const char **attributes) {
  sheet *s = p->context;
  if (strcmp(name, "row") == 0) start_row(p, s, attributes);
  if (strcmp(name, "c") == 0) start_cell(p, s, attributes);
  const bool inlined = strcmp(s->kind, "inlineStr") == 0;
  p->collects = strcmp(name, inlined ? "t" : "v") == 0;
}

static void end_sheet(tp_parse *p, const char *name) {
  sheet *s = p->context;
  p->collects = false;
  if (strcmp(name, "c") == 0) add_cell(p, s);
}

tp_status tp_book_read_sheet(tp_book *book, tp_text *csv) {
  sheet own = {.csv = csv, .at = -1};
  tp_parse parse = {.book = book, .context = &own, .start = start_sheet, .end = end_sheet};
  return tp_book_parse(&parse, book->sheet, true);
}
