/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The mean plane of a chain against the conditions that make a straight line the best one: with a
 * along the line between both ends and b normal to it, what the residual r = b - m a - c adds up to
 * over the chain, and what r a does, is zero. The integrals, of polynomials of degree 2 at most,
 * are taken by Simpson's rule, in rationals. */

#include "base/mean_plane.h"
#include "exact_vectors.h"
#include "random_numbers.h"
#include "suite.h"

enum { ROUNDS = 3000, MOST = 9 };

static random_numbers state;

/* sums += |a1 - a0| of 1, a, b, a a, a b over a segment from (a0, b0) to (a1, b1); times 6. */
static void add_segment(fmpq sums[5], const exact_point *p, const exact_point *q) {
  fmpq_t length, a, b, part;
  fmpq_init(length);
  fmpq_init(a);
  fmpq_init(b);
  fmpq_init(part);
  fmpq_sub(length, &q->x, &p->x);
  fmpq_abs(length, length);
  for (int k = 0; k < 3; k++) {
    fmpq_mul_si(a, &p->x, 2 - k);
    fmpq_mul_si(part, &q->x, k);
    fmpq_add(a, a, part);
    fmpq_div_2exp(a, a, 1);
    fmpq_mul_si(b, &p->y, 2 - k);
    fmpq_mul_si(part, &q->y, k);
    fmpq_add(b, b, part);
    fmpq_div_2exp(b, b, 1);
    fmpq_mul_si(part, length, k == 1 ? 4 : 1);
    fmpq_add(sums, sums, part);
    fmpq_addmul(sums + 1, part, a);
    fmpq_addmul(sums + 2, part, b);
    fmpq_mul(part, part, a);
    fmpq_addmul(sums + 3, part, a);
    fmpq_addmul(sums + 4, part, b);
  }
  fmpq_clear(length);
  fmpq_clear(a);
  fmpq_clear(b);
  fmpq_clear(part);
}

/* (along . p, along x p) of a point. */
static void turn_into(exact_point *own, const exact_point *along, const fmpq_t x, const fmpq_t y) {
  fmpq_mul(&own->x, &along->x, x);
  fmpq_addmul(&own->x, &along->y, y);
  exact_cross(&own->y, &along->x, y, &along->y, x);
}

/* Of the line with the slope m that runs through the mean point: S_ab - S_a S_b / L = m (S_aa -
 * S_a^2 / L), times L. */
static void check_direction(const fmpq_t u, const fmpq_t v, const exact_point *along,
                            const fmpq sums[5]) {
  exact_point own;
  fmpq_t left, right;
  exact_point_init(&own);
  fmpq_init(left);
  fmpq_init(right);
  turn_into(&own, along, u, v);
  ck_assert_int_gt(fmpq_sgn(&own.x), 0); /* from left to right along the chain */
  exact_cross(left, sums + 4, sums, sums + 1, sums + 2);
  fmpq_mul(left, left, &own.x);
  exact_cross(right, sums + 3, sums, sums + 1, sums + 1);
  fmpq_mul(right, right, &own.y);
  ck_assert(fmpq_equal(left, right));
  exact_point_clear(&own);
  fmpq_clear(left);
  fmpq_clear(right);
}

static void draw_chain(tp_polyline *line) {
  const long count = 2 + draw_below(&state, MOST - 1);
  for (long k = 0; k < count; k++) {
    exact_point p;
    exact_point_init(&p);
    fmpq_set_si(&p.x, draw_below(&state, 30), 1 + (ulong)draw_below(&state, 4));
    fmpq_set_si(&p.y, draw_below(&state, 20), 1 + (ulong)draw_below(&state, 4));
    ck_assert(tp_polyline_append(line, &p.x, &p.y, (tp_mark){0}));
    exact_point_clear(&p);
  }
}

/* Chains of any form, also ones that run back; none where both ends are one point. */
START_TEST(no_line_is_nearer_to_the_chain) {
  state = random_numbers_from(81);
  for (int round = 0; round < ROUNDS; round++) {
    tp_polyline line = {0};
    exact_point along, p, q;
    fmpq sums[5];
    fmpq_t u, v;
    exact_point_init(&along);
    exact_point_init(&p);
    exact_point_init(&q);
    for (int k = 0; k < 5; k++) fmpq_init(sums + k);
    fmpq_init(u);
    fmpq_init(v);
    draw_chain(&line);
    const long last = line.count - 1;
    fmpq_sub(&along.x, line.x + last, line.x);
    fmpq_sub(&along.y, line.y + last, line.y);
    const bool closed = fmpq_is_zero(&along.x) && fmpq_is_zero(&along.y);
    ck_assert_int_eq(tp_mean_plane_of_outline(u, v, &line, 0, last), !closed);
    for (long k = 0; k < last && !closed; k++) {
      turn_into(&p, &along, line.x + k, line.y + k);
      turn_into(&q, &along, line.x + k + 1, line.y + k + 1);
      add_segment(sums, &p, &q);
    }
    if (!closed) check_direction(u, v, &along, sums);
    fmpq_clear(u);
    fmpq_clear(v);
    for (int k = 0; k < 5; k++) fmpq_clear(sums + k);
    exact_point_clear(&along);
    exact_point_clear(&p);
    exact_point_clear(&q);
    tp_polyline_clear(&line);
  }
}
END_TEST

SUITE(mean_plane) {
  Suite *suite = suite_create("mean_plane");
  TCase *cases = tcase_create("mean_plane");
  tcase_set_timeout(cases, 60);
  tcase_add_test(cases, no_line_is_nearer_to_the_chain);
  suite_add_tcase(suite, cases);
  return suite;
}
