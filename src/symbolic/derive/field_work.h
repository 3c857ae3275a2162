/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rational functions over the rationals in the symbols of a scene, always in lowest terms
 * (Calcium's fmpz_mpoly_q, later part of FLINT; included here alone), and what arithmetic with them
 * may cost.
 *
 * Sizes are looked at before an operation, since FLINT ends the process where memory ends, and what
 * it is going to take is counted from them: terms, bits and degrees, never seconds, so that the
 * same input gives the same answer on every machine. A unit of work is about a microsecond. An
 * operation that would be too large, or that the budget has no room for, is not done: its value is
 * zero, and so are all that follow, until someone asks for the problem and reports it. */

#ifndef TP_DERIVE_FIELD_WORK_H
#define TP_DERIVE_FIELD_WORK_H

#include "common/message.h"
#include "scene/scene.h"

#include <calcium/fmpz_mpoly_q.h>
#include <flint/fmpz_mpoly_factor.h>

typedef struct tp_field_work {
  double spent, budget;
  const char *problem; /* why an operation was not done; NULL: all were */
} tp_field_work;

typedef struct tp_field {
  fmpz_mpoly_ctx_t ring;
  const tp_parameters *parameters; /* of the scene: names and values */
  long symbol_count;               /* the parameters, one for a count, and those of the caller */
  const char **names; /* of the symbols; the count is N, or n or N_ and so on where that is taken */
  char *count_name, **renamed; /* owned names; the parameters' as derive/c_names.h sets them */
  long known;                  /* parameters read so far */
  fmpz_mpoly_q_struct *values; /* symbol or expression of each */
  tp_field_work *work;         /* what its arithmetic has cost, and may cost */
} tp_field;

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

/* value += a b, value -= a b; `value` is neither. */
void tp_field_addmul(fmpz_mpoly_q_t value, const fmpz_mpoly_q_t a, const fmpz_mpoly_q_t b,
                     const tp_field *field);
void tp_field_submul(fmpz_mpoly_q_t value, const fmpz_mpoly_q_t a, const fmpz_mpoly_q_t b,
                     const tp_field *field);

/* As tp_ball_mirror (plane/contact_rows.h). */
static inline void tp_symbol_mirror(fmpz_mpoly_q_t x, tp_direction towards, const tp_field *field) {
  if (towards == TP_TOWARDS_RIGHT) fmpz_mpoly_q_neg(x, x, field->ring);
}

/* Spend units on other work; false, with the problem set, where there is no room for them. */
bool tp_field_spend(const tp_field *field, double units);

/* What a greatest common divisor, or a factorisation, of polynomials of these sizes takes. */
double tp_field_gcd_units(const fmpz_mpoly_t a, const fmpz_mpoly_t b, const tp_field *field);
double tp_field_factor_units(const fmpz_mpoly_t polynomial, const tp_field *field);

/* The factors of a polynomial, whose product is verified to be it; false: they are not found. */
bool tp_field_factor(fmpz_mpoly_factor_t factors, const fmpz_mpoly_t polynomial,
                     const tp_field *field);

/* Why an operation was not done, NULL where all were; as a failure at a place of the file. */
const char *tp_field_problem(const tp_field *field);
TP_MUST_USE tp_status tp_field_check(const tp_field *field, tp_place place, tp_message *message);

/* Forget a problem that was one operation's; a spent budget stays one. */
void tp_field_forgive(const tp_field *field);

#endif
