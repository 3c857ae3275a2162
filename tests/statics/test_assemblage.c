/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Many blocks: where they touch, and the greatest tilt that forces between them hold, against
 * closed forms, published walls and slopes, and the mirror image. */

#include "assemblage/limit_change.h"
#include "block_pile.h"
#include "random_numbers.h"
#include "suite.h"

#include <math.h>
#include <string.h>

static const double share = 1e-6;

/* Both proofs about a number that is known to so much. */
static void expect(const block_pile *p, double tangent, bool left, double known, double within) {
  tp_load_bracket b = pile_limit(p, tangent, left, share);
  ck_assert_msg(b.is_held && b.is_bounded, "held %d %.9f, bounded %d %.9f", b.is_held, b.held,
                b.is_bounded, b.bound);
  ck_assert_msg(b.bound - b.held <= share * b.bound, "%.12f to %.12f", b.held, b.bound);
  ck_assert_msg(b.held <= known + within && b.bound >= known - within, "%.9f to %.9f, not %.9f",
                b.held, b.bound, known);
  tp_load_bracket_clear(&b);
}

/* A slab on the ground: tan of the tilt is the lesser of tan(phi) and width over height. */
START_TEST(one_block) {
  block_pile p = {.count = 0};
  pile_add_box(&p, -10, -1, 10, 0, 1, true);
  pile_add_box(&p, 0, 0, 2, 3, 1, false);
  pile_build(&p);
  ck_assert_int_eq(p.assemblage.contact_count, 1);
  for (int left = 0; left < 2; left++) {
    expect(&p, 0.5, left == 1, 0.5, 0);
    expect(&p, 0.9, left == 1, 2.0 / 3, 1e-12);
  }
  pile_clear(&p);
}
END_TEST

START_TEST(published_walls) {
  static const struct {
    int courses, bricks;
    long blocks, contacts;
    double known;
  } walls[] = {{6, 5, 33, 83, 0.64286}, {10, 5, 55, 141, 0.58000}};
  for (size_t k = 0; k < sizeof walls / sizeof walls[0]; k++) {
    block_pile p = {.count = 0};
    pile_add_wall(&p, walls[k].courses, walls[k].bricks);
    pile_build(&p);
    ck_assert_int_eq(p.assemblage.free_count, walls[k].blocks);
    ck_assert_int_eq(p.assemblage.contact_count, walls[k].contacts);
    for (int left = 0; left < 2; left++) expect(&p, 0.65, left == 1, walls[k].known, 5e-6);
    pile_clear(&p);
  }
}
END_TEST

/* The slope of Goodman and Bray (1976): sixteen columns 10 wide on steps of 1, the tenth 40 high,
 * those beside it lower by 4 to the toe and by 6 to the back; x along the steps. */
static void add_slope(block_pile *p) {
  enum { COLUMNS = 16, WIDE = 10, TALLEST = 10 };
  long ground[4 * COLUMNS + 8], at = 0;
  ground[at++] = -WIDE;
  ground[at++] = -2 * WIDE;
  ground[at++] = WIDE * (COLUMNS + 1);
  ground[at++] = -2 * WIDE;
  ground[at++] = WIDE * (COLUMNS + 1);
  ground[at++] = COLUMNS - 1;
  for (long n = COLUMNS - 1; n > 0; n--) { /* from the back to the toe */
    ground[at++] = WIDE * n;
    ground[at++] = n;
    ground[at++] = WIDE * n;
    ground[at++] = n - 1;
  }
  ground[at++] = -WIDE;
  ground[at++] = 0;
  pile_add(p, ground, at / 2, 1, true);
  for (long n = 1; n <= COLUMNS; n++) {
    const long high = n <= TALLEST ? 4 * n : 4 * TALLEST - 6 * (n - TALLEST);
    pile_add_box(p, WIDE * (n - 1), n - 1, WIDE * n, n - 1 + high, 1, false);
  }
}

/* It stands at its 30 degrees with tan(phi) = 0.659599, where Goodman and Bray ask for 0.785544. */
START_TEST(slope_of_columns) {
  static const double needed = 0.659599, digits = 2e-6;
  block_pile p = {.count = 0};
  add_slope(&p);
  pile_build(&p);
  ck_assert_int_eq(p.assemblage.contact_count, 16 + 15 + 15);
  tp_load_bracket weak = pile_limit(&p, needed - digits, true, share);
  tp_load_bracket strong = pile_limit(&p, needed + digits, true, share);
  ck_assert(weak.is_bounded && strong.is_held);
  ck_assert_msg(weak.bound < 1 / sqrt(3) && strong.held > 1 / sqrt(3), "%.9f, %.9f", weak.bound,
                strong.held);
  tp_load_bracket_clear(&weak);
  tp_load_bracket_clear(&strong);
  pile_clear(&p);
}
END_TEST

/* What the mechanism says that a little more friction is worth, against what it is: by the mean of
 * both ends, off by the third power of the step, within what the limits are proven to. */
START_TEST(worth_of_friction) {
  static const double tangents[] = {0.7, 0.71}, within = 2e-6;
  tp_load_bracket limits[2];
  tp_force_program programs[2];
  block_pile p = {.count = 0};
  add_slope(&p);
  pile_build(&p);
  for (int k = 0; k < 2; k++) {
    limits[k] = pile_limit(&p, tangents[k], true, share);
    pile_program(programs + k, &p, tangents[k], true);
  }
  const double there = tp_limit_change(limits, programs, programs + 1);
  const double back = tp_limit_change(limits + 1, programs + 1, programs);
  const double truth = limits[1].bound - limits[0].bound;
  ck_assert_double_gt(truth, 100 * within);
  ck_assert_msg(fabs((there - back) / 2 - truth) <= within, "%.9f, %.9f: %.9f", there, back, truth);
  for (int k = 0; k < 2; k++) {
    tp_load_bracket_clear(limits + k);
    tp_force_program_clear(programs + k);
  }
  pile_clear(&p);
}
END_TEST

/* Bricks of length 2, the k-th from the top past the edge of the next by 1 / k less a thousandth of
 * that, balance; by as much more they do not, and fall without any load. */
START_TEST(stack_of_bricks) {
  enum { BRICKS = 6, DIVISOR = 60000000 };
  for (int more = 0; more < 2; more++) {
    block_pile p = {.count = 0};
    pile_add_box(&p, -20L * DIVISOR, -DIVISOR, 0, 0, DIVISOR, true);
    long end = 0; /* of the brick, from the lowest up */
    for (int k = BRICKS; k > 0; k--) {
      const long height = BRICKS - k;
      end += DIVISOR / k / 1000 * (more == 1 ? 1001 : 999);
      pile_add_box(&p, end - 2L * DIVISOR, height * DIVISOR, end, (height + 1) * DIVISOR, DIVISOR,
                   false);
    }
    pile_build(&p);
    tp_load_bracket b = pile_limit(&p, 0.5, false, share);
    ck_assert_msg(more == 1 ? b.is_bounded && b.bound < 0 : b.is_held && b.held > 0,
                  "held %d %g bound %d %g", b.is_held, b.held, b.is_bounded, b.bound);
    tp_load_bracket_clear(&b);
    pile_clear(&p);
  }
}
END_TEST

/* Four hundred bricks; under ./check --long a thousand. */
START_TEST(large_wall) {
  const long courses = rounds(20, 32);
  block_pile p = {.count = 0};
  pile_add_wall(&p, (int)courses, (int)courses);
  pile_build(&p);
  tp_load_bracket b = pile_limit(&p, 0.65, true, 1e-6);
  ck_assert_msg(b.is_held && b.is_bounded && b.bound - b.held <= 1e-6 * b.bound, "%.9f to %.9f",
                b.held, b.bound);
  tp_load_bracket_clear(&b);
  pile_clear(&p);
}
END_TEST

static void expect_refused(block_pile *p, const char *what) {
  tp_message message = {.text = ""};
  ck_assert_int_eq(pile_assemble(p, &message), TP_BAD_INPUT);
  ck_assert_msg(strstr(message.text, what) != NULL, "%s", message.text);
  pile_clear(p);
}

/* Whole numbers tell an overlap and a gap of 1e-9 from blocks that touch; each is said by name. */
START_TEST(what_is_no_assemblage) {
  enum { DIVISOR = 1000000000 };
  block_pile p = {.count = 0};
  pile_add_box(&p, -10, -1, 10, 0, 1, true);
  pile_add_box(&p, 0, -1, 2L * DIVISOR, 2L * DIVISOR, DIVISOR, false);
  expect_refused(&p, "blocks '0' and '1' overlap");
  pile_add_box(&p, -10, -1, 10, 0, 1, true);
  pile_add_box(&p, 0, 1, 2L * DIVISOR, 2L * DIVISOR, DIVISOR, false);
  expect_refused(&p, "block '1' touches no other");
  pile_add_box(&p, -10, -1, 10, 0, 1, true);
  pile_add_box(&p, 0, 0, 2, 2, 1, false);
  pile_add_box(&p, 1, 1, 2, 2, 2, false); /* all within the one before */
  expect_refused(&p, "blocks '1' and '2' overlap");
  pile_add_box(&p, -10, -1, 10, 0, 1, true);
  pile_add_box(&p, 0, 0, 4, 2, 1, false);
  const long hexagon[] = {1, 0, 3, 0, 4, 1, 3, 2, 1, 2, 0, 1}; /* its corners lie on the border */
  pile_add(&p, hexagon, 6, 1, false);
  expect_refused(&p, "blocks '1' and '2' overlap");
  pile_add_box(&p, 0, 0, 2, 2, 1, false);
  expect_refused(&p, "no block is ground");
  pile_add_box(&p, 0, 0, 2, 2, 1, true);
  expect_refused(&p, "all blocks are ground");
}
END_TEST

/* A corner within an edge is a contact in a point: a square on its corner upon the ground beside
 * one that it leans on bears nothing more than a point can. */
START_TEST(corners_on_faces) {
  block_pile p = {.count = 0};
  pile_add_box(&p, -10, -1, 10, 0, 1, true);
  const long diamond[] = {0, 0, 2, 2, 0, 4, -2, 2};
  pile_add(&p, diamond, 4, 1, false);
  pile_build(&p);
  ck_assert_int_eq(p.assemblage.contact_count, 1);
  ck_assert_int_eq(p.assemblage.contacts[0].ends[0], p.assemblage.contacts[0].ends[1]);
  pile_clear(&p);
  pile_add_box(&p, -10, -1, 10, 0, 1, true);
  pile_add_box(&p, 0, 0, 2, 2, 1, false);
  pile_add_box(&p, 2, 2, 4, 4, 1, false); /* corner to corner, no contact */
  expect_refused(&p, "block '2' touches no other");
}
END_TEST

/* A random pile of boxes in courses, joined in other places each time; `split` cuts the ground into
 * two blocks in the middle, `mirrored` turns it over, `times` makes all larger. */
static void add_random(block_pile *p, uint64_t seed, bool mirrored, bool split, long times) {
  enum { COURSES = 5, WIDTH = 24 };
  const long sign = mirrored ? -1 : 1;
  random_numbers state = random_numbers_from(seed);
  if (split) {
    pile_add_box(p, -100 * times, -times, 11 * times * sign, 0, 1, true);
    pile_add_box(p, 11 * times * sign, -times, 200 * times, 0, 1, true);
  } else {
    pile_add_box(p, -100 * times, -times, 200 * times, 0, 1, true);
  }
  for (long c = 0; c < COURSES; c++) {
    for (long from = 0; from < WIDTH;) {
      long to = from + 2 + draw_below(&state, 5);
      if (to > WIDTH - 2) to = WIDTH;
      const long a = times * (mirrored ? -to : from), b = times * (mirrored ? -from : to);
      pile_add_box(p, a, 3 * c * times, b, 3 * (c + 1) * times, 1, false);
      from = to;
    }
  }
}

/* Neither the mirror image, nor another unit, nor ground in two pieces, nor the side of tilt of a
 * mirror changes the limit: all brackets overlap. */
START_TEST(images_of_random_piles) {
  for (uint64_t seed = 1; seed <= (uint64_t)rounds(20, 400); seed++) {
    tp_load_bracket all[4];
    for (int k = 0; k < 4; k++) {
      block_pile p = {.count = 0};
      add_random(&p, seed, k == 1, k == 2, k == 3 ? 7919 : 1);
      pile_build(&p);
      all[k] = pile_limit(&p, 0.6, k != 1, share);
      ck_assert_msg(all[k].is_held && all[k].is_bounded,
                    "seed %d image %d: held %d %g, bounded %d %g", (int)seed, k, all[k].is_held,
                    all[k].held, all[k].is_bounded, all[k].bound);
      ck_assert_msg(all[k].bound - all[k].held <= share * all[k].bound,
                    "seed %d image %d: %.12f to %.12f", (int)seed, k, all[k].held, all[k].bound);
      ck_assert_msg(all[k].held <= all[0].bound && all[k].bound >= all[0].held, "seed %d image %d",
                    (int)seed, k);
      pile_clear(&p);
    }
    for (int k = 0; k < 4; k++) tp_load_bracket_clear(all + k);
  }
}
END_TEST

/* Four blocks about a point are two pairs of corners, on the diagonals, whichever way they are
 * listed; bricks in bond, and boxes side by side of one height, are none, as they share an edge at
 * each of their corners. A side is an edge that ends in the point, and one that begins there. */
START_TEST(pairs_of_corners) {
  for (int turned = 0; turned < 2; turned++) {
    block_pile p = {.count = 0};
    pile_add_box(&p, -10, -1, 10, 0, 1, true);
    for (int k = 0; k < 4; k++) {
      const int own = turned == 1 ? 3 - k : k, x = own % 2 == 0 ? -2 : 0, y = own < 2 ? 0 : 3;
      pile_add_box(&p, x, y, x + 2, y + 3, 1, false);
    }
    pile_build(&p);
    const tp_lattice *l = &p.assemblage.lattice;
    ck_assert_int_eq(p.assemblage.pair_count, 2);
    for (int k = 0; k < 2; k++) {
      const tp_corner_pair *pair = p.assemblage.pairs + k;
      ck_assert_int_eq(pair->side[0].block[0] + pair->side[0].block[1], 5);
      ck_assert(tp_lattice_same_point(l, pair->side[0].to, pair->side[0].ends[0]));
      ck_assert(tp_lattice_same_point(l, pair->side[1].from, pair->side[0].ends[0]));
      /* between both the sector turns to the left, by less than 180 degrees */
      ck_assert_int_gt(tp_lattice_cross(l, pair->side[0].from, pair->side[0].to, pair->side[1].from,
                                        pair->side[1].to) *
                           (pair->side[0].block[0] == pair->side[1].block[0] ? 1 : -1),
                       0);
    }
    pile_clear(&p);
  }
  block_pile wall = {.count = 0};
  pile_add_wall(&wall, 4, 3);
  pile_build(&wall);
  ck_assert_int_eq(wall.assemblage.pair_count, 0);
  pile_clear(&wall);
}
END_TEST

SUITE(assemblage) {
  Suite *suite = suite_create("assemblage");
  TCase *tests = tcase_create("limit");
  tcase_set_timeout(tests, 600);
  tcase_add_test(tests, one_block);
  tcase_add_test(tests, published_walls);
  tcase_add_test(tests, slope_of_columns);
  tcase_add_test(tests, worth_of_friction);
  tcase_add_test(tests, stack_of_bricks);
  tcase_add_test(tests, large_wall);
  tcase_add_test(tests, images_of_random_piles);
  tcase_add_test(tests, what_is_no_assemblage);
  tcase_add_test(tests, corners_on_faces);
  tcase_add_test(tests, pairs_of_corners);
  suite_add_tcase(suite, tests);
  return suite;
}
