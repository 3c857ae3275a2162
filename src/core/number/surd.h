/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Signs of sums of square roots, exactly: where rounding ends on an edge is such a number. */

#ifndef TP_NUMBER_SURD_H
#define TP_NUMBER_SURD_H

#include <flint/fmpq.h>
#include <flint/fmpz.h>

enum { TP_SURD_ROOTS = 4 };

/* c[0] + c[1] sqrt(d[0]) + … + c[count] sqrt(d[count - 1]), the d positive. */
typedef struct tp_surd {
  long count;
  fmpq c[TP_SURD_ROOTS + 1];
  fmpz d[TP_SURD_ROOTS];
} tp_surd;

void tp_surd_init(tp_surd *surd);
void tp_surd_clear(tp_surd *surd);

/* Add factor * sqrt(radicand). */
void tp_surd_add_root(tp_surd *surd, const fmpq_t factor, const fmpz_t radicand);

int tp_surd_sign(const tp_surd *surd);

#endif
