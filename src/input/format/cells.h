/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A table as a spreadsheet has it: a head of names and rows of cells, each a text, read from CSV.
 * Empty rows are left out. At most TP_CELLS_ROWS rows of TP_CELLS_COLUMNS cells. */

#ifndef TP_FORMAT_CELLS_H
#define TP_FORMAT_CELLS_H

#include "common/message.h"

enum { TP_CELLS_ROWS = 1000000, TP_CELLS_COLUMNS = 256 };

typedef struct tp_cells_row {
  size_t line;  /* in the file, from 1; of a worksheet its row */
  size_t first; /* of its cells, among all, */
  size_t count; /* and how many, without the empty ones at its end */
} tp_cells_row;

/* Begin with {0}. */
typedef struct tp_cells {
  size_t row_count; /* with the head, which is the first */
  tp_cells_row *rows;
  long row_room;
  size_t *at; /* where the text of each cell begins */
  long cell_count, cell_room;
  char *bytes; /* the texts, each with a zero behind it */
  size_t length, room;
} tp_cells;

/* Of the text, or where that is NULL of the file. It has a head, and one row besides. */
TP_MUST_USE tp_status tp_cells_read(tp_cells *cells, const char *path, const char *text,
                                    tp_message *message);
void tp_cells_clear(tp_cells *cells);

/* The text, without blanks around it; empty where there is none. The head is row 0. */
const char *tp_cells_text(const tp_cells *cells, size_t row, size_t column);

/* ---- what readers fill it with -----------------------------------------------------------------
 */

/* A row, and a cell of the last one, behind the others; false when memory is exhausted. */
TP_MUST_USE bool tp_cells_add_row(tp_cells *cells, size_t line);
TP_MUST_USE bool tp_cells_add(tp_cells *cells, const char *text, size_t length);
/* The last row is complete: it goes where it is empty. */
void tp_cells_end_row(tp_cells *cells);

#endif
