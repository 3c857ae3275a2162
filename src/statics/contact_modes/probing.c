/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Each contact of a block that is not at rest could be divided (contact_modes/contact_parts.h).
 * Parts that are refuted are left out for good, whatever is divided in the end. Where one part is
 * left, it is so; else the contact of the fewest parts is divided. */

#include "contact_modes/probing.h"

#include "contact_modes/contact_parts.h"
#include "contact_modes/corner_modes.h"

/* How many parts of a contact are not refuted, and their modes; no more than `most` are counted. */
typedef struct division {
  int count;
  long modes;
} division;

static tp_status divide(division *d, bool *refuted, tp_branching *b, long contact, int most,
                        tp_message *message) {
  const tp_contact_parts of = tp_contact_parts_of(&b->state.node, b->q->resting, contact);
  tp_status status = TP_OK;
  *d = (division){.count = 0};
  *refuted = false;
  for (int k = of.count - 1; k >= 0 && status == TP_OK && !*refuted && d->count <= most; k--) {
    const tp_contact_part part = {contact, of.own[k], of.of_twin[k]};
    if (!tp_branching_has(b, &part)) continue;
    bool gone = false;
    status = tp_branching_try(&gone, refuted, &d->modes, b, &part, message);
    if (!gone) d->count++;
  }
  return status;
}

bool tp_probing_can_divide(const tp_modes_node *n, const tp_resting *r, long contact) {
  const long *row = r->contacts[contact].along.row;
  return !(tp_modes_rests(n, row[0]) && tp_modes_rests(n, row[1])) &&
         !tp_modes_is_settled(n->sets, r, contact) && !tp_modes_is_second_side(r, contact);
}

/* Of a pair: past which side it opens is not asked until nothing else is left to ask. */
static bool is_asked_last(const tp_modes_node *n, const tp_resting *r, long contact) {
  const long twin = r->contacts[contact].twin;
  return twin >= 0 && tp_probing_can_divide(n, r, contact) &&
         ((n->sets[contact] | n->sets[twin]) & ~(tp_mode_set)TP_MODES_OPEN) == 0;
}

static bool is_asked_first(const tp_modes_node *n, const tp_resting *r, long contact) {
  return tp_probing_can_divide(n, r, contact) && !is_asked_last(n, r, contact);
}

typedef bool candidate(const tp_modes_node *n, const tp_resting *r, long contact);

/* The contact of the fewest parts of all candidates, and of those the one that leaves the fewest
 * modes; -1: there is none. From the first again where one part is left of one. */
static tp_status probe(long *best, bool *refuted, tp_branching *b, candidate *is_asked,
                       tp_message *message) {
  enum { MANY = TP_MOST_PARTS + 1 };
  const tp_resting *r = b->q->resting;
  tp_status status = TP_OK;
  division fewest = {.count = MANY};
  *best = -1;
  for (long k = 0;
       k < r->contact_count && status == TP_OK && !*refuted && !tp_branching_is_spent(b); k++) {
    if (!is_asked(&b->state.node, r, k)) continue;
    division own;
    status = divide(&own, refuted, b, k, fewest.count, message);
    if (own.count < fewest.count || (own.count == fewest.count && own.modes < fewest.modes)) {
      fewest = own;
      *best = k;
    }
    if (own.count > 1) continue;
    fewest = (division){.count = MANY};
    *best = -1;
    k = -1;
  }
  return status;
}

tp_status tp_probing_find(long *contact, bool *refuted, tp_branching *b, tp_message *message) {
  candidate *const asked[] = {is_asked_first, is_asked_last};
  tp_status status = TP_OK;
  *contact = -1;
  for (int k = 0; k < 2 && *contact < 0 && status == TP_OK && !*refuted; k++) {
    status = probe(contact, refuted, b, asked[k], message);
  }
  return status;
}
