/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* An exclusion of all motions that may not work is undecided.
 *
 * Branch and bound proves that no motion can begin when nothing is left to divide. Where its work
 * is spent nothing is divided either, from the first node on: taken for a proof, that made every
 * pile of blocks stand that was too large for it. So blocks on an incline of tan 0.4, which their
 * friction of 0.5 holds, and on one of 0.6, on which they slide, are asked with any work from none
 * to plenty. */

#include "block_pile.h"
#include "contact_modes/exclusion.h"
#include "suite.h"

#include <stdlib.h>

static const double tangent = 0.5;

/* Boxes 2 by 1 in a pile, on the ground; beside it as many that do not touch it. */
static void build(block_pile *p, long high, long piles) {
  *p = (block_pile){.count = 0};
  pile_add_box(p, -100, -1, 100, 0, 1, true);
  for (long n = 0; n < piles; n++) {
    for (long k = 0; k < high; k++) pile_add_box(p, 10 * n, k, 10 * n + 2, k + 1, 1, false);
  }
  pile_build(p);
}

typedef struct asked {
  tp_exclusion found;
  bool slides; /* in the one combination of modes that is left a contact slips */
} asked;

/* Of the pile on an incline, towards -x, with so much work. */
static asked exclude(const block_pile *p, double incline, long most_work) {
  bool weights_alone = false;
  tp_message message = {.text = ""};
  tp_resting r;
  const size_t count = (size_t)p->assemblage.contact_count + 1;
  tp_contact_strength *strengths = calloc(count, sizeof *strengths);
  tp_near *friction = calloc(count, sizeof *friction), *none = calloc(count, sizeof *none);
  tp_mode_set *left = calloc(count, sizeof *left);
  ck_assert(strengths != NULL && friction != NULL && none != NULL && left != NULL);
  for (size_t k = 0; k < count; k++) {
    strengths[k].tangent = friction[k] = (tp_near){tangent, 0};
  }
  ck_assert_int_eq(tp_resting_init(&r, &p->assemblage, strengths, &message), TP_OK);
  ck_assert_int_eq(r.contact_count, p->assemblage.contact_count);
  tp_near *loads = calloc((size_t)r.rows, sizeof *loads);
  tp_near *central = calloc((size_t)r.rows, sizeof *central);
  ck_assert(loads != NULL && central != NULL);
  const tp_weight_loads weights = tp_weight_loads_tilted(true);
  const tp_near live = {incline, 0};
  ck_assert_int_eq(
      tp_resting_loads(loads, central, &weights_alone, &r, &weights, live, none, &message), TP_OK);
  const tp_modes_question q = {.resting = &r,
                               .friction = {friction, friction},
                               .cohesion = {none, none},
                               .loads = {loads},
                               .load_count = 1};
  asked own = {.found = {.most_work = most_work, .left = left}};
  ck_assert_int_eq(tp_exclusion_find(&own.found, &q, &message), TP_OK);
  for (long k = 0; k < r.contact_count && own.found.has_left; k++) {
    own.slides = own.slides || (left[k] & (TP_MODES_FORWARD | TP_MODES_BACK)) != 0;
  }
  own.found.left = NULL;
  tp_resting_clear(&r);
  free(strengths);
  free(friction);
  free(none);
  free(left);
  free(loads);
  free(central);
  return own;
}

/* With none, or one entry, of which the first linear program takes more: undecided either way. With
 * all that it asks for, the truth. With any share of that a proof is told of what stands alone. */
static void ask(long high, long piles) {
  static const long plenty = 100000000;
  static const double stands = 0.4, slides = 0.6;
  block_pile p;
  build(&p, high, piles);
  for (int moves = 0; moves < 2; moves++) {
    const double incline = moves == 1 ? slides : stands;
    for (long little = 0; little < 2; little++) {
      const asked none = exclude(&p, incline, little);
      ck_assert_msg(!none.found.is_proven && !none.found.has_left, "%ld high, %g", high, incline);
    }
    const asked all = exclude(&p, incline, plenty);
    ck_assert_int_eq(all.found.is_proven, moves == 0);
    ck_assert_int_eq(all.slides, moves == 1);
    ck_assert(all.found.work > 1 && all.found.work < plenty);
    enum { SHARES = 16 };
    for (long k = 1; k <= SHARES; k++) {
      const asked some = exclude(&p, incline, all.found.work / SHARES * k);
      ck_assert_msg(moves == 0 || !some.found.is_proven, "%ld high, %ld", high, k);
    }
  }
  pile_clear(&p);
}

START_TEST(one_box) {
  ask(1, 1);
}
END_TEST

START_TEST(boxes_upon_each_other) {
  ask(3, 1);
}
END_TEST

/* Each pile is excluded by itself: what is spent on the first is not there for the second. */
START_TEST(piles_apart) {
  ask(2, 2);
}
END_TEST

SUITE(exclusion) {
  Suite *suite = suite_create("exclusion");
  TCase *tests = tcase_create("work");
  tcase_set_timeout(tests, 600);
  tcase_add_test(tests, one_box);
  tcase_add_test(tests, boxes_upon_each_other);
  tcase_add_test(tests, piles_apart);
  suite_add_tcase(suite, tests);
  return suite;
}
