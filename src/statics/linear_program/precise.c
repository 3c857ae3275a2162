/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sets up the linear program in floating point of any precision at the midpoints of the data and
 * runs the steps of precise_step.h; programs of more than half a gigabyte are refused. */

#include "linear_program/precise.h"

#include "linear_program/precise_step.h"
#include "number/ball.h"

#include <math.h>
#include <stdlib.h>

/* A force with its moment in the scaled program's units but for `exponent` of its own: midpoints.
 */
static bool set_wrench(arf_struct *own, const tp_scaled *s, const tp_vector *of, long exponent,
                       long bits) {
  arb_t moment;
  arb_init(moment);
  arb_mul(moment, s->y, of->of, bits);
  arb_submul(moment, s->x, of->of + 1, bits);
  arb_add(moment, of->of + 2, moment, bits);
  arf_mul_2exp_si(own, arb_midref(of->of), -exponent);
  arf_mul_2exp_si(own + 1, arb_midref(of->of + 1), -exponent);
  arf_mul_2exp_si(own + 2, arb_midref(moment), -exponent - s->length_exponent);
  arb_clear(moment);
  return arf_is_finite(own) && arf_is_finite(own + 1) && arf_is_finite(own + 2);
}

static long size_exponent(const tp_vector *of) {
  const double size = fmax(tp_ball_log2_above(of->of), tp_ball_log2_above(of->of + 1));
  return isfinite(size) ? (long)size : 0;
}

static bool set_columns(tp_precise *p, const tp_scaled *s, const tp_cones *cones) {
  tp_vector column;
  tp_vector_init(&column);
  bool finite = true;
  for (long k = 0; k < p->count && finite; k++) {
    tp_cones_column(column.of, cones, k, p->bits);
    const long exponent = size_exponent(&column);
    finite = set_wrench(p->columns + 3 * k, s, &column, exponent, p->bits);
    arf_pos_inf(p->most + k);
    if (tp_cones_is_edge(cones, k)) continue;
    tp_cones_bound(column.of, cones, k);
    arf_mul_2exp_si(p->most + k, arb_midref(column.of), exponent - s->force_exponent);
    finite = finite && arf_is_finite(p->most + k);
  }
  tp_vector_clear(&column);
  return finite;
}

static arf_struct *new_numbers(long count) {
  arf_struct *numbers = calloc((size_t)count + 1, sizeof *numbers);
  for (long k = 0; k < count && numbers != NULL; k++) arf_init(numbers + k);
  return numbers;
}

static void free_numbers(arf_struct *numbers, long count) {
  for (long k = 0; k < count && numbers != NULL; k++) arf_clear(numbers + k);
  free(numbers);
}

/* Numbers of so many bits, four a column: its three entries and its bound, each a struct and its
 * limbs. */
static bool fits(long count, long bits) {
  static const double numbers = 4, most_bytes = 5e8; /* half a gigabyte, as precise.h says */
  return numbers * (double)count * (sizeof(arf_struct) + (double)bits / 8) < most_bytes;
}

static void describe(tp_simplex_answer *answer, const tp_precise *p) {
  for (int r = 0; r < 3; r++) {
    answer->basis[r] = p->basis[r] <= TP_SIMPLEX_NONE ? TP_SIMPLEX_NONE : p->basis[r];
    answer->values[r] = arf_get_d(p->values + r, ARF_RND_NEAR);
    if (p->basis[r] == TP_SIMPLEX_T) answer->t = answer->values[r];
  }
}

tp_simplex_answer tp_precise_solve(tp_scaled *scaled, const tp_cones *cones,
                                   const tp_vector *direction, const tp_vector *target,
                                   tp_work *work, long bits) {
  tp_simplex_answer answer = {.outcome = TP_SIMPLEX_STUCK};
  if (!fits(scaled->count, bits)) return answer;
  tp_precise p = {.count = scaled->count, .bits = bits, .at_most = scaled->at_most, .work = work};
  p.columns = new_numbers(3 * p.count);
  p.most = new_numbers(p.count);
  p.scratch = new_numbers(TP_PRECISE_SCRATCH);
  if (p.columns != NULL && p.most != NULL && p.scratch != NULL) {
    tp_precise_share(&p);
    bool finite = set_columns(&p, scaled, cones);
    finite = set_wrench(p.direction, scaled, direction, scaled->force_exponent, bits) && finite;
    finite = set_wrench(p.target, scaled, target, scaled->force_exponent, bits) && finite;
    if (finite) {
      answer.outcome = tp_precise_run(&p);
      describe(&answer, &p);
    }
  } else {
    scaled->out_of_memory = true;
  }
  free_numbers(p.columns, 3 * p.count);
  free_numbers(p.most, p.count);
  free_numbers(p.scratch, TP_PRECISE_SCRATCH);
  return answer;
}
