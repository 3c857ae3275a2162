/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Green's sums of docs/mechanics.md section 2 over symbolic vertices, the polar second moment, and
 * arms about a point. */

#include "derive/formulas.h"

#include "block/ring_sums.h"
#include "derive/field_work.h"

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

#define NUMBER fmpz_mpoly_q_struct
#define COORDINATE fmpz_mpoly_q_struct
#define FUNCTION symbol_sums
#define PARAMETER , const tp_field *field
#define INIT(r) fmpz_mpoly_q_init(r, field->ring)
#define CLEAR(r) fmpz_mpoly_q_clear(r, field->ring)
#define ZERO(r) fmpz_mpoly_q_zero(r, field->ring)
#define SET_COORDINATE(r, a) fmpz_mpoly_q_set(r, a, field->ring)
#define ADD(r, a, b) tp_field_add(r, a, b, field)
#define SUBTRACT(r, a, b) tp_field_sub(r, a, b, field)
#define MULTIPLY(r, a, b) tp_field_mul(r, a, b, field)
#define ADD_PRODUCT(r, a, b) tp_field_addmul(r, a, b, field)
#include "block/ring_sums_in.h"

void tp_formulas_add_chain(tp_formulas *f, const tp_symbolic_chain *chain, const fmpq_t weight,
                           int sign, const tp_field *field) {
  fmpz_mpoly_q_struct own[TP_AREA_SUM_COUNT], *sums[] = {f->weighted2, f->x6, f->y6};
  for (int s = 0; s < TP_AREA_SUM_COUNT; s++) fmpz_mpoly_q_init(own + s, field->ring);
  symbol_sums(own, chain->x, chain->y, chain->count, TP_AREA_SUM_COUNT, field);
  if (sign > 0) tp_field_add(f->area2, f->area2, own + TP_A2, field);
  if (sign < 0) tp_field_sub(f->area2, f->area2, own + TP_A2, field);
  for (int s = 0; s < TP_AREA_SUM_COUNT; s++) {
    fmpz_mpoly_q_mul_fmpq(own + s, own + s, weight, field->ring);
    tp_field_add(sums[s], sums[s], own + s, field);
    fmpz_mpoly_q_clear(own + s, field->ring);
  }
}

static void set_weight(fmpq_t weight, const tp_section *section, long ring) {
  fmpq_set_fmpz(weight, section->ring_weights + ring);
  fmpq_div_fmpz(weight, weight, section->density_weights);
}

void tp_formulas_sum(tp_formulas *f, const tp_symbols *symbols, const tp_section *section) {
  fmpq_t weight;
  fmpq_init(weight);
  for (long r = 0; r < section->ring_count; r++) {
    set_weight(weight, section, r);
    const int sign = r == 0 ? 1 : r <= section->hole_count ? -1 : 0;
    tp_formulas_add_chain(f, symbols->rings + r, weight, sign, &symbols->field);
  }
  fmpq_clear(weight);
}

void tp_formulas_polar(fmpz_mpoly_q_t polar12, const tp_symbols *symbols,
                       const tp_section *section) {
  const tp_field *field = &symbols->field;
  fmpz_mpoly_q_struct own[TP_XY24];
  fmpq_t weight;
  for (int s = 0; s < TP_XY24; s++) fmpz_mpoly_q_init(own + s, field->ring);
  fmpq_init(weight);
  fmpz_mpoly_q_zero(polar12, field->ring);
  for (long r = 0; r < section->ring_count; r++) {
    const tp_symbolic_chain *chain = symbols->rings + r;
    symbol_sums(own, chain->x, chain->y, chain->count, TP_XY24, field);
    set_weight(weight, section, r);
    for (int s = TP_XX12; s <= TP_YY12; s++) {
      fmpz_mpoly_q_mul_fmpq(own + s, own + s, weight, field->ring);
      tp_field_add(polar12, polar12, own + s, field);
    }
  }
  for (int s = 0; s < TP_XY24; s++) fmpz_mpoly_q_clear(own + s, field->ring);
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
