/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Blocks that fall though all others are fixed, against closed forms of one block and of a row that
 * reaches beyond its ground; in random piles never where forces are proven to hold the load. */

#include "assemblage/falling_group.h"
#include "block_pile.h"
#include "random_numbers.h"
#include "random_runs.h"
#include "rounds.h"
#include "suite.h"

#include <math.h>

static bool falls(const block_pile *p, double tangent, bool left, double load) {
  tp_force_program program;
  bool found = false;
  pile_program(&program, p, tangent, left);
  ck_assert_int_eq(tp_falling_group_find(&found, &program, (tp_near){load, 0}, NULL), TP_OK);
  tp_force_program_clear(&program);
  return found;
}

/* Three velocities are all that one block has: it falls beyond the lesser of tan(phi) and width
 * over height, to either side, and not before. */
START_TEST(one_block) {
  static const double near = 1e-5;
  random_numbers state = random_numbers_from(random_seed());
  for (int k = 0; k < rounds(300, 5000); k++) {
    const long width = 1 + draw_below(&state, 60), height = 1 + draw_below(&state, 60);
    const double tangent = 0.01 + 3 * draw_part(&state);
    block_pile p = {.count = 0};
    pile_add_box(&p, -100, -1, 100, 0, 1, true);
    pile_add_box(&p, 0, 0, width, height, 1, false);
    pile_build(&p);
    const double limit = fmin(tangent, (double)width / (double)height);
    for (int left = 0; left < 2; left++) {
      ck_assert_msg(falls(&p, tangent, left == 1, limit * (1 + near)), "%ld x %ld, %.17g", width,
                    height, tangent);
      ck_assert(falls(&p, tangent, left == 1, 3 * limit));
      ck_assert(falls(&p, tangent, left == 1, -limit * (1 + near)));
      ck_assert(!falls(&p, tangent, left == 1, limit * (1 - near)));
      ck_assert(!falls(&p, tangent, left == 1, -limit * (1 - near)));
      ck_assert(!falls(&p, tangent, left == 1, 0));
    }
    pile_clear(&p);
  }
}
END_TEST

/* A row of boxes with the width a and the height h, of which `hanging` reach beyond the ground,
 * tilted towards the ground by tan(tilt) = s: the k farthest are pressed to the rest with k s times
 * the weight of a box, by a force no higher than the top, and their weight is at k a / 2. With any
 * friction they are held where k s h / 2 >= k (k a / 2), so that all are where s >= n a / h; with
 * tan(phi) only where s tan(phi) >= 1 besides. */
START_TEST(beyond_the_ground) {
  enum { HELD = 3, MOST = 6 };
  static const double near = 1e-3, strong = 1e3;
  for (long hanging = 1; hanging <= MOST; hanging++) {
    for (long height = 1; height <= 40; height += 3) {
      block_pile p = {.count = 0};
      const long width = 4;
      pile_add_box(&p, -width, -1, HELD * width, 0, 1, true);
      pile_add_box(&p, -width, 0, 0, 2 * height, 1, true); /* which keeps the row from sliding */
      for (long k = 0; k < HELD + hanging; k++) {
        pile_add_box(&p, k * width, 0, (k + 1) * width, height, 1, false);
      }
      pile_build(&p);
      const double limit = (double)(hanging * width) / (double)height;
      ck_assert(falls(&p, strong, true, limit * (1 - near)));
      ck_assert(!falls(&p, strong, true, limit * (1 + near)));
      ck_assert(falls(&p, 1 / (limit * (1 + 2 * near)), true, limit * (1 + near)));
      ck_assert(falls(&p, strong, true, 0));
      ck_assert(falls(&p, strong, false, 0.1));
      pile_clear(&p);
    }
  }
}
END_TEST

/* Boxes in courses, each course pushed sideways; some hang over, or out of the wall. */
static void add_random(block_pile *p, random_numbers *state) {
  enum { COURSES = 4, WIDTH = 18 };
  pile_add_box(p, 0, -1, WIDTH, 0, 1, true);
  for (long c = 0; c < COURSES; c++) {
    const long shift = draw_below(state, 9) - 4;
    for (long from = 0; from < WIDTH;) {
      long to = from + 2 + draw_below(state, 6);
      if (to > WIDTH - 2) to = WIDTH;
      pile_add_box(p, from + shift, 3 * c, to + shift, 3 * (c + 1), 1, false);
      from = to;
    }
  }
}

/* What is said to fall is held by no forces: the bracket of the interior point method, which is
 * proven by other means, never holds such a load. Some fall, and some do not. */
START_TEST(random_piles) {
  int fallen = 0, held = 0;
  random_numbers state = random_numbers_from(random_seed());
  for (int k = 0; k < rounds(60, 2000); k++) {
    block_pile p = {.count = 0};
    add_random(&p, &state);
    tp_message message;
    if (pile_assemble(&p, &message) == TP_OK) { /* else a block touches no other */
      const double tangent = 0.1 + 1.5 * draw_part(&state);
      const bool left = draw_below(&state, 2) == 0;
      tp_load_bracket b = pile_limit(&p, tangent, left, 1e-6);
      for (int n = 0; n < 8; n++) {
        const double load = n == 0 && b.is_held ? b.held : 2 * draw_part(&state) - 1;
        const bool own = falls(&p, tangent, left, load);
        const bool is_held = b.is_held && load <= b.held && load >= 0;
        fallen += own;
        held += is_held && !own;
        /* a bracket says of lesser loads nothing but where one the other way is held, too */
        if (n == 0 && b.is_held) ck_assert_msg(!own, "pile %d: falls at %.17g", k, load);
      }
      tp_load_bracket_clear(&b);
    }
    pile_clear(&p);
  }
  ck_assert_int_gt(fallen, 10);
  ck_assert_int_gt(held, 10);
}
END_TEST

SUITE(falling_group) {
  Suite *suite = suite_create("falling_group");
  TCase *tests = tcase_create("proofs");
  tcase_set_timeout(tests, 600);
  tcase_add_test(tests, one_block);
  tcase_add_test(tests, beyond_the_ground);
  tcase_add_test(tests, random_piles);
  suite_add_tcase(suite, tests);
  return suite;
}
