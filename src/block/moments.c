/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "block/moments.h"

#include "block/ellipse.h"
#include "number/ball.h"

void tp_moments_init(tp_moments *moments) {
  arb_init(moments->area2);
  for (int k = 0; k < TP_SUM_COUNT; k++) arb_init(moments->weighted + k);
}

void tp_moments_clear(tp_moments *moments) {
  arb_clear(moments->area2);
  for (int k = 0; k < TP_SUM_COUNT; k++) arb_clear(moments->weighted + k);
}

static void ring_in_double(arb_struct sums[TP_SUM_COUNT], const tp_lattice *lattice, long first,
                           long count) {
  double values[TP_SUM_COUNT], bounds[TP_SUM_COUNT];
  tp_ring_sums_double(values, bounds, lattice->u + first, lattice->v + first, count,
                      tp_lattice_is_exact(lattice));
  for (int k = 0; k < TP_SUM_COUNT; k++) {
    tp_ball_set_bounded(sums + k, values[k], bounds[k]);
    arb_mul_2exp_si(sums + k, sums + k,
                    lattice->exponent_u * tp_sum_degree[k].x +
                        lattice->exponent_v * tp_sum_degree[k].y);
  }
}

static void ring_exactly(arb_struct sums[TP_SUM_COUNT], const tp_lattice *lattice, long first,
                         long count) {
  fmpz integers[TP_SUM_COUNT];
  for (int k = 0; k < TP_SUM_COUNT; k++) fmpz_init(integers + k);
  tp_ring_sums_exact(integers, lattice->x + first, lattice->y + first, count);
  for (int k = 0; k < TP_SUM_COUNT; k++) {
    arb_set_fmpz(sums + k, integers + k);
    fmpz_clear(integers + k);
  }
}

/* An ellipse, which is the only ring of its section. */
static void evaluate_ellipse(tp_moments *moments, const tp_section *section,
                             const tp_lattice *lattice, const fmpq_t metres_per_unit, long bits) {
  tp_ellipse_sums(moments->weighted, section->ellipse, lattice, metres_per_unit, bits);
  arb_set(moments->area2, moments->weighted + TP_A2);
  for (int k = 0; k < TP_SUM_COUNT; k++) {
    arb_mul_fmpz(moments->weighted + k, moments->weighted + k, section->ring_weights, bits);
  }
}

void tp_moments_evaluate(tp_moments *moments, const tp_section *section, const tp_lattice *lattice,
                         const fmpq_t metres_per_unit, tp_rung rung) {
  if (section->ellipse != NULL) {
    evaluate_ellipse(moments, section, lattice, metres_per_unit, rung.bits);
    return;
  }
  const long bits = rung.level == TP_LEVEL_EXACT ? ARF_PREC_EXACT : rung.bits;
  arb_struct ring[TP_SUM_COUNT];
  for (int k = 0; k < TP_SUM_COUNT; k++) {
    arb_init(ring + k);
    arb_zero(moments->weighted + k);
  }
  arb_zero(moments->area2);
  for (long r = 0; r < section->ring_count; r++) {
    const long first = lattice->start[r], count = lattice->start[r + 1] - first;
    switch (rung.level) {
    case TP_LEVEL_DOUBLE:
    case TP_LEVEL_COMPENSATED:
      ring_in_double(ring, lattice, first, count);
      break;
    case TP_LEVEL_BALL:
      tp_ring_sums_ball(ring, lattice->x + first, lattice->y + first, count, rung.bits);
      break;
    case TP_LEVEL_EXACT:
      ring_exactly(ring, lattice, first, count);
      break;
    }
    if (r == 0) {
      arb_set(moments->area2, ring + TP_A2);
    } else if (r <= section->hole_count) {
      arb_sub(moments->area2, moments->area2, ring + TP_A2, bits);
    }
    for (int k = 0; k < TP_SUM_COUNT; k++) {
      arb_addmul_fmpz(moments->weighted + k, ring + k, section->ring_weights + r, bits);
    }
  }
  for (int k = 0; k < TP_SUM_COUNT; k++) arb_clear(ring + k);
}
