/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads header, units and rows; consecutive rows of one layer and name make one object. */

#include "format/csv_drawing.h"

#include "format/columns.h"
#include "number/ratio.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { LAYER, NAME, BULGE, COLUMNS };

typedef struct reader {
  tp_drawing *drawing;
  tp_message *message;
  int line;
  char separator;
  int header_line;
  tp_columns points;    /* no header yet: none of them */
  int columns[COLUMNS]; /* -1: there is none */
  tp_column_level level;
  bool has_points;
} reader;

static tp_status fail(const reader *r, size_t column, const char *what) {
  return tp_refuse(r->message, TP_FAULT_FORMAT,
                   (tp_place){r->drawing->path, r->line, (int)column + 1}, "%s", what);
}

/* ---- the header --------------------------------------------------------------------------------
 */

static bool is_word(const tp_csv_row *row, int field, const char *word) {
  const tp_csv_field *f = row->fields + field;
  return f->length == strlen(word) && strncasecmp(row->text + f->at, word, f->length) == 0;
}

static tp_status read_header(reader *r, const tp_csv_row *row) {
  static const char *const words[COLUMNS] = {"layer", "name", "bulge"};
  const tp_place line = {r->drawing->path, r->line, 1};
  tp_header header = TP_HEADER_TITLE;
  const tp_status status = tp_columns_read(&r->points, &header, row, line, r->message);
  if (status != TP_OK) return status;
  if (header != TP_HEADER_NAMES) {
    return fail(r, 0,
                "the first line names no columns x and y, as in 'layer,x,y'; a file of two columns "
                "alone is an outline: block: {outline: FILE}");
  }
  for (int column = 0; column < COLUMNS; column++) {
    r->columns[column] = -1;
    for (int k = 0; k < row->count; k++) {
      if (!is_word(row, k, words[column])) continue;
      if (r->columns[column] >= 0) {
        return fail(r, row->fields[k].at, "the header names two columns alike");
      }
      r->columns[column] = k;
    }
  }
  r->separator = row->separator;
  r->header_line = r->line;
  return TP_OK;
}

/* The line below the names may hold units; then all is known of the columns. */
static tp_status read_units(reader *r, const tp_csv_row *row, bool *taken) {
  const tp_place line = {r->drawing->path, r->line, 1};
  tp_columns own = r->points;
  tp_header header = TP_HEADER_TITLE;
  *taken = false;
  for (int k = 0; k < row->count; k++) {
    if (tp_csv_is_numeric(row, k)) return TP_OK;
  }
  const tp_status status = tp_columns_read(&own, &header, row, line, r->message);
  if (status != TP_OK || header != TP_HEADER_UNITS) return status;
  r->points = own;
  *taken = true;
  return TP_OK;
}

static tp_status finish_header(reader *r) {
  const bool plain = strcmp(r->points.words[0], "x") == 0 && strcmp(r->points.words[1], "y") == 0;
  r->drawing->unit = r->points.unit;
  r->drawing->unit_from = "the header of its columns";
  if (plain) return TP_OK;
  return tp_columns_note(&r->points, (tp_place){r->drawing->path, r->header_line, 1},
                         &r->drawing->notes, r->message);
}

/* ---- rows --------------------------------------------------------------------------------------
 */

static tp_status read_number(const reader *r, fmpq_t value, const tp_csv_row *row, int column) {
  const tp_csv_field *f = row->fields + column;
  size_t comma = 0;
  const char *problem = NULL;
  if (tp_csv_has_decimal_comma(row, &comma)) {
    return fail(r, comma, "a decimal comma; decimals take a point");
  }
  if (tp_ratio_read_field(value, row->text + f->at, f->length, &problem)) return TP_OK;
  char what[120];
  snprintf(what, sizeof what, "this entry %s; a coordinate is a number", problem);
  return fail(r, f->at, what);
}

/* Of a row, to be freed; "" where it has none. */
static char *text_of(const reader *r, const tp_csv_row *row, int column) {
  const int field = r->columns[column];
  if (field < 0 || field >= row->count) return strdup("");
  return strndup(row->text + row->fields[field].at, row->fields[field].length);
}

/* The object that the row goes on, or a new one. */
static tp_status find_object(const reader *r, tp_drawing_object **object, const tp_csv_row *row,
                             tp_mark mark) {
  char *layer = text_of(r, row, LAYER), *name = text_of(r, row, NAME);
  tp_drawing *drawing = r->drawing;
  *object = drawing->count > 0 ? drawing->objects + drawing->count - 1 : NULL;
  if (layer != NULL && name != NULL &&
      (*object == NULL || strcmp((*object)->layer, layer) != 0 ||
       strcmp((*object)->name, name) != 0)) {
    *object = tp_drawing_add(drawing, "points", layer, name, mark);
    if (*object != NULL) (*object)->closure = TP_DRAWING_EITHER;
  }
  const bool done = layer != NULL && name != NULL && *object != NULL;
  free(layer);
  free(name);
  return done ? TP_OK : tp_fail_memory(r->message, "a drawing");
}

/* A height beside x and y. */
static tp_status check_level(reader *r, const tp_csv_row *row) {
  if (tp_column_level_stays(&r->level, &r->points, row)) return TP_OK;
  return fail(r, row->fields[r->points.level].at, tp_columns_plan);
}

static tp_status read_row(reader *r, const tp_csv_row *row, fmpq_t x, fmpq_t y) {
  const int *at = r->points.at;
  if (row->open_quote) return fail(r, row->quote, "a quote is not closed in this line");
  if (row->count <= at[0] || row->count <= at[1]) return fail(r, 0, "a line without x or y");
  tp_status status = check_level(r, row);
  if (status == TP_OK) status = read_number(r, x, row, at[0]);
  if (status == TP_OK) status = read_number(r, y, row, at[1]);
  if (status != TP_OK) return status;
  const tp_mark mark = {r->line, (int)row->fields[at[0]].at + 1};
  tp_drawing_object *object = NULL;
  status = find_object(r, &object, row, mark);
  if (status != TP_OK) return status;
  if (!tp_drawing_add_point(object, x, y, mark)) return tp_fail_memory(r->message, "a drawing");
  const int bulge = r->columns[BULGE];
  if (bulge < 0 || bulge >= row->count || row->fields[bulge].length == 0) return TP_OK;
  status = read_number(r, x, row, bulge);
  if (status != TP_OK || fmpq_is_zero(x)) return status;
  return tp_drawing_bend(object, x) ? TP_OK : tp_fail_memory(r->message, "a drawing");
}

/* Behind the names. */
static tp_status read_line(reader *r, const tp_csv_row *row, fmpq_t x, fmpq_t y) {
  bool units = false;
  if (r->has_points) return read_row(r, row, x, y);
  r->has_points = true;
  tp_status status = read_units(r, row, &units);
  if (status == TP_OK) status = finish_header(r);
  return status == TP_OK && !units ? read_row(r, row, x, y) : status;
}

static tp_status read_lines(reader *r, const tp_text_file *file) {
  const char *at = file->text, *end = file->text + file->length;
  tp_status status = TP_OK;
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  while (at < end && status == TP_OK) {
    const char *stop = memchr(at, '\n', (size_t)(end - at));
    if (stop == NULL) stop = end;
    tp_csv_row row;
    r->line++;
    tp_csv_split(&row, at, (size_t)(stop - at), r->separator);
    at = stop < end ? stop + 1 : end;
    if (row.count == 0 && !row.open_quote) continue;
    if (r->points.count == 0) {
      status = read_header(r, &row);
    } else {
      status = read_line(r, &row, x, y);
    }
  }
  fmpq_clear(x);
  fmpq_clear(y);
  return status;
}

tp_status tp_csv_drawing_read(tp_drawing *drawing, const tp_text_file *file,
                              const tp_drawing_options *options, tp_message *message) {
  (void)options; /* no curves */
  reader r = {.drawing = drawing, .message = message, .points = {.level = -1}};
  tp_column_level_init(&r.level);
  const tp_status status = read_lines(&r, file);
  tp_column_level_clear(&r.level);
  for (long k = 0; k < drawing->count && status == TP_OK; k++) {
    tp_drawing_tidy(drawing->objects + k);
  }
  return status;
}
