/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Determines the separator of a line, then splits it into fields; recognises numbers with decimal
 * commas. */

#include "format/csv_row.h"

#include <ctype.h>
#include <string.h>

static bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

static bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/* The length up to a comment, and which separator the rest has. A tab beside a comma is a blank. */
static void look_over(tp_csv_row *row, char named) {
  bool quoted = false, has_named = false, semicolon = false, comma = false, tab = false;
  bool behind_tab = false;
  char last = ','; /* that is no blank */
  size_t k = 0;
  for (; k < row->length && (quoted || row->text[k] != '#'); k++) {
    const char c = row->text[k];
    if (c == '"') quoted = !quoted;
    if (!quoted) {
      has_named = has_named || c == named;
      semicolon = semicolon || c == ';';
      comma = comma || c == ',';
    }
    if (!is_blank(c)) {
      tab = tab || (behind_tab && last != ',' && c != ',');
      behind_tab = false;
      last = c;
    } else if (c == '\t' && !quoted) {
      behind_tab = true;
    }
  }
  while (k > 0 && isspace((unsigned char)row->text[k - 1])) k--;
  row->length = k;
  row->separator = ' ';
  if (comma) row->separator = ',';
  if (tab) row->separator = '\t';
  if (semicolon) row->separator = ';';
  if (has_named) row->separator = named;
}

static bool separates(const tp_csv_row *row, char c) {
  return c == row->separator || (row->separator == ' ' && c == '\t');
}

/* Two quotes within a field in quotes stand for one of its own. */
static bool is_doubled(const tp_csv_row *row, size_t quote) {
  return quote + 1 < row->length && row->text[quote + 1] == '"';
}

/* The field from `*at`, which ends up behind it, at its separator or at the end of the row. */
static tp_csv_field read_field(tp_csv_row *row, size_t *at) {
  const char *text = row->text;
  const bool quoted = *at < row->length && text[*at] == '"';
  tp_csv_field field = {*at + quoted, 0};
  size_t end = field.at;
  while (quoted && end < row->length && (text[end] != '"' || is_doubled(row, end))) {
    end += text[end] == '"' ? 2 : 1;
  }
  row->open_quote = quoted && end >= row->length;
  row->quote = *at;
  size_t next = end;
  while (next < row->length && !separates(row, text[next])) next++;
  if (!quoted) end = next;
  while (end > field.at && is_blank(text[end - 1])) end--;
  while (field.at < end && is_blank(text[field.at])) field.at++;
  field.length = end - field.at;
  *at = next;
  return field;
}

void tp_csv_split(tp_csv_row *row, const char *text, size_t length, char named) {
  row->text = text;
  row->length = length;
  row->count = 0;
  row->too_many = row->open_quote = false;
  look_over(row, named);
  const bool runs = is_blank(row->separator); /* several in a row count once */
  size_t at = 0;
  while (at < row->length) {
    while (at < row->length && is_blank(text[at]) && !(separates(row, text[at]) && !runs)) at++;
    const tp_csv_field field = read_field(row, &at);
    row->too_many = row->too_many || (row->count == TP_CSV_FIELDS && field.length > 0);
    if (row->count < TP_CSV_FIELDS) row->fields[row->count++] = field;
    at++;
  }
  while (!row->too_many && row->count > 0 && row->fields[row->count - 1].length == 0) row->count--;
}

static bool starts_number(const char *text, size_t length) {
  size_t k = 0;
  if (k < length && (text[k] == '+' || text[k] == '-')) k++;
  if (k < length && text[k] == '.') k++;
  return k < length && is_digit(text[k]);
}

bool tp_csv_is_numeric(const tp_csv_row *row, int field) {
  return starts_number(row->text + row->fields[field].at, row->fields[field].length);
}

/* Digits, a comma and digits, as in -1,5 or 1,500.25; `*comma` is where the comma stands. */
static bool is_comma_number(const char *text, size_t length, size_t *comma) {
  size_t k = 0;
  bool found = false;
  if (!starts_number(text, length)) return false;
  for (k = text[0] == '+' || text[0] == '-'; k < length; k++) {
    const bool within = k + 1 < length && is_digit(text[k + 1]);
    if (text[k] == ',' && k > 0 && is_digit(text[k - 1]) && within) {
      if (!found) *comma = k;
      found = true;
    } else if (!is_digit(text[k]) && strchr(".eE+-", text[k]) == NULL) {
      return false;
    }
  }
  return found;
}

/* Of words between blanks, all of which are numbers, with or without a comma. */
static bool has_comma_words(const tp_csv_row *row, size_t *at) {
  int words = 0;
  bool found = false;
  for (size_t k = 0; k < row->length;) {
    while (k < row->length && is_blank(row->text[k])) k++;
    size_t end = k, comma = 0;
    while (end < row->length && !is_blank(row->text[end])) end++;
    const bool own = is_comma_number(row->text + k, end - k, &comma);
    if (own && !found) *at = k + comma;
    found = found || own;
    if (!own && memchr(row->text + k, ',', end - k) != NULL) return false;
    words += end > k;
    k = end;
  }
  return found && words > 1;
}

bool tp_csv_has_decimal_comma(const tp_csv_row *row, size_t *at) {
  for (int k = 0; k < row->count; k++) {
    const tp_csv_field *f = row->fields + k;
    size_t comma = 0;
    if (!is_comma_number(row->text + f->at, f->length, &comma)) continue;
    *at = f->at + comma;
    return true;
  }
  return row->separator == ',' && has_comma_words(row, at);
}
