/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* An accelerogram in CSV. Units are read from the header and never guessed: a record in m/s2 taken
 * for one in g would spare no block, the other way round would overturn none. */

#include "scene/record_csv.h"
#include "format/csv_row.h"

#include <ctype.h>
#include <string.h>

enum { UNIT_SIZE = 80 };

/* Shares of gravity per unit. */
typedef struct unit {
  const char *name;
  long numerator, denominator;
} unit;

static const unit units[] = {
    {"cm/s2", 1000, 980665},         {"cm/s^2", 1000, 980665},       {"cm/s/s", 1000, 980665},
    {"cm s2", 1000, 980665},         {"gal", 1000, 980665},          {"m/s2", 100000, 980665},
    {"m/s^2", 100000, 980665},       {"m/s/s", 100000, 980665},      {"m s2", 100000, 980665},
    {"m/s\xc2\xb2", 100000, 980665}, {"cm/s\xc2\xb2", 1000, 980665}, {"g", 1, 1}};

static const char *const seconds[] = {"s", "sec", "second", "seconds", NULL};

/* In small letters, with single blanks for what separates words. */
static void plain_words(char words[UNIT_SIZE], const tp_csv_row *row, int field) {
  const tp_csv_field f = row->fields[field];
  size_t length = 0;
  for (size_t k = 0; k < f.length && length + 1 < UNIT_SIZE; k++) {
    const char c = row->text[f.at + k];
    const bool parts = strchr(" \t_-()[],:\"", c) != NULL;
    if (parts && (length == 0 || words[length - 1] == ' ')) continue;
    words[length] = ' ';
    if (!parts) words[length] = (char)tolower((unsigned char)c);
    length++;
  }
  while (length > 0 && words[length - 1] == ' ') length--;
  words[length] = '\0';
}

/* Do the words end in these, which are some of their own? */
static bool ends_in(const char *words, const char *ending) {
  const size_t all = strlen(words), own = strlen(ending);
  return all >= own && strcmp(words + all - own, ending) == 0 &&
         (all == own || words[all - own - 1] == ' ');
}

static tp_status find_unit(const unit **found, const tp_record_source *source,
                           const tp_csv_row *row, int column) {
  char words[UNIT_SIZE];
  plain_words(words, row, column);
  for (size_t k = 0; k < sizeof units / sizeof units[0] && *found == NULL; k++) {
    if (ends_in(words, units[k].name)) *found = units + k;
  }
  if (*found != NULL) return TP_OK;
  return tp_record_fail(source, row->fields[column].at,
                        "the header of this column must end in the unit of the acceleration, g, "
                        "m/s2 or cm/s2, as 'acceleration_m_s2'");
}

static tp_status check_time(const tp_record_source *source, const tp_csv_row *row) {
  char words[UNIT_SIZE];
  plain_words(words, row, 0);
  for (int k = 0; seconds[k] != NULL; k++) {
    if (ends_in(words, seconds[k])) return TP_OK;
  }
  return tp_record_fail(source, row->fields[0].at,
                        "the first column must be the time in seconds, and its header say so, as "
                        "'time_s'");
}

static tp_status read_header(const unit **found, const tp_record_source *source,
                             const tp_csv_row *row, long column) {
  if (tp_csv_is_numeric(row, 0)) {
    return tp_record_fail(source, 0,
                          "a header with units must come first, for example "
                          "'time_s,acceleration_m_s2'");
  }
  if (column > row->count) {
    return tp_refuse(source->message, TP_FAULT_FORMAT, (tp_place){source->path, source->number, 1},
                     "the header names %d columns; there is no column %ld", row->count, column);
  }
  const tp_status status = check_time(source, row);
  return status == TP_OK ? find_unit(found, source, row, (int)column - 1) : status;
}

static tp_status read_sample(tp_polyline *record, const tp_record_source *source,
                             const tp_csv_row *row, const unit *u, long column) {
  if (row->open_quote) return tp_record_fail(source, row->quote, "this quote is not closed");
  if (column > row->count) {
    return tp_record_fail(source, source->length, "a number is missing: the acceleration");
  }
  const tp_csv_field first = row->fields[0], own = row->fields[column - 1];
  fmpq_t time, value, factor;
  fmpq_init(time);
  fmpq_init(value);
  fmpq_init(factor);
  tp_status status = tp_record_value(time, source, first.at, first.length);
  if (status == TP_OK) status = tp_record_value(value, source, own.at, own.length);
  if (status == TP_OK) {
    fmpq_set_si(factor, u->numerator, (unsigned long)u->denominator);
    fmpq_mul(value, value, factor);
    status = tp_record_append(record, source, time, value, own.at);
  }
  fmpq_clear(time);
  fmpq_clear(value);
  fmpq_clear(factor);
  return status;
}

tp_status tp_record_read_csv(tp_polyline *record, tp_record_source *source, long column) {
  const unit *found = NULL;
  char separator = '\0';
  bool more = true;
  tp_status status = TP_OK;
  while (status == TP_OK) {
    tp_csv_row row;
    status = tp_record_next(source, &more);
    if (status != TP_OK || !more) break;
    tp_csv_split(&row, source->line, source->length, separator);
    if (row.count == 0 && !row.open_quote) continue; /* empty, or a comment */
    if (found != NULL) {
      status = read_sample(record, source, &row, found, column);
    } else {
      status = read_header(&found, source, &row, column);
      if (row.separator != ' ') separator = row.separator;
    }
  }
  if (status != TP_OK || found != NULL) return status;
  return tp_refuse(source->message, TP_FAULT_FORMAT, (tp_place){source->path, 1, 1},
                   "the file is empty; an accelerogram in CSV begins with a header such as "
                   "'time_s,acceleration_m_s2'");
}
