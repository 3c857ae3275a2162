/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Formulas in exact rationals: + - * / and whole powers; 1/3 is a third. Values are bounded by
 * 20 000 bits, so that no text exhausts the memory, which would end the process. */

#ifndef TP_FORMULA_RATIONAL_H
#define TP_FORMULA_RATIONAL_H

#include "formula/evaluate.h"

/* Values are fmpq; the context is the fmpq of the names, by their numbers. */
extern const tp_algebra tp_rational_algebra;

#endif
