/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Moment sums over rings, and the lattice under them, by other routes: triangle formulas, values by
 * hand, conversions of FLINT. An error is compared with its bound in floats of unlimited length. */

#include "block/ring_sums.h"
#include "geom/geom.h"
#include "plane/lattice.h"
#include "random_numbers.h"
#include "suite.h"

#include <math.h>
#include <stdint.h>

enum { MOST = 20000 };
static fmpz px[MOST], py[MOST]; /* initialised, to 0 */
static double pu[MOST], pv[MOST];

static void set_point(long k, long u, long v) {
  fmpz_set_si(px + k, u);
  fmpz_set_si(py + k, v);
  pu[k] = (double)u;
  pv[k] = (double)v;
}

/* Vertices first … first + count - 1 about the centre: angles jump by 0.6 to 1.4 of a full turn
 * over `count`, radii are 0.3 to 1 of the given ones. Simple while rounding is less than a jump. */
static void set_star(long first, long count, double radius_u, double radius_v, const long centre[2],
                     random_numbers *state) {
  for (long k = 0; k < count; k++) {
    const double jitter = 0.4 * draw_part(state);
    const double part = 0.3 + 0.7 * draw_part(state);
    const double angle = 2 * acos(-1) * ((double)k + jitter) / (double)count;
    set_point(first + k, centre[0] + lround(part * radius_u * cos(angle)),
              centre[1] + lround(part * radius_v * sin(angle)));
  }
}

static void clear_all(fmpz *values, long count) {
  for (long k = 0; k < count; k++) fmpz_clear(values + k);
}

/* Add the six sums of a triangle: twice its area times 1, sum x, sum y, sum x_i x_j over i <= j,
 * likewise for y, and sum x sum y + sum x_i y_i. */
static void add_triangle(fmpz sums[TP_SUM_COUNT], const size_t c[3]) {
  fmpz t[TP_SUM_COUNT + 2] = {[TP_A2] = 1}, *det = t + TP_SUM_COUNT, *height = det + 1;
  for (int k = 0; k < 3; k++) {
    fmpz_sub(height, py + c[(k + 1) % 3], py + c[(k + 2) % 3]);
    fmpz_addmul(det, px + c[k], height);
    fmpz_add(t + TP_X6, t + TP_X6, px + c[k]);
    fmpz_add(t + TP_Y6, t + TP_Y6, py + c[k]);
    fmpz_addmul(t + TP_XY24, px + c[k], py + c[k]);
    for (int i = 0; i <= k; i++) {
      fmpz_addmul(t + TP_XX12, px + c[i], px + c[k]);
      fmpz_addmul(t + TP_YY12, py + c[i], py + c[k]);
    }
  }
  fmpz_addmul(t + TP_XY24, t + TP_X6, t + TP_Y6);
  for (int k = 0; k < TP_SUM_COUNT; k++) fmpz_addmul(sums + k, det, t + k);
  clear_all(t, TP_SUM_COUNT + 2);
}

static void check_triangles(const size_t *start, size_t ring_count, bool small) {
  const tp_geom_rings rings = {ring_count, start, pu, pv, px, py, small};
  tp_geom_triangulation t;
  ck_assert_int_eq(tp_geom_triangulate(&t, &rings, (const int[]){0, 1}), TP_GEOM_OK);
  fmpz all[3 * TP_SUM_COUNT] = {0}, *ring = all, *hole = all + 6, *triangles = all + 12;
  for (size_t k = 0; k < t.count; k++) {
    if (t.triangles[k].ring_in_layer[1] == 0) add_triangle(triangles, t.triangles[k].corner);
  }
  tp_geom_triangulation_clear(&t);
  tp_ring_sums_exact(ring, px, py, (long)start[1]);
  const long hole_size = ring_count > 1 ? (long)(start[2] - start[1]) : 0;
  tp_ring_sums_exact(hole, px + start[1], py + start[1], hole_size);
  for (int k = 0; k < TP_SUM_COUNT; k++) {
    fmpz_sub(ring + k, ring + k, hole + k);
    ck_assert_msg(fmpz_equal(ring + k, triangles + k), "%zu vertices, sum %d", start[1], k);
  }
  clear_all(all, 3 * TP_SUM_COUNT);
}

/* Guards the boundary formulas against integrals over triangles that another algorithm found. A
 * star of three or more covers 0.3 cos(1.4 pi / 3) = 0.031 of its radius: a hole of 0.02 fits. */
START_TEST(test_ring_sums_are_sums_over_triangles) {
  random_numbers state = random_numbers_from(1);
  for (int k = 0; k < 200; k++) {
    const size_t n = 3 + draw(&state) % (k < 100 ? 30 : 498), m = 3 + draw(&state) % 60;
    const long centre[2] = {(long)(draw(&state) % 2000000) - 1000000, k % 3 * 500000L};
    const size_t start[3] = {0, n, n + m};
    set_star(0, (long)n, 1e6, 1e6, centre, &state);
    set_star((long)n, (long)m, 2e4, 2e4, centre, &state);
    check_triangles(start, 1 + k / 2 % 2, k % 2 == 0);
  }
}
END_TEST

/* |sum - exact 2^(-exponent degree)| <= bound for all six. Returns the area's relative bound. */
static double check_double(const fmpz *x, const fmpz *y, const double *u, const double *v,
                           long count, tp_degree exponent) {
  const bool whole = exponent.x == 0 && exponent.y == 0;
  fmpz exact[TP_SUM_COUNT] = {0};
  double sums[TP_SUM_COUNT], bounds[TP_SUM_COUNT];
  arf_t error, limit;
  arf_init(error);
  arf_init(limit);
  tp_ring_sums_exact(exact, x, y, count);
  tp_ring_sums_double(sums, bounds, u, v, count, whole);
  const bool tiny = !whole && fabs(u[0]) < 1; /* no bound is promised below one lattice unit */
  for (int k = 0; k < TP_SUM_COUNT; k++) {
    arf_set_fmpz(error, exact + k);
    arf_mul_2exp_si(error, error,
                    -exponent.x * tp_sum_degree[k].x - exponent.y * tp_sum_degree[k].y);
    arf_set_d(limit, sums[k]);
    arf_sub(error, error, limit, ARF_PREC_EXACT, ARF_RND_DOWN);
    arf_set_d(limit, bounds[k]);
    ck_assert_msg(arf_cmpabs(error, limit) <= 0, "sum %d", k);
    ck_assert(isfinite(bounds[k]) != tiny);
  }
  clear_all(exact, TP_SUM_COUNT);
  arf_clear(error);
  arf_clear(limit);
  return bounds[TP_A2] / fabs(sums[TP_A2]);
}

static const long sizes[] = {3, 4, 7, 8, 9, 10, 17, 511, 512, 513, 514, 1025, 1026, 5000, 20000};

/* Guards the proven bound of the double sums on exact coordinates, at the seams of lanes and chunks
 * (8, 512): about the origin, far from it on both axes and on one, slivers of aspect 1e-12 flat
 * and on the diagonal, and a chain that is no polygon. The bound is of use, too: the first star has
 * edges |du| + |dv| <= R and A2 > 0.5 R^2, so 142 w n R^2 / A2 < 4e-11 for a thousand vertices. */
START_TEST(test_double_sums_keep_their_bound) {
  const long far = 1L << 52, centres[4][2] = {{0, 0}, {far, far}, {3, -far}, {7, 0}};
  random_numbers state = random_numbers_from(2 + (uint64_t)_i);
  for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
    const long n = sizes[s];
    set_star(0, n, _i < 3 ? 1e6 : 0x1p50, _i < 3 ? 1e6 : 1e3, centres[_i % 4], &state);
    for (long k = 0; k < n && _i > 3; k++) {
      const long u = _i == 4 ? (long)pu[k] : (long)(draw(&state) >> 12);
      const long v = _i == 4 ? (long)pv[k] : (long)(draw(&state) >> 12);
      set_point(k, u + v, u - v);
    }
    ck_assert(check_double(px, py, pu, pv, n, (tp_degree){0, 0}) < 1e-10 || _i > 0 || n > 1026);
  }
}
END_TEST

/* Guards containment at every precision, and the size of the ball. With R < 2^20 (2^180) the
 * largest coordinate, roundings of 2^(1 - bits), per edge 6 R^2 of the products, 2 R^2 of their
 * difference, 8 R^2 >= A2 of the sum so far: 500 * 32 R^2 2^-bits. The first ring needs 500 * 12
 * R^4 < 2^96: at 128 bits nothing is rounded. */
START_TEST(test_balls_contain_the_truth) {
  random_numbers state = random_numbers_from(3);
  set_star(0, 500, 1e6, 1e6, (const long[]){0, 0}, &state);
  fmpz exact[TP_SUM_COUNT] = {0};
  arb_struct *sums = _arb_vec_init(TP_SUM_COUNT);
  for (int large = 0; large < 2; large++) {
    for (long k = 0; k < 500 && large; k++) fmpz_pow_ui(px + k, px + k, 9);
    for (long k = 0; k < 500 && large; k++) fmpz_pow_ui(py + k, py + k, 9);
    tp_ring_sums_exact(exact, px, py, 500);
    for (long bits = 53; bits <= 256; bits = bits == 53 ? 64 : 2 * bits) {
      tp_ring_sums_ball(sums, px, py, 500, bits);
      for (int k = 0; k < TP_SUM_COUNT; k++) {
        ck_assert_msg(arb_contains_fmpz(sums + k, exact + k), "%ld bits, sum %d", bits, k);
        ck_assert(large || bits < 128 || arb_is_exact(sums + k));
      }
      ck_assert(mag_cmp_2exp_si(arb_radref(sums + TP_A2), (large ? 374 : 54) - bits) <= 0);
    }
  }
  _arb_vec_clear(sums, TP_SUM_COUNT);
  clear_all(exact, TP_SUM_COUNT);
}
END_TEST

static const struct {
  long points[4][2], sums[TP_SUM_COUNT];
} by_hand[] = {
    {{{0, 0}, {12, 0}, {12, 12}, {0, 12}}, {288, 5184, 5184, 82944, 82944, 124416}},
    {{{1, -2}, {4, -2}, {4, 5}, {1, 5}}, {42, 315, 189, 1764, 1596, 1890}},
    {{{0, 0}, {1, 0}, {3, 0}, {0, 6}}, {18, 54, 108, 162, 648, 324}}, /* a triangle */
};

/* Guards sign, order and factor of the sums: integrals by hand of two rectangles and a triangle,
 * also in double, exact here; they change sign with the direction (_i = 1) and not with the start.
 */
START_TEST(test_sums_by_hand) {
  for (int k = 0; k < 3 * 4; k++) {
    for (int i = 0; i < 4; i++) {
      const long *p = by_hand[k / 4].points[(k + (_i == 0 ? i : 4 - i)) % 4];
      set_point(i, p[0], p[1]);
    }
    fmpz exact[TP_SUM_COUNT] = {0};
    double sums[TP_SUM_COUNT], bounds[TP_SUM_COUNT];
    tp_ring_sums_exact(exact, px, py, 4);
    tp_ring_sums_double(sums, bounds, pu, pv, 4, true);
    for (int sum = 0; sum < TP_SUM_COUNT; sum++) {
      const long truth = (_i == 0 ? 1 : -1) * by_hand[k / 4].sums[sum];
      ck_assert_int_eq(fmpz_get_si(exact + sum), truth);
      ck_assert_double_eq(sums[sum], (double)truth);
    }
    clear_all(exact, TP_SUM_COUNT);
  }
}
END_TEST

enum { HUGES, EXACT, SLIVER, THREAD, TINY, FAR_OFF, TIES, SCENES };
/* Powers of ten times x, y and the denominator; power of two times the first chain. */
static const unsigned long scenes[SCENES][4] = {{53, 53, 0, 0}, {0, 0, 0, 0},  {55, 0, 0, 0},
                                                {300, 0, 0, 0}, {0, 0, 70, 0}, {43, 43, 0, 200},
                                                {0, 0, 0, 200}};
static const fmpq foot = {381, 1250}; /* in metres */

/* A scaled coordinate of the star, or an integer half way between two doubles or next to that. */
static void draw_value(fmpq_t value, const fmpz_t star, int scene, int axis,
                       random_numbers *state) {
  fmpz *top = fmpq_numref(value), *below = fmpq_denref(value);
  if (scene == TIES) {
    fmpz_set_ui(top, draw(state) >> 11 << 1 | UINT64_C(1) << 53 | 1);
    fmpz_mul_2exp(top, top, draw(state) % 140);
    fmpz_add_si(top, top, (long)(draw(state) % 3) - 1);
    if (draw(state) % 2 == 0) fmpz_neg(top, top);
  } else {
    fmpz_ui_pow_ui(top, 10, scenes[scene][axis]);
    fmpz_mul(top, top, star);
    fmpz_ui_pow_ui(below, 10, scenes[scene][2]);
    fmpz_mul_ui(below, below, 1 + draw(state) % 12);
  }
  fmpq_canonicalise(value);
}

static void check_coordinate(double u, const fmpz_t x, long exponent, fmpq_t metres,
                             const fmpq_t written) {
  arf_t truth;
  arf_init(truth);
  arf_set_fmpz(truth, x);
  arf_mul_2exp_si(truth, truth, -exponent);
  ck_assert_double_eq(u, arf_get_d(truth, ARF_RND_NEAR));
  fmpq_div(metres, metres, &foot);
  ck_assert(fmpq_equal(metres, written));
  arf_clear(truth);
}

/* The first chain, which centres the lattice: about 0, or 4 * 2^200; the second is the scene. */
static void draw_lines(tp_polyline lines[2], int scene, random_numbers *state) {
  for (long k = 0; k < 2002; k++) {
    fmpq x = {(scene == FAR_OFF ? 4 : 0) + 2 * k - 1, 1}, y = {0, 1};
    fmpq_mul_2exp(&x, &x, scenes[scene][3]);
    fmpq_set(&y, &x);
    if (k > 1) draw_value(&x, px + k, scene, 0, state);
    if (k > 1) draw_value(&y, py + k, scene, 1, state);
    ck_assert(tp_polyline_append(lines + (k > 1), &x, &y, (tp_mark){0}));
    fmpq_clear(&x);
    fmpq_clear(&y);
  }
}

/* Guards the lattice: metres come back exactly, doubles are what FLINT rounds to nearest, and sums
 * of rounded coordinates keep the bound that counts the rounding; for huge coordinates, small ones,
 * slivers of aspect 1e-55 and 1e-300, tiny ones, a ring far off the centre of the lattice, and
 * ties. */
START_TEST(test_lattice_rounds_as_it_says) {
  random_numbers state = random_numbers_from(4);
  tp_polyline lines[2] = {0};
  tp_lattice lattice;
  fmpq metres = {0, 1};
  set_star(2, 2000, 1e6, 1e6, (const long[]){5, 7}, &state);
  draw_lines(lines, _i, &state);
  const tp_polyline *const chains[2] = {lines, lines + 1};
  ck_assert_int_eq(tp_lattice_init(&lattice, chains, 2, &foot, NULL), TP_OK);
  const tp_degree exponent = {(int)lattice.exponent_u, (int)lattice.exponent_v};
  ck_assert_int_eq(tp_lattice_is_exact(&lattice), _i == EXACT);
  for (long k = 2; k < lattice.count; k++) {
    tp_lattice_metres_x(&metres, &lattice, lattice.x + k);
    check_coordinate(lattice.u[k], lattice.x + k, exponent.x, &metres, lines[1].x + k - 2);
    tp_lattice_metres_y(&metres, &lattice, lattice.y + k);
    check_coordinate(lattice.v[k], lattice.y + k, exponent.y, &metres, lines[1].y + k - 2);
  }
  check_double(lattice.x + 2, lattice.y + 2, lattice.u + 2, lattice.v + 2, 2000, exponent);
  tp_lattice_clear(&lattice);
  tp_polyline_clear(lines);
  tp_polyline_clear(lines + 1);
  fmpq_clear(&metres);
}
END_TEST

SUITE(sums) {
  Suite *suite = suite_create("sums");
  TCase *cases = tcase_create("sums");
  tcase_set_timeout(cases, 60);
  tcase_add_test(cases, test_ring_sums_are_sums_over_triangles);
  tcase_add_loop_test(cases, test_double_sums_keep_their_bound, 0, 6);
  tcase_add_test(cases, test_balls_contain_the_truth);
  tcase_add_loop_test(cases, test_sums_by_hand, 0, 2);
  tcase_add_loop_test(cases, test_lattice_rounds_as_it_says, 0, SCENES);
  suite_add_tcase(suite, cases);
  return suite;
}
