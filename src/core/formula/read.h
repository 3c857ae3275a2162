/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The language of formulas, into trees.
 *
 * + - * / ^ and parentheses over decimals, which are exact, and names. -2^2 is -(2^2), 2^-1 is
 * allowed, 2^3^2 is 2^(3^2). A dialect says what else may stand in a formula, a vocabulary which
 * names. Nesting is bounded by 200 levels, so that no text exhausts the stack. */

#ifndef TP_FORMULA_READ_H
#define TP_FORMULA_READ_H

#include "formula/dialect.h"
#include "formula/formula.h"

/* `formula` is left empty on failure. The text must outlive it. */
TP_MUST_USE tp_status tp_formula_read(tp_formula *formula, const char *text, tp_place place,
                                      const tp_dialect *dialect, const tp_vocabulary *vocabulary,
                                      tp_message *message);

/* The same, where a short formula takes no memory but the `count` nodes at `lent`, which must
 * outlive it. */
TP_MUST_USE tp_status tp_formula_read_into(tp_formula *formula, tp_formula_node *lent, long count,
                                           const char *text, tp_place place,
                                           const tp_dialect *dialect,
                                           const tp_vocabulary *vocabulary, tp_message *message);

#endif
