/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Keeps the texts of all cells one behind another, and where each begins. */

#include "format/cells.h"

#include "common/grow.h"

#include <stdlib.h>
#include <string.h>

bool tp_cells_add_row(tp_cells *cells, size_t line) {
  tp_cells_row *rows =
      tp_grow(cells->rows, (long)cells->row_count, &cells->row_room, sizeof *cells->rows);
  if (rows == NULL) return false;
  cells->rows = rows;
  rows[cells->row_count++] = (tp_cells_row){.line = line, .first = (size_t)cells->cell_count};
  return true;
}

static bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

static bool has_room(tp_cells *cells, size_t more) {
  if (cells->length + more <= cells->room) return true;
  const size_t room = 2 * (cells->length + more);
  char *bytes = realloc(cells->bytes, room);
  if (bytes == NULL) return false;
  cells->bytes = bytes;
  cells->room = room;
  return true;
}

bool tp_cells_add(tp_cells *cells, const char *text, size_t length) {
  while (length > 0 && is_blank(text[length - 1])) length--;
  while (length > 0 && is_blank(text[0])) {
    text++;
    length--;
  }
  size_t *at = tp_grow(cells->at, cells->cell_count, &cells->cell_room, sizeof *cells->at);
  if (at == NULL) return false;
  cells->at = at;
  if (!has_room(cells, length + 1)) return false;
  at[cells->cell_count++] = cells->length;
  if (length > 0) memcpy(cells->bytes + cells->length, text, length);
  cells->bytes[cells->length + length] = '\0';
  cells->length += length + 1;
  cells->rows[cells->row_count - 1].count++;
  return true;
}

void tp_cells_end_row(tp_cells *cells) {
  tp_cells_row *row = cells->rows + cells->row_count - 1;
  while (row->count > 0 && cells->bytes[cells->at[row->first + row->count - 1]] == '\0') {
    row->count--;
    cells->cell_count--;
  }
  if (row->count == 0) cells->row_count--;
}

const char *tp_cells_text(const tp_cells *cells, size_t row, size_t column) {
  const tp_cells_row *own = cells->rows + row;
  return column < own->count ? cells->bytes + cells->at[own->first + column] : "";
}

void tp_cells_clear(tp_cells *cells) {
  free(cells->rows);
  free(cells->at);
  free(cells->bytes);
  *cells = (tp_cells){0};
}
