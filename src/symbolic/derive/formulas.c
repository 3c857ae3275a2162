/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Green's sums of docs/mechanics.md section 2 over symbolic vertices, the polar second moment, and
 * arms about a point. */

#include "derive/formulas.h"

#include "derive/field_work.h"
#include "derive/vector_formulas.h"

void tp_formulas_init(tp_formulas *f, const tp_field *field) {
  fmpz_mpoly_q_init(f->area2, field->ring);
  fmpz_mpoly_q_init(f->weighted2, field->ring);
  fmpz_mpoly_q_init(f->x6, field->ring);
  fmpz_mpoly_q_init(f->y6, field->ring);
}

void tp_formulas_clear(tp_formulas *f, const tp_field *field) {
  fmpz_mpoly_q_clear(f->area2, field->ring);
  fmpz_mpoly_q_clear(f->weighted2, field->ring);
  fmpz_mpoly_q_clear(f->x6, field->ring);
  fmpz_mpoly_q_clear(f->y6, field->ring);
}

/* sum += (p + q) c weight */
static void add_moment(fmpz_mpoly_q_t sum, const fmpz_mpoly_q_t p, const fmpz_mpoly_q_t q,
                       const fmpz_mpoly_q_t c, const fmpq_t weight, fmpz_mpoly_q_t scratch,
                       const tp_field *field) {
  tp_field_add(scratch, p, q, field);
  tp_field_mul(scratch, scratch, c, field);
  fmpz_mpoly_q_mul_fmpq(scratch, scratch, weight, field->ring);
  tp_field_add(sum, sum, scratch, field);
}

void tp_formulas_add_chain(tp_formulas *f, const tp_symbolic_chain *chain, const fmpq_t weight,
                           int sign, const tp_field *field) {
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  fmpz_mpoly_q_t c, scratch;
  fmpz_mpoly_q_init(c, ring);
  fmpz_mpoly_q_init(scratch, ring);
  for (long k = 0; k < chain->count; k++) {
    const long next = k + 1 == chain->count ? 0 : k + 1;
    const fmpz_mpoly_q_struct *x0 = chain->x + k, *x1 = chain->x + next;
    const fmpz_mpoly_q_struct *y0 = chain->y + k, *y1 = chain->y + next;
    tp_field_mul(c, x0, y1, field);
    tp_field_mul(scratch, x1, y0, field);
    tp_field_sub(c, c, scratch, field);
    if (sign > 0) tp_field_add(f->area2, f->area2, c, field);
    if (sign < 0) tp_field_sub(f->area2, f->area2, c, field);
    fmpz_mpoly_q_mul_fmpq(scratch, c, weight, ring);
    tp_field_add(f->weighted2, f->weighted2, scratch, field);
    add_moment(f->x6, x0, x1, c, weight, scratch, field);
    add_moment(f->y6, y0, y1, c, weight, scratch, field);
  }
  fmpz_mpoly_q_clear(c, ring);
  fmpz_mpoly_q_clear(scratch, ring);
}

void tp_formulas_sum(tp_formulas *f, const tp_symbols *symbols, const tp_section *section) {
  fmpq_t weight;
  fmpq_init(weight);
  for (long r = 0; r < section->ring_count; r++) {
    fmpq_set_fmpz(weight, section->ring_weights + r);
    fmpq_div_fmpz(weight, weight, section->density_weights);
    const int sign = r == 0 ? 1 : r <= section->hole_count ? -1 : 0;
    tp_formulas_add_chain(f, symbols->rings + r, weight, sign, &symbols->field);
  }
  fmpq_clear(weight);
}

/* sum += (p^2 + p q + q^2) c weight */
static void add_square(fmpz_mpoly_q_t sum, const fmpz_mpoly_q_t p, const fmpz_mpoly_q_t q,
                       const fmpz_mpoly_q_t c, const fmpq_t weight, const tp_field *field) {
  fmpz_mpoly_q_t term, product;
  fmpz_mpoly_q_init(term, field->ring);
  fmpz_mpoly_q_init(product, field->ring);
  tp_field_add(term, p, q, field);
  tp_field_mul(term, term, term, field);
  tp_field_mul(product, p, q, field);
  tp_field_sub(term, term, product, field);
  tp_field_mul(term, term, c, field);
  fmpz_mpoly_q_mul_fmpq(term, term, weight, field->ring);
  tp_field_add(sum, sum, term, field);
  fmpz_mpoly_q_clear(term, field->ring);
  fmpz_mpoly_q_clear(product, field->ring);
}

void tp_formulas_polar(fmpz_mpoly_q_t polar12, const tp_symbols *symbols,
                       const tp_section *section) {
  const tp_field *field = &symbols->field;
  fmpz_mpoly_q_t c;
  fmpq_t weight;
  fmpz_mpoly_q_init(c, field->ring);
  fmpq_init(weight);
  fmpz_mpoly_q_zero(polar12, field->ring);
  for (long r = 0; r < section->ring_count; r++) {
    const tp_symbolic_chain *chain = symbols->rings + r;
    fmpq_set_fmpz(weight, section->ring_weights + r);
    fmpq_div_fmpz(weight, weight, section->density_weights);
    for (long k = 0; k < chain->count; k++) {
      const long next = k + 1 == chain->count ? 0 : k + 1;
      tp_formulas_determinant(c, chain->x + k, chain->y + k, chain->x + next, chain->y + next,
                              field);
      add_square(polar12, chain->x + k, chain->x + next, c, weight, field);
      add_square(polar12, chain->y + k, chain->y + next, c, weight, field);
    }
  }
  fmpz_mpoly_q_clear(c, field->ring);
  fmpq_clear(weight);
}

void tp_formulas_arm(fmpz_mpoly_q_t arm, const fmpz_mpoly_q_t moment6,
                     const fmpz_mpoly_q_t weighted2, const fmpz_mpoly_q_t pivot,
                     const tp_field *field) {
  fmpz_t three;
  fmpz_init_set_si(three, 3);
  tp_field_mul(arm, weighted2, pivot, field);
  fmpz_mpoly_q_mul_fmpz(arm, arm, three, field->ring);
  tp_field_sub(arm, moment6, arm, field);
  fmpz_clear(three);
}

bool tp_formulas_point(tp_symbolic_point *coordinates, const tp_symbols *symbols,
                       const tp_problem *problem, long point) {
  const long *start = problem->lattice.start, rings = symbols->ring_count;
  long chain = 0;
  while (point >= start[chain + 1]) chain++;
  const tp_symbolic_chain *found = chain < rings    ? symbols->rings + chain
                                   : chain == rings ? &symbols->profile
                                                    : &symbols->corners;
  const long at = point - start[chain];
  if (at >= found->count) return false;
  *coordinates = (tp_symbolic_point){found->x + at, found->y + at};
  return true;
}
