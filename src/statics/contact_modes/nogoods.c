/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Those that watch a contact or a block are a chain, linked both ways: each leaves it, from
 * wherever it is, as it begins to watch another. */

#include "contact_modes/nogoods.h"

#include "common/grow.h"
#include "contact_modes/corner_modes.h"

#include <stdlib.h>
#include <string.h>

bool tp_nogoods_init(tp_nogoods *n, const tp_resting *r) {
  const long count = r->contact_count + r->rows / 3;
  *n = (tp_nogoods){.resting = r, .watching = calloc((size_t)count + 1, sizeof *n->watching)};
  for (long k = 0; k < count && n->watching != NULL; k++) n->watching[k] = -1;
  return n->watching != NULL;
}

void tp_nogoods_clear(tp_nogoods *n) {
  free(n->all);
  free(n->terms);
  free(n->watching);
  *n = (tp_nogoods){.resting = n->resting};
}

/* ---- terms -------------------------------------------------------------------------------------
 */

static bool add_term(tp_nogoods *n, tp_nogood_term own) {
  tp_nogood_term *more = tp_grow(n->terms, n->term_count, &n->term_room, sizeof *more);
  if (more == NULL) return false;
  n->terms = more;
  more[n->term_count++] = own;
  return true;
}

static bool add_terms(tp_nogoods *n, const tp_modes_node *refuted) {
  const tp_resting *r = n->resting;
  bool done = true;
  for (long k = 0; k < r->contact_count && done; k++) {
    if (tp_modes_is_second_side(r, k)) continue;
    const long twin = r->contacts[k].twin;
    const tp_mode_set of_twin = twin >= 0 ? refuted->sets[twin] : 0;
    const tp_nogood_term own = {(int32_t)k, (int32_t)twin, -1, (uint16_t)refuted->sets[k],
                                (uint16_t)of_twin};
    const bool limits = own.own != tp_modes_of_contact(r, k) ||
                        (twin >= 0 && own.of_twin != tp_modes_of_contact(r, twin));
    done = !limits || add_term(n, own);
  }
  for (long b = 0; b < r->rows / 3 && done; b++) {
    done = !refuted->still[b] || add_term(n, (tp_nogood_term){-1, -1, (int32_t)b, 0, 0});
  }
  return done;
}

static long end_of(const tp_nogoods *n, long number) {
  return number + 1 < n->count ? n->all[number + 1].terms : n->term_count;
}

static bool meets(const tp_modes_node *node, const tp_nogood_term *t) {
  if (t->block >= 0) return node->still[t->block];
  return (node->sets[t->contact] & ~(tp_mode_set)t->own) == 0 &&
         (t->twin < 0 || (node->sets[t->twin] & ~(tp_mode_set)t->of_twin) == 0);
}

/* ---- watching ----------------------------------------------------------------------------------
 */

static int32_t *chain_of(const tp_nogoods *n, long term) {
  const tp_nogood_term *t = n->terms + term;
  return n->watching + (t->block >= 0 ? n->resting->contact_count + t->block : t->contact);
}

static void watch(tp_nogoods *n, long number, int which, long term) {
  tp_nogood *own = n->all + number;
  const int32_t link = (int32_t)(2 * number + which);
  own->watched[which] = (int32_t)term;
  if (term < 0) return;
  int32_t *chain = chain_of(n, term);
  own->next[which] = *chain;
  own->before[which] = -1;
  if (*chain >= 0) n->all[*chain / 2].before[*chain % 2] = link;
  *chain = link;
}

static void unwatch(tp_nogoods *n, long number, int which) {
  const tp_nogood *own = n->all + number;
  if (own->watched[which] < 0) return;
  const int32_t next = own->next[which], before = own->before[which];
  if (next >= 0) n->all[next / 2].before[next % 2] = before;
  if (before >= 0)
    n->all[before / 2].next[before % 2] = next;
  else
    *chain_of(n, own->watched[which]) = next;
}

tp_status tp_nogoods_add(tp_nogoods *n, const tp_modes_node *refuted, tp_message *message) {
  tp_nogood *more = tp_grow(n->all, n->count, &n->room, sizeof *more);
  if (more == NULL) return tp_fail_memory(message, "a proof");
  n->all = more;
  more[n->count] = (tp_nogood){.terms = (int32_t)n->term_count, .watched = {-1, -1}};
  if (!add_terms(n, refuted)) return tp_fail_memory(message, "a proof");
  n->count++;
  for (int k = 0; k < 2; k++) {
    const long term = n->all[n->count - 1].terms + k;
    watch(n, n->count - 1, k, term < n->term_count ? term : -1);
  }
  return TP_OK;
}

long tp_nogoods_watching(long *at, const tp_nogoods *n, long contact, long block) {
  const int32_t *chain = n->watching + (block >= 0 ? n->resting->contact_count + block : contact);
  *at = *at < 0 ? *chain : n->all[*at / 2].next[*at % 2];
  return *at < 0 ? -1 : *at / 2;
}

/* Terms that are not met are watched, as many as there are up to two. To ask one takes as long as
 * two entries of a program. */
tp_nogood_says tp_nogoods_ask(tp_nogood_term *term, long *work, tp_nogoods *n, long number,
                              const tp_modes_node *node) {
  tp_nogood *own = n->all + number;
  long found[2] = {-1, -1};
  int count = 0;
  *work += 2;
  for (int k = 0; k < 2; k++) {
    if (own->watched[k] < 0 || meets(node, n->terms + own->watched[k])) continue;
    found[count++] = own->watched[k];
  }
  for (long k = own->terms; k < end_of(n, number) && count < 2; k++) {
    *work += 2;
    if (k == found[0] || meets(node, n->terms + k)) continue;
    found[count++] = k;
  }
  for (int k = 0; k < count; k++) {
    if (found[k] == own->watched[0] || found[k] == own->watched[1]) continue;
    const int which = found[1 - k] == own->watched[0] ? 1 : 0;
    unwatch(n, number, which);
    watch(n, number, which, found[k]);
  }
  if (count == 0) return TP_NOGOOD_REFUTES;
  if (count == 2 || n->terms[found[0]].block >= 0) return TP_NOGOOD_NOTHING;
  *term = n->terms[found[0]];
  return TP_NOGOOD_LIMITS;
}

/* ---- refuted nodes -----------------------------------------------------------------------------
 */

void tp_nogoods_take(tp_modes_node *refuted, tp_nogoods *n, long number) {
  const tp_resting *r = n->resting;
  n->all[number].is_used = true;
  tp_modes_node_widen(refuted, r);
  for (long k = n->all[number].terms; k < end_of(n, number); k++) {
    const tp_nogood_term *t = n->terms + k;
    if (t->block >= 0) {
      refuted->still[t->block] = true;
      continue;
    }
    refuted->sets[t->contact] = t->own;
    if (t->twin >= 0) refuted->sets[t->twin] = t->of_twin;
  }
}

void tp_nogoods_resolve(tp_modes_node *refuted, tp_nogoods *n, long number, long contact) {
  tp_mode_set *sets = refuted->sets;
  n->all[number].is_used = true;
  for (long k = n->all[number].terms; k < end_of(n, number); k++) {
    const tp_nogood_term *t = n->terms + k;
    if (t->block >= 0) {
      refuted->still[t->block] = true;
      continue;
    }
    const bool is_it = t->contact == contact;
    sets[t->contact] = is_it ? sets[contact] | t->own : sets[t->contact] & t->own;
    if (t->twin < 0) continue;
    sets[t->twin] = is_it ? sets[t->twin] | t->of_twin : sets[t->twin] & t->of_twin;
  }
}
