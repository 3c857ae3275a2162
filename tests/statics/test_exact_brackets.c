/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The greatest load in rationals (assemblage/exact_bracket.h).
 *
 * Where strengths are given as doubles without a bound, the greatest load is one rational, and the
 * bracket that is told is that number rounded down and up. So it has to lie in the bracket that
 * doubles prove, which knows nothing of it, to be two neighbouring doubles, and to be the same pair
 * of the mirror image, of all in another unit, and of ground in two pieces. */

#include "assemblage/exact_bracket.h"
#include "block_pile.h"
#include "random_numbers.h"
#include "suite.h"

#include <math.h>
#include <stdlib.h>

typedef struct image {
  bool mirrored, split;
  long times;
} image;

static void add_random(block_pile *p, uint64_t seed, long courses, const image *how) {
  enum { WIDTH = 12 };
  const long times = how->times, sign = how->mirrored ? -1 : 1;
  random_numbers state = random_numbers_from(seed);
  if (how->split) {
    pile_add_box(p, -100 * times, -times, 5 * times * sign, 0, 1, true);
    pile_add_box(p, 5 * times * sign, -times, 200 * times, 0, 1, true);
  } else {
    pile_add_box(p, -100 * times, -times, 200 * times, 0, 1, true);
  }
  long low = 0;
  for (long c = 0; c < courses; c++) {
    const long high = low + 2 + draw_below(&state, 5);
    for (long from = 0; from < WIDTH;) {
      long to = from + 2 + draw_below(&state, 6);
      if (to > WIDTH - 2) to = WIDTH;
      const long a = times * (how->mirrored ? -to : from), b = times * (how->mirrored ? -from : to);
      pile_add_box(p, a, low * times, b, high * times, 1, false);
      from = to;
    }
    low = high;
  }
}

/* Each joint has the same strength; with cohesion, in the unit of the assemblage. */
static tp_load_bracket narrowed(const block_pile *p, bool left,
                                const tp_contact_strength *strength) {
  static const double share = 1e-6;
  tp_message message = {.text = ""};
  const tp_bracket_aim aim = {.share = share, .enough = INFINITY};
  const tp_weight_loads loads = tp_weight_loads_tilted(left);
  tp_contact_strength *strengths = pile_strengths(p, 0);
  for (long k = 0; k < p->assemblage.contact_count; k++) strengths[k] = *strength;
  tp_force_program program;
  tp_load_bracket b;
  ck_assert_int_eq(tp_force_program_init(&program, &p->assemblage, strengths, &loads, &message),
                   TP_OK);
  ck_assert_int_eq(tp_load_bracket_find(&b, &program, &aim, &message), TP_OK);
  const double held = b.is_held ? b.held : -INFINITY, bound = b.is_bounded ? b.bound : INFINITY;
  ck_assert_int_eq(tp_exact_bracket_narrow(&b, &program, strengths, &loads, &message), TP_OK);
  ck_assert(b.is_held && b.is_bounded);
  ck_assert_msg(b.held >= held && b.bound <= bound, "%.17g to %.17g, not within %.17g to %.17g",
                b.held, b.bound, held, bound);
  tp_force_program_clear(&program);
  free(strengths);
  return b;
}

START_TEST(images_of_random_piles) {
  static const image images[] = {
      {false, false, 1}, {true, false, 1}, {false, true, 1}, {true, true, 7919}};
  static const tp_contact_strength rough = {.tangent = {0.6, 0}};
  static const tp_contact_strength bonded = {{0.6, 0}, {0.25, 0}, {0.0625, 0}};
  enum { IMAGES = sizeof images / sizeof *images };
  for (uint64_t seed = 1; seed <= (uint64_t)rounds(20, 400); seed++) {
    const bool coheres = seed % 3 == 0; /* that has a unit of length: no image in another one */
    double held = 0, bound = 0;
    for (int k = 0; k < IMAGES - (coheres ? 1 : 0); k++) {
      block_pile p = {.count = 0};
      add_random(&p, seed, 2 + (long)(seed % 4), images + k);
      pile_build(&p);
      tp_load_bracket b = narrowed(&p, !images[k].mirrored, coheres ? &bonded : &rough);
      ck_assert_msg(b.held <= b.bound && b.bound <= nextafter(b.held, INFINITY),
                    "seed %d: %.17g to %.17g are no neighbours", (int)seed, b.held, b.bound);
      if (k == 0) {
        held = b.held;
        bound = b.bound;
      }
      ck_assert_msg(b.held == held && b.bound == bound, "seed %d image %d: %.17g, not %.17g",
                    (int)seed, k, b.held, held);
      tp_load_bracket_clear(&b);
      pile_clear(&p);
    }
  }
}
END_TEST

/* A slab slides at its tan(phi), whatever that is of what encloses it; one that is slender topples
 * at a third, which no double is. */
START_TEST(slabs) {
  static const tp_contact_strength enclosed = {.tangent = {0.5, 0.125}};
  block_pile p = {.count = 0};
  pile_add_box(&p, -10, -1, 10, 0, 1, true);
  pile_add_box(&p, 0, 0, 2, 1, 1, false);
  pile_build(&p);
  tp_load_bracket b = narrowed(&p, true, &enclosed);
  ck_assert(b.held == 0.375 && b.bound == 0.625);
  tp_load_bracket_clear(&b);
  pile_clear(&p);
  pile_add_box(&p, -10, -1, 10, 0, 1, true);
  pile_add_box(&p, 0, 0, 1, 3, 1, false);
  pile_build(&p);
  b = narrowed(&p, true, &enclosed);
  ck_assert(fma(3, b.held, -1) < 0 && fma(3, b.bound, -1) > 0);
  ck_assert(b.bound == nextafter(b.held, INFINITY));
  tp_load_bracket_clear(&b);
  pile_clear(&p);
}
END_TEST

SUITE(exact_brackets) {
  Suite *suite = suite_create("exact_brackets");
  TCase *tests = tcase_create("rationals");
  tcase_set_timeout(tests, 300);
  tcase_add_test(tests, images_of_random_piles);
  tcase_add_test(tests, slabs);
  suite_add_tcase(suite, tests);
  return suite;
}
