/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The fast boundary sums: the same bits by every instruction set of this machine and any number of
 * threads, and the bound of the compensated ones against exact integers. */

#include "block/ring_sums.h"
#include "random_numbers.h"
#include "suite.h"

#include <math.h>
#include <pthread.h>
#include <string.h>

enum { BLOCK = 1 << 18, MOST = 5 * BLOCK + 3 };
static double pu[MOST], pv[MOST];

/* Both forms of the sums, and how a plan asks for them. */
typedef struct results {
  double sums[TP_SUM_COUNT], bounds[TP_SUM_COUNT];
  tp_double_pair pairs[TP_SUM_COUNT];
  double pair_bounds[TP_SUM_COUNT];
} results;

static results results_of(long count, tp_sums_plan plan) {
  results r;
  memset(&r, 0, sizeof r);
  tp_ring_sums_double_first(r.sums, r.bounds, pu, pv, count, true, plan);
  tp_ring_sums_compensated_first(r.pairs, r.pair_bounds, pu, pv, count, plan);
  return r;
}

/* Bit for bit; of the first `sum_count`. */
static void check_same(const results *a, const results *b, int sum_count, const char *what,
                       long count) {
  const size_t n = (size_t)sum_count;
  ck_assert_msg(memcmp(a->sums, b->sums, n * sizeof *a->sums) == 0 &&
                    memcmp(a->bounds, b->bounds, n * sizeof *a->bounds) == 0,
                "double, %s, %ld vertices", what, count);
  ck_assert_msg(memcmp(a->pairs, b->pairs, n * sizeof *a->pairs) == 0 &&
                    memcmp(a->pair_bounds, b->pair_bounds, n * sizeof *a->pair_bounds) == 0,
                "pairs, %s, %ld vertices", what, count);
}

/* A chain of integers of magnitude up to 2^bits, no polygon: the sums do not ask for one. */
static void set_chain(long count, int bits, random_numbers *state) {
  for (long k = 0; k < count; k++) {
    pu[k] = (double)((long)(draw(state) >> (63 - bits)) - (1L << bits));
    pv[k] = (double)((long)(draw(state) >> (63 - bits)) - (1L << bits));
  }
}

/* Guards the promise of the same bits on every machine: whatever instruction sets this one has
 * agree with the plainest, for every rest of eight lanes and around chunks, and the first three
 * sums of six are the three. Coordinates up to 2^53: nothing is exact by chance. */
START_TEST(test_every_instruction_set_gives_the_same_bits) {
  static const long seams[] = {63, 64, 65, 511, 512, 513, 514, 1024, 1025, 5003, BLOCK + 9};
  random_numbers state = random_numbers_from(11 + (uint64_t)_i);
  const long seam_count = sizeof seams / sizeof *seams;
  for (long s = 0; s <= 40 + seam_count; s++) {
    const long count = s <= 40 ? s : seams[s - 41];
    set_chain(count, _i == 0 ? 53 : 20, &state);
    const results plain =
        results_of(count, (tp_sums_plan){TP_SUM_COUNT, TP_INSTRUCTIONS_BASELINE, 1});
    for (int set = TP_INSTRUCTIONS_BEST; set < TP_INSTRUCTIONS_COUNT; set++) {
      if (set != TP_INSTRUCTIONS_BEST && !tp_instructions_present(set)) continue;
      const results six = results_of(count, (tp_sums_plan){TP_SUM_COUNT, set, 1});
      const results three = results_of(count, (tp_sums_plan){TP_AREA_SUM_COUNT, set, 1});
      check_same(&plain, &six, TP_SUM_COUNT, "six sums", count);
      check_same(&plain, &three, TP_AREA_SUM_COUNT, "three sums", count);
    }
  }
}
END_TEST

/* Guards the same promise for threads, with blocks that fill their last one, and one edge more. */
START_TEST(test_any_number_of_threads_gives_the_same_bits) {
  static const long counts[] = {BLOCK, BLOCK + 1, 3 * BLOCK, 4 * BLOCK + 1, MOST};
  static const int threads[] = {0, 2, 3, 7, 16};
  random_numbers state = random_numbers_from(12);
  set_chain(MOST, 53, &state);
  for (size_t c = 0; c < sizeof counts / sizeof *counts; c++) {
    const results one =
        results_of(counts[c], (tp_sums_plan){.sum_count = TP_SUM_COUNT, .threads = 1});
    for (size_t t = 0; t < sizeof threads / sizeof *threads; t++) {
      const tp_sums_plan plan = {.sum_count = TP_SUM_COUNT, .threads = threads[t]};
      const results many = results_of(counts[c], plan);
      check_same(&one, &many, TP_SUM_COUNT, "threads", counts[c]);
    }
  }
}
END_TEST

static void *call(void *result) {
  *(results *)result =
      results_of(MOST, (tp_sums_plan){.sum_count = TP_AREA_SUM_COUNT, .threads = 2});
  return NULL;
}

/* Guards calls from several threads of a user at once: no state is shared. */
START_TEST(test_callers_do_not_disturb_each_other) {
  enum { CALLERS = 3 };
  static results got[CALLERS];
  pthread_t callers[CALLERS];
  random_numbers state = random_numbers_from(13);
  set_chain(MOST, 40, &state);
  for (int k = 0; k < CALLERS; k++) {
    ck_assert_int_eq(pthread_create(callers + k, NULL, call, got + k), 0);
  }
  for (int k = 0; k < CALLERS; k++) ck_assert_int_eq(pthread_join(callers[k], NULL), 0);
  results alone;
  call(&alone);
  for (int k = 0; k < CALLERS; k++) {
    check_same(&alone, got + k, TP_AREA_SUM_COUNT, "callers", MOST);
  }
}
END_TEST

/* |high + low - exact| <= bound for all six, and `high` is what the pair rounds to. Returns the
 * largest bound in units of K n U V, the scale of the bound in ring_sums_compensated.c. */
static double check_pairs(long count, int threads) {
  fmpz *x = flint_calloc((size_t)count, sizeof *x), *y = flint_calloc((size_t)count, sizeof *y);
  fmpz exact[TP_SUM_COUNT] = {0};
  tp_double_pair pairs[TP_SUM_COUNT];
  double bounds[TP_SUM_COUNT], most_u = 0, most_v = 0, worst = 0;
  arf_t error, part;
  arf_init(error);
  arf_init(part);
  for (long k = 0; k < count; k++) {
    fmpz_set_d(x + k, pu[k]);
    fmpz_set_d(y + k, pv[k]);
    most_u = fmax(most_u, fabs(pu[k]));
    most_v = fmax(most_v, fabs(pv[k]));
  }
  tp_ring_sums_exact(exact, x, y, count);
  tp_ring_sums_compensated_first(pairs, bounds, pu, pv, count,
                                 (tp_sums_plan){.sum_count = TP_SUM_COUNT, .threads = threads});
  const double scale[TP_SUM_COUNT] = {
      1, 2 * most_u, 2 * most_v, 3 * most_u * most_u, 3 * most_v * most_v, 6 * most_u * most_v};
  for (int k = 0; k < TP_SUM_COUNT; k++) {
    arf_set_fmpz(error, exact + k);
    arf_set_d(part, pairs[k].high);
    arf_sub(error, error, part, ARF_PREC_EXACT, ARF_RND_DOWN);
    arf_set_d(part, pairs[k].low);
    arf_sub(error, error, part, ARF_PREC_EXACT, ARF_RND_DOWN);
    arf_set_d(part, bounds[k]);
    ck_assert_msg(isfinite(bounds[k]) && arf_cmpabs(error, part) <= 0, "%ld, sum %d", count, k);
    ck_assert(pairs[k].high + pairs[k].low == pairs[k].high);
    worst = fmax(worst, bounds[k] / (scale[k] * (double)count * most_u * most_v));
    fmpz_clear(exact + k);
  }
  arf_clear(error);
  arf_clear(part);
  for (long k = 0; k < count; k++) {
    fmpz_clear(x + k);
    fmpz_clear(y + k);
  }
  flint_free(x);
  flint_free(y);
  return worst;
}

/* Every coordinate -2^53 or 2^53: what rounds, rounds as much as it can. */
static void set_corners(long count, random_numbers *state) {
  for (long k = 0; k < count; k++) {
    pu[k] = draw(state) % 2 == 0 ? 0x1p53 : -0x1p53;
    pv[k] = draw(state) % 2 == 0 ? 0x1p53 : -0x1p53;
  }
}

/* Guards the proven bound of the pairs on chains of 53 bits, of 27 (whose products fit a double),
 * far off on both axes, on one, on the diagonal (slivers) and of extreme coordinates, at the seams
 * of lanes and chunks. The bound is as small as its proof says: M <= 2.01 n U V, D <= 89, so at
 * most w^2 (2.03 92^2 2.01 + 8.2 93) 1.01 < 2^-90 of the scale. */
START_TEST(test_pairs_keep_their_bound) {
  static const long counts[] = {1, 2, 3, 4, 7, 8, 9, 17, 511, 512, 513, 514, 1026, 20000};
  random_numbers state = random_numbers_from(14 + (uint64_t)_i);
  for (size_t c = 0; c < sizeof counts / sizeof *counts; c++) {
    const long count = counts[c];
    set_chain(count, _i == 0 ? 53 : _i == 1 ? 27 : 20, &state);
    if (_i == 5) set_corners(count, &state);
    for (long k = 0; k < count && _i >= 2 && _i <= 4; k++) {
      const double u = pu[k], v = pv[k];
      pu[k] = _i == 4 ? u + 0x1p30 * v : u + 0x1p52;
      pv[k] = _i == 4 ? u - 0x1p30 * v : _i == 2 ? v - 0x1p52 : v;
    }
    ck_assert_double_lt(check_pairs(count, 1), 0x1p-90);
  }
}
END_TEST

/* Guards the joining of blocks in pairs: two full ones and a rest, by two threads. */
START_TEST(test_blocks_of_pairs_keep_their_bound) {
  random_numbers state = random_numbers_from(15);
  set_chain(2 * BLOCK + 5, 53, &state);
  ck_assert_double_lt(check_pairs(2 * BLOCK + 5, 2), 0x1p-90);
}
END_TEST

/* Guards what pairs are for: a unit square 2^48 from the origin, where products have 96 bits. Twice
 * its area, an integer, is certain to be 2: D = 4, M <= 4 * 2^49 and 4 U V < 2^98.01, so the bound
 * is 2^-106 (2^58 + 65.6 * 2^98.01) 1.01 < 0.27. */
START_TEST(test_a_far_off_square_is_certain) {
  const double corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int k = 0; k < 4; k++) {
    pu[k] = 0x1p48 + corners[k][0];
    pv[k] = 0x1p48 + corners[k][1];
  }
  tp_double_pair pairs[TP_SUM_COUNT];
  double bounds[TP_SUM_COUNT];
  tp_ring_sums_compensated(pairs, bounds, pu, pv, 4);
  ck_assert_double_eq(pairs[TP_A2].high, 2);
  ck_assert_double_eq(pairs[TP_A2].low, 0);
  ck_assert_double_lt(bounds[TP_A2], 0.5);
  ck_assert_double_eq(pairs[TP_X6].high, 6 * 0x1p48 + 3); /* 6 times the middle */
}
END_TEST

SUITE(fast_sums) {
  Suite *suite = suite_create("fast sums");
  TCase *cases = tcase_create("fast sums");
  tcase_set_timeout(cases, 120);
  tcase_add_loop_test(cases, test_every_instruction_set_gives_the_same_bits, 0, 2);
  tcase_add_test(cases, test_any_number_of_threads_gives_the_same_bits);
  tcase_add_test(cases, test_callers_do_not_disturb_each_other);
  tcase_add_loop_test(cases, test_pairs_keep_their_bound, 0, 6);
  tcase_add_test(cases, test_blocks_of_pairs_keep_their_bound);
  tcase_add_test(cases, test_a_far_off_square_is_certain);
  suite_add_tcase(suite, cases);
  return suite;
}
