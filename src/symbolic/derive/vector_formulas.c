/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Determinant, cross and dot products of triples of rational functions, and their values in
 * balls. */

#include "derive/vector_formulas.h"

#include "derive/field_work.h"

void tp_vector_formulas_init(tp_vector_formulas *v, const tp_field *field) {
  for (int k = 0; k < 3; k++) fmpz_mpoly_q_init(v->of[k], field->ring);
}

void tp_vector_formulas_clear(tp_vector_formulas *v, const tp_field *field) {
  for (int k = 0; k < 3; k++) fmpz_mpoly_q_clear(v->of[k], field->ring);
}

void tp_vector_formulas_neg(tp_vector_formulas *v, const tp_field *field) {
  for (int k = 0; k < 3; k++) fmpz_mpoly_q_neg(v->of[k], v->of[k], field->ring);
}

void tp_formulas_determinant(fmpz_mpoly_q_t value, const fmpz_mpoly_q_t a, const fmpz_mpoly_q_t b,
                             const fmpz_mpoly_q_t c, const fmpz_mpoly_q_t d,
                             const tp_field *field) {
  fmpz_mpoly_q_t first, other;
  fmpz_mpoly_q_init(first, field->ring);
  fmpz_mpoly_q_init(other, field->ring);
  tp_field_mul(first, a, d, field);
  tp_field_mul(other, b, c, field);
  tp_field_sub(value, first, other, field);
  fmpz_mpoly_q_clear(first, field->ring);
  fmpz_mpoly_q_clear(other, field->ring);
}

void tp_vector_formulas_cross(tp_vector_formulas *product, const tp_vector_formulas *a,
                              const tp_vector_formulas *b, const tp_field *field) {
  for (int k = 0; k < 3; k++) {
    const int next = (k + 1) % 3, last = (k + 2) % 3;
    tp_formulas_determinant(product->of[k], a->of[next], a->of[last], b->of[next], b->of[last],
                            field);
  }
}

void tp_vector_formulas_dot(fmpz_mpoly_q_t product, const tp_vector_formulas *a,
                            const tp_vector_formulas *b, const tp_field *field) {
  fmpz_mpoly_q_t term, sum;
  fmpz_mpoly_q_init(term, field->ring);
  fmpz_mpoly_q_init(sum, field->ring);
  for (int k = 0; k < 3; k++) {
    tp_field_mul(term, a->of[k], b->of[k], field);
    tp_field_add(sum, sum, term, field);
  }
  fmpz_mpoly_q_swap(product, sum, field->ring);
  fmpz_mpoly_q_clear(term, field->ring);
  fmpz_mpoly_q_clear(sum, field->ring);
}

void tp_vector_formulas_evaluate(tp_vector *value, const tp_vector_formulas *v, arb_srcptr symbols,
                                 const tp_field *field, long bits) {
  for (int k = 0; k < 3; k++) {
    tp_field_evaluate_ball(value->of + k, v->of[k], symbols, field, bits);
  }
}
