/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "scene/csv.h"

#include "number/ratio.h"
#include "scene/expression.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_LINE = 1 << 16, MOST_POINTS = 50000000 };

typedef struct reader {
  const char *path;
  FILE *file;
  char *buffer; /* LONGEST_LINE bytes, of which from … to are still to be read */
  size_t from, to;
  int line;
  bool header_seen;
  tp_polyline *points;
  tp_message *message;
} reader;

static tp_status fail(const reader *r, size_t column, const char *what) {
  return tp_fail(r->message, TP_BAD_INPUT, (tp_place){r->path, r->line, (int)column + 1}, "%s",
                 what);
}

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
      r->to += fread(r->buffer + r->to, 1, LONGEST_LINE - r->to, r->file);
      continue;
    }
    if (ferror(r->file)) {
      *status = tp_fail(r->message, TP_BAD_INPUT, (tp_place){r->path, 0, 0}, "cannot be read: %s",
                        strerror(errno));
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

static bool separates(char c) {
  return c == ',' || c == ';' || c == '\t' || c == ' ';
}

/* The next field of a line from `*at`; its length. Blanks around one separator are skipped. */
static size_t field(const char *text, size_t length, size_t *at) {
  while (*at < length && (text[*at] == ' ' || text[*at] == '\t')) ++*at;
  size_t end = *at;
  while (end < length && !separates(text[end])) end++;
  return end - *at;
}

static void skip_separator(const char *text, size_t length, size_t *at) {
  while (*at < length && (text[*at] == ' ' || text[*at] == '\t')) ++*at;
  if (*at < length && (text[*at] == ',' || text[*at] == ';')) ++*at;
}

static bool is_header(const char *text, size_t length) {
  char word[32] = "";
  strncat(word, text, length < 31 ? length : 31);
  const bool named = isalpha((unsigned char)word[0]) || word[0] == '"';
  return named && !tp_expression_is_not_finite(word);
}

/* What stands in the file is not quoted: it may be any file, which the scene names by mistake. */
static tp_status read_number(const reader *r, fmpq_t value, const char *text, size_t column,
                             size_t length) {
  const char *problem = NULL;
  if (tp_ratio_read_field(value, text + column, length, &problem)) return TP_OK;
  if (length == 0) return fail(r, column, "a number is missing; each line holds x, y");
  char word[16] = "", what[160];
  strncat(word, text + column, length < 15 ? length : 15);
  if (tp_expression_is_not_finite(word)) {
    snprintf(what, sizeof what, "'%s' is not a finite number", word);
  } else {
    snprintf(what, sizeof what, "what stands here %s; each line holds x, y", problem);
  }
  return fail(r, column, what);
}

static tp_status read_point(reader *r, const char *text, size_t length, fmpq_t x, fmpq_t y) {
  size_t at = 0;
  const size_t x_length = field(text, length, &at);
  if (!r->header_seen && is_header(text + at, x_length)) {
    r->header_seen = true;
    return TP_OK;
  }
  r->header_seen = true;
  tp_status status = read_number(r, x, text, at, x_length);
  if (status != TP_OK) return status;
  const int column = (int)at + 1;
  at += x_length;
  skip_separator(text, length, &at);
  const size_t y_length = field(text, length, &at);
  status = read_number(r, y, text, at, y_length);
  if (status != TP_OK) return status;
  at += y_length;
  skip_separator(text, length, &at);
  if (at < length) return fail(r, at, "more than two columns; each line holds x, y");
  if (r->points->count == MOST_POINTS) return fail(r, 0, "more than 50 million points");
  if (!tp_polyline_append(r->points, x, y, (tp_mark){r->line, column})) {
    return tp_fail_memory(r->message, "an outline");
  }
  return TP_OK;
}

static tp_status read_lines(reader *r) {
  tp_status status = TP_OK;
  const char *text = NULL;
  size_t length = 0;
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  while (status == TP_OK && next_line(r, &text, &length, &status)) {
    if (r->line == 1 && length >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0) {
      text += 3; /* byte order mark */
      length -= 3;
    }
    const char *comment = memchr(text, '#', length);
    if (comment != NULL) length = (size_t)(comment - text);
    while (length > 0 && isspace((unsigned char)text[length - 1])) length--;
    if (length > 0) status = read_point(r, text, length, x, y);
  }
  fmpq_clear(x);
  fmpq_clear(y);
  return status;
}

static void drop_closing_point(tp_polyline *line) {
  const long last = line->count - 1;
  if (last < 3 || !fmpq_equal(line->x, line->x + last) || !fmpq_equal(line->y, line->y + last)) {
    return;
  }
  fmpq_clear(line->x + last);
  fmpq_clear(line->y + last);
  line->count--;
}

/* Closes the file. */
static tp_status read_file(tp_polyline *line, FILE *file, const char *path, bool closed,
                           tp_message *message) {
  *line = (tp_polyline){.file = path};
  reader r = {.path = path, .points = line, .message = message, .file = file};
  r.buffer = calloc(1, LONGEST_LINE);
  tp_status status = r.buffer != NULL ? read_lines(&r) : tp_fail_memory(message, "an outline");
  if (status == TP_OK && line->count == 0) {
    status =
        tp_fail(message, TP_BAD_INPUT, (tp_place){path, 1, 1}, "no points; each line holds x, y");
  }
  fclose(r.file);
  free(r.buffer);
  if (status != TP_OK) {
    tp_polyline_clear(line);
  } else if (closed) {
    drop_closing_point(line);
  }
  return status;
}

tp_status tp_csv_read(tp_polyline *line, const char *path, bool closed, tp_message *message) {
  FILE *file = fopen(path, "rb");
  if (file == NULL) {
    *line = (tp_polyline){.file = path};
    if (errno == ENOMEM) return tp_fail_memory(message, "an outline");
    return tp_fail(message, TP_BAD_INPUT, (tp_place){path, 0, 0}, "cannot be opened: %s",
                   strerror(errno));
  }
  return read_file(line, file, path, closed, message);
}

tp_status tp_csv_read_text(tp_polyline *line, const char *text, const char *name, bool closed,
                           tp_message *message) {
  FILE *file = fmemopen((void *)text, strlen(text), "rb"); /* it only reads */
  if (file == NULL) {
    *line = (tp_polyline){.file = name};
    return tp_fail_memory(message, "an outline");
  }
  return read_file(line, file, name, closed, message);
}
