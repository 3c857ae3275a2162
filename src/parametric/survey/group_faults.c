/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Faults that say the same of one column, whatever the cell: told once, with the rows. They are
 * sorted by what they say, those alike by their rows; then groups by the row of their first. */

#include "common/outside.h"
#include "survey/faults.h"

#include <stdlib.h>
#include <string.h>

typedef struct one_fault {
  size_t row; /* behind the head */
  const tp_row_fault *fault;
} one_fault;

static int compare_numbers(size_t a, size_t b) {
  return (a > b) - (a < b);
}

static int compare_sayings(const void *left, const void *right) {
  const one_fault *a = left, *b = right;
  int order = compare_numbers(a->fault->column, b->fault->column);
  if (order == 0) order = strcmp(a->fault->text, b->fault->text);
  return order != 0 ? order : compare_numbers(a->row, b->row);
}

static bool is_alike(const one_fault *a, const one_fault *b) {
  return a->fault->column == b->fault->column && strcmp(a->fault->text, b->fault->text) == 0;
}

/* "; likewise line 6 ('?'), 7 and 12" */
static void add_others(tp_text *text, const tp_survey *survey, const one_fault *group,
                       size_t count) {
  enum { MOST = 10 };
  const char *value = group->fault->value;
  tp_text_add(text, "; likewise in %s ", count == 2 ? "line" : "lines");
  for (size_t k = 1; k < count; k++) {
    const char *own = group[k].fault->value;
    if (k > MOST) {
      tp_text_add(text, " and %zu more", count - k);
      return;
    }
    tp_text_add(text, "%s%zu",
                k == 1           ? ""
                : k + 1 == count ? " and "
                                 : ", ",
                survey->cells.rows[group[k].row + 1].line);
    if (own != NULL && strcmp(own, value) != 0) {
      tp_text_add(text, " ('%s')", tp_quote_all(own).text);
    }
  }
}

static tp_status tell(tp_batch_fault *own, const tp_survey *survey, const one_fault *group,
                      size_t count, tp_message *message) {
  tp_text text = {0};
  tp_fault_add_place(&text, survey, group->row + 1, group->fault->column);
  tp_fault_add(&text, survey, group->fault);
  if (count > 1) add_others(&text, survey, group, count);
  *own = (tp_batch_fault){.line = survey->cells.rows[group->row + 1].line,
                          .column = group->fault->column,
                          .row_count = count,
                          .text = tp_fault_finish(&text)};
  return own->text != NULL ? TP_OK : tp_fail_memory(message, "a table");
}

static int compare_places(const void *left, const void *right) {
  const tp_batch_fault *a = left, *b = right;
  const int order = compare_numbers(a->line, b->line);
  return order != 0 ? order : compare_numbers(a->column, b->column);
}

tp_status tp_batch_group_faults(tp_batch *batch, const tp_row_faults *rows, const tp_survey *survey,
                                tp_message *message) {
  size_t count = 0, filled = 0;
  for (size_t k = 0; k < batch->row_count; k++) count += (size_t)rows[k].count;
  if (count == 0) return TP_OK;
  one_fault *all = calloc(count, sizeof *all);
  batch->faults = calloc(count, sizeof *batch->faults);
  tp_status status =
      all != NULL && batch->faults != NULL ? TP_OK : tp_fail_memory(message, "a table");
  for (size_t k = 0; k < batch->row_count && status == TP_OK; k++) {
    for (long f = 0; f < rows[k].count; f++) {
      all[filled++] = (one_fault){.row = k, .fault = rows[k].items + f};
    }
  }
  if (status == TP_OK) qsort(all, count, sizeof *all, compare_sayings);
  for (size_t first = 0, next; first < count && status == TP_OK; first = next) {
    for (next = first + 1; next < count && is_alike(all + first, all + next);) next++;
    status = tell(batch->faults + batch->fault_count++, survey, all + first, next - first, message);
  }
  if (status == TP_OK) {
    qsort(batch->faults, batch->fault_count, sizeof *batch->faults, compare_places);
  }
  free(all);
  return status;
}
