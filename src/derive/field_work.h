/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What arithmetic in the field may cost.
 *
 * Sizes are looked at before an operation, since FLINT ends the process where memory ends, and what
 * it is going to take is counted from them: terms, bits and degrees, never seconds, so that the
 * same input gives the same answer on every machine. A unit of work is about a microsecond. An
 * operation that would be too large, or that the budget has no room for, is not done: its value is
 * zero, and so are all that follow, until someone asks for the problem and reports it. */

#ifndef TP_FIELD_WORK_H
#define TP_FIELD_WORK_H

#include "derive/field.h"

struct tp_field_work {
  double spent, budget;
  const char *problem; /* why an operation was not done; NULL: all were */
};

/* Units for one derivation, or for all claims of a file. */
enum { TP_FIELD_BUDGET = 8000000 };

/* value = a op b; `value` may be either. A divisor that is zero is the caller's mistake. */
void tp_field_add(fmpz_mpoly_q_t value, const fmpz_mpoly_q_t a, const fmpz_mpoly_q_t b,
                  const tp_field *field);
void tp_field_sub(fmpz_mpoly_q_t value, const fmpz_mpoly_q_t a, const fmpz_mpoly_q_t b,
                  const tp_field *field);
void tp_field_mul(fmpz_mpoly_q_t value, const fmpz_mpoly_q_t a, const fmpz_mpoly_q_t b,
                  const tp_field *field);
void tp_field_div(fmpz_mpoly_q_t value, const fmpz_mpoly_q_t a, const fmpz_mpoly_q_t b,
                  const tp_field *field);

/* Spend units on other work; false, with the problem set, where there is no room for them. */
bool tp_field_spend(const tp_field *field, double units);

/* What a greatest common divisor, or a factorisation, of polynomials of these sizes takes. */
double tp_field_gcd_units(const fmpz_mpoly_t a, const fmpz_mpoly_t b, const tp_field *field);
double tp_field_factor_units(const fmpz_mpoly_t polynomial, const tp_field *field);

/* Why an operation was not done, NULL where all were; as a failure at a place. */
const char *tp_field_problem(const tp_field *field);
TP_MUST_USE tp_status tp_field_check(const tp_field *field, tp_place place, tp_message *message);

/* Forget a problem that was one operation's; a spent budget stays one. */
void tp_field_forgive(const tp_field *field);

#endif
