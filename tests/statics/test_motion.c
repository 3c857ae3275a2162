/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The cone K of twists against every pair of its planes, in whole numbers, for small cones of all
 * ranks. */

#include "motion/twists.h"
#include "random_numbers.h"
#include "suite.h"
#include "whole_vectors.h"

enum { CONES = 6000, MOST = 7 };

static random_numbers state;

/* A contact, K's planes, and what is told of K. */
typedef struct contact {
  tp_cones cones;
  tp_normals normals;
  tp_twists twists;
  long plane_count;
  whole planes[2 * MOST];
  long ray_count;
  whole rays[4 * MOST];
} contact;

static void describe(contact *c) {
  const tp_judge judge = {.bits = 128, .precision = ARF_PREC_EXACT};
  ck_assert_int_eq(tp_normals_init(&c->normals, &c->cones, &judge), TP_MOTION_PROVEN);
  ck_assert_int_eq(tp_twists_init(&c->twists, &c->normals, NULL), TP_MOTION_PROVEN);
}

/* Few directions and places, so that planes repeat, oppose each other and meet in one ray. */
static void contact_init(contact *c) {
  const long count = 1 + draw_below(&state, MOST), spread = 1 + draw_below(&state, 4);
  ck_assert(tp_cones_init(&c->cones, count));
  c->plane_count = c->ray_count = 0;
  for (long k = 0; k < count; k++) {
    const long x = draw_below(&state, spread), y = draw_below(&state, spread);
    long tx = 0, ty = 0;
    while (tx == 0 && ty == 0) {
      tx = draw_below(&state, 2 * spread + 1) - spread;
      ty = draw_below(&state, spread + 1) - (draw_below(&state, 3) == 0 ? 1 : 0);
    }
    set_point(&c->cones, k, x, y, tx, ty);
    c->planes[c->plane_count++] = (whole){{-ty, tx, tx * x + ty * y}};
  }
  describe(c);
  ck_assert_int_le(c->twists.ray_count, 4 * MOST);
  for (long k = 0; k < c->twists.ray_count; k++) {
    c->rays[c->ray_count++] = whole_vector(&c->twists.rays[k].twist);
  }
}

static void contact_clear(contact *c) {
  tp_twists_clear(&c->twists);
  tp_normals_clear(&c->normals);
  tp_cones_clear(&c->cones);
}

static bool is_in_k(const contact *c, const whole *a) {
  for (long k = 0; k < c->plane_count; k++) {
    if (dot(c->planes + k, a) < 0) return false;
  }
  return true;
}

static int rank_of(const contact *c) {
  int rank = 1;
  for (long i = 0; i < c->plane_count; i++) {
    for (long j = 0; j < i; j++) {
      const whole across = cross(c->planes + i, c->planes + j);
      if (is_zero(&across)) continue;
      if (rank < 2) rank = 2;
      for (long k = 0; k < j; k++) {
        if (dot(&across, c->planes + k) != 0) rank = 3;
      }
    }
  }
  return rank;
}

static long times_told(const contact *c, const whole *ray) {
  long times = 0;
  for (long k = 0; k < c->ray_count; k++) times += are_along(c->rays + k, ray);
  return times;
}

/* The rays of a K without a line: those of two planes that lie within all. */
static void check_pairs(const contact *c) {
  whole sum = {{0, 0, 0}};
  for (long k = 0; k < c->ray_count; k++) {
    long planes = 0; /* through it, not along each other */
    for (long i = 0; i < c->plane_count; i++) {
      for (long j = 0; j < i; j++) {
        const whole across = cross(c->planes + i, c->planes + j);
        planes += !is_zero(&across) && dot(c->planes + i, c->rays + k) == 0 &&
                  dot(c->planes + j, c->rays + k) == 0;
      }
    }
    ck_assert_int_gt(planes, 0);
    ck_assert_int_eq(times_told(c, c->rays + k), 1);
    for (int e = 0; e < 3; e++) sum.of[e] += c->rays[k].of[e];
  }
  for (long i = 0; i < c->plane_count; i++) {
    for (long j = 0; j < c->plane_count; j++) {
      const whole ray = cross(c->planes + i, c->planes + j); /* and back with i and j exchanged */
      if (is_zero(&ray) || !is_in_k(c, &ray)) continue;
      ck_assert_int_eq(times_told(c, &ray), 1);
    }
  }
  bool inside = c->ray_count > 2;
  for (long k = 0; k < c->plane_count; k++) inside = inside && dot(c->planes + k, &sum) > 0;
  ck_assert_int_eq(c->twists.has_interior, inside);
  ck_assert_int_eq(c->twists.face_count, inside ? c->ray_count : c->ray_count == 2);
}

/* Every contact closed under a ray lies on one of the lines that are told of it, or on one between
 * the outermost of its direction. */
static void check_lines(const contact *c) {
  for (long k = 0; k < c->ray_count; k++) {
    const tp_ray *ray = c->twists.rays + k;
    long told = 0;
    for (long l = 0; l < c->normals.count; l++) {
      const tp_contact_family *family = c->normals.families + c->normals.items[l].family;
      if (l != family->first && l != family->first + family->count - 1) continue;
      const long point = c->normals.order[c->normals.items[l].first];
      if (dot(c->planes + point, c->rays + k) != 0) continue;
      ck_assert_int_lt(told, ray->line_count);
      ck_assert_int_eq(c->twists.lines[ray->first_line + told], l);
      told++;
    }
    ck_assert_int_eq(told, ray->line_count);
  }
}

/* Is a = sum of rays with factors that are not negative? Then of three at most. */
static bool is_spanned(const contact *c, const whole *a) {
  if (is_zero(a)) return true;
  for (long i = 0; i < c->ray_count; i++) {
    if (are_along(c->rays + i, a)) return true;
    for (long j = 0; j < i; j++) {
      const whole plane = cross(c->rays + i, c->rays + j);
      if (is_zero(&plane)) continue;
      const whole left = cross(a, c->rays + j), right = cross(c->rays + i, a);
      if (dot(&plane, a) == 0 && dot(&left, &plane) >= 0 && dot(&right, &plane) >= 0) return true;
      for (long k = 0; k < j; k++) {
        const long all = dot(&plane, c->rays + k);
        const whole jk = cross(c->rays + j, c->rays + k), ki = cross(c->rays + k, c->rays + i);
        const long sign = all > 0 ? 1 : -1;
        if (all != 0 && sign * dot(&jk, a) >= 0 && sign * dot(&ki, a) >= 0 &&
            sign * dot(&plane, a) >= 0) {
          return true;
        }
      }
    }
  }
  return false;
}

/* K is what its rays span: of a half-space they span its plane, and its normal is added. */
static void check_span(contact *c, int rank) {
  enum { REACH = 2 };
  for (long k = 0; k < c->ray_count; k++) ck_assert(is_in_k(c, c->rays + k));
  const long rays = c->ray_count;
  if (rank == 1 && c->twists.has_interior) c->rays[c->ray_count++] = c->planes[0];
  for (long x = -REACH; x <= REACH; x++) {
    for (long y = -REACH; y <= REACH; y++) {
      for (long turn = -REACH; turn <= REACH; turn++) {
        const whole a = {{x, y, turn}};
        ck_assert_int_eq(is_in_k(c, &a), is_spanned(c, &a));
      }
    }
  }
  c->ray_count = rays;
}

/* Both rays of a face lie on its line. */
static void check_faces(const contact *c) {
  for (long k = 0; k < c->twists.face_count; k++) {
    const tp_twist_face *face = c->twists.faces + k;
    const long point = c->normals.order[c->normals.items[face->normal].first];
    ck_assert_int_eq(dot(c->planes + point, c->rays + face->from), 0);
    ck_assert_int_eq(dot(c->planes + point, c->rays + face->to), 0);
    ck_assert(!are_along(c->rays + face->from, c->rays + face->to));
  }
}

START_TEST(rays_are_those_of_all_pairs_of_planes) {
  state = random_numbers_from(20261122);
  long ranks[4] = {0}, flat = 0, nothing = 0;
  for (long k = 0; k < CONES; k++) {
    contact c;
    contact_init(&c);
    const int rank = rank_of(&c);
    ranks[rank]++;
    check_span(&c, rank);
    check_faces(&c);
    if (rank == 3) check_pairs(&c);
    if (rank == 3 && c.twists.has_interior) check_lines(&c);
    flat += rank == 3 && !c.twists.has_interior && c.ray_count > 0;
    nothing += c.ray_count == 0;
    contact_clear(&c);
  }
  for (int rank = 1; rank <= 3; rank++) ck_assert_int_gt(ranks[rank], CONES / 20);
  ck_assert_int_gt(flat, CONES / 20);
  ck_assert_int_gt(nothing, CONES / 50);
}
END_TEST

START_TEST(nothing_bounds_a_block_without_contacts) {
  contact c;
  ck_assert(tp_cones_init(&c.cones, 0));
  describe(&c);
  ck_assert(c.twists.everything);
  ck_assert_int_eq(c.twists.ray_count, 0);
  contact_clear(&c);
}
END_TEST

SUITE(motion) {
  Suite *suite = suite_create("motion");
  TCase *cases = tcase_create("motion");
  tcase_set_timeout(cases, 120);
  tcase_add_test(cases, rays_are_those_of_all_pairs_of_planes);
  tcase_add_test(cases, nothing_bounds_a_block_without_contacts);
  suite_add_tcase(suite, cases);
  return suite;
}
