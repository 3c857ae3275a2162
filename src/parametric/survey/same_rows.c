/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rows are sorted by all cells that their scenes are made of, so that those which are the same are
 * next to each other: n log n comparisons of n rows. Cells are compared as they are written. */

#include "survey/same_rows.h"

#include <stdlib.h>
#include <string.h>

typedef struct row_of {
  const tp_survey *survey;
  size_t number;
} row_of;

/* Does a cell below this head change nothing but the title? */
static bool is_passed(const tp_survey *survey, size_t column) {
  if (column >= survey->column_count) return false; /* an error of its row */
  const tp_column_kind kind = survey->columns[column].kind;
  return kind == TP_COLUMN_NAME || kind == TP_COLUMN_PASSED;
}

static int compare_cells(const row_of *a, const row_of *b) {
  const tp_cells *cells = &a->survey->cells;
  const size_t count = cells->rows[a->number + 1].count, other = cells->rows[b->number + 1].count;
  if (count != other) return count < other ? -1 : 1;
  for (size_t k = 0; k < count; k++) {
    if (is_passed(a->survey, k)) continue;
    const int order =
        strcmp(tp_cells_text(cells, a->number + 1, k), tp_cells_text(cells, b->number + 1, k));
    if (order != 0) return order;
  }
  /* a title is a line of the scene, by which complaints find their place */
  const bool named = tp_survey_cell(a->survey, a->number + 1, TP_COLUMN_NAME) != NULL;
  const bool is_named = tp_survey_cell(b->survey, b->number + 1, TP_COLUMN_NAME) != NULL;
  return (int)named - (int)is_named;
}

static int compare(const void *one, const void *other) {
  const row_of *a = one, *b = other;
  const int order = compare_cells(a, b);
  return order != 0 ? order : a->number < b->number ? -1 : a->number > b->number;
}

static void take(tp_same_rows *rows, const row_of *sorted, size_t count) {
  for (size_t k = 0; k < count; k++) {
    const bool is_new = k == 0 || compare_cells(sorted + k - 1, sorted + k) != 0;
    rows->first[sorted[k].number] = is_new ? sorted[k].number : rows->first[sorted[k - 1].number];
  }
  for (size_t k = 0; k < count; k++) {
    if (rows->first[k] == k) {
      rows->different[rows->different_count++] = k;
    } else {
      rows->same[rows->same_count++] = k;
    }
  }
}

bool tp_same_rows_find(tp_same_rows *rows, const tp_survey *survey) {
  const size_t count = survey->cells.row_count - 1;
  row_of *sorted = calloc(count + 1, sizeof *sorted);
  *rows = (tp_same_rows){.first = calloc(count + 1, sizeof *rows->first),
                         .different = calloc(count + 1, sizeof *rows->different),
                         .same = calloc(count + 1, sizeof *rows->same)};
  const bool made =
      sorted != NULL && rows->first != NULL && rows->different != NULL && rows->same != NULL;
  if (made) {
    for (size_t k = 0; k < count; k++) sorted[k] = (row_of){survey, k};
    qsort(sorted, count, sizeof *sorted, compare);
    take(rows, sorted, count);
  } else {
    tp_same_rows_clear(rows);
  }
  free(sorted);
  return made;
}

void tp_same_rows_clear(tp_same_rows *rows) {
  free(rows->first);
  free(rows->different);
  free(rows->same);
  *rows = (tp_same_rows){.first = NULL};
}
