/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Moments of a section: the boundary sums of its rings (block/ring_sums.h) at the price of a rung,
 * each times its ring's whole-number weight, or an ellipse's in closed form. The bound of the sums
 * goes along in balls; powers of two and weights are multiplied exactly. */

#ifndef TP_BLOCK_MOMENTS_H
#define TP_BLOCK_MOMENTS_H

#include "block/ring_sums.h"
#include "block/section.h"
#include "number/ladder.h"

/* In lattice units about the lattice's origin. `weighted` sums every ring by its weight; `area2` is
 * twice the area of outline less holes. */
typedef struct tp_moments {
  arb_t area2;
  arb_struct weighted[TP_SUM_COUNT];
} tp_moments;

void tp_moments_init(tp_moments *moments);
void tp_moments_clear(tp_moments *moments);

/* The first `sum_count` of the sums, TP_AREA_SUM_COUNT or TP_SUM_COUNT, at one rung of the ladder;
 * exact integers at TP_LEVEL_EXACT. The first chains of the lattice are the rings of the section.
 */
void tp_moments_evaluate(tp_moments *moments, const tp_section *section, const tp_lattice *lattice,
                         const fmpq_t metres_per_unit, tp_rung rung, int sum_count);

#endif
