/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A cell by itself: is it a number, and one that its key may have? What names a parameter of the
 * scene is left to the reader of scenes. */

#include "survey/cell_check.h"

#include "scene/expression.h"

#include <stdio.h>
#include <string.h>

/* Does a parameter of the scene stand in it? */
static bool names_parameter(const tp_node *root, const char *cell) {
  static const char between[] = " \t.,;:+-*/^()?'\"";
  const tp_node *parameters = tp_node_get(root, "parameters");
  for (const char *at = cell; parameters != NULL && *at != '\0';) {
    const size_t length = strcspn(at, between);
    if (length > 0 && tp_tree_child(parameters, at, length) != NULL) return true;
    at += length + strspn(at + length, between);
  }
  return false;
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

tp_status tp_cell_check(tp_row_faults *faults, const tp_column *own, size_t column,
                        const char *cell, const tp_node *root, tp_message *message) {
  const tp_place nowhere = {0};
  tp_message what;
  fmpq_t value;
  if (has_decimal_comma(cell)) {
    return tp_row_faults_add(faults, column + 1, cell,
                             "has a comma for its decimal point; write a point", message);
  }
  if (!own->is_number || names_parameter(root, cell)) return TP_OK;
  fmpq_init(value);
  tp_status status = tp_expression_evaluate(value, cell, nowhere, NULL, &what);
  if (status == TP_OUT_OF_MEMORY) {
    status = tp_fail_memory(message, "a table");
  } else if (status != TP_OK) {
    status = tp_row_faults_add(faults, column + 1, cell,
                               "is not a number; write digits alone, as 2.5, or leave the cell "
                               "empty where the scene below the table has the number",
                               message);
  } else if (tp_check_range(value, name_of(own->key), nowhere, &what) != TP_OK ||
             tp_check_rule(own->rule, value, name_of(own->key), nowhere, &what) != TP_OK) {
    char told[sizeof what.text + 24];
    snprintf(told, sizeof told, "is out of range: %s", what.text);
    status = tp_row_faults_add(faults, column + 1, cell, told, message);
  }
  fmpq_clear(value);
  return status;
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
