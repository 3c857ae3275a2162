/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Inequalities between polynomials, in short: each keeps the sign that it has at the scene's
 * values, read in balls, and is written as its factors (FLINT), each with its own sign. That is
 * enough for the product, not needed for it. */

#ifndef TP_DERIVE_CONDITIONS_H
#define TP_DERIVE_CONDITIONS_H

#include "derive/field.h"

/* Conditions that a polynomial is not below zero, no two alike. */
typedef struct tp_conditions {
  const tp_field *field;
  bool positive; /* every symbol in use is above zero */
  arb_srcptr at; /* values of all symbols, at which each condition holds */
  long bits;
  long count, capacity;
  fmpz_mpoly_q_struct *items;
  bool failed; /* memory was exhausted */
} tp_conditions;

void tp_conditions_clear(tp_conditions *conditions);

/* `value` keeps the sign that it has at the values: a condition for each of its factors, which is
 * enough and far shorter than one for their product. Squares go, and where symbols are above zero
 * every factor that is so by its signs alone. */
void tp_conditions_add(tp_conditions *conditions, const fmpz_mpoly_q_t value);

/* `value`, nothing at the values, is not below zero. */
void tp_conditions_add_above(tp_conditions *conditions, const fmpz_mpoly_q_t value);

/* Keep the first `count` alone. Terms of those from `first` on. */
void tp_conditions_forget(tp_conditions *conditions, long count);
long tp_conditions_length(const tp_conditions *conditions, long first);

#endif
