/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Formulas in writing: plain text that computer algebra reads, LaTeX, or C. */

#ifndef TP_NOTATION_H
#define TP_NOTATION_H

#include "derive/field.h"

/* The polynomial in a notation, allocated with malloc; NULL when memory is exhausted. */
char *tp_notation_polynomial(const fmpz_mpoly_t polynomial, const tp_field *field,
                             tp_notation notation);

/* The fraction as one formula. */
char *tp_notation_fraction(const fmpz_mpoly_q_t fraction, const tp_field *field,
                           tp_notation notation);

#endif
