/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Line reader with a fixed buffer: header and units by format/columns.h, then two numbers a line;
 * repeated points are dropped, decimal commas and other slips are refused with a hint. */

#include "scene_reading/csv.h"

#include "common/input_file.h"
#include "format/columns.h"
#include "number/ratio.h"

#include <ctype.h>
#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
  LONGEST_LINE = 1 << 16, /* two numbers of TP_RATIO_DIGITS and a great many other columns */
  MOST_POINTS = 50000000, /* 2 GB as exact points of short numbers */
  MOST_HEADER_LINES = 2   /* names, and units */
};

/* A line above the points that names no column. */
typedef struct title_line {
  int line, count; /* 0: there is none */
  char separator;
} title_line;

typedef struct reader {
  const char *path;
  FILE *file;
  char *buffer; /* LONGEST_LINE bytes, of which from … to are still to be read */
  size_t from, to;
  uint64_t bytes; /* that were read */
  int line;
  int header_lines;
  bool fractions; /* may stand in it */
  tp_columns columns;
  char named;       /* its separator, if it is no blank */
  title_line title; /* the line above the points, where it names nothing */
  tp_column_level level;
  char separator; /* of the last point */
  long repeated;  /* points left out */
  tp_mark first_repeated;
  tp_polyline *points;
  tp_notes *notes;
  tp_message *message;
} reader;

static tp_status fail(const reader *r, size_t column, const char *what) {
  return tp_refuse(r->message, TP_FAULT_FORMAT, (tp_place){r->path, r->line, (int)column + 1}, "%s",
                   what);
}

static const uint64_t most_bytes = UINT64_C(1) << 32;

/* The next line into `*text`, `*length`; false at the end of the file, or with r->message set. */
static bool next_line(reader *r, const char **text, size_t *length, tp_status *status) {
  for (;;) {
    char *start = r->buffer + r->from;
    char *end = memchr(start, '\n', r->to - r->from);
    const bool full = r->to - r->from == LONGEST_LINE;
    if (end == NULL && !full && !feof(r->file) && !ferror(r->file)) {
      memmove(r->buffer, start, r->to - r->from);
      r->to -= r->from;
      r->from = 0;
      const size_t more = fread(r->buffer + r->to, 1, LONGEST_LINE - r->to, r->file);
      r->to += more;
      r->bytes += more;
      if (r->bytes <= most_bytes) continue;
      *status = fail(r, 0, "a file of more than 4 GiB");
      return false;
    }
    if (ferror(r->file)) {
      *status = tp_fail_file(r->message, r->path, "read", errno);
      return false;
    }
    if (end == NULL && r->from == r->to) return false;
    r->line++;
    if (end == NULL && full) {
      *status = fail(r, 0, "a line longer than 65536 bytes; is this a CSV file of x, y?");
      return false;
    }
    *text = start;
    *length = (size_t)((end != NULL ? end : r->buffer + r->to) - start);
    r->from += *length + (end != NULL ? 1 : 0);
    return true;
  }
}

static bool is_header(const tp_csv_row *row) {
  int numbers = 0;
  for (int k = 0; k < row->count; k++) {
    const tp_csv_field *f = row->fields + k;
    char word[16] = "";
    strncat(word, row->text + f->at, f->length < 15 ? f->length : 15);
    if (tp_ratio_is_not_finite(word)) return false;
    numbers += tp_csv_is_numeric(row, k);
  }
  if (row->count > 0 && tp_csv_is_numeric(row, 0)) return false;
  /* "Profile 3" is a title; "o,0" is a point with a slip in it */
  return numbers == 0 || (numbers == 1 && (row->separator == ' ' || row->count > 2));
}

/* "x (m) y (m)", separated by blanks: a unit in brackets belongs to the name before it. */
static void join_units(tp_csv_row *row) {
  int kept = 0;
  for (int k = 0; k < row->count && row->separator == ' '; k++) {
    const tp_csv_field own = row->fields[k];
    const char *first = row->text + own.at;
    if (kept > 0 && own.length > 0 && (*first == '(' || *first == '[')) {
      row->fields[kept - 1].length = own.at + own.length - row->fields[kept - 1].at;
    } else {
      row->fields[kept++] = own;
    }
  }
  if (row->separator == ' ') row->count = kept;
}

/* A line above the points: a title, names of columns, or their units. */
static tp_status read_header(reader *r, tp_csv_row *row) {
  const tp_place line = {r->path, r->line, 1};
  tp_header header = TP_HEADER_TITLE;
  join_units(row);
  r->header_lines++;
  const bool named = r->columns.count > 0;
  tp_columns own = r->columns;
  tp_status status = tp_columns_read(&own, &header, row, line, r->message);
  r->title = (title_line){0};
  if (header == TP_HEADER_TITLE && !named) {
    r->title = (title_line){r->line, row->count, row->separator};
  }
  if (status != TP_OK || header == TP_HEADER_TITLE) return status;
  r->columns = own;
  if (header == TP_HEADER_UNITS) return TP_OK;
  r->separator = row->separator;
  if (row->separator != ' ') r->named = row->separator;
  return tp_columns_note(&r->columns, line, r->notes, r->message);
}

/* Words over the columns of points that are none of the table. */
static tp_status check_title(const reader *r, const tp_csv_row *row) {
  if (r->title.line == 0 || r->points->count > 0 || r->title.count != row->count ||
      r->title.count < 2 || r->title.separator != row->separator) {
    return TP_OK;
  }
  return tp_refuse(r->message, TP_FAULT_FORMAT, (tp_place){r->path, r->title.line, 1},
                   "the header names no column that is known: call them 'x,y' or "
                   "'distance,elevation'; a title begins with '#'");
}

static tp_status fail_comma(const reader *r, size_t at) {
  return fail(r, at,
              "a comma within a number; write decimals with a point, 1.5 for 1,5, and thousands "
              "without a mark");
}

/* What stands in the file is not quoted: it may be any file, which the scene names by mistake. */
static tp_status read_number(const reader *r, fmpq_t value, const tp_csv_row *row, int column) {
  const char *problem = NULL;
  const tp_csv_field f = column < row->count ? row->fields[column] : (tp_csv_field){row->length, 0};
  size_t comma = 0;
  if (r->fractions ? tp_ratio_read_fraction(value, row->text + f.at, f.length, &problem)
                   : tp_ratio_read_field(value, row->text + f.at, f.length, &problem)) {
    return TP_OK;
  }
  if (tp_csv_has_decimal_comma(row, &comma)) return fail_comma(r, comma);
  if (f.length == 0) return fail(r, f.at, "a number is missing; each line holds x, y");
  char word[16] = "", what[160];
  strncat(word, row->text + f.at, f.length < 15 ? f.length : 15);
  if (tp_ratio_is_not_finite(word)) {
    snprintf(what, sizeof what, "'%s' is not a finite number", word);
  } else {
    snprintf(what, sizeof what, "this entry %s; each line holds x, y", problem);
  }
  return fail(r, f.at, what);
}

/* More columns than there may be, or none of those that the points above had. */
static tp_status check_columns(reader *r, const tp_csv_row *row) {
  const int most = r->columns.count > 0 ? r->columns.count : 2;
  size_t comma = 0;
  if (row->open_quote) return fail(r, row->quote, "this quote is not closed");
  if (r->separator == ';' && row->separator == ',') {
    return fail(r, 0,
                "the columns were separated by ';' so far, here by ','; if this is a decimal "
                "comma, write a point");
  }
  r->separator = row->separator;
  if (row->count <= most && !row->too_many) return TP_OK;
  if (tp_csv_has_decimal_comma(row, &comma)) return fail_comma(r, comma);
  return fail(r, row->fields[most].at,
              r->columns.count > 0
                  ? "more columns than the header names; decimals take a point, not a "
                    "comma"
                  : "more than two columns; each line holds x, y, or a header line such "
                    "as 'id,x,y' says which they are; decimals take a point, not a "
                    "comma");
}

static bool repeats_last(const tp_polyline *line, const fmpq_t x, const fmpq_t y) {
  const long last = line->count - 1;
  return last >= 0 && fmpq_equal(line->x + last, x) && fmpq_equal(line->y + last, y);
}

/* A height beside x and y. */
static tp_status check_level(reader *r, const tp_csv_row *row) {
  if (tp_column_level_stays(&r->level, &r->columns, row)) return TP_OK;
  return fail(r, row->fields[r->columns.level].at, tp_columns_plan);
}

static tp_status read_point(reader *r, const tp_csv_row *row, fmpq_t x, fmpq_t y) {
  const int *column = r->columns.at;
  tp_status status = check_title(r, row);
  if (status == TP_OK) status = check_columns(r, row);
  if (status == TP_OK) status = check_level(r, row);
  if (status == TP_OK) status = read_number(r, x, row, column[0]);
  if (status == TP_OK) status = read_number(r, y, row, column[1]);
  if (status != TP_OK) return status;
  const int first = column[0] < column[1] ? column[0] : column[1];
  const tp_mark mark = {r->line, (int)row->fields[first].at + 1};
  if (repeats_last(r->points, x, y)) {
    if (r->repeated++ == 0) r->first_repeated = mark;
    return TP_OK;
  }
  if (r->points->count == MOST_POINTS) return fail(r, 0, "more than 50 million points");
  return tp_polyline_append(r->points, x, y, mark) ? TP_OK
                                                   : tp_fail_memory(r->message, "an outline");
}

static tp_status note_repeated(const reader *r) {
  if (r->repeated == 0) return TP_OK;
  const tp_place place = {r->path, r->first_repeated.line, r->first_repeated.column};
  if (r->repeated == 1) {
    return tp_notes_add(r->notes, r->message, TP_NOTE, place,
                        "a point that repeats the one before it is left out");
  }
  return tp_notes_add(r->notes, r->message, TP_NOTE, place,
                      "points that repeat the one before them are left out, %ld in all",
                      r->repeated);
}

static bool says_fractions(const char *text, size_t length) {
  static const char line[] = TP_CSV_FRACTIONS;
  while (length > 0 && isspace((unsigned char)text[length - 1])) length--;
  return length == sizeof line - 1 && memcmp(text, line, length) == 0;
}

static tp_status read_lines(reader *r) {
  tp_status status = TP_OK;
  const char *text = NULL;
  size_t length = 0;
  tp_csv_row row;
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  while (status == TP_OK && next_line(r, &text, &length, &status)) {
    if (r->line == 1 && length >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0) {
      text += 3; /* byte order mark */
      length -= 3;
    }
    if (r->line == 1) r->fractions = says_fractions(text, length);
    tp_csv_split(&row, text, length, r->named);
    if (row.count == 0 && !row.open_quote) continue; /* empty, or separators alone */
    const bool above = r->header_lines < MOST_HEADER_LINES && r->points->count == 0;
    status = above && is_header(&row) ? read_header(r, &row) : read_point(r, &row, x, y);
  }
  fmpq_clear(x);
  fmpq_clear(y);
  return status == TP_OK ? note_repeated(r) : status;
}

/* Closes the file. */
static tp_status read_file(tp_polyline *line, const char **unit, FILE *file, const char *path,
                           bool closed, tp_notes *notes, tp_message *message) {
  *line = (tp_polyline){.file = path};
  reader r = {.path = path,
              .columns = {.at = {0, 1}, .level = -1},
              .points = line,
              .notes = notes,
              .message = message,
              .file = file};
  r.buffer = calloc(1, LONGEST_LINE);
  tp_column_level_init(&r.level);
  tp_status status = r.buffer != NULL ? read_lines(&r) : tp_fail_memory(message, "an outline");
  if (status == TP_OK && line->count == 0) {
    status = tp_refuse(message, TP_FAULT_FORMAT, (tp_place){path, 1, 1},
                       "no points; each line holds x, y");
  }
  fclose(r.file);
  free(r.buffer);
  tp_column_level_clear(&r.level);
  *unit = r.columns.unit;
  if (status != TP_OK) {
    tp_polyline_clear(line);
  } else if (closed) {
    tp_polyline_drop_closing_point(line);
  }
  return status;
}

tp_status tp_csv_check_unit(const char *said, const char *unit, const char *path, const char *meant,
                            tp_message *message) {
  if (said == NULL || unit == NULL || strcmp(said, unit) == 0) return TP_OK;
  return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){path, 1, 1},
                   "the header says that lengths are in %s, %s is %s; convert one to the other, or "
                   "correct which is wrong",
                   said, meant, unit);
}

tp_status tp_csv_read(tp_polyline *line, const char **unit, const char *path, bool closed,
                      tp_notes *notes, tp_message *message) {
  FILE *file = NULL;
  const tp_status status = tp_input_open(&file, path, message);
  if (status != TP_OK) {
    *line = (tp_polyline){.file = path};
    *unit = NULL;
    return status;
  }
  return read_file(line, unit, file, path, closed, notes, message);
}

tp_status tp_csv_read_text(tp_polyline *line, const char **unit, const char *text, const char *name,
                           bool closed, tp_notes *notes, tp_message *message) {
  FILE *file = fmemopen((void *)text, strlen(text), "rb"); /* it only reads */
  if (file == NULL) {
    *line = (tp_polyline){.file = name};
    *unit = NULL;
    return tp_fail_memory(message, "an outline");
  }
  return read_file(line, unit, file, name, closed, notes, message);
}
