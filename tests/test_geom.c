/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The geometry behind geom.h against brute force in exact 128-bit integers. Small rings on a tiny
 * grid, where touching, collinear and overlapping edges are the rule and not the exception. All
 * comparisons are of integers: no tolerances. Loop tests run twice: 0 the path of big integers,
 * 1 the path of doubles. */

#include "geom.h"

#include <check.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 64, RINGS = 4 };
typedef __int128 wide;

/* Rings of integer points, the open one last; (x, y) are (u, v) moved and scaled by 2^70. */
typedef struct figure {
  size_t ring_count, count, start[RINGS + 1];
  double u[MOST], v[MOST];
  fmpz x[MOST], y[MOST];
} figure;

static uint64_t draw(uint64_t *state) {
  uint64_t z = (*state += UINT64_C(0x9e3779b97f4a7c15));
  z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
  return z ^ (z >> 31);
}

static double draw_unit(uint64_t *state) {
  return (double)(draw(state) >> 11) * 0x1p-53;
}

static void set_large(fmpz *large, long value) {
  fmpz_set_si(large, value - 1000003);
  fmpz_mul_2exp(large, large, 70);
  fmpz_add_ui(large, large, 12345678987654321);
}

static void add_vertex(figure *f, long u, long v) {
  ck_assert_uint_lt(f->count, MOST);
  f->u[f->count] = (double)u;
  f->v[f->count] = (double)v;
  set_large(f->x + f->count, u);
  set_large(f->y + f->count, v);
  f->count++;
}

static void close_ring(figure *f) {
  f->start[++f->ring_count] = f->count;
}

static void add_ring(figure *f, const long (*points)[2], size_t count) {
  for (size_t k = 0; k < count; k++) add_vertex(f, points[k][0], points[k][1]);
  close_ring(f);
}

#define ADD_RING(f, ...)                                                                           \
  add_ring(f, (const long[][2]){__VA_ARGS__}, sizeof((long[][2]){__VA_ARGS__}) / sizeof(long[2]))

static bool same_point(const figure *f, size_t a, size_t b) {
  return f->u[a] == f->u[b] && f->v[a] == f->v[b];
}

/* 3 to 9 vertices on the grid 0 … 6, no two neighbours equal. */
static void add_random_ring(figure *f, uint64_t *state) {
  const size_t first = f->count, last = first + 2 + draw(state) % 7;
  while (f->count <= last) {
    add_vertex(f, (long)(draw(state) % 7), (long)(draw(state) % 7));
    const size_t k = f->count - 1;
    if (k > first && (same_point(f, k, k - 1) || (k == last && same_point(f, k, first)))) {
      f->count--;
    }
  }
  close_ring(f);
}

/* Star-shaped about (u, v): angles jump by less than a half turn, radii are 0.3 to 1 of `radius`. */
static void add_star(figure *f, long u, long v, double radius, size_t count, uint64_t *state) {
  for (size_t k = 0; k < count; k++) {
    const double turn = ((double)k + 0.4 * draw_unit(state)) / (double)count;
    const double r = radius * (0.3 + 0.7 * draw_unit(state)), angle = 2 * acos(-1) * turn;
    add_vertex(f, u + lround(r * cos(angle)), v + lround(r * sin(angle)));
  }
  close_ring(f);
}

static void clear(figure *f) {
  for (size_t k = 0; k < MOST; k++) {
    fmpz_clear(f->x + k);
    fmpz_clear(f->y + k);
  }
  memset(f, 0, sizeof *f);
}

/* Each path is given its own coordinates only, so that it cannot take the other's. */
static tp_geom_rings view(const figure *f, bool small) {
  tp_geom_rings rings = {.count = f->ring_count, .start = f->start, .small = small};
  if (small) {
    rings.u = f->u;
    rings.v = f->v;
  } else {
    rings.x = f->x;
    rings.y = f->y;
  }
  return rings;
}

static size_t ring_of(const figure *f, size_t vertex) {
  size_t ring = 0;
  while (f->start[ring + 1] <= vertex) ring++;
  return ring;
}

static size_t next_of(const figure *f, size_t vertex) {
  const size_t ring = ring_of(f, vertex);
  return vertex + 1 == f->start[ring + 1] ? f->start[ring] : vertex + 1;
}

typedef struct vector {
  wide u, v;
} vector;

static vector between(const figure *f, size_t from, size_t to) {
  return (vector){(wide)f->u[to] - (wide)f->u[from], (wide)f->v[to] - (wide)f->v[from]};
}

static wide cross(vector a, vector b) {
  return a.u * b.v - a.v * b.u;
}

static wide dot(vector a, vector b) {
  return a.u * b.u + a.v * b.v;
}

enum { APART = 0, CROSS = 1 + TP_GEOM_CROSS, TOUCH = 1 + TP_GEOM_TOUCH, LIE = 1 + TP_GEOM_OVERLAP };

/* Edges on one line, a from 0 to |d|^2 and b from `from` to `to` in the measure of d. */
static int meet_on_line(wide length, wide from, wide to) {
  const wide low = from < to ? from : to, high = from < to ? to : from;
  const wide begin = low > 0 ? low : 0, end = high < length ? high : length;
  return begin < end ? LIE : begin == end ? TOUCH : APART;
}

/* How the edges a and b meet, by Cramer's rule: p + (s / det) d = r + (t / det) e. */
static int meet(const figure *f, size_t a, size_t b) {
  const vector d = between(f, a, next_of(f, a)), e = between(f, b, next_of(f, b));
  const vector w = between(f, a, b);
  const bool neighbours = next_of(f, a) == b || next_of(f, b) == a;
  wide det = cross(d, e), s = cross(w, e), t = cross(w, d);
  if (det == 0) {
    const int kind = t != 0 ? APART : meet_on_line(dot(d, d), dot(w, d), dot(w, d) + dot(e, d));
    return kind == TOUCH && neighbours ? APART : kind;
  }
  if (det < 0) det = -det, s = -s, t = -t;
  if (neighbours || s < 0 || s > det || t < 0 || t > det) return APART;
  return s > 0 && s < det && t > 0 && t < det ? CROSS : TOUCH;
}

typedef struct meetings {
  size_t found[4]; /* of each kind */
  char kind[MOST][MOST];
  size_t calls, most_calls;
  bool out_of_order;
} meetings;

static void expect_meetings(meetings *m, const figure *f, long with) {
  memset(m, 0, sizeof *m);
  for (size_t b = 0; b < f->count; b++) {
    for (size_t a = 0; a < b; a++) {
      const long ring_a = (long)ring_of(f, a), ring_b = (long)ring_of(f, b);
      if (with >= 0 && (ring_a == with) == (ring_b == with)) continue;
      m->kind[a][b] = (char)meet(f, a, b);
      m->found[meet(f, a, b)]++;
    }
  }
}

static bool note_meeting(void *context, tp_geom_meeting meeting) {
  meetings *m = context;
  const bool fresh = meeting.a < meeting.b && meeting.b < MOST && !m->kind[meeting.a][meeting.b];
  if (!fresh) m->out_of_order = true;
  if (fresh) m->kind[meeting.a][meeting.b] = (char)(1 + meeting.kind);
  return ++m->calls != m->most_calls;
}

static void check_meetings(const figure *f, long with, bool small, size_t found[4]) {
  static meetings expected, actual;
  expect_meetings(&expected, f, with);
  memset(&actual, 0, sizeof actual);
  const tp_geom_rings rings = view(f, small);
  ck_assert_int_eq(tp_geom_find_meetings(&rings, with, note_meeting, &actual), TP_GEOM_OK);
  ck_assert(!actual.out_of_order);
  ck_assert_mem_eq(actual.kind, expected.kind, sizeof actual.kind);
  for (int k = 0; k < 4; k++) found[k] += expected.found[k];
}

static bool is_simple(const figure *f, size_t ring, bool small) {
  bool simple = false;
  const tp_geom_rings rings = view(f, small);
  ck_assert_int_eq(tp_geom_is_simple(&simple, &rings, ring), TP_GEOM_OK);
  return simple;
}

static bool has_no_meetings(const figure *f) {
  static meetings m;
  expect_meetings(&m, f, -1);
  return m.found[CROSS] + m.found[TOUCH] + m.found[LIE] == 0;
}

/* Guards the sweep that decides simplicity, whose answer everything downstream relies on, against
 * all pairs of edges. That both answers come up in their hundreds keeps it from proving nothing. */
START_TEST(test_simple_is_what_all_pairs_say) {
  uint64_t state = 1;
  figure f = {0};
  int simple_count = 0;
  for (int k = 0; k < 20000; k++, clear(&f)) {
    add_random_ring(&f, &state);
    const bool simple = has_no_meetings(&f);
    simple_count += simple;
    ck_assert_msg(is_simple(&f, 0, _i != 0) == simple, "ring %d, simple: %d", k, simple);
  }
  ck_assert_int_gt(simple_count, 1000);
  ck_assert_int_lt(simple_count, 19000);
}
END_TEST

/* Guards the pairs and kinds of meetings in messages: for one ring, for two, and between two only,
 * the very set that Cramer's rule gives (the library takes orientations), no pair twice. */
START_TEST(test_meetings_are_what_all_pairs_say) {
  uint64_t state = 2;
  figure f = {0};
  size_t found[4] = {0};
  for (int k = 0; k < 4000; k++, clear(&f)) {
    add_random_ring(&f, &state);
    check_meetings(&f, -1, _i != 0, found);
    add_random_ring(&f, &state);
    for (long with = -1; with < 2; with++) check_meetings(&f, with, _i != 0, found);
  }
  for (int k = 0; k < 4; k++) ck_assert_uint_gt(found[k], 1000);
}
END_TEST

/* Guards the promise that a visitor may stop the search: the exception that does it stays inside. */
START_TEST(test_visitor_stops_the_search) {
  figure f = {0};
  ADD_RING(&f, {0, 0}, {6, 5}, {0, 5}, {6, 0}, {3, 6}); /* a pentagram: five crossings */
  meetings m = {.most_calls = 2};
  const tp_geom_rings rings = view(&f, _i != 0);
  ck_assert_int_eq(tp_geom_find_meetings(&rings, -1, note_meeting, &m), TP_GEOM_OK);
  ck_assert_uint_eq(m.calls, 2);
  clear(&f);
}
END_TEST
