/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Outlines of doubles: every moment against rationals, by fans of triangles, and whether an outline
 * is simple against whole numbers of 128 bits, by trying every edge against every other. */

#include "claim_block.h"
#include "suite.h"

#include "batch/simple.h"

#include <arf.h>
#include <flint/fmpq.h>

/* Is a rational within the error of a number? */
static bool holds(tp_bounded number, const fmpq_t truth) {
  fmpq_t value, error;
  fmpq_init(value);
  fmpq_init(error);
  arf_t exact;
  arf_init(exact);
  arf_set_d(exact, number.value);
  arf_get_fmpq(value, exact);
  arf_set_d(exact, number.error);
  arf_get_fmpq(error, exact);
  arf_clear(exact);
  fmpq_sub(value, value, truth);
  fmpq_abs(value, value);
  const bool within = fmpq_cmp(value, error) <= 0;
  fmpq_clear(value);
  fmpq_clear(error);
  return within;
}

/* Integrals over the fan of triangles from the origin: 1, x, y, x^2, y^2, x y by the closed forms
 * of a triangle with two corners a and b besides. */
typedef struct fan {
  fmpq of[6];
} fan;

static void add_term(fmpq_t sum, const fmpq_t cross, const fmpq_t factor, unsigned long divisor) {
  fmpq_t term;
  fmpz_t d;
  fmpq_init(term);
  fmpz_init_set_ui(d, divisor);
  fmpq_mul(term, cross, factor);
  fmpq_div_fmpz(term, term, d);
  fmpq_add(sum, sum, term);
  fmpq_clear(term);
  fmpz_clear(d);
}

/* (2 a c + 2 b d + a d + b c) / 24 of the corners' coordinates a, b along one axis and c, d along
 * the other: the mean of their product times half, over the triangle with the origin. */
static void add_second(fmpq_t sum, const fmpq_t cross, const fmpq_t a, const fmpq_t b,
                       const fmpq_t c, const fmpq_t d) {
  fmpq_t factor, one, other;
  fmpq_init(factor);
  fmpq_init(one);
  fmpq_init(other);
  fmpq_add(one, c, d);
  fmpq_add(one, one, c);
  fmpq_mul(factor, a, one);
  fmpq_add(other, c, d);
  fmpq_add(other, other, d);
  fmpq_addmul(factor, b, other);
  add_term(sum, cross, factor, 24);
  fmpq_clear(factor);
  fmpq_clear(one);
  fmpq_clear(other);
}

static void set_double(fmpq_t value, double number) {
  arf_t exact;
  arf_init(exact);
  arf_set_d(exact, number);
  arf_get_fmpq(value, exact);
  arf_clear(exact);
}

static void fan_of(fan *f, const double *xy, size_t count) {
  fmpq c[4], cross, one, sum; /* ax, ay, bx, by */
  for (int k = 0; k < 4; k++) fmpq_init(c + k);
  fmpq_init(&cross);
  fmpq_init(&one);
  fmpq_init(&sum);
  fmpq_one(&one);
  for (int k = 0; k < 6; k++) fmpq_init(f->of + k);
  for (size_t k = 0; k < count; k++) {
    const size_t next = k + 1 == count ? 0 : k + 1;
    set_double(c, xy[2 * k]);
    set_double(c + 1, xy[2 * k + 1]);
    set_double(c + 2, xy[2 * next]);
    set_double(c + 3, xy[2 * next + 1]);
    fmpq_mul(&cross, c, c + 3);
    fmpq_submul(&cross, c + 1, c + 2);
    add_term(f->of, &cross, &one, 2);
    fmpq_add(&sum, c, c + 2);
    add_term(f->of + 1, &cross, &sum, 6);
    fmpq_add(&sum, c + 1, c + 3);
    add_term(f->of + 2, &cross, &sum, 6);
    add_second(f->of + 3, &cross, c, c + 2, c, c + 2);
    add_second(f->of + 4, &cross, c + 1, c + 3, c + 1, c + 3);
    add_second(f->of + 5, &cross, c, c + 2, c + 1, c + 3);
  }
  for (int k = 0; k < 4; k++) fmpq_clear(c + k);
  fmpq_clear(&cross);
  fmpq_clear(&one);
  fmpq_clear(&sum);
}

/* From integrals to area, centroid and second moments about it. */
static void finish(fan *f) {
  if (fmpq_sgn(f->of) < 0) {
    for (int k = 0; k < 6; k++) fmpq_neg(f->of + k, f->of + k);
  }
  fmpq_t shift;
  fmpq_init(shift);
  for (int k = 1; k <= 2; k++) fmpq_div(f->of + k, f->of + k, f->of);
  for (int k = 3; k < 6; k++) {
    fmpq_mul(shift, f->of + (k == 4 ? 2 : 1), f->of + (k == 3 ? 1 : 2));
    fmpq_submul(f->of + k, shift, f->of);
  }
  fmpq_clear(shift);
}

static void claim_moments(const random_block *block) {
  tp_area_moments own;
  claim(tp_outline_moments(&own, block->xy, block->count, &claim_message) == TP_OK, "moments");
  fan truth;
  fan_of(&truth, block->xy, block->count);
  finish(&truth);
  const tp_bounded numbers[6] = {own.area,
                                 own.centroid_x,
                                 own.centroid_y,
                                 own.second_moment_xx,
                                 own.second_moment_yy,
                                 own.second_moment_xy};
  for (int k = 0; k < 6; k++) {
    claim(holds(numbers[k], truth.of + k), "a moment is not within its error");
    fmpq_clear(truth.of + k);
  }
  /* the bound is worth something: a thin block has 1e4 times the error of a square one */
  claim(own.area.error <= 1e-9 * own.area.value, "the bound of the area is wide");
  claim(own.second_moment_xx.error <= 1e-7 * own.second_moment_xx.value, "the bound is wide");
}

START_TEST(moments_of_random_blocks) {
  const long blocks = 4 * random_scenes_or(500);
  for (long k = 0; k < blocks; k++) {
    seed = random_seed() + (uint64_t)k;
    random_numbers state = random_numbers_from(seed);
    random_block block;
    draw_block(&block, &state);
    claim_moments(&block);
  }
}
END_TEST

/* Do two edges of whole numbers have a point in common? */
static int side(const polygon *p, long a, long b, long c) {
  const wide cross = (wide)(p->x[b] - p->x[a]) * (p->y[c] - p->y[a]) -
                     (wide)(p->y[b] - p->y[a]) * (p->x[c] - p->x[a]);
  return cross > 0 ? 1 : cross < 0 ? -1 : 0;
}

static bool is_between(const polygon *p, long a, long b, long c) {
  return side(p, a, b, c) == 0 && dot(p, a, c, a, b) >= 0 && dot(p, b, c, b, a) >= 0;
}

static bool meet(const polygon *p, long a, long b) {
  const long a1 = (a + 1) % p->count, b1 = (b + 1) % p->count;
  if (a1 == b) return is_between(p, a, a1, b1) || is_between(p, b, b1, a);
  if (b1 == a) return is_between(p, b, b1, a1) || is_between(p, a, a1, b);
  return (side(p, a, a1, b) * side(p, a, a1, b1) < 0 &&
          side(p, b, b1, a) * side(p, b, b1, a1) < 0) ||
         is_between(p, a, a1, b) || is_between(p, a, a1, b1) || is_between(p, b, b1, a) ||
         is_between(p, b, b1, a1);
}

static bool is_simple(const polygon *p) {
  for (long a = 0; a < p->count; a++) {
    for (long b = a + 1; b < p->count; b++) {
      if (meet(p, a, b)) return false;
    }
  }
  return true;
}

/* Stars of few and close vertices, and some of which two are exchanged. */
START_TEST(simple_outlines) {
  long proven = 0, simple = 0, polygons = 20 * random_scenes_or(500);
  for (long k = 0; k < polygons; k++) {
    seed = random_seed() + (uint64_t)k;
    random_numbers state = random_numbers_from(seed);
    polygon p;
    const long size = draw_once_in(&state, 2) ? 1000000 : 20;
    draw_star(&p, 4 + draw_below(&state, 40), (double)size, (double)size, &state);
    if (draw_once_in(&state, 2)) {
      const long a = draw_below(&state, p.count), b = draw_below(&state, p.count);
      const long x = p.x[a], y = p.y[a];
      p.x[a] = p.x[b];
      p.y[a] = p.y[b];
      p.x[b] = x;
      p.y[b] = y;
    }
    double x[64], y[64];
    for (long j = 0; j <= p.count; j++) {
      x[j] = (double)p.x[j % p.count];
      y[j] = (double)p.y[j % p.count];
    }
    const bool told = tp_is_simple(x, y, p.count), expected = is_simple(&p);
    claim(expected || !told, "taken for simple");
    proven += told;
    simple += expected;
  }
  ck_assert_int_gt(simple, polygons / 4);
  ck_assert_int_lt(simple, polygons * 3 / 4);
  ck_assert_int_eq(proven, simple); /* whole numbers of this size are certain */
}
END_TEST

SUITE(random_outlines) {
  Suite *suite = suite_create("random outlines");
  TCase *tests = tcase_create("outlines");
  tcase_set_timeout(tests, 0);
  tcase_add_test(tests, moments_of_random_blocks);
  tcase_add_test(tests, simple_outlines);
  suite_add_tcase(suite, tests);
  return suite;
}
