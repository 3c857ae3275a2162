/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What is refuted in one branch is known in all others.
 *
 * A branch and bound that draws a wrong conclusion from what it has refuted lets blocks stand that
 * can move. So nogoods are drawn at random, and the search is led at random over a few boxes:
 * contacts are narrowed, all that follows is found, and where nothing is left the refutation is
 * explained as one of the node that it began with. Of every single combination of modes of that
 * node it must be true: no contact has it by the nogoods alone, each asked one by one. And what the
 * search finds with its watching it must find as if it asked all of them again and again; what it
 * takes back must be as it was. */

#include "block_pile.h"
#include "contact_modes/corner_modes.h"
#include "contact_modes/settling.h"
#include "random_numbers.h"
#include "suite.h"

#include <stdlib.h>
#include <string.h>

enum { NOGOODS = 10 };

typedef struct scene {
  block_pile pile;
  tp_resting resting;
  tp_contact_strength *strengths;
  bool *none;           /* blocks at rest: none */
  tp_nogoods nogoods;   /* that the search has */
  tp_nogoods originals; /* without what it learns */
} scene;

/* Boxes on the ground: two and one upon the second, that meets a corner of the first; or two side
 * by side, that rest while a third one may move. */
static void build(scene *s, bool has_corners) {
  tp_message message = {.text = ""};
  *s = (scene){.pile = {.count = 0}};
  pile_add_box(&s->pile, -100, -1, 100, 0, 1, true);
  pile_add_box(&s->pile, 0, 0, 2, 1, 1, false);
  if (has_corners) {
    pile_add_box(&s->pile, 2, 1, 5, 2, 1, false);
    pile_add_box(&s->pile, 3, 0, 4, 1, 1, false);
  } else {
    pile_add_box(&s->pile, 2, 0, 5, 2, 1, false);
    pile_add_box(&s->pile, 9, 0, 10, 1, 1, false);
  }
  pile_build(&s->pile);
  const tp_assemblage *a = &s->pile.assemblage;
  s->strengths = calloc((size_t)a->contact_count + 1, sizeof *s->strengths);
  ck_assert_int_eq(tp_resting_init(&s->resting, a, s->strengths, &message), TP_OK);
  s->none = calloc((size_t)s->resting.rows / 3 + 1, sizeof *s->none);
  ck_assert_int_eq(s->resting.contact_count, has_corners ? 3 + 2 : 4);
  ck_assert(tp_nogoods_init(&s->nogoods, &s->resting));
  ck_assert(tp_nogoods_init(&s->originals, &s->resting));
}

static void clear(scene *s) {
  tp_nogoods_clear(&s->nogoods);
  tp_nogoods_clear(&s->originals);
  tp_resting_clear(&s->resting);
  free(s->strengths);
  free(s->none);
  pile_clear(&s->pile);
}

static void add(tp_nogoods *to, const tp_modes_node *node) {
  tp_message message = {.text = ""};
  ck_assert_int_eq(tp_nogoods_add(to, node, &message), TP_OK);
}

/* Any, or those of one slip; or rest alone, so that blocks come to rest. */
static tp_mode_set draw_set(random_numbers *r) {
  static const tp_mode_set kinds[] = {
      TP_MODES_STICK, TP_MODES_FORWARD, TP_MODES_BACK, 1, 2, 128, 128};
  enum { KINDS = sizeof kinds / sizeof kinds[0] };
  if (draw_below(r, 2) == 0) return (tp_mode_set)draw_below(r, 1024);
  return kinds[draw_below(r, KINDS)] | (draw_below(r, 2) == 0 ? kinds[draw_below(r, KINDS)] : 0);
}

/* All modes of most contacts, some of the others; sometimes that a block rests. */
static void draw_nogoods(scene *s, random_numbers *r) {
  tp_modes_node own;
  ck_assert(tp_modes_node_init(&own, &s->resting));
  for (long n = 0; n < NOGOODS; n++) {
    tp_modes_node_widen(&own, &s->resting);
    for (long k = 0; k < s->resting.contact_count; k++) {
      if (draw_below(r, 2) > 0) own.sets[k] &= draw_set(r);
    }
    if (draw_below(r, 2) == 0) own.still[draw_below(r, s->resting.rows / 3)] = true;
    add(&s->nogoods, &own);
    add(&s->originals, &own);
  }
  tp_modes_node_clear(&own);
}

/* ---- by asking all, again and again ------------------------------------------------------------
 */

static bool is_within(const tp_modes_node *n, const tp_nogood_term *t) {
  if (t->block >= 0) return n->still[t->block];
  return (n->sets[t->contact] & ~(tp_mode_set)t->own) == 0 &&
         (t->twin < 0 || (n->sets[t->twin] & ~(tp_mode_set)t->of_twin) == 0);
}

/* False: refuted. */
static bool settle_plainly(tp_search_state *state, const scene *s, const tp_nogoods *of) {
  tp_modes_node room;
  tp_nogoods empty;
  long work = 0;
  bool left = true;
  ck_assert(tp_modes_node_init(&room, &s->resting) && tp_nogoods_init(&empty, &s->resting));
  for (bool changed = true; changed && left;) {
    left = tp_search_settle(&room, &work, state, &empty);
    changed = false;
    for (long n = 0; n < of->count && left; n++) {
      const long end = n + 1 < of->count ? of->all[n + 1].terms : of->term_count;
      const tp_nogood_term *beyond = NULL;
      int count = 0;
      for (long k = of->all[n].terms; k < end; k++) {
        if (is_within(&state->node, of->terms + k)) continue;
        beyond = of->terms + k;
        count++;
      }
      left = count > 0;
      if (count != 1 || beyond->block >= 0) continue;
      changed = tp_search_narrow(state, beyond->contact, ~(tp_mode_set)beyond->own,
                                 ~(tp_mode_set)beyond->of_twin, n) ||
                changed;
    }
  }
  tp_modes_node_clear(&room);
  tp_nogoods_clear(&empty);
  return left;
}

/* ---- of every combination of modes -------------------------------------------------------------
 */

/* Of contacts from k on, those before have one mode. */
static void refute_each(const scene *s, tp_search_state *state, const tp_modes_node *refuted,
                        long k) {
  const tp_resting *r = &s->resting;
  const long mark = state->count;
  if (k == r->contact_count) {
    ck_assert(!settle_plainly(state, s, &s->originals));
    tp_search_undo(state, mark);
    return;
  }
  if (tp_modes_is_second_side(r, k)) {
    refute_each(s, state, refuted, k + 1);
    return;
  }
  const long twin = r->contacts[k].twin;
  for (tp_mode_set bit = 1; bit < 1024; bit *= 2) {
    for (int side = 0; side < (twin >= 0 ? 2 : 1); side++) {
      if ((refuted->sets[side == 0 ? k : twin] & bit) == 0) continue;
      tp_search_narrow(state, k, side == 0 ? bit : 0, side == 0 ? 0 : bit, TP_REASON_DECIDED);
      refute_each(s, state, refuted, k + 1);
      tp_search_undo(state, mark);
    }
  }
}

static void check_refuted(const scene *s, const tp_modes_node *refuted) {
  tp_search_state state;
  ck_assert(tp_search_state_init(&state, &s->resting, refuted->still));
  refute_each(s, &state, refuted, 0);
  tp_search_state_clear(&state);
}

/* ---- a search ----------------------------------------------------------------------------------
 */

/* A contact has some of its modes only. */
static void decide(tp_search_state *state, const scene *s, random_numbers *r) {
  const long k = draw_below(r, s->resting.contact_count);
  const tp_mode_set rest = s->resting.contacts[k].ends == 1 ? 2 : 128;
  const tp_mode_set own = draw_below(r, 3) == 0 ? rest : draw_set(r), other = draw_set(r);
  if (tp_modes_is_second_side(&s->resting, k)) return;
  const long twin = s->resting.contacts[k].twin;
  const bool leaves_some =
      (state->node.sets[k] & own) != 0 || (twin >= 0 && (state->node.sets[twin] & other) != 0);
  if (leaves_some) tp_search_narrow(state, k, own, other, TP_REASON_DECIDED);
}

static bool is_part(const tp_modes_node *n, const tp_modes_node *of, const tp_resting *r) {
  for (long k = 0; k < r->contact_count; k++) {
    if ((n->sets[k] & ~of->sets[k]) != 0) return false;
  }
  for (long b = 0; b < r->rows / 3; b++) {
    if (of->still[b] && !n->still[b]) return false;
  }
  return true;
}

static void copy(tp_modes_node *own, const tp_modes_node *from, const tp_resting *r) {
  memcpy(own->sets, from->sets, (size_t)r->contact_count * sizeof *own->sets);
  memcpy(own->still, from->still, (size_t)(r->rows / 3) * sizeof *own->still);
}

/* Decisions until nothing is left, from the state as it is; that becomes a nogood. True where
 * something is left of the state itself, with that. */
static bool descend(scene *s, tp_search_state *state, random_numbers *r, tp_modes_node *refuted) {
  enum { MOST = 12 };
  const long mark = state->count, known = s->nogoods.count;
  tp_modes_node before;
  tp_search_state plain;
  long work = 0;
  bool left = true;
  ck_assert(tp_modes_node_init(&before, &s->resting));
  copy(&before, &state->node, &s->resting);
  for (int k = 0; k < MOST && left; k++) {
    decide(state, s, r);
    const long decided = state->count;
    ck_assert(tp_search_state_init(&plain, &s->resting, state->node.still));
    copy(&plain.node, &state->node, &s->resting);
    left = tp_search_settle(refuted, &work, state, &s->nogoods);
    ck_assert_int_eq(left, settle_plainly(&plain, s, &s->nogoods));
    if (left) {
      ck_assert(is_part(&state->node, &plain.node, &s->resting));
      ck_assert(is_part(&plain.node, &state->node, &s->resting));
    } else {
      tp_search_explain(refuted, state, &s->nogoods, decided);
      ck_assert(is_part(&state->node, refuted, &s->resting));
      check_refuted(s, refuted);
      add(&s->nogoods, refuted);
    }
    tp_search_state_clear(&plain);
  }
  tp_search_undo(state, mark);
  state->asked = known;
  ck_assert(is_part(&state->node, &before, &s->resting));
  ck_assert(is_part(&before, &state->node, &s->resting));
  tp_modes_node_clear(&before);
  return tp_search_settle(refuted, &work, state, &s->nogoods);
}

/* How many refutations it learns. */
static long search(uint64_t seed) {
  enum { DESCENTS = 16 };
  random_numbers r = random_numbers_from(seed);
  scene s;
  tp_search_state state;
  tp_modes_node refuted;
  long work = 0;
  build(&s, seed % 2 == 0);
  draw_nogoods(&s, &r);
  ck_assert(tp_search_state_init(&state, &s.resting, s.none));
  ck_assert(tp_modes_node_init(&refuted, &s.resting));
  bool left = tp_search_settle(&refuted, &work, &state, &s.nogoods);
  for (int k = 0; k < DESCENTS && left; k++) left = descend(&s, &state, &r, &refuted);
  if (!left) {
    tp_search_explain(&refuted, &state, &s.nogoods, 0);
    check_refuted(&s, &refuted);
  }
  const long learned = s.nogoods.count - s.originals.count;
  tp_modes_node_clear(&refuted);
  tp_search_state_clear(&state);
  clear(&s);
  return learned;
}

START_TEST(random_searches) {
  enum { SEEDS = 400 };
  long learned = 0;
  for (uint64_t seed = 0; seed < SEEDS; seed++) learned += search(seed);
  ck_assert_int_gt(learned, SEEDS);
}
END_TEST

SUITE(nogoods) {
  Suite *suite = suite_create("nogoods");
  TCase *tests = tcase_create("searches");
  tcase_set_timeout(tests, 300);
  tcase_add_test(tests, random_searches);
  suite_add_tcase(suite, tests);
  return suite;
}
