/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A virtual motion that excludes every motion is found where nothing moves, and only there.
 *
 * The search by modes decides small piles; so random ones are asked both ways, of one incline and
 * friction and of intervals, to either side. A box has a closed form: it stands below the lesser of
 * its friction and its width over its height. */

#include "block_pile.h"
#include "contact_modes/exclusion.h"
#include "contact_modes/virtual_motion.h"
#include "linear_program/margins.h"
#include "random_numbers.h"
#include "rounds.h"
#include "suite.h"

#include <stdlib.h>

typedef struct scene {
  block_pile pile;
  tp_resting resting;
  tp_arranged arranged;
  tp_contact_strength *strengths;
  tp_near *friction[2], *none, *loads[2], *central, *rows;
  tp_mode_set *left;
  bool to_the_left;
} scene;

static void prepare(scene *s, bool to_the_left) {
  tp_message message = {.text = ""};
  pile_build(&s->pile);
  const tp_assemblage *a = &s->pile.assemblage;
  s->to_the_left = to_the_left;
  s->strengths = calloc((size_t)a->contact_count + 1, sizeof *s->strengths);
  ck_assert_int_eq(tp_resting_init(&s->resting, a, s->strengths, &message), TP_OK);
  ck_assert_int_eq(tp_arranged_init(&s->arranged, &s->resting, to_the_left, &message), TP_OK);
  const size_t contacts = (size_t)s->resting.contact_count + (size_t)a->contact_count + 1;
  const size_t rows = (size_t)s->resting.rows;
  for (int k = 0; k < 2; k++) {
    s->friction[k] = calloc(contacts, sizeof *s->friction[k]);
    s->loads[k] = calloc(rows, sizeof *s->loads[k]);
  }
  s->none = calloc(contacts, sizeof *s->none);
  s->central = calloc(rows, sizeof *s->central);
  s->rows = calloc(rows, sizeof *s->rows);
  s->left = calloc(contacts, sizeof *s->left);
}

static void clear(scene *s) {
  tp_arranged_clear(&s->arranged);
  tp_resting_clear(&s->resting);
  free(s->strengths);
  for (int k = 0; k < 2; k++) {
    free(s->friction[k]);
    free(s->loads[k]);
  }
  free(s->none);
  free(s->central);
  free(s->rows);
  free(s->left);
  pile_clear(&s->pile);
}

/* Weights at inclines, and tangents of friction, each between two. */
static tp_modes_question ask(scene *s, const double incline[2], const double tangent[2]) {
  const tp_weight_loads weights = tp_weight_loads_tilted(s->to_the_left);
  tp_message message = {.text = ""};
  bool weights_alone = false;
  for (int k = 0; k < 2; k++) {
    for (long c = 0; c < s->resting.contact_count; c++) {
      s->friction[k][c] = (tp_near){tangent[k], 0};
    }
    ck_assert_int_eq(tp_resting_loads(s->rows, s->central, &weights_alone, &s->resting, &weights,
                                      (tp_near){incline[k], 0}, s->none, &message),
                     TP_OK);
    tp_arranged_loads(s->loads[k], &s->arranged, s->central);
  }
  ck_assert(weights_alone);
  return (tp_modes_question){.resting = &s->arranged.resting,
                             .friction = {s->friction[0], s->friction[1]},
                             .cohesion = {s->none, s->none},
                             .loads = {s->loads[0], s->loads[1]},
                             .load_count = incline[1] > incline[0] ? 2 : 1,
                             .weights_alone = weights_alone};
}

static bool stands(const scene *s, const tp_modes_question *q) {
  tp_virtual_known known = {.count = 0};
  tp_message message = {.text = ""};
  bool proven = false;
  ck_assert_int_eq(tp_virtual_motion_find(&proven, &known, &s->arranged, q, &message), TP_OK);
  tp_virtual_known_clear(&known);
  return proven;
}

/* Courses of boxes, the upper ones within those below. */
static void build(scene *s, random_numbers *r) {
  *s = (scene){.pile = {.count = 0}};
  pile_add_box(&s->pile, -100, -1, 100, 0, 1, true);
  const long courses = 1 + draw_below(r, 3);
  long from = 0, to = 4 + draw_below(r, 5), low = 0;
  for (long k = 0; k < courses && to - from > 1; k++) {
    const long high = low + 1 + draw_below(r, 2);
    const long joint = draw_below(r, 2) == 0 ? to : from + 1 + draw_below(r, to - from - 1);
    pile_add_box(&s->pile, from, low, joint, high, 1, false);
    if (joint < to) pile_add_box(&s->pile, joint, low, to, high, 1, false);
    from += draw_below(r, 2);
    to -= draw_below(r, 2);
    low = high;
  }
  prepare(s, draw_below(r, 2) == 0);
}

START_TEST(agrees_with_modes) {
  enum { ASKED = 4 };
  static const long plenty = 20000000;
  random_numbers r = random_numbers_from(59);
  long asked = 0, proven = 0, by_modes = 0;
  const long piles = rounds(40, 400);
  for (long n = 0; n < piles; n++) {
    scene s;
    build(&s, &r);
    for (int k = 0; k < ASKED; k++) {
      const double incline = draw_part(&r), tangent = 0.9 * draw_part(&r) + 0.05;
      const double inclines[] = {incline, incline + (k % 2) * 0.02 * draw_part(&r)};
      const double tangents[] = {tangent, tangent * (1 + (k / 2) * draw_part(&r))};
      const tp_modes_question q = ask(&s, inclines, tangents);
      tp_message message = {.text = ""};
      tp_exclusion e = {.most_work = plenty, .left = s.left};
      ck_assert_int_eq(tp_exclusion_find(&e, &q, &message), TP_OK);
      const bool by_motion = stands(&s, &q), is_decided = e.is_proven || e.has_left;
      ck_assert_msg(!by_motion || e.is_proven || !is_decided, "pile %ld, incline %g, tangent %g", n,
                    incline, tangent);
      ck_assert(!by_motion || incline < tangent);
      asked++;
      proven += by_motion;
      by_modes += e.is_proven;
    }
    clear(&s);
  }
  ck_assert_msg(proven > 0.8 * (double)by_modes && by_modes > asked / 10, "%ld of %ld of %ld",
                proven, by_modes, asked);
}
END_TEST

START_TEST(box) {
  static const double near = 0.02;
  for (int k = 0; k < 8; k++) {
    const bool slides = k % 2 == 0, to_the_left = k / 2 % 2 == 0;
    const double limit = 0.5; /* by its friction, or its shape */
    scene s = {.pile = {.count = 0}};
    pile_add_box(&s.pile, -100, -1, 100, 0, 1, true);
    pile_add_box(&s.pile, 0, 0, slides ? 6 : 2, 4, 1, false);
    prepare(&s, to_the_left);
    const double tangent[] = {slides ? limit : 0.8, slides ? limit : 0.8};
    for (int above = 0; above < 2; above++) {
      const double incline = limit * (above ? 1 + near : 1 - near);
      const double wide = k / 4 == 0 ? 0 : 0.2;
      const double inclines[] = {incline - wide, incline};
      const tp_modes_question q = ask(&s, inclines, tangent);
      ck_assert_int_eq(stands(&s, &q), above == 0);
    }
    clear(&s);
  }
}
END_TEST

/* x in 0 ... 1 has a margin, y = 0, given by two inequalities, has none; x = z. */
START_TEST(margins) {
  static const long first[] = {0, 1, 2, 3, 4}, column[] = {0, 0, 1, 1};
  static const double entry[] = {1, -1, 1, -1}, constant[] = {-1, 0, 0, 0};
  static const long first_equation[] = {0, 2}, columns[] = {0, 2};
  static const double entries[] = {1, -1}, constants[] = {0};
  static const bool wants[] = {true, true, true, true};
  const tp_margin_program program = {.columns = 3,
                                     .rows = {4, first, column, entry, constant},
                                     .equations = {1, first_equation, columns, entries, constants},
                                     .wants_margin = wants,
                                     .most = 0.25,
                                     .most_work = 1e6};
  double x[3], margin[4];
  bool found = false;
  ck_assert(tp_margins_find(&found, x, margin, &program));
  ck_assert(found && margin[0] > 0.24 && margin[1] > 0.24 && margin[2] < 1e-4 && margin[3] < 1e-4);
  ck_assert(x[0] > 0.24 && x[0] < 0.76 && fabs(x[1]) < 1e-4 && fabs(x[2] - x[0]) < 1e-4);
}
END_TEST

SUITE(virtual_motion) {
  Suite *suite = suite_create("virtual_motion");
  TCase *tests = tcase_create("virtual motions");
  tcase_set_timeout(tests, 1200);
  tcase_add_test(tests, margins);
  tcase_add_test(tests, box);
  tcase_add_test(tests, agrees_with_modes);
  suite_add_tcase(suite, tests);
  return suite;
}
