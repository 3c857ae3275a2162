/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Area, centroid and second moments of one outline exactly: its vertices on a lattice of whole
 * numbers, the sums there, and rationals of them, each rounded once. */

#include "batch/area.h"

#include "number/ball.h"
#include "plane/lattice.h"
#include "scene/exact.h"

/* What scales: about the lattice's origin in units of it, then in those of the outline. */
typedef struct exact_sums {
  const tp_lattice *lattice;
  fmpz sums[TP_SUM_COUNT];
} exact_sums;

static tp_bounded rounded(const fmpq_t value) {
  enum { BITS = 128 };
  arb_t ball;
  arb_init(ball);
  arb_set_fmpq(ball, value, BITS);
  const tp_bounded result = tp_ball_bounded(ball);
  arb_clear(ball);
  return result;
}

/* value * step^degree. */
static tp_bounded in_units(fmpq_t value, const exact_sums *s, int degree) {
  for (int k = 0; k < degree; k++) fmpq_mul(value, value, s->lattice->step_m);
  return rounded(value);
}

static tp_bounded area(const exact_sums *s) {
  fmpq_t value;
  fmpq_init(value);
  fmpq_set_fmpz(value, s->sums + TP_A2);
  fmpq_abs(value, value);
  fmpq_div_2exp(value, value, 1);
  const tp_bounded result = in_units(value, s, 2);
  fmpq_clear(value);
  return result;
}

/* sum / (3 A2) + origin. */
static tp_bounded centroid(const exact_sums *s, int sum, const fmpz_t origin) {
  fmpq_t value;
  fmpz_t divisor;
  fmpq_init(value);
  fmpz_init(divisor);
  fmpz_mul_ui(divisor, s->sums + TP_A2, 3);
  fmpq_set_fmpz_frac(value, s->sums + sum, divisor);
  fmpq_add_fmpz(value, value, origin);
  const tp_bounded result = in_units(value, s, 1);
  fmpq_clear(value);
  fmpz_clear(divisor);
  return result;
}

/* Times the way round, second / divisor - one other / (18 A2). */
static tp_bounded second_moment(const exact_sums *s, int second, unsigned long divisor, int one,
                                int other) {
  fmpq_t value, less;
  fmpz_t n, d;
  fmpq_init(value);
  fmpq_init(less);
  fmpz_init(n);
  fmpz_init_set_ui(d, divisor);
  fmpq_set_fmpz_frac(value, s->sums + second, d);
  fmpz_mul(n, s->sums + one, s->sums + other);
  fmpz_mul_ui(d, s->sums + TP_A2, 18);
  fmpq_set_fmpz_frac(less, n, d);
  fmpq_sub(value, value, less);
  if (fmpz_sgn(s->sums + TP_A2) < 0) fmpq_neg(value, value);
  const tp_bounded result = in_units(value, s, 4);
  fmpq_clear(value);
  fmpq_clear(less);
  fmpz_clear(n);
  fmpz_clear(d);
  return result;
}

static tp_status take(tp_area_moments *moments, const tp_lattice *lattice, tp_message *message) {
  exact_sums s = {.lattice = lattice};
  for (int k = 0; k < TP_SUM_COUNT; k++) fmpz_init(s.sums + k);
  tp_ring_sums_exact(s.sums, lattice->x, lattice->y, lattice->count);
  tp_status status = TP_OK;
  if (fmpz_is_zero(s.sums + TP_A2)) {
    status =
        tp_refuse(message, TP_FAULT_GEOMETRY, (tp_place){0}, "the outline has an area of zero");
  } else {
    *moments = (tp_area_moments){.area = area(&s),
                                 .centroid_x = centroid(&s, TP_X6, lattice->origin_x),
                                 .centroid_y = centroid(&s, TP_Y6, lattice->origin_y),
                                 .second_moment_xx = second_moment(&s, TP_XX12, 12, TP_X6, TP_X6),
                                 .second_moment_yy = second_moment(&s, TP_YY12, 12, TP_Y6, TP_Y6),
                                 .second_moment_xy = second_moment(&s, TP_XY24, 24, TP_X6, TP_Y6)};
  }
  for (int k = 0; k < TP_SUM_COUNT; k++) fmpz_clear(s.sums + k);
  return status;
}

tp_status tp_area_exact(tp_area_moments *moments, tp_vertices vertices, tp_message *message) {
  if (vertices.count < 3) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                     "the outline has %zu %s; it needs at least three", vertices.count,
                     vertices.count == 1 ? "vertex" : "vertices");
  }
  tp_polyline line = {0};
  const tp_coordinates given = tp_coordinates_of(vertices.xy, vertices.count);
  tp_status status = tp_coordinates_read(&line, given, true, "the outline", NULL, 0, message);
  if (status != TP_OK) return status;
  tp_lattice lattice;
  fmpq_t one;
  fmpq_init(one);
  fmpq_one(one);
  const tp_polyline *chain = &line;
  status = tp_lattice_init(&lattice, &chain, 1, one, message);
  if (status == TP_OK) {
    status = take(moments, &lattice, message);
    tp_lattice_clear(&lattice);
  }
  fmpq_clear(one);
  tp_polyline_clear(&line);
  return status;
}
