/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A table from CSV (RFC 4180), as spreadsheets save it. Cells are separated by ';' where the head
 * has one outside quotes, else by tabs, else by ','. A cell in double quotes may hold separators,
 * ends of lines and quotes, which are doubled. A line that begins with '#' is a comment. */

#include "format/cells.h"
#include "format/text_file.h"

#include <stdlib.h>
#include <string.h>

typedef struct reader {
  tp_cells *cells;
  const char *path;
  tp_message *message;
  const char *at, *end; /* in the text */
  size_t line;
  char separator;
  char *cell; /* room for a cell without its quotes */
} reader;

/* The first line that is no comment and not empty. */
static const char *find_head(const char *at, const char *end) {
  while (at < end && (*at == '#' || *at == '\n' || *at == '\r')) {
    if (*at == '#') {
      while (at < end && *at != '\n') at++;
    } else {
      at++;
    }
  }
  return at;
}

static char find_separator(const char *at, const char *end) {
  bool quoted = false, tab = false;
  for (at = find_head(at, end); at < end && (quoted || *at != '\n'); at++) {
    if (*at == '"') quoted = !quoted;
    if (!quoted && *at == ';') return ';';
    tab = tab || (!quoted && *at == '\t');
  }
  return tab ? '\t' : ',';
}

static tp_status refuse(const reader *r, size_t line, const char *what) {
  return tp_refuse(r->message, TP_FAULT_FORMAT, (tp_place){r->path, (int)line, 0}, "%s", what);
}

static bool ends_cell(const reader *r) {
  return r->at == r->end || *r->at == r->separator || *r->at == '\n';
}

/* The text in quotes, from behind the first of them. */
static tp_status read_quoted(reader *r, size_t *length) {
  const size_t line = r->line;
  for (;; r->at++) {
    if (r->at == r->end) {
      return refuse(r, line,
                    "a cell begins with a quote that is not closed; close it, or leave it "
                    "out");
    }
    if (*r->at == '"') {
      r->at++;
      if (r->at == r->end || *r->at != '"') break;
    }
    r->line += *r->at == '\n';
    r->cell[(*length)++] = *r->at;
  }
  while (!ends_cell(r)) {
    if (*r->at != ' ' && *r->at != '\r') {
      return refuse(r, line,
                    "text stands behind the closing quote of a cell; a quote within a "
                    "cell is written twice");
    }
    r->at++;
  }
  return TP_OK;
}

/* Up to its separator, or the end of its line. */
static tp_status read_cell(reader *r) {
  size_t length = 0;
  while (r->at < r->end && *r->at == ' ') r->at++;
  if (r->at < r->end && *r->at == '"') {
    r->at++;
    const tp_status status = read_quoted(r, &length);
    if (status != TP_OK) return status;
  } else {
    while (!ends_cell(r)) r->cell[length++] = *r->at++;
  }
  if (memchr(r->cell, '\0', length) != NULL) {
    return refuse(r, r->line, "a byte of zero stands in the table: it is no CSV; save it as CSV");
  }
  return tp_cells_add(r->cells, r->cell, length) ? TP_OK : tp_fail_memory(r->message, "a table");
}

static tp_status read_row(reader *r) {
  size_t count = 0;
  if (r->cells->row_count > TP_CELLS_ROWS) {
    return refuse(r, r->line, "the table has more than a million rows; split it");
  }
  if (!tp_cells_add_row(r->cells, r->line)) return tp_fail_memory(r->message, "a table");
  for (;;) {
    const tp_status status = read_cell(r);
    if (status != TP_OK) return status;
    if (r->at == r->end || *r->at == '\n') break;
    r->at++;
    if (++count == TP_CELLS_COLUMNS) {
      return refuse(r, r->line,
                    "a row has more than 256 cells; leave out columns that say nothing "
                    "of the block");
    }
  }
  tp_cells_end_row(r->cells);
  return TP_OK;
}

static tp_status read_rows(reader *r) {
  tp_status status = TP_OK;
  while (r->at < r->end && status == TP_OK) {
    if (*r->at == '#') {
      while (r->at < r->end && *r->at != '\n') r->at++;
    } else {
      status = read_row(r);
    }
    r->line++;
    if (r->at < r->end) r->at++;
  }
  return status;
}

static tp_status read_csv(tp_cells *cells, const char *path, const char *text, size_t length,
                          tp_message *message) {
  reader r = {.cells = cells,
              .path = path,
              .message = message,
              .at = text,
              .end = text + length,
              .line = 1,
              .separator = find_separator(text, text + length),
              .cell = malloc(length + 1)};
  const tp_status status = r.cell != NULL ? read_rows(&r) : tp_fail_memory(message, "a table");
  free(r.cell);
  return status;
}

static tp_status check(const tp_cells *cells, const char *path, tp_message *message) {
  if (cells->row_count > 1) return TP_OK;
  return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){path, 0, 0},
                   cells->row_count == 0
                       ? "the table is empty; its first row names the columns, as name, width (m), "
                         "height (m), dip (deg), friction (deg), and each row below is a block"
                       : "the table has a head and no row below it; each row is a block");
}

tp_status tp_cells_read(tp_cells *cells, const char *path, const char *text, tp_message *message) {
  tp_cells own = {0};
  tp_text_file file = {NULL, 0};
  tp_status status = text == NULL ? tp_text_file_read(&file, path, message) : TP_OK;
  if (status == TP_OK) {
    status = read_csv(&own, path, text != NULL ? text : file.text,
                      text != NULL ? strlen(text) : file.length, message);
  }
  free(file.text);
  if (status == TP_OK) status = check(&own, path, message);
  if (status == TP_OK) {
    *cells = own;
  } else {
    tp_cells_clear(&own);
  }
  return status;
}
