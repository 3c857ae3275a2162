/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A proof that is known of one tilt is no proof of another until it is proven there.
 *
 * How far blocks stand is searched in steps, each an exclusion of all motions. What one has found
 * is given to the next: taken as it is, it would let blocks stand at any tilt. So random piles are
 * asked at inclines that grow and fall by random steps, with friction and inclines of one number
 * and between two, by searches that know what those before have found, and by others that know
 * nothing. Those that end must tell the same; and of blocks on an incline that is steeper than
 * their friction, which slide, none may tell that they stand. What is known spares most of the
 * work. */

#include "block_pile.h"
#include "contact_modes/exclusion.h"
#include "contact_modes/renewing.h"
#include "random_numbers.h"
#include "suite.h"

#include <limits.h>
#include <stdlib.h>

enum { MOST_BOXES = 4 };

typedef struct scene {
  block_pile pile;
  tp_resting resting;
  tp_contact_strength *strengths;
  tp_near *friction[2], *none, *loads[2], *central;
  tp_mode_set *left;
} scene;

typedef struct account {
  long asked, proven, other_proven, slides;
  double known_work, other_work;
} account;

/* A course of two or three boxes on the ground, and one upon them, within them or beyond. */
static void build(scene *s, random_numbers *r) {
  tp_message message = {.text = ""};
  *s = (scene){.pile = {.count = 0}};
  pile_add_box(&s->pile, -100, -1, 100, 0, 1, true);
  const long count = 2 + draw_below(r, MOST_BOXES - 2), high = 1 + draw_below(r, 3);
  long at = 0;
  for (long k = 0; k < count; k++) {
    const long width = 1 + draw_below(r, 4);
    pile_add_box(&s->pile, at, 0, at + width, high, 1, false);
    at += width;
  }
  if (draw_below(r, 2) == 0) {
    const long left = draw_below(r, at - 1);
    pile_add_box(&s->pile, left, high, left + 1 + draw_below(r, 3), high + 1, 1, false);
  }
  pile_build(&s->pile);
  const tp_assemblage *a = &s->pile.assemblage;
  s->strengths = calloc((size_t)a->contact_count + 1, sizeof *s->strengths);
  ck_assert_int_eq(tp_resting_init(&s->resting, a, s->strengths, &message), TP_OK);
  const size_t contacts = (size_t)s->resting.contact_count + (size_t)a->contact_count + 1;
  for (int k = 0; k < 2; k++) {
    s->friction[k] = calloc(contacts, sizeof *s->friction[k]);
    s->loads[k] = calloc((size_t)s->resting.rows, sizeof *s->loads[k]);
  }
  s->none = calloc(contacts, sizeof *s->none);
  s->central = calloc((size_t)s->resting.rows, sizeof *s->central);
  s->left = calloc(contacts, sizeof *s->left);
}

static void clear(scene *s) {
  tp_resting_clear(&s->resting);
  free(s->strengths);
  for (int k = 0; k < 2; k++) {
    free(s->friction[k]);
    free(s->loads[k]);
  }
  free(s->none);
  free(s->central);
  free(s->left);
  pile_clear(&s->pile);
}

static tp_exclusion exclude(const scene *s, const tp_modes_question *q, tp_known_proofs *known) {
  static const long plenty = 5000000;
  tp_message message = {.text = ""};
  tp_exclusion e = {.most_work = plenty, .left = s->left, .known = known};
  ck_assert_int_eq(tp_exclusion_find(&e, q, &message), TP_OK);
  return e;
}

/* ---- what is renewed ---------------------------------------------------------------------------
 */

/* By proof, what it refutes now: a nogood, or none. */
static long *renew(tp_nogoods *nogoods, const scene *s, const tp_modes_question *q,
                   tp_known_proofs *known) {
  tp_message message = {.text = ""};
  tp_modes_node room;
  long work = 0;
  bool *none = calloc((size_t)s->resting.rows / 3 + 1, sizeof *none);
  long *number = calloc((size_t)known->count + 1, sizeof *number);
  ck_assert(none != NULL && number != NULL && tp_modes_node_init(&room, &s->resting));
  ck_assert(tp_nogoods_init(nogoods, &s->resting));
  ck_assert_int_eq(tp_known_proofs_renew(known, nogoods, &room, &work, LONG_MAX, q, none, &message),
                   TP_OK);
  for (long k = 0; k < known->count; k++) number[k] = known->all[k].nogood;
  tp_modes_node_clear(&room);
  free(none);
  return number;
}

static bool is_part(const tp_modes_node *own, const tp_modes_node *of, const tp_resting *r) {
  bool is = true;
  for (long k = 0; k < r->contact_count; k++) is = is && (own->sets[k] & ~of->sets[k]) == 0;
  return is;
}

/* Of two loads a proof by forces refutes no more than of each; and only where blocks rest that did.
 */
static void check_renewed(const scene *s, const tp_modes_question *q, tp_known_proofs *known) {
  tp_nogoods of[3]; /* of both loads, of each */
  long *number[3];
  tp_modes_node own, each;
  ck_assert(tp_modes_node_init(&own, &s->resting) && tp_modes_node_init(&each, &s->resting));
  for (int n = 0; n < 3; n++) {
    tp_modes_question one = *q;
    if (n > 0) one.load_count = 1;
    if (n > 0) one.loads[0] = q->loads[n - 1];
    number[n] = renew(of + n, s, &one, known);
  }
  for (long k = 0; k < known->count; k++) {
    if (!known->all[k].by_forces || number[0][k] < 0) continue;
    tp_nogoods_take(&own, of, number[0][k]);
    for (long b = 0; b < s->resting.rows / 3; b++) {
      ck_assert(own.still[b] || !known->all[k].node.still[b]);
    }
    for (int n = 1; n < 3; n++) {
      ck_assert_int_ge(number[n][k], 0);
      tp_nogoods_take(&each, of + n, number[n][k]);
      ck_assert(is_part(&own, &each, &s->resting));
    }
  }
  for (int n = 0; n < 3; n++) {
    tp_nogoods_clear(of + n);
    free(number[n]);
  }
  tp_modes_node_clear(&own);
  tp_modes_node_clear(&each);
}

/* ---- what is told ------------------------------------------------------------------------------
 */

/* At an incline, or from there on up to a steeper one; friction is of one number, or more. */
static void ask(scene *s, account *seen, tp_known_proofs *known, double incline, double wide,
                random_numbers *r) {
  static const double rough = 0.5;
  const double tangent = rough + 0.05 * draw_part(r);
  const tp_weight_loads weights = tp_weight_loads_tilted(true);
  tp_message message = {.text = ""};
  bool weights_alone = false;
  for (int k = 0; k < 2; k++) {
    const double more = k * wide;
    const tp_near live = {incline + more, 0};
    for (long c = 0; c < s->resting.contact_count; c++) {
      s->friction[k][c] = (tp_near){tangent + more, 0};
    }
    ck_assert_int_eq(tp_resting_loads(s->loads[k], s->central, &weights_alone, &s->resting,
                                      &weights, live, s->none, &message),
                     TP_OK);
  }
  const tp_modes_question q = {.resting = &s->resting,
                               .friction = {s->friction[0], s->friction[1]},
                               .cohesion = {s->none, s->none},
                               .loads = {s->loads[0], s->loads[1]},
                               .load_count = wide > 0 ? 2 : 1};
  if (wide > 0) check_renewed(s, &q, known);
  const tp_exclusion own = exclude(s, &q, known), other = exclude(s, &q, NULL);
  const double steepest = incline + wide;
  const bool both_end = own.work <= own.most_work && other.work <= other.most_work;
  ck_assert(!both_end || own.is_proven == other.is_proven);
  ck_assert(steepest < tangent || !own.is_proven);
  seen->asked++;
  seen->proven += own.is_proven;
  seen->other_proven += other.is_proven;
  seen->slides += steepest >= tangent;
  seen->known_work += (double)own.work;
  seen->other_work += (double)other.work;
}

START_TEST(as_if_nothing_were_known) {
  enum { PILES = 30, STEPS = 5 };
  random_numbers r = random_numbers_from(35);
  account seen = {.asked = 0};
  for (long n = 0; n < PILES; n++) {
    scene s;
    tp_known_proofs known;
    tp_message message = {.text = ""};
    build(&s, &r);
    ck_assert_int_eq(tp_known_proofs_init(&known, &s.resting, &message), TP_OK);
    double incline = 0.5 * draw_part(&r);
    for (int k = 0; k < STEPS; k++) {
      ask(&s, &seen, &known, incline, 0, &r);
      ask(&s, &seen, &known, incline, 0.2 * draw_part(&r), &r);
      incline += 0.15 * (draw_part(&r) - 0.3);
    }
    tp_known_proofs_clear(&known);
    clear(&s);
  }
  ck_assert_msg(seen.proven > seen.asked / 5 && seen.slides > seen.asked / 5, "%ld, %ld of %ld",
                seen.proven, seen.slides, seen.asked);
  ck_assert_int_ge(seen.proven, seen.other_proven);
  ck_assert_msg(seen.known_work < 0.75 * seen.other_work, "%g of %g", seen.known_work,
                seen.other_work);
}
END_TEST

SUITE(known_proofs) {
  Suite *suite = suite_create("known_proofs");
  TCase *tests = tcase_create("inclines");
  tcase_set_timeout(tests, 300);
  tcase_add_test(tests, as_if_nothing_were_known);
  suite_add_tcase(suite, tests);
  return suite;
}
