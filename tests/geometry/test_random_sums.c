/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Moment sums of a million random polygons: against a fan of triangles in integers of 128 bits, at
 * every price, and as the polygon is moved, turned, mirrored, scaled, renumbered and split. */

#include "block/ring_sums.h"
#include "random_sums.h"
#include "suite.h"

#include <math.h>

enum { POLYGONS_A_SCENE = 1024 };

static uint64_t seed; /* of the polygon in hand */
static double u[POLYGON_MOST], v[POLYGON_MOST];
static fmpz exact_x[POLYGON_MOST], exact_y[POLYGON_MOST]; /* small: no memory */

static void set_coordinates(const polygon *p) {
  for (long k = 0; k < p->count; k++) {
    u[k] = (double)p->x[k];
    v[k] = (double)p->y[k];
    fmpz_set_si(exact_x + k, p->x[k]);
    fmpz_set_si(exact_y + k, p->y[k]);
  }
}

/* Check writes to a file for each assertion that holds; of a hundred million only those that fail
 * are told. */
static void claim(bool condition, const char *what, int sum) {
  if (!condition) ck_abort_msg("%s, sum %d: TOPPLE_RANDOM_SEED=%lu", what, sum, (ulong)seed);
}

/* The double sums of integers are integers; so the distance from the truth is one, too, and
 * compares with the whole part of the bound. */
static void claim_double(const sums *truth, const char *what, long count) {
  double values[TP_SUM_COUNT], bounds[TP_SUM_COUNT];
  tp_ring_sums_double(values, bounds, u, v, count, true);
  for (int k = 0; k < TP_SUM_COUNT; k++) {
    const wide error = (wide)values[k] - truth->of[k];
    claim((error < 0 ? -error : error) <= (wide)floor(bounds[k]), what, k);
  }
}

/* The same in pairs of doubles, which are integers as well. Their bound is no larger, but where all
 * vertices are one point: doubles know it for exact, and pairs do not look. */
static void claim_pairs(const sums *truth, const char *what, long count) {
  tp_double_pair values[TP_SUM_COUNT];
  double bounds[TP_SUM_COUNT], single[TP_SUM_COUNT], single_bounds[TP_SUM_COUNT];
  tp_ring_sums_double(single, single_bounds, u, v, count, true);
  tp_ring_sums_compensated(values, bounds, u, v, count);
  for (int k = 0; k < TP_SUM_COUNT; k++) {
    const wide error = (wide)values[k].high + (wide)values[k].low - truth->of[k];
    claim((error < 0 ? -error : error) <= (wide)floor(bounds[k]), what, k);
    claim(bounds[k] <= single_bounds[k] || single_bounds[k] == 0, "pairs are no worse", k);
  }
}

static void claim_exact(const sums *truth, const char *what, long count) {
  fmpz values[TP_SUM_COUNT] = {0};
  fmpz_t expected;
  fmpz_init(expected);
  tp_ring_sums_exact(values, exact_x, exact_y, count);
  for (int k = 0; k < TP_SUM_COUNT; k++) {
    fmpz_set_wide(expected, truth->of[k]);
    claim(fmpz_equal(values + k, expected), what, k);
    fmpz_clear(values + k);
  }
  fmpz_clear(expected);
}

static void claim_sums(const polygon *p, const sums *truth, const char *what) {
  set_coordinates(p);
  claim_exact(truth, what, p->count);
  claim_double(truth, what, p->count);
  claim_pairs(truth, what, p->count);
}

/* Balls of more bits contain the truth and are no wider. The radius at b bits lies between 2^-b
 * times the least and a few n 2^-b times the largest of what is rounded. */
static void claim_balls(const sums *truth, long count) {
  static const long bits[] = {53, 64, 128, 256, 512};
  arb_struct *values = _arb_vec_init(2L * TP_SUM_COUNT), *before = values + TP_SUM_COUNT;
  fmpz_t expected;
  fmpz_init(expected);
  for (size_t b = 0; b < sizeof bits / sizeof *bits; b++) {
    tp_ring_sums_ball(values, exact_x, exact_y, count, bits[b]);
    for (int k = 0; k < TP_SUM_COUNT; k++) {
      fmpz_set_wide(expected, truth->of[k]);
      claim(arb_contains_fmpz(values + k, expected), "balls contain the truth", k);
      claim(b == 0 || mag_cmp(arb_radref(values + k), arb_radref(before + k)) <= 0,
            "balls do not grow with their bits", k);
      claim(b < 3 || arb_is_exact(values + k), "256 bits round nothing", k);
      arb_set(before + k, values + k);
    }
  }
  fmpz_clear(expected);
  _arb_vec_clear(values, 2L * TP_SUM_COUNT);
}

/* Times 2^k and the like, to powers that leave the range of doubles far off: the same bits. */
static void claim_powers_of_two(long count, random_numbers *state) {
  double plain[2][TP_SUM_COUNT], scaled[2][TP_SUM_COUNT];
  const int power_u = (int)draw_signed(state, 100), power_v = (int)draw_signed(state, 100);
  tp_ring_sums_double(plain[0], plain[1], u, v, count, true);
  for (long k = 0; k < count; k++) {
    u[k] = ldexp(u[k], power_u);
    v[k] = ldexp(v[k], power_v);
  }
  tp_ring_sums_double(scaled[0], scaled[1], u, v, count, true);
  for (int k = 0; k < TP_SUM_COUNT; k++) {
    const int power = power_u * tp_sum_degree[k].x + power_v * tp_sum_degree[k].y;
    claim(scaled[0][k] == ldexp(plain[0][k], power), "powers of two scale sums", k);
    claim(scaled[1][k] == ldexp(plain[1][k], power), "powers of two scale bounds", k);
  }
}

/* What becomes of the sums of an outline x' = a x - b y + p, y' = c x + d y + q; by expansion of
 * the integrals, each times the determinant. */
typedef struct change {
  wide a, b, c, d, p, q;
} change;

static sums change_sums(const sums *s, const change *t) {
  const wide det = t->a * t->d - t->b * t->c;
  const wide area = s->of[TP_A2], x = s->of[TP_X6], y = s->of[TP_Y6];
  const wide xx = s->of[TP_XX12], yy = s->of[TP_YY12], xy = s->of[TP_XY24];
  const wide new_x = t->a * x + t->b * y, new_y = t->c * x + t->d * y; /* before the move */
  sums r;
  r.of[TP_A2] = det * area;
  r.of[TP_X6] = det * (new_x + 3 * t->p * area);
  r.of[TP_Y6] = det * (new_y + 3 * t->q * area);
  r.of[TP_XX12] = det * (t->a * t->a * xx + t->a * t->b * xy + t->b * t->b * yy + 4 * t->p * new_x +
                         6 * t->p * t->p * area);
  r.of[TP_YY12] = det * (t->c * t->c * xx + t->c * t->d * xy + t->d * t->d * yy + 4 * t->q * new_y +
                         6 * t->q * t->q * area);
  r.of[TP_XY24] =
      det * (2 * t->a * t->c * xx + (t->a * t->d + t->b * t->c) * xy + 2 * t->b * t->d * yy +
             4 * (t->p * new_y + t->q * new_x) + 12 * t->p * t->q * area);
  return r;
}

static void change_polygon(polygon *p, const change *t) {
  for (long k = 0; k < p->count; k++) {
    const wide x = p->x[k], y = p->y[k];
    p->x[k] = (long)(t->a * x + t->b * y + t->p);
    p->y[k] = (long)(t->c * x + t->d * y + t->q);
  }
}

/* A turn by a Pythagorean angle, a mirror, ten times the unit, a move; or some of them together. */
static change draw_change(random_numbers *state) {
  static const long triples[][2] = {{3, 4}, {5, 12}, {8, 15}, {7, 24}, {20, 21}, {0, 1}};
  change t = {1, 0, 0, 1, 0, 0};
  const long kinds = 1 + draw_below(state, 15);
  if ((kinds & 1) != 0) {
    const long *leg = triples[draw_below(state, 6)];
    t = (change){leg[0], -leg[1], leg[1], leg[0], 0, 0};
  }
  if ((kinds & 2) != 0) t = (change){-t.a, -t.b, t.c, t.d, 0, 0};
  if ((kinds & 4) != 0 && (kinds & 1) == 0) t = (change){10 * t.a, 0, 0, 10 * t.d, 0, 0};
  if ((kinds & 8) != 0) {
    t.p = draw_signed(state, 1L << (1 + draw_below(state, 26)));
    t.q = draw_signed(state, 1L << (1 + draw_below(state, 26)));
  }
  return t;
}

static void claim_changed(const polygon *p, const sums *truth, random_numbers *state) {
  polygon changed = *p;
  const change t = draw_change(state);
  change_polygon(&changed, &t);
  const sums expected = change_sums(truth, &t);
  claim_sums(&changed, &expected, "moved, turned, mirrored, scaled");
}

/* From another vertex, and the other way about. */
static void claim_renumbered(const polygon *p, const sums *truth, random_numbers *state) {
  polygon changed = {.count = 0};
  sums expected = *truth;
  const long first = draw_below(state, p->count), way = draw_once_in(state, 2) ? 1 : p->count - 1;
  for (long k = 0; k < p->count; k++) {
    polygon_add(&changed, p->x[(first + way * k) % p->count], p->y[(first + way * k) % p->count]);
  }
  for (int k = 0; k < TP_SUM_COUNT && way > 1; k++) expected.of[k] = -expected.of[k];
  claim_sums(&changed, &expected, "renumbered");
}

/* Twice as large, with the middles of some edges as vertices. */
static void claim_collinear(const polygon *p, const sums *truth, random_numbers *state) {
  polygon changed = {.count = 0};
  for (long k = 0; k < p->count; k++) {
    const long next = (k + 1) % p->count;
    polygon_add(&changed, 2 * p->x[k], 2 * p->y[k]);
    if (draw_once_in(state, 2)) polygon_add(&changed, p->x[k] + p->x[next], p->y[k] + p->y[next]);
  }
  const change twice = {2, 0, 0, 2, 0, 0};
  const sums expected = change_sums(truth, &twice);
  claim_sums(&changed, &expected, "with vertices on its edges");
}

/* Along a diagonal: what the two pieces have adds up to the whole, exactly, and in double within
 * the sum of their bounds. A diagonal may lie outside: its two edges cancel all the same. */
static void claim_split(const polygon *p, const sums *truth, random_numbers *state) {
  const long from = draw_below(state, p->count), length = 2 + draw_below(state, p->count - 2);
  double values[TP_SUM_COUNT], bounds[TP_SUM_COUNT], room[TP_SUM_COUNT] = {0};
  wide total[TP_SUM_COUNT] = {0};
  for (int piece = 0; piece < 2; piece++) {
    polygon own = {.count = 0};
    const long vertices = piece == 0 ? length + 1 : p->count - length + 1;
    for (long k = 0; k < vertices; k++) {
      const long at = (from + (piece == 0 ? k : length + k)) % p->count;
      polygon_add(&own, p->x[at], p->y[at]);
    }
    const sums truth_of_piece = polygon_sums(&own);
    claim_sums(&own, &truth_of_piece, "a piece");
    tp_ring_sums_double(values, bounds, u, v, own.count, true);
    for (int k = 0; k < TP_SUM_COUNT; k++) {
      total[k] += (wide)values[k];
      room[k] += floor(bounds[k]);
    }
  }
  for (int k = 0; k < TP_SUM_COUNT; k++) {
    const wide error = total[k] - truth->of[k];
    claim((error < 0 ? -error : error) <= (wide)room[k], "two pieces", k);
  }
}

/* Guards all prices of the sums against a second route, and the second route's laws. */
START_TEST(test_sums_of_random_polygons) {
  const uint64_t first = random_seed();
  const long count = random_scenes() * POLYGONS_A_SCENE;
  for (long k = 0; k < count; k++) {
    seed = first + (uint64_t)k;
    random_numbers state = random_numbers_from(seed);
    polygon p;
    draw_polygon(&p, &state);
    const sums truth = polygon_sums(&p);
    claim_sums(&p, &truth, "as drawn");
    if (draw_once_in(&state, 16)) claim_balls(&truth, p.count);
    claim_powers_of_two(p.count, &state);
    static void (*const claims[])(const polygon *, const sums *, random_numbers *) = {
        claim_changed, claim_changed, claim_renumbered, claim_collinear, claim_split};
    claims[draw_below(&state, 5)](&p, &truth, &state);
  }
}
END_TEST

SUITE(random_sums) {
  Suite *suite = suite_create("random sums");
  TCase *cases = tcase_create("random sums");
  tcase_set_timeout(cases, 0);
  tcase_add_test(cases, test_sums_of_random_polygons);
  suite_add_tcase(suite, cases);
  return suite;
}
