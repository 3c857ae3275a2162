/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Arrangements of random segments of a small grid, where crossings, touches and overlaps are the
 * rule, against all pairs by Cramer's rule in rationals; their cycles against Euler's formula. */

#include "geom/geom.h"
#include "random_numbers.h"
#include "suite.h"

enum { SEGMENTS = 9, SIDE = 6, MOST = 400 };

typedef struct plan {
  fmpq ends[4 * SEGMENTS];
  fmpq points[2 * MOST];
  long point_count, on[SEGMENTS][MOST], on_count[SEGMENTS];
  long edges[MOST][2], edge_count;
} plan;

static int turn(const fmpq *p, const fmpq *q, const fmpq *r) {
  fmpq n[4];
  for (int k = 0; k < 4; k++) fmpq_init(n + k);
  fmpq_sub(n, q, p);
  fmpq_sub(n + 1, r + 1, p + 1);
  fmpq_mul(n, n, n + 1);
  fmpq_sub(n + 2, q + 1, p + 1);
  fmpq_sub(n + 3, r, p);
  fmpq_mul(n + 2, n + 2, n + 3);
  const int sign = fmpq_cmp(n, n + 2);
  for (int k = 0; k < 4; k++) fmpq_clear(n + k);
  return sign;
}

static int compare(const fmpq *p, const fmpq *q) {
  const int order = fmpq_cmp(p, q);
  return order != 0 ? order : fmpq_cmp(p + 1, q + 1);
}

/* Is a point on a segment, ends and all? */
static bool is_on(const plan *f, long segment, const fmpq *p) {
  const fmpq *a = f->ends + 4 * segment, *b = a + 2;
  return turn(a, b, p) == 0 && compare(a, p) * compare(p, b) >= 0;
}

static void add_point(plan *f, const fmpq *x, const fmpq *y) {
  fmpq *own = f->points + 2 * f->point_count;
  fmpq_set(own, x);
  fmpq_set(own + 1, y);
  for (long k = 0; k < f->point_count; k++) {
    if (compare(f->points + 2 * k, own) == 0) return;
  }
  f->point_count++;
}

/* Where the lines of two segments cross, if that is on both. */
static void add_crossing(plan *f, long i, long j) {
  const fmpq *a = f->ends + 4 * i, *b = f->ends + 4 * j;
  fmpq n[8];
  for (int k = 0; k < 8; k++) fmpq_init(n + k);
  for (int k = 0; k < 2; k++) {
    fmpq_sub(n + k, a + 2 + k, a + k);     /* d */
    fmpq_sub(n + 2 + k, b + 2 + k, b + k); /* e */
    fmpq_sub(n + 4 + k, b + k, a + k);     /* w */
  }
  fmpq_mul(n + 6, n, n + 3);
  fmpq_mul(n + 7, n + 1, n + 2);
  fmpq_sub(n + 6, n + 6, n + 7); /* d x e */
  if (!fmpq_is_zero(n + 6)) {
    fmpq_mul(n + 7, n + 4, n + 3);
    fmpq_submul(n + 7, n + 5, n + 2);
    fmpq_div(n + 7, n + 7, n + 6);
    fmpq_mul(n, n, n + 7);
    fmpq_add(n, n, a);
    fmpq_mul(n + 1, n + 1, n + 7);
    fmpq_add(n + 1, n + 1, a + 1);
    if (is_on(f, i, n) && is_on(f, j, n)) add_point(f, n, n + 1);
  }
  for (int k = 0; k < 8; k++) fmpq_clear(n + k);
}

static void add_edge(plan *f, long p, long q) {
  const long low = p < q ? p : q, high = p < q ? q : p;
  for (long k = 0; k < f->edge_count; k++) {
    if (f->edges[k][0] == low && f->edges[k][1] == high) return;
  }
  f->edges[f->edge_count][0] = low;
  f->edges[f->edge_count++][1] = high;
}

/* Points of a segment in their order, and the edges between them. */
static void order_points(plan *f, long segment) {
  long *on = f->on[segment], count = 0;
  for (long p = 0; p < f->point_count; p++) {
    if (!is_on(f, segment, f->points + 2 * p)) continue;
    long at = count++;
    for (; at > 0 && compare(f->points + 2 * on[at - 1], f->points + 2 * p) > 0; at--) {
      on[at] = on[at - 1];
    }
    on[at] = p;
  }
  f->on_count[segment] = count;
  for (long k = 1; k < count; k++) add_edge(f, on[k - 1], on[k]);
}

static void draw_plan(plan *f, random_numbers *state) {
  f->point_count = f->edge_count = 0;
  for (long k = 0; k < SEGMENTS; k++) {
    fmpq *own = f->ends + 4 * k;
    do {
      for (int n = 0; n < 4; n++) fmpq_set_si(own + n, draw_below(state, SIDE), 1);
    } while (compare(own, own + 2) == 0);
    add_point(f, own, own + 1);
    add_point(f, own + 2, own + 3);
    for (long j = 0; j < k; j++) add_crossing(f, j, k);
  }
  for (long k = 0; k < SEGMENTS; k++) order_points(f, k);
}

/* Of the graph of edges. */
static long count_components(const plan *f) {
  long part[MOST], count = f->point_count;
  for (long p = 0; p < f->point_count; p++) part[p] = p;
  for (long e = 0; e < f->edge_count; e++) {
    const long a = part[f->edges[e][0]], b = part[f->edges[e][1]];
    if (a == b) continue;
    count--;
    for (long p = 0; p < f->point_count; p++) {
      if (part[p] == b) part[p] = a;
    }
  }
  return count;
}

static long count_cycles(const tp_geom_arrangement *a) {
  bool seen[2 * MOST] = {false};
  long count = 0;
  for (size_t h = 0; h < 2 * a->edge_count; h++) {
    if (seen[h]) continue;
    count++;
    for (size_t at = h; !seen[at]; at = a->next[at]) seen[at] = true;
  }
  return count;
}

/* Every edge is a piece of just those segments that have both of its ends, and leads on at its end.
 */
static void check_edges(const tp_geom_arrangement *a, const plan *f) {
  for (size_t h = 0; h < 2 * a->edge_count; h++) {
    ck_assert_uint_eq(a->origin[a->next[h]], a->origin[h ^ 1]);
  }
  for (size_t e = 0; e < a->edge_count; e++) {
    size_t at = a->first[e];
    for (long s = 0; s < SEGMENTS; s++) {
      if (!is_on(f, s, a->points + 2 * a->origin[2 * e]) ||
          !is_on(f, s, a->points + 2 * a->origin[2 * e + 1])) {
        continue;
      }
      ck_assert(at < a->first[e + 1] && a->segments[at] == (size_t)s);
      at++;
    }
    ck_assert_uint_eq(at, a->first[e + 1]);
  }
}

START_TEST(test_arrangement_is_what_all_pairs_say) {
  static plan f;
  random_numbers state = random_numbers_from(11);
  for (int k = 0; k < 4 * SEGMENTS; k++) fmpq_init(f.ends + k);
  for (int k = 0; k < 2 * MOST; k++) fmpq_init(f.points + k);
  for (int round = 0; round < 150; round++) {
    tp_geom_arrangement a;
    draw_plan(&f, &state);
    ck_assert_int_eq(tp_geom_arrange(&a, f.ends, SEGMENTS), TP_GEOM_OK);
    ck_assert_int_eq((long)a.vertex_count, f.point_count);
    ck_assert_int_eq((long)a.edge_count, f.edge_count);
    check_edges(&a, &f);
    /* V - E + F = 1 + C, and each component but one adds a cycle to a face */
    ck_assert_int_eq(count_cycles(&a), f.edge_count - f.point_count + 2 * count_components(&f));
    tp_geom_arrangement_clear(&a);
  }
  for (int k = 0; k < 4 * SEGMENTS; k++) fmpq_clear(f.ends + k);
  for (int k = 0; k < 2 * MOST; k++) fmpq_clear(f.points + k);
}
END_TEST

SUITE(arrange) {
  Suite *suite = suite_create("arrange");
  TCase *cases = tcase_create("arrange");
  tcase_add_test(cases, test_arrangement_is_what_all_pairs_say);
  suite_add_tcase(suite, cases);
  return suite;
}
