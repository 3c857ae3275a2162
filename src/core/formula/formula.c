/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The tree of a formula: nodes in one array, which doubles where it is full. */

#include "formula/formula.h"

#include <stdlib.h>
#include <string.h>

const tp_formula_node *tp_formula_root(const tp_formula *formula) {
  return formula->nodes + formula->count - 1;
}

/* Columns count characters, not bytes. */
tp_place tp_formula_place(const tp_formula *formula, int at) {
  tp_place place = formula->place;
  for (int k = 0; k < at && place.column > 0; k++) {
    if (((unsigned char)formula->text[k] & 0xc0) != 0x80) place.column++;
  }
  return place;
}

tp_status tp_formula_fail(const tp_formula *formula, const tp_formula_node *node,
                          tp_message *message, const char *problem) {
  return tp_refuse(message, TP_FAULT_FORMAT,
                   tp_formula_place(formula, node->length > 0 ? node->at : node->begin), "%s",
                   problem);
}

/* Room for more nodes; out of the room that was lent when that is full. */
static bool grow(tp_formula *f) {
  const long capacity = 2 * f->capacity + 2;
  const bool lent = f->nodes == f->lent;
  tp_formula_node *nodes = realloc(lent ? NULL : f->nodes, (size_t)capacity * sizeof *nodes);
  if (nodes == NULL) return false;
  if (lent && f->count > 0) memcpy(nodes, f->nodes, (size_t)f->count * sizeof *nodes);
  f->nodes = nodes;
  f->lent = NULL;
  f->capacity = capacity;
  return true;
}

tp_formula_node *tp_formula_add(tp_formula *f, tp_formula_kind kind) {
  if (f->count == f->capacity && !grow(f)) return NULL;
  tp_formula_node *node = f->nodes + f->count++;
  *node = (tp_formula_node){.kind = kind, .left = -1, .right = -1, .name = -1};
  fmpq_init(&node->value);
  return node;
}

void tp_formula_clear(tp_formula *formula) {
  for (long k = 0; k < formula->count; k++) fmpq_clear(&formula->nodes[k].value);
  if (formula->nodes != formula->lent) free(formula->nodes);
  *formula = (tp_formula){0};
}
