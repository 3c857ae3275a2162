/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The cells of a row at their keys. A length in another unit than the scene's is a product, exact:
 * (3.5)*(3048/10000)/(1). */

#include "common/outside.h"
#include "survey/cell_check.h"
#include "survey/heads_table.h"
#include "survey/tree.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *metres_of(const char *unit) {
  static const struct {
    const char *name, *metres;
  } lengths[] = {
#define LENGTH_ROW(name, metres) {name, metres},
      TP_SURVEY_LENGTHS(LENGTH_ROW)
#undef LENGTH_ROW
  };
  for (size_t k = 0; k < sizeof lengths / sizeof lengths[0]; k++) {
    if (strcmp(lengths[k].name, unit) == 0) return lengths[k].metres;
  }
  return NULL;
}

/* A scene that names no unit of length has that of the first column whose head does. */
static tp_status choose_unit(tp_node *root, const tp_survey *survey, size_t row,
                             tp_message *message) {
  size_t bare = survey->column_count;
  if (tp_node_get(root, "length_unit") != NULL || tp_node_get(root, "drawing") != NULL) {
    return TP_OK;
  }
  for (size_t k = 0; k < survey->column_count; k++) {
    const tp_column *own = survey->columns + k;
    if (own->kind == TP_COLUMN_KEY && strcmp(own->key, "length_unit") == 0) return TP_OK;
    if (own->unit != NULL)
      return tp_tree_put(root, "length_unit", own->unit, tp_mark_of_column(k), message);
    if (own->is_length && tp_cells_text(&survey->cells, row, k)[0] != '\0') bare = k;
  }
  if (bare == survey->column_count) return TP_OK;
  return tp_refuse(message, TP_FAULT_UNIT, (tp_place){0},
                   "the unit of '%s' is not told; write it in the head, as %s (m), or give a scene "
                   "that has a length_unit",
                   tp_quote_all(survey->columns[bare].head).text,
                   tp_quote_all(survey->columns[bare].head).text);
}

/* The cell as a formula of the scene, to be freed. */
static char *make_formula(const tp_column *own, const char *cell, const char *unit) {
  const char *from = own->unit != NULL ? metres_of(own->unit) : NULL;
  const char *to = unit != NULL ? metres_of(unit) : NULL;
  const bool other = from != NULL && to != NULL && strcmp(from, to) != 0;
  if (!other && own->factor == NULL) return strdup(cell);
  const size_t size = strlen(cell) + 64;
  char *text = malloc(size);
  if (text != NULL && other) snprintf(text, size, "(%s)*%s/%s", cell, from, to);
  if (text != NULL && !other) snprintf(text, size, "(%s)*%s", cell, own->factor);
  return text;
}

static bool is_unit(const tp_column *column) {
  return column->kind == TP_COLUMN_KEY && strcmp(column->key, "length_unit") == 0;
}

static tp_status put_unit(tp_node *root, const tp_survey *survey, size_t row, tp_message *message) {
  for (size_t k = 0; k < survey->column_count; k++) {
    const char *cell = tp_cells_text(&survey->cells, row, k);
    if (!is_unit(survey->columns + k) || cell[0] == '\0') continue;
    return tp_tree_put(root, "length_unit", cell, tp_mark_of_column(k), message);
  }
  return TP_OK;
}

static tp_status put_cell(tp_node *root, const tp_column *own, size_t column, const char *cell,
                          tp_message *message) {
  const tp_node *unit = tp_node_get(root, "length_unit");
  char *text = make_formula(own, cell, unit != NULL ? unit->text : NULL);
  if (text == NULL) return tp_fail_memory(message, "the scene of a row");
  const tp_status status = tp_tree_put(root, own->key, text, tp_mark_of_column(column), message);
  free(text);
  return status;
}

/* Both numbers of a field of a plane, each as if it had a column to itself. */
static tp_status put_plane(tp_node *root, tp_row_faults *faults, const tp_column *own,
                           size_t column, const char *cell, tp_message *message) {
  char *texts[2] = {NULL, NULL};
  tp_column parts[2] = {*own, *own};
  parts[1].key = (char *)tp_plane_direction_key; /* it is only read */
  tp_column_take_rule(parts + 1);
  tp_status status = tp_cell_split_plane(texts, texts + 1, faults, own, column, cell, message);
  for (int k = 0; k < 2 && status == TP_OK && texts[k] != NULL; k++) {
    status = tp_cell_check(faults, parts + k, column, texts[k], root, message);
    if (status == TP_OK) status = put_cell(root, parts + k, column, texts[k], message);
  }
  free(texts[0]);
  free(texts[1]);
  return status;
}

/* The cells of a row, or all faults of them. */
static tp_status put_cells(tp_node *root, tp_row_faults *faults, const tp_survey *survey,
                           size_t row, tp_message *message) {
  tp_status status = TP_OK;
  for (size_t k = 0; k < survey->column_count && status == TP_OK; k++) {
    const tp_column *own = survey->columns + k;
    const char *cell = tp_cells_text(&survey->cells, row, k);
    if (cell[0] == '\0' || is_unit(own)) continue;
    if (own->kind == TP_COLUMN_NAME) {
      status = tp_tree_put(root, "title", cell, tp_mark_of_column(k), message);
    } else if (own->kind == TP_COLUMN_PLANE) {
      status = put_plane(root, faults, own, k, cell, message);
    } else if (own->kind == TP_COLUMN_KEY) {
      status = tp_cell_check(faults, own, k, cell, root, message);
      if (status == TP_OK) status = put_cell(root, own, k, cell, message);
    }
  }
  if (status != TP_OK || faults->count == 0) return status;
  status = tp_row_check_missing(faults, root, message);
  return status != TP_OK
             ? status
             : tp_refuse(message, TP_FAULT_FORMAT, (tp_place){0}, "%s", faults->items[0].text);
}

tp_status tp_survey_put_cells(tp_node *root, tp_row_faults *faults, const tp_survey *survey,
                              size_t row, tp_message *message) {
  tp_status status = choose_unit(root, survey, row, message);
  if (status == TP_OK) status = put_unit(root, survey, row, message);
  return status == TP_OK ? put_cells(root, faults, survey, row, message) : status;
}
