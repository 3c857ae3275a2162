/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Whether a block and its base have an inside in common, told by the meetings of their edges,
 * against the triangles of both by CGAL: simple rings on a tiny grid, on which touching, coinciding
 * and nested rings are the rule. Only yes and no are compared: no tolerances. */

#include "base/overlap.h"
#include "random_numbers.h"
#include "suite.h"

#include <string.h>

enum { GRID = 5, MOST = 8, ROUNDS = 1000000, FIRST_SEED = 1 };

typedef struct figure {
  size_t start[3];
  double u[2 * MOST], v[2 * MOST];
  fmpz x[2 * MOST], y[2 * MOST];
} figure;

static void draw_ring(figure *f, int ring, random_numbers *state) {
  const size_t first = f->start[ring];
  const size_t count = 3 + draw(state) % (MOST - 2);
  f->start[ring + 1] = first + count;
  for (size_t k = first; k < first + count; k++) {
    f->u[k] = (double)(draw(state) % GRID);
    f->v[k] = (double)(draw(state) % GRID);
  }
}

static double area_of(const figure *f, int ring) {
  double sum = 0;
  for (size_t k = f->start[ring], last = f->start[ring + 1] - 1; k < f->start[ring + 1]; last = k++)
    sum += f->u[last] * f->v[k] - f->u[k] * f->v[last];
  return sum;
}

static tp_geom_rings view(const figure *f) {
  return (tp_geom_rings){2, f->start, f->u, f->v, f->x, f->y, true};
}

/* Counter-clockwise or clockwise, as it comes. False: the ring is no polygon. */
static bool is_polygon(const figure *f, int ring) {
  bool simple = false;
  const tp_geom_rings rings = view(f);
  for (size_t k = f->start[ring], last = f->start[ring + 1] - 1; k < f->start[ring + 1]; last = k++)
    if (f->u[k] == f->u[last] && f->v[k] == f->v[last]) return false;
  ck_assert_int_eq(tp_geom_is_simple(&simple, &rings, (size_t)ring), TP_GEOM_OK);
  return simple && area_of(f, ring) != 0;
}

typedef struct meeting {
  tp_overlap overlap;
  bool crossed;
} meeting;

static bool take(void *context, tp_geom_meeting met) {
  meeting *m = context;
  if (met.kind == TP_GEOM_CROSS) {
    m->crossed = true;
  } else {
    tp_overlap_meet(&m->overlap, met.kind, (long)met.a, (long)met.b);
  }
  return true;
}

/* A triangle that lies in both. */
static bool shares_triangle(const figure *f) {
  static const int layer[] = {0, 3};
  const tp_geom_rings rings = view(f);
  tp_geom_triangulation all = {0};
  bool shared = false;
  ck_assert_int_eq(tp_geom_triangulate(&all, &rings, layer), TP_GEOM_OK);
  for (size_t k = 0; k < all.count; k++) {
    shared = shared ||
             (all.triangles[k].ring_in_layer[0] != 0 && all.triangles[k].ring_in_layer[3] != 0);
  }
  tp_geom_triangulation_clear(&all);
  return shared;
}

START_TEST(meetings_tell_of_an_overlap) {
  random_numbers state = random_numbers_from(FIRST_SEED);
  static figure f;
  long touching[2] = {0}, apart[2] = {0};
  for (long round = 0; round < ROUNDS; round++) {
    memset(f.start, 0, sizeof f.start);
    draw_ring(&f, 0, &state);
    draw_ring(&f, 1, &state);
    if (!is_polygon(&f, 0) || !is_polygon(&f, 1)) continue;
    for (size_t k = 0; k < f.start[2]; k++) {
      fmpz_set_si(f.x + k, (long)f.u[k]);
      fmpz_set_si(f.y + k, (long)f.v[k]);
    }
    const tp_lattice lattice = {.x = f.x, .y = f.y};
    meeting m = {
        .overlap = {.lattice = &lattice,
                    .a = {0, (long)f.start[1], area_of(&f, 0) < 0},
                    .b = {(long)f.start[1], (long)(f.start[2] - f.start[1]), area_of(&f, 1) < 0}}};
    const tp_geom_rings rings = view(&f);
    ck_assert_int_eq(tp_geom_find_meetings(&rings, 1, take, &m), TP_GEOM_OK);
    if (m.crossed) continue;
    const bool truth = shares_triangle(&f), told = tp_overlap_is(&m.overlap);
    ck_assert_msg(told == truth, "round %ld: %d, but the triangles say %d", round, told, truth);
    (m.overlap.touch ? touching : apart)[truth]++;
  }
  for (int k = 0; k < 2; k++) { /* all four kinds were met often */
    ck_assert_int_gt(touching[k], 100);
    ck_assert_int_gt(apart[k], 30);
  }
  for (size_t k = 0; k < 2 * MOST; k++) {
    fmpz_clear(f.x + k);
    fmpz_clear(f.y + k);
  }
}
END_TEST

SUITE(overlap) {
  Suite *suite = suite_create("overlap");
  TCase *cases = tcase_create("overlap");
  tcase_set_timeout(cases, 120);
  tcase_add_test(cases, meetings_tell_of_an_overlap);
  suite_add_tcase(suite, cases);
  return suite;
}
