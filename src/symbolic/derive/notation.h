/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Formulas in writing: plain text that computer algebra reads, LaTeX, or C. */

#ifndef TP_DERIVE_NOTATION_H
#define TP_DERIVE_NOTATION_H

#include "derive/field.h"

/* Numerator, denominator and formula at once; `*failed` is set when memory is exhausted. Over zero
 * the formula is "unbounded", in C INFINITY, and the denominator 0. */
tp_fraction tp_notation_write(const fmpz_mpoly_q_t formula, const tp_field *field,
                              tp_notation notation, bool *failed);
tp_fraction tp_notation_write_quotient(const fmpz_mpoly_q_t top, const fmpz_mpoly_q_t below,
                                       const tp_field *field, tp_notation notation, bool *failed);
void tp_notation_free(tp_fraction *fraction);

#endif
