/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Triples in symbols: a force with its moment, or a twist (v_x, v_y, omega) about the origin
 * (plane/vector.h says the same in balls). */

#ifndef TP_DERIVE_VECTOR_FORMULAS_H
#define TP_DERIVE_VECTOR_FORMULAS_H

#include "derive/field.h"

#include "plane/vector.h"

typedef struct tp_vector_formulas {
  fmpz_mpoly_q_t of[3];
} tp_vector_formulas;

void tp_vector_formulas_init(tp_vector_formulas *v, const tp_field *field);
void tp_vector_formulas_clear(tp_vector_formulas *v, const tp_field *field);
void tp_vector_formulas_neg(tp_vector_formulas *v, const tp_field *field);
void tp_vector_formulas_cross(tp_vector_formulas *product, const tp_vector_formulas *a,
                              const tp_vector_formulas *b, const tp_field *field);
void tp_vector_formulas_dot(fmpz_mpoly_q_t product, const tp_vector_formulas *a,
                            const tp_vector_formulas *b, const tp_field *field);

/* a d - b c */
void tp_formulas_determinant(fmpz_mpoly_q_t value, const fmpz_mpoly_q_t a, const fmpz_mpoly_q_t b,
                             const fmpz_mpoly_q_t c, const fmpz_mpoly_q_t d, const tp_field *field);

/* Where each symbol takes its ball. */
void tp_vector_formulas_evaluate(tp_vector *value, const tp_vector_formulas *v, arb_srcptr symbols,
                                 const tp_field *field, long bits);

#endif
