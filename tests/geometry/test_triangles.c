/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Triangles that CGAL finds in a block are checked before they are used. Those of a square with two
 * holes, one of which touches its outline, pass; with damage of each kind they do not. */

#include "block/check.h"
#include "suite.h"

#include <string.h>

enum { POINTS = 12, RINGS = 3, MOST = 40 };

static const long points[POINTS][2] = {{0, 0}, {12, 0}, {12, 12}, {0, 12}, {3, 3}, {3, 5},
                                       {5, 5}, {5, 3},  {12, 8},  {9, 7},  {8, 9}, {9, 10}};
static size_t ring_starts[RINGS + 1] = {0, 4, 8, 12};
static long chain_starts[RINGS + 1] = {0, 4, 8, 12};
static double u[POINTS], v[POINTS];
static fmpz x[POINTS], y[POINTS];
static tp_geom_triangulation all, block;
static tp_geom_triangle kept[MOST];
static const tp_lattice lattice = {.start = chain_starts, .x = x, .y = y};

static void begin(void) {
  static const int layers[RINGS] = {0, 1, 1};
  for (int k = 0; k < POINTS; k++) {
    u[k] = (double)points[k][0];
    v[k] = (double)points[k][1];
    fmpz_init_set_si(x + k, points[k][0]);
    fmpz_init_set_si(y + k, points[k][1]);
  }
  const tp_geom_rings rings = {RINGS, ring_starts, u, v, x, y, true};
  ck_assert_int_eq(tp_geom_triangulate(&all, &rings, layers), TP_GEOM_OK);
  block = (tp_geom_triangulation){.triangles = kept};
  for (size_t k = 0; k < all.count; k++) {
    if (all.triangles[k].ring_in_layer[1] == 0) kept[block.count++] = all.triangles[k];
  }
  ck_assert(block.count > 10 && block.count < all.count && all.count < MOST);
}

static void end(void) {
  tp_geom_triangulation_clear(&all);
  for (int k = 0; k < POINTS; k++) {
    fmpz_clear(x + k);
    fmpz_clear(y + k);
  }
}

START_TEST(triangles_of_the_block_fill_it) {
  ck_assert(tp_check_fills(&block, &lattice, RINGS - 1));
}
END_TEST

START_TEST(damaged_ones_do_not) {
  ck_assert(!tp_check_fills(&all, &lattice, RINGS - 1)); /* those of the holes as well */
  block.count--;                                         /* one is missing */
  ck_assert(!tp_check_fills(&block, &lattice, RINGS - 1));
  kept[block.count] = kept[0]; /* one twice, for the one that is missing */
  block.count++;
  ck_assert(!tp_check_fills(&block, &lattice, RINGS - 1));
  kept[block.count - 1] = all.triangles[0];
}
END_TEST

START_TEST(a_turned_one_does_not) {
  for (size_t k = 0; k < block.count; k++) {
    const tp_geom_triangle sound = kept[k];
    kept[k].corner[0] = sound.corner[1];
    kept[k].corner[1] = sound.corner[0];
    ck_assert(!tp_check_fills(&block, &lattice, RINGS - 1));
    kept[k] = sound;
  }
  ck_assert(tp_check_fills(&block, &lattice, RINGS - 1));
}
END_TEST

SUITE(triangles) {
  Suite *suite = suite_create("triangles");
  TCase *cases = tcase_create("triangles");
  tcase_add_checked_fixture(cases, begin, end);
  tcase_add_test(cases, triangles_of_the_block_fill_it);
  tcase_add_test(cases, damaged_ones_do_not);
  tcase_add_test(cases, a_turned_one_does_not);
  suite_add_tcase(suite, cases);
  return suite;
}
