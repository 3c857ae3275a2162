/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Exact signs by words, and which of two facets has the centroid higher (solid/word_heights.h).
 *
 * Solids of like facets were computed twice, in doubles and then in whole numbers, as doubles do
 * not separate equal heights. They are compared exactly at the level of doubles now. The centroid
 * of a tetrahedron is 3 V / (4 A) over a face of area A: of two faces the larger one has it lower.
 */

#include "random_numbers.h"
#include "rounds.h"
#include "solid/hull_facets.h"
#include "solid/persistence.h"
#include "solid/word_heights.h"
#include "suite.h"

#include <stdio.h>

enum { TEXT = 2048 };

static const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

static tp_message message;

/* ---- determinants ------------------------------------------------------------------------------
 */

static int sign_of_whole(const int64_t a[3], const int64_t b[3], const int64_t c[3]) {
  fmpz_t sum, term;
  fmpz_init(sum);
  fmpz_init(term);
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    fmpz_set_si(term, a[i]);
    fmpz_mul_si(term, term, b[j]);
    fmpz_mul_si(term, term, c[k]);
    fmpz_add(sum, sum, term);
    fmpz_set_si(term, a[j]);
    fmpz_mul_si(term, term, b[i]);
    fmpz_mul_si(term, term, c[k]);
    fmpz_sub(sum, sum, term);
  }
  const int sign = fmpz_sgn(sum);
  fmpz_clear(sum);
  fmpz_clear(term);
  return sign;
}

static int64_t draw_word(random_numbers *state, int bits) {
  const int64_t size = (int64_t)(draw(state) >> (64 - bits));
  return draw_below(state, 2) == 0 ? size : -size;
}

START_TEST(signs_by_words_are_those_by_whole_numbers) {
  random_numbers state = random_numbers_from(59);
  long zeros = 0;
  for (long round = 0; round < rounds(20000, 5000000); round++) {
    int64_t v[3][3];
    const int bits = 1 + (int)draw_below(&state, TP_TURN_WORD_BITS - 2);
    for (int n = 0; n < 2; n++) {
      for (int k = 0; k < 3; k++) v[n][k] = draw_word(&state, bits);
    }
    const int64_t off = draw_below(&state, 3) - 1; /* in the plane of the others, or next to it */
    for (int k = 0; k < 3; k++) {
      v[2][k] = draw_below(&state, 8) == 0 ? draw_word(&state, bits + 1) : v[0][k] - v[1][k];
    }
    v[2][draw_below(&state, 3)] += off;
    const int sign = tp_word_turn(v[0], v[1], v[2]);
    ck_assert_int_eq(sign, sign_of_whole(v[0], v[1], v[2]));
    zeros += sign == 0;
  }
  ck_assert_int_gt(zeros, 1000);
  const int64_t most = (INT64_C(1) << TP_TURN_WORD_BITS) - 1;
  const int64_t a[3] = {most, -most, most}, b[3] = {most, most, -most}, c[3] = {-most, most, most};
  ck_assert_int_eq(tp_word_turn(a, b, c), sign_of_whole(a, b, c));
  ck_assert_int_eq(tp_word_turn(b, a, c), sign_of_whole(b, a, c));
}
END_TEST

/* ---- heights -----------------------------------------------------------------------------------
 */

typedef struct solid {
  tp_mesh mesh;
  tp_surface surface;
} solid;

/* Coordinates times 1, or times 10^20 + 1: then no word holds them. */
static void open_solid(solid *s, long points[4][3], bool is_large) {
  char text[TEXT];
  size_t length = 0;
  for (int v = 0; v < 4; v++) {
    length += (size_t)snprintf(text + length, TEXT - length, "v");
    for (int k = 0; k < 3; k++) {
      const long at = points[v][k], size = labs(at);
      length += (size_t)snprintf(text + length, TEXT - length, is_large ? " %s%ld%020ld" : " %s%ld",
                                 at < 0 ? "-" : "", size, size);
    }
    length += (size_t)snprintf(text + length, TEXT - length, "\n");
  }
  for (int f = 0; f < 4; f++) {
    length += (size_t)snprintf(text + length, TEXT - length, "f %d %d %d\n", faces[f][0] + 1,
                               faces[f][1] + 1, faces[f][2] + 1);
  }
  ck_assert_int_eq(tp_mesh_read_bytes(&s->mesh, TP_MESH_OBJ, text, length, "four.obj", &message),
                   TP_OK);
  ck_assert_int_eq(tp_surface_init(&s->surface, &s->mesh, -1, &message), TP_OK);
  ck_assert_int_eq(tp_surface_has_words(&s->surface), !is_large);
}

static void close_solid(solid *s) {
  tp_surface_clear(&s->surface);
  tp_mesh_clear(&s->mesh);
}

/* The squares of areas, times 4. */
static __int128 area_of(long points[4][3], const int face[3]) {
  __int128 square = 0;
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const long *o = points[face[0]], *p = points[face[1]], *q = points[face[2]];
    const __int128 turn =
        (__int128)(p[i] - o[i]) * (q[j] - o[j]) - (__int128)(p[j] - o[j]) * (q[i] - o[i]);
    square += turn * turn;
  }
  return square;
}

static int compare(const solid *s, const tp_centre *exact, const int *one, const int *other) {
  tp_rest_plane planes[2];
  tp_rest_plane_below(planes, &s->surface, one);
  tp_rest_plane_below(planes + 1, &s->surface, other);
  const int order = tp_centre_compare_heights(exact, planes, planes + 1);
  tp_rest_plane_clear(planes);
  tp_rest_plane_clear(planes + 1);
  return order;
}

/* The corners of a face by the numbers that the surface has for them. */
static void take_corners(int corners[3], const solid *s, const int *face) {
  for (int c = 0; c < 3; c++) {
    for (int v = 0; v < 4; v++) {
      if (s->surface.sources[v] == face[c]) corners[c] = v;
    }
  }
}

static void check_order(long points[4][3], bool is_large, long *ties) {
  solid s = {0};
  open_solid(&s, points, is_large);
  tp_near sums[TP_SOLID_SUM_COUNT];
  tp_centre near, exact;
  tp_word_centre words;
  tp_solid_sums_near(sums, &s.surface);
  tp_centre_of_near(&near, &s.surface, sums);
  ck_assert(!tp_centre_exactly(&exact, &near));
  near.summed = &s.surface;
  ck_assert(tp_centre_exactly(&exact, &near));
  if (!is_large) tp_word_centre_init(&words, &s.surface);
  for (int a = 0; a < 4; a++) {
    for (int b = 0; b < 4; b++) {
      int one[3], other[3];
      take_corners(one, &s, faces[a]);
      take_corners(other, &s, faces[b]);
      const __int128 more = area_of(points, faces[b]) - area_of(points, faces[a]);
      const int order = more > 0 ? 1 : more < 0 ? -1 : 0;
      ck_assert_int_eq(compare(&s, &exact, one, other), order);
      if (!is_large) {
        ck_assert_int_eq(tp_word_centre_compare(&words, &s.surface, one, other), order);
      }
      *ties += a != b && order == 0;
    }
  }
  if (!is_large) tp_word_centre_clear(&words);
  tp_centre_clear(&exact);
  tp_centre_clear(&near);
  close_solid(&s);
}

static bool is_outwards(long points[4][3]) {
  int64_t way[3][3];
  for (int n = 0; n < 3; n++) {
    for (int k = 0; k < 3; k++) way[n][k] = points[n + 1][k] - points[0][k];
  }
  return tp_word_turn(way[0], way[1], way[2]) > 0;
}

START_TEST(the_larger_face_has_the_centroid_lower) {
  random_numbers state = random_numbers_from(5959);
  long ties = 0, count = 0;
  while (count < rounds(400, 100000)) {
    long points[4][3];
    const long size = draw_below(&state, 2) == 0 ? 4 : 1000000000;
    for (int v = 0; v < 4; v++) {
      for (int k = 0; k < 3; k++) points[v][k] = draw_below(&state, size) - size / 2;
    }
    if (!is_outwards(points)) continue;
    check_order(points, count % 4 == 0, &ties);
    count++;
  }
  ck_assert_int_gt(ties, 50);
}
END_TEST

/* Every facet is a pose, and doubles do not separate any two: three of four end at the same rise,
 * each but one, without the level of whole numbers. */
START_TEST(like_facets_are_decided_at_the_level_of_doubles) {
  long points[4][3] = {{-1, -1, -1}, {-1, 1, 1}, {1, -1, 1}, {1, 1, -1}};
  const bool is_pose[4] = {true, true, true, true};
  solid s = {0};
  if (!is_outwards(points)) {
    for (int v = 0; v < 4; v++) points[v][0] = -points[v][0];
  }
  open_solid(&s, points, _i != 0);
  tp_near sums[TP_SOLID_SUM_COUNT];
  tp_centre centre;
  tp_hull_facets facets;
  tp_hull_heights over;
  tp_solid_sums_near(sums, &s.surface);
  tp_centre_of_near(&centre, &s.surface, sums);
  ck_assert_int_eq(tp_hull_facets_init(&facets, &s.surface, &message), TP_OK);
  ck_assert_int_eq(facets.count, 4);
  for (int knows = 0; knows < 2; knows++) {
    tp_persistence *found = NULL;
    bool told = true;
    int ended = 0;
    centre.summed = knows == 1 ? &s.surface : NULL;
    ck_assert_int_eq(tp_hull_heights_init(&over, &centre, &facets, &message), TP_OK);
    ck_assert_int_eq(tp_persistences_find(&found, &over, is_pose, &told, &message), TP_OK);
    ck_assert_int_eq(told, knows == 1);
    for (int f = 0; f < 4; f++) {
      ended += found[f].is_left;
      if (!found[f].is_left || knows == 0) continue;
      const double part =
          found[f].rise.value / over.heights[f].value; /* an edge is sqrt 3 as far */
      ck_assert_double_eq_tol(part, sqrt(3) - 1, 1e-12);
    }
    if (knows == 1) ck_assert_int_eq(ended, 3);
    free(found);
    tp_hull_heights_clear(&over);
  }
  tp_hull_facets_clear(&facets);
  tp_centre_clear(&centre);
  close_solid(&s);
}
END_TEST

SUITE(solid_heights) {
  Suite *suite = suite_create("solid_heights");
  TCase *cases = tcase_create("solid_heights");
  tcase_set_timeout(cases, 3600);
  tcase_add_test(cases, signs_by_words_are_those_by_whole_numbers);
  tcase_add_test(cases, the_larger_face_has_the_centroid_lower);
  tcase_add_loop_test(cases, like_facets_are_decided_at_the_level_of_doubles, 0, 2);
  suite_add_tcase(suite, cases);
  return suite;
}
