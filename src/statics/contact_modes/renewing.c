/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* By forces in one pass over the contacts, for each load, which takes a hundredth of the program
 * that found them. By reactions the program is solved for the node that it refuted: these have to
 * balance the loads exactly. */

#include "contact_modes/renewing.h"

#include "contact_modes/corner_modes.h"
#include "contact_modes/refuted_node.h"

#include <stdlib.h>

typedef struct renewing {
  const tp_modes_question *q;
  tp_modes_node *room;
  tp_near *wrenches, *y; /* by row */
  long *work;
} renewing;

/* Entries that are read: of columns of reactions, of rows, of contacts. */
static long entries_of(const tp_known_proof *own, const tp_resting *r) {
  enum { OF_REACTION = 6, OF_CONTACT = 18 };
  return OF_REACTION * own->reactions.count + r->rows + OF_CONTACT * r->contact_count;
}

static bool renew_forces(const renewing *n, const tp_known_proof *own) {
  tp_forces_proof p = {.node = &own->node,
                       .question = n->q,
                       .reactions = &own->reactions,
                       .factors = own->factors,
                       .share = own->share,
                       .wrenches = n->wrenches,
                       .y = n->y};
  tp_refuted_node_begin(n->room, &own->node, n->q);
  bool proven = true;
  for (int k = 0; k < n->q->load_count && proven; k++) {
    *n->work += entries_of(own, n->q->resting);
    proven = tp_forces_proof_drives(&p, k);
    if (proven) tp_forces_proof_widen(n->room, &p);
  }
  return proven;
}

/* Has every contact some modes left? Else it is of no node. */
static bool is_of_some(const tp_modes_node *n, const tp_resting *r) {
  for (long k = 0; k < r->contact_count; k++) {
    const long twin = r->contacts[k].twin;
    if (n->sets[k] == 0 && (twin < 0 || n->sets[twin] == 0)) return false;
  }
  return true;
}

static tp_status renew(bool *proven, const renewing *n, const tp_known_proof *own,
                       tp_message *message) {
  if (own->by_forces) {
    *proven = renew_forces(n, own);
    return TP_OK;
  }
  tp_relaxed_motions none;
  if (!tp_relaxed_motions_init(&none, n->q)) return tp_fail_memory(message, "a proof");
  const tp_modes_finding finding = {.refuted = n->room, .relaxed = &none};
  const tp_status status =
      tp_modes_refute_by_reactions(proven, &finding, n->work, &own->node, n->q, message);
  tp_relaxed_motions_clear(&none);
  return status;
}

static bool is_of_blocks(const tp_known_proof *own, const bool *still, const tp_resting *r) {
  for (long b = 0; b < r->rows / 3; b++) {
    if (still[b] && !own->node.still[b]) return false;
  }
  return true;
}

tp_status tp_known_proofs_renew(tp_known_proofs *known, tp_nogoods *nogoods, tp_modes_node *room,
                                long *work, long most_work, const tp_modes_question *q,
                                const bool *still, tp_message *message) {
  const size_t rows = (size_t)q->resting->rows + 1;
  const renewing n = {.q = q,
                      .room = room,
                      .wrenches = calloc(rows, sizeof *n.wrenches),
                      .y = calloc(rows, sizeof *n.y),
                      .work = work};
  tp_status status = n.wrenches != NULL && n.y != NULL ? TP_OK : tp_fail_memory(message, "a proof");
  for (long k = 0; k < known->count && status == TP_OK && *work <= most_work; k++) {
    tp_known_proof *own = known->all + k;
    bool proven = false;
    own->nogood = -1;
    if (!is_of_blocks(own, still, q->resting)) continue;
    own->was_asked = true;
    status = renew(&proven, &n, own, message);
    if (status != TP_OK || !proven || !is_of_some(room, q->resting)) continue;
    own->nogood = nogoods->count;
    status = tp_nogoods_add(nogoods, room, message);
  }
  free(n.wrenches);
  free(n.y);
  return status;
}
