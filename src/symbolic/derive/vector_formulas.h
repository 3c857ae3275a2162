/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Triples in symbols: a force with its moment, or a twist (v_x, v_y, omega) about the origin
 * (plane/vector.h says the same in balls); rows of contact points, edges of friction cones and what
 * else plane/contact_rows_in.h defines, as tp_symbol_…. */

#ifndef TP_DERIVE_VECTOR_FORMULAS_H
#define TP_DERIVE_VECTOR_FORMULAS_H

#include "derive/field.h"
#include "derive/field_work.h"
#include "plane/vector.h"

typedef struct tp_vector_formulas {
  fmpz_mpoly_q_struct of[3];
} tp_vector_formulas;

void tp_vector_formulas_init(tp_vector_formulas *v, const tp_field *field);
void tp_vector_formulas_clear(tp_vector_formulas *v, const tp_field *field);

/* a d - b c */
void tp_formulas_determinant(fmpz_mpoly_q_t value, const fmpz_mpoly_q_t a, const fmpz_mpoly_q_t b,
                             const fmpz_mpoly_q_t c, const fmpz_mpoly_q_t d, const tp_field *field);

/* Where each symbol takes its ball. */
void tp_vector_formulas_evaluate(tp_vector *value, const tp_vector_formulas *v, arb_srcptr symbols,
                                 const tp_field *field, long bits);

#define NUMBER fmpz_mpoly_q_struct
#define NAME(name) tp_symbol_##name
#define PARAMETER , const tp_field *field
#define DISCARD (void)field
#define SET(r, a) fmpz_mpoly_q_set(r, a, field->ring)
#define NEGATE(r, a) fmpz_mpoly_q_neg(r, a, field->ring)
#define ONE(r) fmpz_mpoly_q_one(r, field->ring)
#define ZERO(r) fmpz_mpoly_q_zero(r, field->ring)
#define ADD(r, a, b) tp_field_add(r, a, b, field)
#define SUBTRACT(r, a, b) tp_field_sub(r, a, b, field)
#define MULTIPLY(r, a, b) tp_field_mul(r, a, b, field)
#define ADD_PRODUCT(r, a, b) tp_field_addmul(r, a, b, field)
#define SUBTRACT_PRODUCT(r, a, b) tp_field_submul(r, a, b, field)
#include "plane/contact_rows_in.h"

#endif
