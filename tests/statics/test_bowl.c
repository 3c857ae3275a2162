/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The cone K of twists of a bowl of 60 000 facets, half of which bound it, against what
 * its parabola y = x^2 says; and that it costs n log n. */

#include "motion/twists.h"
#include "suite.h"
#include "whole_vectors.h"

#include <stdlib.h>

enum { BOWL = 30000 };

/* t . q at the first end of the facet of y = x^2 from i to i + 1, t = (1, 2 i + 1). */
static long first_along(long i) {
  return i + (2 * i + 1) * i * i;
}

/* Turning counter-clockwise by 1, facet i bounds v_y >= (2 i + 1) v_x - g_i, g_i as above: rays are
 * the corners of the largest of these lines, which the first facet and those from some one on are
 * part of. */
static long first_on_hull(void) {
  const __int128 begin = first_along(-BOWL);
  long best = -BOWL + 1;
  for (long i = best + 1; i < BOWL; i++) {
    const __int128 own = (first_along(i) - begin) * (best + BOWL);
    const __int128 least = (first_along(best) - begin) * (i + BOWL);
    if (own <= least) best = i;
  }
  return best;
}

/* Two facets, both at their bounds. */
static whole corner(long i, long j) {
  const long turn = 2 * (j - i), x = first_along(j) - first_along(i);
  return (whole){{x, (2 * i + 1) * x - turn * first_along(i), turn}};
}

static bool is_same_ray(const whole *a, const whole *b) {
  for (int k = 0; k < 3; k++) {
    const int l = (k + 1) % 3;
    if ((__int128)a->of[k] * b->of[l] != (__int128)a->of[l] * b->of[k]) return false;
    if ((a->of[k] > 0) != (b->of[k] > 0) || (a->of[k] < 0) != (b->of[k] < 0)) return false;
  }
  return true;
}

/* Around K: counter-clockwise turns by falling v_x, then clockwise ones, mirrored. */
static int around(const void *left, const void *right) {
  const whole *a = left, *b = right;
  const int sense_a = (a->of[2] > 0) - (a->of[2] < 0), sense_b = (b->of[2] > 0) - (b->of[2] < 0);
  if (sense_a != sense_b) return sense_a - sense_b;
  if (sense_a == 0) return (a->of[0] > b->of[0]) - (a->of[0] < b->of[0]);
  const __int128 own = (__int128)a->of[0] * labs(b->of[2]),
                 other = (__int128)b->of[0] * labs(a->of[2]);
  return (own > other) - (own < other);
}

START_TEST(bowl_has_the_rays_of_its_parabola) {
  tp_cones cones;
  tp_normals normals;
  tp_twists twists;
  ck_assert(tp_cones_init(&cones, 4 * BOWL));
  for (long i = -BOWL; i < BOWL; i++) {
    for (long end = 0; end < 2; end++) {
      const long x = i + end;
      set_point(&cones, 2 * (i + BOWL) + end, x, x * x, 1, 2 * i + 1);
    }
  }
  tp_work work = {.most = 2e6}; /* n^2 signs would be 10^8 of work */
  const tp_judge judge = {.bits = 128, .precision = ARF_PREC_EXACT};
  ck_assert_int_eq(tp_normals_init(&normals, &cones, &judge), TP_MOTION_PROVEN);
  ck_assert_int_eq(tp_twists_init(&twists, &normals, &work), TP_MOTION_PROVEN);
  const long from = first_on_hull(), count = 2 * (BOWL - from) + 2;
  ck_assert_int_gt(from, 0);
  ck_assert_int_lt(from, 3 * BOWL / 4);
  whole *rays = calloc((size_t)count, sizeof *rays), *told = calloc((size_t)count, sizeof *told);
  ck_assert(rays != NULL && told != NULL);
  long next = 0;
  for (long i = from; i < BOWL; i++) {
    rays[next] = i == from ? corner(-BOWL, from) : corner(i - 1, i);
    rays[next + 1] = (whole){{-rays[next].of[0], rays[next].of[1], -rays[next].of[2]}};
    next += 2;
  }
  for (long side = -1; side <= 1; side += 2) rays[next++] = (whole){{side, 2 * BOWL - 1, 0}};
  ck_assert_int_eq(twists.ray_count, count);
  ck_assert(twists.has_interior);
  for (long k = 0; k < count; k++) told[k] = whole_vector(&twists.rays[k].twist);
  qsort(rays, (size_t)count, sizeof *rays, around);
  qsort(told, (size_t)count, sizeof *told, around);
  for (long k = 0; k < count; k++) ck_assert(is_same_ray(rays + k, told + k));
  free(rays);
  free(told);
  tp_twists_clear(&twists);
  tp_normals_clear(&normals);
  tp_cones_clear(&cones);
}
END_TEST

SUITE(bowl) {
  Suite *suite = suite_create("bowl");
  TCase *cases = tcase_create("bowl");
  tcase_set_timeout(cases, 120);
  tcase_add_test(cases, bowl_has_the_rays_of_its_parabola);
  suite_add_tcase(suite, cases);
  return suite;
}
