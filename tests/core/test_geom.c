/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The geometry behind geom.h against brute force in exact 128-bit integers, on rings of a tiny grid
 * where touching, collinear and overlapping edges are the rule. Only integers are compared: no
 * tolerances. Every test runs twice: _i = 0 on the path of big integers, 1 on that of doubles. */

#include "geom/geom.h"
#include "geom_figure.h"
#include "random_numbers.h"
#include "suite.h"

#include <stdint.h>
#include <string.h>

enum { APART, CROSS = 1 + TP_GEOM_CROSS, TOUCH = 1 + TP_GEOM_TOUCH, LIE = 1 + TP_GEOM_OVERLAP };

/* How the edges d from a and e from b meet, by Cramer's rule: a + (s / det) d = b + (t / det) e. On
 * one line d runs from 0 to `length`, and e as far as both project on it. */
static int meet(const figure *f, size_t a, size_t b) {
  const vector d = between(f, a, next_of(f, a)), e = between(f, b, next_of(f, b));
  const vector w = between(f, a, b), normal = {-d.v, d.u};
  const bool neighbours = next_of(f, a) == b || next_of(f, b) == a;
  const wide sign = cross(d, e) < 0 ? -1 : 1, det = sign * cross(d, e);
  const wide s = sign * cross(w, e), t = sign * cross(w, d);
  if (det == 0) {
    const wide length = cross(d, normal), from = cross(w, normal), to = from + cross(e, normal);
    const wide low = from < to ? from : to, high = from < to ? to : from;
    if (t != 0 || high < 0 || low > length) return APART;
    return high > 0 && low < length ? LIE : neighbours ? APART : TOUCH;
  }
  if (neighbours || s < 0 || s > det || t < 0 || t > det) return APART;
  return s > 0 && s < det && t > 0 && t < det ? CROSS : TOUCH;
}

typedef struct meetings {
  char kind[MOST][MOST];
  size_t found[4], in_ring[RINGS], calls, most_calls;
  bool wrong; /* a pair twice, or not in order */
} meetings;

/* All pairs, or those of an edge of ring `with` and one of another. */
static void expect_meetings(meetings *m, const figure *f, long with) {
  memset(m, 0, sizeof *m);
  for (size_t b = 0; b < f->count; b++) {
    for (size_t a = 0; a < b; a++) {
      if (with >= 0 && ((long)ring_of(f, a) == with) == ((long)ring_of(f, b) == with)) continue;
      m->kind[a][b] = (char)meet(f, a, b);
      m->found[meet(f, a, b)]++;
      m->in_ring[ring_of(f, a)] += ring_of(f, a) == ring_of(f, b) && m->kind[a][b] != APART;
    }
  }
}

static bool note_meeting(void *context, tp_geom_meeting meeting) {
  meetings *m = context;
  char *kind = m->kind[meeting.a % MOST] + meeting.b % MOST;
  m->wrong |= meeting.a >= meeting.b || meeting.b >= MOST || *kind != 0;
  *kind = (char)(1 + meeting.kind);
  return ++m->calls != m->most_calls;
}

/* Guards the meetings that messages name, and the sweep that decides simplicity: for one ring, for
 * two, and between the two, the very pairs and kinds that Cramer's rule gives (the library takes
 * orientations), none twice; a ring is simple where it has none. All answers come up often. */
START_TEST(test_meetings_are_what_all_pairs_say) {
  static meetings expected, actual;
  random_numbers state = random_numbers_from(1);
  size_t found[4] = {0}, simple_count = 0;
  for (int k = 0; k < 10000; k++) {
    figure f = {0};
    add_random_ring(&f, &state);
    if (k % 4 > 0) add_random_ring(&f, &state);
    const long with = k % 4 > 1 ? k % 2 : -1;
    expect_meetings(&expected, &f, with);
    memset(&actual, 0, sizeof actual);
    const tp_geom_rings rings = view(&f, _i != 0);
    ck_assert_int_eq(tp_geom_find_meetings(&rings, with, note_meeting, &actual), TP_GEOM_OK);
    ck_assert(!actual.wrong && memcmp(actual.kind, expected.kind, sizeof actual.kind) == 0);
    for (int kind = 0; kind < 4; kind++) found[kind] += expected.found[kind];
    expect_meetings(&expected, &f, -1);
    for (size_t r = 0; r < f.ring_count; r++) {
      bool simple;
      ck_assert_int_eq(tp_geom_is_simple(&simple, &rings, r), TP_GEOM_OK);
      ck_assert_msg(simple == !expected.in_ring[r], "case %d, ring %zu: %d", k, r, simple);
      simple_count += simple;
    }
  }
  for (int kind = 0; kind < 4; kind++) ck_assert_uint_gt(found[kind], 1000);
  ck_assert(simple_count > 1000 && simple_count < 16000);
}
END_TEST

static const long pentagram[5][2] = {{0, 0}, {6, 5}, {0, 5}, {6, 0}, {3, 6}};

/* Guards the guard: a search that its visitor stops and a ring whose edges cross end in a status,
 * the exceptions inside, and nothing is left to free. */
START_TEST(test_nothing_escapes) {
  figure f = {0};
  add_ring(&f, pentagram, 5);
  meetings m = {.most_calls = 2};
  const tp_geom_rings rings = view(&f, _i != 0);
  ck_assert_int_eq(tp_geom_find_meetings(&rings, -1, note_meeting, &m), TP_GEOM_OK);
  ck_assert_uint_eq(m.calls, 2);
  tp_geom_triangulation t;
  ck_assert_int_eq(tp_geom_triangulate(&t, &rings, (const int[]){0}), TP_GEOM_FAILED);
  ck_assert_ptr_null(t.triangles);
}
END_TEST

static wide ring_area2(const figure *f, size_t ring) {
  wide sum = 0;
  const size_t first = f->start[ring], end = f->start[ring + 1];
  for (size_t k = first + 1; k < end; k++) {
    sum += cross(between(f, first, k), between(f, k, next_of(f, k)));
  }
  return sum < 0 ? -sum : sum;
}

/* Twice the area, and through `count` the number, of the triangles that lie in ring `in` of layer 0
 * and ring `also` of layer 1, counted from 1; 0: in none, -1: anywhere. All must be positive. */
static wide area2(const tp_geom_triangulation *t, const figure *f, int in, int also,
                  size_t *count) {
  wide sum = 0;
  *count = 0;
  for (size_t k = 0; k < t->count; k++) {
    const size_t *c = t->triangles[k].corner;
    const int *ring = t->triangles[k].ring_in_layer;
    const wide own = cross(between(f, c[0], c[1]), between(f, c[0], c[2]));
    ck_assert(own > 0 && ring[2] == 0 && ring[3] == 0);
    if ((in >= 0 && ring[0] != in) || (also >= 0 && ring[1] != also)) continue;
    sum += own;
    ++*count;
  }
  return sum;
}

/* Every side of a triangle has its two ends in common with the triangle across, run the other way;
 * the sides without one, which are on the outline, are as many as the edges of `ring`. */
static void check_neighbours(const tp_geom_triangulation *t, const figure *f, size_t ring) {
  size_t alone = 0;
  for (size_t k = 0; k < 3 * t->count; k++) {
    const size_t next = t->across[k];
    const size_t *c = t->triangles[k / 3].corner;
    const size_t from = c[(k + 1) % 3], to = c[(k + 2) % 3];
    alone += next == TP_GEOM_NONE;
    if (next == TP_GEOM_NONE) continue;
    const size_t *d = t->triangles[next].corner;
    ck_assert((d[0] == to && d[1] == from) || (d[1] == to && d[2] == from) ||
              (d[2] == to && d[0] == from));
  }
  ck_assert_uint_eq(alone, f->start[ring + 1] - f->start[ring]);
}

static const long side[8][2] = {{0, 0}, {1, 0}, {3, 0}, {6, 0}, {6, 6}, {5, 6}, {0, 6}, {0, 3}};

/* Guards what moments rest on: n + 2 h - 2 triangles (Euler) that fill an outline but its h holes,
 * m - 2 that fill each hole; without holes (first half) and with a square that has vertices along
 * its sides. An outline of 8 or more vertices covers 0.3 cos(1.4 pi / 8) = 0.25 of its radius. */
START_TEST(test_outline_is_filled_and_holes_are_not) {
  random_numbers state = random_numbers_from(3);
  for (size_t n = 2, count; n < 60; n++) {
    const size_t holes = n < 30 ? 0 : 2;
    figure f = {0};
    if (n == 2) add_ring(&f, side, 8);
    if (n > 2) add_star(&f, 0, 10000, n < 30 ? n : n - 22, &state);
    if (holes > 0) add_star(&f, -1200, 1000, 3 + draw(&state) % 9, &state);
    if (holes > 0) add_star(&f, 1200, 1000, 3 + draw(&state) % 9, &state);
    const tp_geom_rings rings = view(&f, _i != 0);
    tp_geom_triangulation t;
    ck_assert_int_eq(tp_geom_triangulate(&t, &rings, (const int[]){0, 1, 1}), TP_GEOM_OK);
    wide block = ring_area2(&f, 0);
    for (size_t hole = 1; hole <= holes; hole++) {
      ck_assert(area2(&t, &f, 1, (int)hole + 1, &count) == ring_area2(&f, hole));
      ck_assert_uint_eq(count, f.start[hole + 1] - f.start[hole] - 2);
      block -= ring_area2(&f, hole);
    }
    ck_assert(!t.conflict && area2(&t, &f, 1, 0, &count) == block);
    ck_assert_uint_eq(count, f.count + 2 * holes - 2);
    if (holes > 0) check_neighbours(&t, &f, 0);
    tp_geom_triangulation_clear(&t);
  }
}
END_TEST

/* Guards conflict and failure for pairs of simple rings as the dice give them: on two layers the
 * call fails exactly where edges cross, else each ring is filled; on one layer, rings that share
 * vertices or pieces of edges only are no conflict, rings whose interiors meet are. */
START_TEST(test_rings_of_one_layer_and_of_two) {
  static meetings m;
  random_numbers state = random_numbers_from(4);
  size_t failed = 0, conflicts = 0, along = 0, count, shared;
  while (failed < 1000 || conflicts < 40 || along < 40) {
    figure f = {0};
    add_random_ring(&f, &state);
    add_random_ring(&f, &state);
    bool simple[2];
    const tp_geom_rings rings = view(&f, _i != 0);
    for (size_t r = 0; r < 2; r++) ck_assert(!tp_geom_is_simple(simple + r, &rings, r));
    if (!simple[0] || !simple[1]) continue;
    expect_meetings(&m, &f, -1);
    const tp_geom_status expected = m.found[CROSS] > 0 ? TP_GEOM_FAILED : TP_GEOM_OK;
    tp_geom_triangulation two, one;
    ck_assert_int_eq(tp_geom_triangulate(&two, &rings, (const int[]){0, 1}), expected);
    ck_assert_int_eq(tp_geom_triangulate(&one, &rings, (const int[]){0, 0}), expected);
    if (expected == TP_GEOM_FAILED && ++failed > 0) continue;
    area2(&two, &f, 1, 2, &shared);
    ck_assert(area2(&two, &f, 1, -1, &count) == ring_area2(&f, 0));
    ck_assert(area2(&two, &f, -1, 2, &count) == ring_area2(&f, 1));
    ck_assert(!two.conflict && one.conflict == (shared > 0));
    ck_assert_uint_eq(one.conflict_a + one.conflict_b, one.conflict);
    ck_assert(one.conflict || area2(&one, &f, 2, 0, &count) == ring_area2(&f, 1));
    conflicts += one.conflict;
    along += !one.conflict && m.found[LIE] > 0;
    tp_geom_triangulation_clear(&two);
    tp_geom_triangulation_clear(&one);
  }
}
END_TEST

/* Guards the precondition of the triangulation: points all on one line, or none, are a status and
 * no crash. */
START_TEST(test_degenerate_points_are_refused) {
  const size_t start[2] = {0, 3}, none[2] = {0, 0};
  const double u[3] = {0, 1, 2}, v[3] = {0, 2, 4};
  const int layer[1] = {0};
  tp_geom_triangulation result;
  tp_geom_rings rings = {.count = 1, .start = start, .u = u, .v = v, .small = true};
  ck_assert_int_eq(tp_geom_triangulate(&result, &rings, layer), TP_GEOM_FAILED);
  rings.start = none;
  ck_assert_int_eq(tp_geom_triangulate(&result, &rings, layer), TP_GEOM_FAILED);
}
END_TEST

SUITE(geom) {
  Suite *suite = suite_create("geom");
  TCase *cases = tcase_create("geom");
  tcase_set_timeout(cases, 120);
  tcase_add_loop_test(cases, test_meetings_are_what_all_pairs_say, 0, 2);
  tcase_add_loop_test(cases, test_nothing_escapes, 0, 2);
  tcase_add_loop_test(cases, test_outline_is_filled_and_holes_are_not, 0, 2);
  tcase_add_loop_test(cases, test_rings_of_one_layer_and_of_two, 0, 2);
  tcase_add_test(cases, test_degenerate_points_are_refused);
  suite_add_tcase(suite, cases);
  return suite;
}
