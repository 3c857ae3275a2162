/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* With d = (q - p) x (r - p) for the triangle p, q, r: A2 = sum d, X6 = sum d (p_x + q_x + r_x), Y6
 * likewise.
 *
 * Bound in doubles (unit roundoff w = 2^-53; |u| <= U, |v| <= V). With the measure m = |du| |dv'| +
 * |dv| |du'| of a triangle, |d| <= m; four rounded differences, two products and a difference:
 * |err d| <= 4.1 w m. A sum of three coordinates, at most 3 U, has two roundings, the product one:
 * |err| <= 3 U (7.2 w) m. Adding n terms one by one: at most n w sum |terms|. Together (n + 8) w K
 * sum m, K = 1, 3 U, 3 V; the sum of m is itself short by less than (n + 4) w of itself, which the
 * margin of 1 % takes in for n below 10^13.
 * Coordinates that were rounded (|du| <= w U, |dv| <= w V) move each d by at most 16.1 w U V, and
 * each of the other terms, |d| <= 8 U V, by at most 3 * 16.1 + 8 * 3.1 = 73.1 w U V times U or V.
 */

#include "block/triangle_sums.h"

#include "number/ball.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

enum { SUMS = TP_Y6 + 1, MEASURE = SUMS, COUNT, ROWS };

static size_t part_of(const tp_geom_triangle *t, const tp_section *section) {
  const int in = t->ring_in_layer[2];
  return in == 0 ? 0 : (size_t)(in - 1 - section->hole_count);
}

static void add_in_double(double rows[ROWS], const size_t c[3], const tp_lattice *l) {
  const double *u = l->u, *v = l->v;
  const double one = (u[c[1]] - u[c[0]]) * (v[c[2]] - v[c[0]]);
  const double other = (v[c[1]] - v[c[0]]) * (u[c[2]] - u[c[0]]);
  const double d = one - other;
  rows[TP_A2] += d;
  rows[TP_X6] += d * (u[c[0]] + u[c[1]] + u[c[2]]);
  rows[TP_Y6] += d * (v[c[0]] + v[c[1]] + v[c[2]]);
  rows[MEASURE] += fabs(one) + fabs(other);
  rows[COUNT]++;
}

/* The sums of one part as balls, times its weight. */
static void add_part(tp_moments *moments, const double rows[ROWS], const fmpz *weight,
                     const tp_lattice *l, const double most[2]) {
  const double unit = DBL_EPSILON / 2, n = rows[COUNT], moved = most[0] * most[1] * n;
  const double scale[SUMS] = {1, 3 * most[0], 3 * most[1]};
  const double moves[SUMS] = {16.1 * moved, 73.1 * moved * most[0], 73.1 * moved * most[1]};
  arb_t sum;
  arb_init(sum);
  for (int k = 0; k < SUMS; k++) {
    double bound = (n + 8) * unit * scale[k] * rows[MEASURE];
    if (!tp_lattice_is_exact(l)) bound += unit * moves[k];
    tp_ball_set_bounded(sum, rows[k], 1.01 * bound);
    arb_mul_2exp_si(sum, sum,
                    l->exponent_u * tp_sum_degree[k].x + l->exponent_v * tp_sum_degree[k].y);
    arb_mul_fmpz(sum, sum, weight, ARF_PREC_EXACT);
    arb_add(moments->weighted + k, moments->weighted + k, sum, ARF_PREC_EXACT);
  }
  arb_clear(sum);
}

static bool sum_in_double(tp_moments *moments, const tp_geom_triangulation *t,
                          const tp_section *section, const tp_lattice *l) {
  const size_t parts = (size_t)section->part_count + 1;
  double(*rows)[ROWS] = calloc(parts, sizeof *rows);
  if (rows == NULL) return false;
  for (size_t k = 0; k < t->count; k++) {
    add_in_double(rows[part_of(t->triangles + k, section)], t->triangles[k].corner, l);
  }
  double most[2] = {0, 0};
  for (long k = 0; k < l->start[section->ring_count]; k++) {
    most[0] = fmax(most[0], fabs(l->u[k]));
    most[1] = fmax(most[1], fabs(l->v[k]));
  }
  for (size_t k = 0; k < parts; k++) {
    add_part(moments, rows[k], section->density_weights + k, l, most);
  }
  free(rows);
  return true;
}

typedef struct registers {
  arb_t x[3], y[3], d, t;
} registers;

static void add_ball(tp_moments *moments, registers *r, const size_t c[3], const fmpz *weight,
                     const tp_lattice *l, long bits) {
  for (int k = 0; k < 3; k++) {
    arb_set_round_fmpz(r->x[k], l->x + c[k], bits);
    arb_set_round_fmpz(r->y[k], l->y + c[k], bits);
  }
  arb_zero(r->d);
  for (int k = 0; k < 3; k++) { /* sum of x_k (y_{k+1} - y_{k+2}) */
    arb_sub(r->t, r->y[(k + 1) % 3], r->y[(k + 2) % 3], bits);
    arb_addmul(r->d, r->x[k], r->t, bits);
  }
  arb_mul_fmpz(r->d, r->d, weight, bits);
  arb_add(moments->weighted + TP_A2, moments->weighted + TP_A2, r->d, bits);
  arb_add(r->t, r->x[0], r->x[1], bits);
  arb_add(r->t, r->t, r->x[2], bits);
  arb_addmul(moments->weighted + TP_X6, r->d, r->t, bits);
  arb_add(r->t, r->y[0], r->y[1], bits);
  arb_add(r->t, r->t, r->y[2], bits);
  arb_addmul(moments->weighted + TP_Y6, r->d, r->t, bits);
}

static void sum_in_balls(tp_moments *moments, const tp_geom_triangulation *t,
                         const tp_section *section, const tp_lattice *l, long bits) {
  registers r;
  for (int k = 0; k < 3; k++) {
    arb_init(r.x[k]);
    arb_init(r.y[k]);
  }
  arb_init(r.d);
  arb_init(r.t);
  for (size_t k = 0; k < t->count; k++) {
    const tp_geom_triangle *own = t->triangles + k;
    add_ball(moments, &r, own->corner, section->density_weights + part_of(own, section), l, bits);
  }
  for (int k = 0; k < 3; k++) {
    arb_clear(r.x[k]);
    arb_clear(r.y[k]);
  }
  arb_clear(r.d);
  arb_clear(r.t);
}

bool tp_triangle_sums(tp_moments *moments, const tp_geom_triangulation *t,
                      const tp_section *section, const tp_lattice *lattice, tp_rung rung) {
  for (int k = 0; k < SUMS; k++) arb_zero(moments->weighted + k);
  if (rung.level < TP_LEVEL_BALL) return sum_in_double(moments, t, section, lattice);
  const bool exact = rung.level == TP_LEVEL_EXACT;
  sum_in_balls(moments, t, section, lattice, exact ? ARF_PREC_EXACT : rung.bits);
  return true;
}
