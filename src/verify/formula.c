/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The tree of a formula. */

#include "verify/formula.h"

#include <stdlib.h>

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
  return tp_fail(message, TP_BAD_INPUT,
                 tp_formula_place(formula, node->length > 0 ? node->at : node->begin), "%s",
                 problem);
}

long tp_formula_add(tp_formula *f, tp_formula_node node) {
  if ((f->count & (f->count + 1)) == 0) { /* at 0, 1, 3, 7, … */
    const size_t capacity = 2 * (size_t)f->count + 2;
    tp_formula_node *nodes = realloc(f->nodes, capacity * sizeof *nodes);
    if (nodes == NULL) return -1;
    f->nodes = nodes;
  }
  fmpq_init(&node.value);
  f->nodes[f->count] = node;
  return f->count++;
}

void tp_formula_clear(tp_formula *formula) {
  for (long k = 0; k < formula->count; k++) fmpq_clear(&formula->nodes[k].value);
  free(formula->nodes);
  *formula = (tp_formula){0};
}
