/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Samples that are spread evenly: every stratum of a Latin hypercube hit once, by permutations that
 * are all equally likely; Sobol' points as GSL has them, and shifted so that they still hit all
 * strata. */

#include "draws_stage.h"
#include "sampling/permutation.h"
#include "sampling/sobol_points.h"
#include "suite.h"

#include <gsl/gsl_qrng.h>
#include <inttypes.h>
#include <math.h>
#include <string.h>

START_TEST(every_stratum_once) {
  static const uint64_t counts[] = {1, 2, 3, 4, 5, 7, 8, 9, 31, 64, 100, 1000, 65536, 100003};
  enum { DIMENSIONS = 2, MOST = 100003 };
  static bool hit[MOST];
  for (size_t k = 0; k < sizeof counts / sizeof counts[0]; k++) {
    const tp_draws draws = {TP_DRAW_LATIN_HYPERCUBE, 1, counts[k], 1, DIMENSIONS, NULL};
    for (size_t dimension = 0; dimension < DIMENSIONS; dimension++) {
      tp_draws_walk *walk = begun(&draws, 0);
      memset(hit, 0, sizeof hit);
      for (uint64_t j = 0; j < counts[k]; j++) {
        double u[DIMENSIONS];
        tp_draws_next(walk, u);
        const size_t stratum = (size_t)(u[dimension] * (double)counts[k]);
        if (stratum >= counts[k] || hit[stratum]) ck_abort_msg("stratum %zu", stratum);
        hit[stratum] = true;
      }
      tp_draws_end(walk);
    }
  }
}
END_TEST

/* Over many keys each of the 24 orders of four things comes as often as the others: chi^2 of 23
 * degrees of freedom is beyond 49.7 once in 1000. And the largest plan begins and ends within (0,
 * 1).
 */
START_TEST(permutations) {
  enum { KEYS = 24000, THINGS = 4 };
  int counts[256] = {0};
  for (uint64_t key = 0; key < KEYS; key++) {
    const tp_permutation p = tp_permutation_of(THINGS, key * UINT64_C(0x9e3779b97f4a7c15));
    unsigned order = 0;
    for (uint64_t k = 0; k < THINGS; k++) order |= (unsigned)tp_permutation_at(&p, k) << (2 * k);
    counts[order]++;
  }
  double chi = 0;
  int orders = 0;
  for (size_t k = 0; k < 256; k++) {
    if (counts[k] > 0) orders++;
    if (counts[k] > 0) chi += pow(counts[k] - KEYS / 24.0, 2) / (KEYS / 24.0);
  }
  ck_assert_int_eq(orders, 24);
  ck_assert_msg(chi < 49.7, "chi^2 %g", chi);
  const tp_draws draws = {TP_DRAW_LATIN_HYPERCUBE, 1, TP_DRAWS_SAMPLES, 1, 1, NULL};
  tp_draws_walk *walk = begun(&draws, TP_DRAWS_SAMPLES - 500);
  for (size_t k = 0; k < 1000; k++) {
    double u;
    tp_draws_next(walk, &u);
    ck_assert(u > 0 && u < 1);
  }
  tp_draws_end(walk);
}
END_TEST

/* GSL leaves out the origin, and has 30 places. */
START_TEST(sobol_points_of_gsl) {
  enum { POINTS = 1 << 14, PLACES = 30 };
  gsl_qrng *points = gsl_qrng_alloc(gsl_qrng_sobol, TP_SOBOL_DIMENSIONS);
  uint64_t directions[TP_SOBOL_DIMENSIONS][TP_SOBOL_BITS];
  for (size_t d = 0; d < TP_SOBOL_DIMENSIONS; d++) {
    tp_sobol_directions(directions[d], d);
    ck_assert_uint_eq(tp_sobol_coordinate(directions[d], 0), 0);
  }
  for (uint64_t k = 1; k < POINTS; k++) {
    double u[TP_SOBOL_DIMENSIONS];
    gsl_qrng_get(points, u);
    for (size_t d = 0; d < TP_SOBOL_DIMENSIONS; d++) {
      const uint64_t own = tp_sobol_coordinate(directions[d], k);
      const uint64_t stepped =
          tp_sobol_coordinate(directions[d], k - 1) ^ directions[d][tp_sobol_step(k - 1)];
      if (own >> (TP_SOBOL_BITS - PLACES) == (uint64_t)ldexp(u[d], PLACES) && own == stepped) {
        continue;
      }
      ck_abort_msg("coordinate %zu of point %" PRIu64, d, k);
    }
  }
  gsl_qrng_free(points);
  for (size_t d = 0; d < TP_SOBOL_DIMENSIONS; d++) { /* a triangle with ones: all strata are hit */
    for (unsigned i = 0; i < TP_SOBOL_BITS; i++) {
      ck_assert_uint_eq(directions[d][i] & ((UINT64_C(1) << (TP_SOBOL_BITS - i)) - 1),
                        UINT64_C(1) << (TP_SOBOL_BITS - 1 - i));
    }
  }
}
END_TEST

/* 0, 1/2, 3/4, 1/4 in the first dimension and 0, 1/2, 1/4, 3/4 in the second; a shift moves the
 * digits of all points alike, several shifts take turns. */
START_TEST(shifted_points) {
  enum { POINTS = 64, SHIFTS = 3, DIMENSIONS = 5 };
  static const uint64_t first[] = {0, 2, 3, 1}, second[] = {0, 2, 1, 3};
  const tp_draws draws = {TP_DRAW_SOBOL, 9, POINTS * SHIFTS, SHIFTS, DIMENSIONS, NULL};
  double u[POINTS][SHIFTS][DIMENSIONS];
  tp_draws_walk *walk = begun(&draws, 0);
  for (size_t k = 0; k < POINTS * SHIFTS; k++) tp_draws_next(walk, u[k / SHIFTS][k % SHIFTS]);
  tp_draws_end(walk);
  for (size_t shift = 0; shift < SHIFTS; shift++) {
    for (size_t k = 0; k < 4; k++) {
      const uint64_t x = (uint64_t)(4 * u[0][shift][0]), y = (uint64_t)(4 * u[0][shift][1]);
      ck_assert_uint_eq((uint64_t)(4 * u[k][shift][0]), x ^ first[k]);
      ck_assert_uint_eq((uint64_t)(4 * u[k][shift][1]), y ^ second[k]);
    }
    for (size_t dimension = 0; dimension < DIMENSIONS; dimension++) {
      bool hit[POINTS] = {false};
      for (size_t k = 0; k < POINTS; k++) hit[(size_t)(POINTS * u[k][shift][dimension])] = true;
      for (size_t k = 0; k < POINTS; k++) ck_assert(hit[k]);
      ck_assert(shift == 0 || u[0][shift][dimension] != u[0][0][dimension]);
    }
  }
}
END_TEST

SUITE(draws_strata) {
  TCase *tests = tcase_create("draws_strata");
  tcase_set_timeout(tests, 120);
  tcase_add_test(tests, every_stratum_once);
  tcase_add_test(tests, permutations);
  tcase_add_test(tests, sobol_points_of_gsl);
  tcase_add_test(tests, shifted_points);
  Suite *suite = suite_create("draws_strata");
  suite_add_tcase(suite, tests);
  return suite;
}
