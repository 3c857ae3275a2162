/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A cell by itself: is it one plain number, and one that its key may have? A cell is data. `30/120`
 * is a dip and its direction, `35-28` a range: whoever evaluated them took a dip of 0.25 degrees.
 * So nothing is calculated in a cell, in columns of words either. */

#include "survey/cell_check.h"

#include "number/ratio.h"
#include "scene/expression.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char between_names[] = " \t.,;:+-*/^()?'\"";

static bool is_number_text(const char *text, size_t length) {
  const char *problem = NULL;
  fmpq_t value;
  fmpq_init(value);
  const bool is = tp_ratio_read_field(value, text, length, &problem);
  fmpq_clear(value);
  return is;
}

/* Do parameters of the scene and numbers make up all of it, with one parameter at least? */
static bool names_parameters(const tp_node *root, const char *cell) {
  const tp_node *parameters = tp_node_get(root, "parameters");
  bool all = parameters != NULL, any = false;
  for (const char *at = cell; all && *at != '\0';) {
    const size_t length = strcspn(at, between_names);
    const bool named = length > 0 && tp_tree_child(parameters, at, length) != NULL;
    any = any || named;
    all = named || length == 0 || is_number_text(at, length);
    at += length + strspn(at + length, between_names);
  }
  return all && any;
}

/* Would a reader of scenes calculate it? */
static tp_status is_formula(bool *is, const tp_column *head, const char *cell, const tp_node *root,
                            tp_message *message) {
  tp_message what;
  fmpq_t value;
  *is = false;
  if (is_number_text(cell, strlen(cell))) return TP_OK;
  fmpq_init(value);
  const tp_status status = tp_expression_evaluate(value, cell, (tp_place){0}, NULL, &what);
  fmpq_clear(value);
  if (status == TP_OUT_OF_MEMORY) return tp_fail_memory(message, "a table");
  const bool words = strcspn(cell, between_names) == strlen(cell) && !head->is_length;
  *is = status == TP_OK || (!words && names_parameters(root, cell));
  return TP_OK;
}

/* 1,5 in place of 1.5. */
static bool has_decimal_comma(const char *cell) {
  const size_t digits = strspn(cell, "+-0123456789");
  return digits > 0 && cell[digits] == ',' && strspn(cell + digits, ",0123456789") > 1 &&
         cell[digits + strspn(cell + digits, ",0123456789")] == '\0';
}

/* The last part of a key. */
static const char *name_of(const char *key) {
  const char *dot = strrchr(key, '.');
  return dot != NULL ? dot + 1 : key;
}

/* A number, a separator and another number. */
static bool has_two_numbers(const char *cell, const char *separator) {
  const char *at = strstr(cell, separator);
  if (at == NULL || at == cell) return false;
  const char *other = at + strlen(separator);
  size_t first = (size_t)(at - cell), second = strlen(other);
  while (first > 0 && cell[first - 1] == ' ') first--;
  while (*other == ' ') other++, second--;
  return is_number_text(cell, first) && is_number_text(other, second);
}

/* Why a cell is no number. */
static const char *problem_of(const tp_column *head, const char *cell, const tp_node *root) {
  static const char *const ranges[] = {"-", "\xe2\x80\x93", "..", " to "};
  if (has_two_numbers(cell, "/")) {
    return strcmp(head->key, "slope.dip_deg") == 0
               ? "is two numbers, and nothing is calculated in a table; if they are dip and dip "
                 "direction, name the column 'dip/dip direction', else write one number"
               : "is two numbers, and nothing is calculated in a table; write one number, as 2.5";
  }
  for (size_t k = 0; k < sizeof ranges / sizeof ranges[0]; k++) {
    if (has_two_numbers(cell, ranges[k])) {
      return "is a range; write one number, or vary it by 'topple study'";
    }
  }
  if (names_parameters(root, cell)) {
    return "names a parameter of the scene, and nothing is calculated in a table; write its value";
  }
  return "is not a number; write digits alone, as 2.5, or leave the cell empty where the scene "
         "below the table has the number";
}

static tp_status check_number(tp_row_faults *faults, const tp_column *head, size_t column,
                              const char *cell, const tp_node *root, tp_message *message) {
  const tp_place nowhere = {0};
  const char *problem = NULL;
  tp_message what;
  fmpq_t value;
  fmpq_init(value);
  tp_status status = TP_OK;
  if (!tp_ratio_read_field(value, cell, strlen(cell), &problem)) {
    status = tp_row_faults_add(faults, column + 1, cell, problem_of(head, cell, root), message);
  } else if (tp_check_range(value, name_of(head->key), nowhere, &what) != TP_OK ||
             tp_check_rule(head->rule, value, name_of(head->key), nowhere, &what) != TP_OK) {
    char told[sizeof what.text + 24];
    snprintf(told, sizeof told, "is out of range: %s", what.text);
    status = tp_row_faults_add(faults, column + 1, cell, told, message);
  }
  fmpq_clear(value);
  return status;
}

tp_status tp_cell_check(tp_row_faults *faults, const tp_column *head, size_t column,
                        const char *cell, const tp_node *root, tp_message *message) {
  bool formula = false;
  if (has_decimal_comma(cell)) {
    return tp_row_faults_add(faults, column + 1, cell,
                             "has a comma for its decimal point; write a point", message);
  }
  if (head->is_number) return check_number(faults, head, column, cell, root, message);
  const tp_status status = is_formula(&formula, head, cell, root, message);
  if (status != TP_OK || !formula) return status;
  return tp_row_faults_add(faults, column + 1, cell,
                           "is a formula, and nothing is calculated in a table; write its value",
                           message);
}

static char *without_blanks(const char *text, size_t length) {
  while (length > 0 && text[length - 1] == ' ') length--;
  while (length > 0 && *text == ' ') text++, length--;
  return strndup(text, length);
}

tp_status tp_cell_split_plane(char **dip, char **direction, tp_row_faults *faults,
                              const tp_column *head, size_t column, const char *cell,
                              tp_message *message) {
  const char *slash = strchr(cell, '/');
  *dip = *direction = NULL;
  if (!has_two_numbers(cell, "/")) {
    return tp_row_faults_add(faults, column + 1, cell,
                             head->reversed ? "is no dip direction and dip, as 120/30"
                                            : "is no dip and dip direction, as 30/120",
                             message);
  }
  char *first = without_blanks(cell, (size_t)(slash - cell));
  char *second = without_blanks(slash + 1, strlen(slash + 1));
  if (first == NULL || second == NULL) {
    free(first);
    free(second);
    return tp_fail_memory(message, "a table");
  }
  *dip = head->reversed ? second : first;
  *direction = head->reversed ? first : second;
  return TP_OK;
}

/* ---- what is not there -------------------------------------------------------------------------
 */

const char tp_row_no_dip[] = "it is not told at which dip the block lies; give a column dip (deg), "
                             "or a scene with slope or tilt";
const char tp_row_no_friction[] =
    "it is not told at which friction the block slides; give a column friction (deg), or a scene "
    "with friction_angle_deg";

/* Has the scene one of the keys, or cases, each of which may have its own? */
static bool has_any(const tp_node *root, const char *const *keys) {
  while (*keys != NULL && tp_node_get(root, *keys) == NULL) keys++;
  return *keys != NULL;
}

tp_status tp_row_check_missing(tp_row_faults *faults, const tp_node *root, tp_message *message) {
  static const char *const of_dip[] = {"slope", "tilt", "frame", "joint", "cases", NULL};
  static const char *const of_friction[] = {"friction_angle_deg", "friction", "cases", NULL};
  tp_status status = TP_OK;
  if (!has_any(root, of_dip)) status = tp_row_faults_add(faults, 0, NULL, tp_row_no_dip, message);
  if (status == TP_OK && !has_any(root, of_friction)) {
    status = tp_row_faults_add(faults, 0, NULL, tp_row_no_friction, message);
  }
  return status;
}
