/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The field in which formulas are derived, made from a scene, and values of what is in it.
 *
 * A parameter that the scene gives by a number is a symbol; one that it gives by an expression in
 * others stands for that expression. Further symbols are a count, and whatever a caller adds. */

#ifndef TP_DERIVE_FIELD_H
#define TP_DERIVE_FIELD_H

#include "derive/field_work.h"
#include "scene/scene.h"

#include <arb.h>

/* A coordinate may have so many terms. */
enum { TP_FIELD_COORDINATE_TERMS = 64 };

/* Names of symbols that a caller adds; they must outlive the field. */
typedef struct tp_symbol_names {
  long count;
  const char *const *names;
} tp_symbol_names;

/* `scene` NULL: no parameters. `more` NULL: no symbols but the scene's. */
TP_MUST_USE tp_status tp_field_init(tp_field *field, const tp_scene *scene,
                                    const tp_symbol_names *more, tp_message *message);
void tp_field_clear(tp_field *field);

/* The expression of a scalar node as a rational function. */
TP_MUST_USE tp_status tp_field_read(fmpz_mpoly_q_t value, const tp_field *field,
                                    const tp_node *node, const tp_scene *scene,
                                    tp_message *message);

/* Names of the parameters that are symbols, as formulas write them and as the scene gives them,
 * allocated with malloc like each of them; their number. False when memory is exhausted. */
TP_MUST_USE bool tp_field_list_symbols(size_t *count, char ***names, char ***parameters,
                                       const tp_field *field);

/* value = value op other, for one of + - * /, of which a divisor that is zero is the caller's
 * mistake; NULL, or what is wrong as a static string. */
const char *tp_field_combine(fmpz_mpoly_q_t value, tp_formula_kind kind, const fmpz_mpoly_q_t other,
                             const tp_field *field);

/* base = base^exponent for a whole exponent; NULL, or what is wrong as a static string. */
const char *tp_field_power(fmpz_mpoly_q_t base, long exponent, const tp_field *field);

/* The index of the symbol that the caller added as its k-th. */
long tp_field_added(const tp_field *field, long k);

/* The symbol that stands for a count. */
void tp_field_count_symbol(fmpz_mpoly_q_t value, const tp_field *field);

/* Its exact value at the scene's parameters; false where the denominator vanishes there.
 * The count symbol and those of the caller have no value and must not occur. */
bool tp_field_evaluate(fmpq_t value, const fmpz_mpoly_q_t formula, const tp_field *field);

/* The same where each symbol of the field takes the value given. */
bool tp_field_evaluate_at(fmpq_t value, const fmpz_mpoly_q_t formula, const fmpq *symbols,
                          const tp_field *field);

/* Its value where each symbol takes its ball; not finite where the denominator may vanish. */
void tp_field_evaluate_ball(arb_t value, const fmpz_mpoly_q_t formula, arb_srcptr symbols,
                            const tp_field *field, long bits);

/* The angle of which the formula is the tangent, in degrees, where each symbol takes its ball. */
tp_bounded tp_field_angle(const fmpz_mpoly_q_t tangent, arb_srcptr symbols, const tp_field *field,
                          long bits);

/* 1 or -1 where all coefficients of a polynomial have that sign, 0 where they differ. */
int tp_field_sign_of_coefficients(const fmpz_mpoly_t polynomial, const tp_field *field);

#endif
