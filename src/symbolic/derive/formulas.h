/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The moment sums and lever arms of a block in symbols (docs/mechanics.md section 9). */

#ifndef TP_DERIVE_FORMULAS_H
#define TP_DERIVE_FORMULAS_H

#include "derive/symbols.h"
#include "problem/problem.h"

/* Twice the area, six times the first moments about the scene's origin, weighted by relative
 * density; `area2` without weights, holes taken off. */
typedef struct tp_formulas {
  fmpz_mpoly_q_t area2, weighted2, x6, y6;
} tp_formulas;

void tp_formulas_init(tp_formulas *formulas, const tp_field *field);
void tp_formulas_clear(tp_formulas *formulas, const tp_field *field);

/* The boundary sums of block/ring_sums.h over all rings. */
void tp_formulas_sum(tp_formulas *formulas, const tp_symbols *symbols, const tp_section *section);

/* Twelve times the polar second moment about the scene's origin, weighted likewise. */
void tp_formulas_polar(fmpz_mpoly_q_t polar12, const tp_symbols *symbols,
                       const tp_section *section);

/* Add one ring with its relative weight; the plain area times `sign`. */
void tp_formulas_add_chain(tp_formulas *formulas, const tp_symbolic_chain *chain,
                           const fmpq_t weight, int sign, const tp_field *field);

/* S6 - 3 A2 p: six times the first moment about a pivot. */
void tp_formulas_arm(fmpz_mpoly_q_t arm, const fmpz_mpoly_q_t moment6,
                     const fmpz_mpoly_q_t weighted2, const fmpz_mpoly_q_t pivot,
                     const tp_field *field);

/* A point in symbols, borrowed. */
typedef struct tp_symbolic_point {
  const fmpz_mpoly_q_struct *x, *y;
} tp_symbolic_point;

/* A point of the problem's lattice; false where it has no symbols, as past the block on a mated
 * base. */
bool tp_formulas_point(tp_symbolic_point *coordinates, const tp_symbols *symbols,
                       const tp_problem *problem, long point);

/* An element about a pivot: its area times relative density, the arms of its weight (x mirrored
 * towards the right), and the sides that they are on at the scene's values. */
typedef struct tp_element_formulas {
  fmpz_mpoly_q_t area, normal_arm, parallel_arm;
  bool normal_stabilises, parallel_overturns;
} tp_element_formulas;

void tp_element_formulas_init(tp_element_formulas *element, const tp_field *field);
void tp_element_formulas_clear(tp_element_formulas *element, const tp_field *field);
void tp_element_formulas_set(tp_element_formulas *element, const tp_symbols *symbols,
                             const tp_problem *problem, long index, const tp_symbolic_point *pivot,
                             tp_direction towards);

/* The sums of the elements' moments: a, b stabilise with cos and sin of the tilt, c, d overturn. */
typedef struct tp_side_formulas {
  fmpz_mpoly_q_t a, b, c, d;
} tp_side_formulas;

void tp_side_formulas_init(tp_side_formulas *sides, const tp_field *field);
void tp_side_formulas_clear(tp_side_formulas *sides, const tp_field *field);

/* False where the elements do not add up to the block for all values of the parameters, because
 * corners of different rings meet only at the scene's values. */
bool tp_side_formulas_sum(tp_side_formulas *sides, const tp_formulas *formulas,
                          const tp_symbols *symbols, const tp_problem *problem,
                          const tp_symbolic_point *pivot, tp_direction towards);

#endif
