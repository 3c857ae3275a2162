/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A refutation is taken back over a change by its reason, which is either a nogood (resolution:
 * what one of both excludes or what the other does, whichever mode the contact has of them), or
 * what holds a block. */

#include "contact_modes/search_state.h"

#include "contact_modes/corner_modes.h"

#include <stdlib.h>
#include <string.h>

bool tp_search_state_init(tp_search_state *s, const tp_resting *r, const bool *still) {
  const size_t blocks = (size_t)r->rows / 3;
  *s = (tp_search_state){.resting = r};
  const bool made = tp_modes_node_init(&s->node, r);
  /* each change takes a mode at least, or rests a block */
  const size_t most = made ? (size_t)tp_modes_node_count(&s->node, r) + blocks : 0;
  s->changes = calloc(most + 1, sizeof *s->changes);
  if (!made || s->changes == NULL) {
    tp_search_state_clear(s);
    return false;
  }
  memcpy(s->node.still, still, blocks * sizeof *still);
  return true;
}

void tp_search_state_clear(tp_search_state *s) {
  tp_modes_node_clear(&s->node);
  free(s->changes);
  s->changes = NULL;
}

bool tp_search_narrow(tp_search_state *s, long contact, tp_mode_set own, tp_mode_set of_twin,
                      long reason) {
  const long twin = s->resting->contacts[contact].twin;
  tp_mode_set *sets = s->node.sets;
  const tp_mode_set gone = sets[contact] & ~own;
  const tp_mode_set gone_of_twin = twin >= 0 ? sets[twin] & ~of_twin : 0;
  if (gone == 0 && gone_of_twin == 0) return false;
  sets[contact] &= ~gone;
  if (twin >= 0) sets[twin] &= ~gone_of_twin;
  s->changes[s->count++] = (tp_search_change){contact, -1, gone, gone_of_twin, reason};
  return true;
}

void tp_search_rest(tp_search_state *s, long block) {
  s->node.still[block] = true;
  s->changes[s->count++] = (tp_search_change){.contact = -1, .block = block};
}

static tp_search_change take_back(tp_search_state *s) {
  const tp_search_change c = s->changes[--s->count];
  if (s->told > s->count) s->told = s->count;
  if (c.block >= 0) {
    s->node.still[c.block] = false;
    return c;
  }
  const long twin = s->resting->contacts[c.contact].twin;
  s->node.sets[c.contact] |= c.gone;
  if (twin >= 0) s->node.sets[twin] |= c.gone_of_twin;
  return c;
}

void tp_search_undo(tp_search_state *s, long mark) {
  while (s->count > mark) take_back(s);
}

/* ---- reasons -----------------------------------------------------------------------------------
 */

static void rest(tp_modes_node *refuted, long row) {
  if (row >= 0) refuted->still[row / 3] = true;
}

/* Of a contact whose blocks rest: it has no velocity, whatever else it might do. */
static void explain_rest_of_contact(tp_modes_node *refuted, const tp_resting *r, long k) {
  const tp_resting_contact *c = r->contacts + k;
  for (int side = 0; side < 2; side++) rest(refuted, c->along.row[side]);
  refuted->sets[k] = tp_modes_of_contact(r, k);
  if (c->twin >= 0) refuted->sets[c->twin] = tp_modes_of_contact(r, c->twin);
}

/* Does it stick to a block at rest by this contact? */
static bool is_stuck(const tp_search_state *s, const tp_resting_contact *c, long k, int side) {
  return c->ends == 2 && s->node.sets[k] == tp_modes_at_rest(2) &&
         tp_modes_rests(&s->node, c->along.row[1 - side]);
}

/* By one contact that it sticks to; else by all with blocks at rest. The state is that from which
 * it followed. */
static void explain_rest_of_block(tp_modes_node *refuted, const tp_search_state *s, long block) {
  const tp_resting *r = s->resting;
  refuted->still[block] = false;
  for (int pass = 0; pass < 2; pass++) {
    for (long k = 0; k < r->contact_count; k++) {
      const tp_resting_contact *c = r->contacts + k;
      const int side = c->along.row[0] == 3 * block ? 0 : 1;
      const long other = c->along.row[1 - side];
      if (c->along.row[side] != 3 * block || !tp_modes_rests(&s->node, other)) continue;
      if (pass == 0 && !is_stuck(s, c, k, side)) continue;
      refuted->sets[k] &= s->node.sets[k];
      rest(refuted, other);
      if (pass == 0) return;
    }
  }
}

void tp_search_explain(tp_modes_node *refuted, tp_search_state *s, tp_nogoods *nogoods, long mark) {
  const tp_resting *r = s->resting;
  while (s->count > mark) {
    const tp_search_change c = take_back(s);
    if (c.block >= 0) {
      if (refuted->still[c.block]) explain_rest_of_block(refuted, s, c.block);
      continue;
    }
    const long twin = r->contacts[c.contact].twin;
    const bool covered = (c.gone & ~refuted->sets[c.contact]) == 0 &&
                         (twin < 0 || (c.gone_of_twin & ~refuted->sets[twin]) == 0);
    if (covered) continue;
    if (c.reason == TP_REASON_REST) {
      explain_rest_of_contact(refuted, r, c.contact);
    } else if (c.reason != TP_REASON_DECIDED) {
      tp_nogoods_resolve(refuted, nogoods, c.reason, c.contact);
    }
  }
}
