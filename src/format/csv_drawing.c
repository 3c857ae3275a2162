/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "format/csv_drawing.h"

#include "format/csv_row.h"
#include "number/ratio.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { X, Y, LAYER, NAME, BULGE, COLUMNS };

typedef struct reader {
  tp_drawing *drawing;
  tp_message *message;
  int line;
  bool has_header;
  char separator;
  int columns[COLUMNS]; /* -1: there is none */
} reader;

static tp_status fail(const reader *r, size_t column, const char *what) {
  return tp_fail(r->message, TP_BAD_INPUT, (tp_place){r->drawing->path, r->line, (int)column + 1},
                 "%s", what);
}

/* ---- the header --------------------------------------------------------------------------------
 */

static bool is_word(const tp_csv_row *row, int field, const char *word) {
  const tp_csv_field *f = row->fields + field;
  return f->length == strlen(word) && strncasecmp(row->text + f->at, word, f->length) == 0;
}

static bool names(const tp_csv_row *row, int field, int column) {
  static const char *const words[COLUMNS] = {"", "", "layer", "name", "bulge"};
  if (column == X || column == Y) return tp_csv_names(row, field, column == X ? 'x' : 'y');
  return is_word(row, field, words[column]);
}

static tp_status read_header(reader *r, const tp_csv_row *row) {
  for (int column = 0; column < COLUMNS; column++) {
    r->columns[column] = -1;
    for (int k = 0; k < row->count; k++) {
      if (!names(row, k, column)) continue;
      if (r->columns[column] >= 0) {
        return fail(r, row->fields[k].at, "the header names two columns alike");
      }
      r->columns[column] = k;
    }
  }
  if (r->columns[X] < 0 || r->columns[Y] < 0) {
    return fail(r, 0,
                "the first line names no columns x and y, as in 'layer,x,y'; a file of two columns "
                "alone is an outline: block: {outline: FILE}");
  }
  r->has_header = true;
  r->separator = row->separator;
  return TP_OK;
}

/* ---- rows --------------------------------------------------------------------------------------
 */

static tp_status read_number(const reader *r, fmpq_t value, const tp_csv_row *row, int column) {
  const tp_csv_field *f = row->fields + r->columns[column];
  size_t comma = 0;
  const char *problem = NULL;
  if (tp_csv_has_decimal_comma(row, &comma)) {
    return fail(r, comma, "a decimal comma; decimals take a point");
  }
  if (tp_ratio_read_field(value, row->text + f->at, f->length, &problem)) return TP_OK;
  char what[120];
  snprintf(what, sizeof what, "what stands here %s; a coordinate is a number", problem);
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

static tp_status read_row(const reader *r, const tp_csv_row *row, fmpq_t x, fmpq_t y) {
  if (row->open_quote) return fail(r, row->quote, "a quote is not closed in this line");
  if (row->count <= r->columns[X] || row->count <= r->columns[Y]) {
    return fail(r, 0, "a line without x or y");
  }
  tp_status status = read_number(r, x, row, X);
  if (status == TP_OK) status = read_number(r, y, row, Y);
  if (status != TP_OK) return status;
  const tp_mark mark = {r->line, (int)row->fields[r->columns[X]].at + 1};
  tp_drawing_object *object = NULL;
  status = find_object(r, &object, row, mark);
  if (status != TP_OK) return status;
  if (!tp_drawing_add_point(object, x, y, mark)) return tp_fail_memory(r->message, "a drawing");
  const int bulge = r->columns[BULGE];
  if (bulge < 0 || bulge >= row->count || row->fields[bulge].length == 0) return TP_OK;
  status = read_number(r, x, row, BULGE);
  if (status != TP_OK || fmpq_is_zero(x)) return status;
  return tp_drawing_bend(object, x) ? TP_OK : tp_fail_memory(r->message, "a drawing");
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
    status = r->has_header ? read_row(r, &row, x, y) : read_header(r, &row);
  }
  fmpq_clear(x);
  fmpq_clear(y);
  return status;
}

tp_status tp_csv_drawing_read(tp_drawing *drawing, const tp_text_file *file,
                              const tp_drawing_options *options, tp_message *message) {
  (void)options; /* no curves */
  reader r = {.drawing = drawing, .message = message};
  const tp_status status = read_lines(&r, file);
  for (long k = 0; k < drawing->count && status == TP_OK; k++) {
    tp_drawing_tidy(drawing->objects + k);
  }
  return status;
}
