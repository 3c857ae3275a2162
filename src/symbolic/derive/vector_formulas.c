/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Triples of rational functions, their values in balls, and a determinant. */

#include "derive/vector_formulas.h"

void tp_vector_formulas_init(tp_vector_formulas *v, const tp_field *field) {
  for (int k = 0; k < 3; k++) fmpz_mpoly_q_init(v->of + k, field->ring);
}

void tp_vector_formulas_clear(tp_vector_formulas *v, const tp_field *field) {
  for (int k = 0; k < 3; k++) fmpz_mpoly_q_clear(v->of + k, field->ring);
}

void tp_formulas_determinant(fmpz_mpoly_q_t value, const fmpz_mpoly_q_t a, const fmpz_mpoly_q_t b,
                             const fmpz_mpoly_q_t c, const fmpz_mpoly_q_t d,
                             const tp_field *field) {
  fmpz_mpoly_q_t first;
  fmpz_mpoly_q_init(first, field->ring);
  tp_field_mul(first, a, d, field);
  tp_field_submul(first, b, c, field);
  fmpz_mpoly_q_swap(value, first, field->ring);
  fmpz_mpoly_q_clear(first, field->ring);
}

void tp_vector_formulas_evaluate(tp_vector *value, const tp_vector_formulas *v, arb_srcptr symbols,
                                 const tp_field *field, long bits) {
  for (int k = 0; k < 3; k++) {
    tp_field_evaluate_ball(value->of + k, v->of + k, symbols, field, bits);
  }
}
