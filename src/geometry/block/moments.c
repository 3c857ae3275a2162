/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Ring sums by doubles, pairs of doubles, balls or integers according to the precision asked for,
 * scaled by powers of two and summed with the weights of the rings (docs/mechanics.md section
 * 2). */

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

/* In the units of the lattice. */
static void unscale(arb_t sum, int k, const tp_lattice *lattice) {
  arb_mul_2exp_si(sum, sum,
                  lattice->exponent_u * tp_sum_degree[k].x +
                      lattice->exponent_v * tp_sum_degree[k].y);
}

/* The points first … first + count - 1 of the lattice. */
typedef struct ring {
  const tp_lattice *lattice;
  long first, count;
  int sum_count, threads;
} ring;

static tp_sums_plan plan_of(const ring *r) {
  return (tp_sums_plan){.sum_count = r->sum_count, .threads = r->threads};
}

static void ring_in_double(arb_struct *sums, const ring *r) {
  const tp_lattice *l = r->lattice;
  double values[TP_SUM_COUNT], bounds[TP_SUM_COUNT];
  tp_ring_sums_double_first(values, bounds, l->u + r->first, l->v + r->first, r->count,
                            tp_lattice_is_exact(l), plan_of(r));
  for (int k = 0; k < r->sum_count; k++) {
    tp_ball_set_bounded(sums + k, values[k], bounds[k]);
    unscale(sums + k, k, l);
  }
}

static void ring_compensated(arb_struct *sums, const ring *r) {
  const tp_lattice *l = r->lattice;
  tp_double_pair values[TP_SUM_COUNT];
  double bounds[TP_SUM_COUNT];
  arf_t low;
  arf_init(low);
  tp_ring_sums_compensated_first(values, bounds, l->u + r->first, l->v + r->first, r->count,
                                 plan_of(r));
  for (int k = 0; k < r->sum_count; k++) {
    tp_ball_set_bounded(sums + k, values[k].high, bounds[k]);
    arf_set_d(low, values[k].low);
    arf_add(arb_midref(sums + k), arb_midref(sums + k), low, ARF_PREC_EXACT, ARF_RND_NEAR);
  }
  arf_clear(low);
}

static void ring_exactly(arb_struct *sums, const ring *r) {
  const tp_lattice *l = r->lattice;
  fmpz integers[TP_SUM_COUNT];
  for (int k = 0; k < r->sum_count; k++) fmpz_init(integers + k);
  tp_ring_sums_exact_first(integers, l->x + r->first, l->y + r->first, r->count, r->sum_count);
  for (int k = 0; k < r->sum_count; k++) {
    arb_set_fmpz(sums + k, integers + k);
    fmpz_clear(integers + k);
  }
}

/* Pairs of doubles sum integers; coordinates that were rounded already are summed as well in plain
 * doubles. */
static void ring_sums(arb_struct *sums, const ring *r, tp_rung rung) {
  const tp_lattice *l = r->lattice;
  switch (rung.level) {
  case TP_LEVEL_DOUBLE:
    ring_in_double(sums, r);
    break;
  case TP_LEVEL_COMPENSATED:
    (tp_lattice_is_exact(l) ? ring_compensated : ring_in_double)(sums, r);
    break;
  case TP_LEVEL_BALL:
    tp_ring_sums_ball_first(sums, l->x + r->first, l->y + r->first, r->count, rung.bits,
                            r->sum_count);
    break;
  case TP_LEVEL_EXACT:
    ring_exactly(sums, r);
    break;
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
                         const fmpq_t metres_per_unit, tp_rung rung, int sum_count) {
  if (section->ellipse != NULL) {
    evaluate_ellipse(moments, section, lattice, metres_per_unit, rung.bits);
    return;
  }
  const long bits = rung.level == TP_LEVEL_EXACT ? ARF_PREC_EXACT : rung.bits;
  arb_struct sums[TP_SUM_COUNT];
  for (int k = 0; k < sum_count; k++) {
    arb_init(sums + k);
    arb_zero(moments->weighted + k);
  }
  arb_zero(moments->area2);
  for (long r = 0; r < section->ring_count; r++) {
    const long first = lattice->start[r];
    ring_sums(sums,
              &(ring){lattice, first, lattice->start[r + 1] - first, sum_count, section->threads},
              rung);
    if (r == 0) {
      arb_set(moments->area2, sums + TP_A2);
    } else if (r <= section->hole_count) {
      arb_sub(moments->area2, moments->area2, sums + TP_A2, bits);
    }
    for (int k = 0; k < sum_count; k++) {
      arb_addmul_fmpz(moments->weighted + k, sums + k, section->ring_weights + r, bits);
    }
  }
  for (int k = 0; k < sum_count; k++) arb_clear(sums + k);
}
