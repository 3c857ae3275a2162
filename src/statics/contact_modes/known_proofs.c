/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Proofs in the order in which they were found. There are no more than so many: of more, the search
 * has none to keep. */

#include "contact_modes/known_proofs.h"

#include "common/grow.h"

#include <stdlib.h>
#include <string.h>

enum { MOST = 1 << 14 };

static void clear_one(tp_known_proof *p) {
  tp_modes_node_clear(&p->node);
  tp_reactions_clear(&p->reactions);
  free(p->factors);
}

void tp_known_proofs_clear(tp_known_proofs *known) {
  for (long k = 0; k < known->count; k++) clear_one(known->all + k);
  free(known->all);
  free(known->root);
  free(known->proven_root);
  tp_search_tree_clear(&known->tree);
  *known = (tp_known_proofs){.resting = known->resting};
}

tp_status tp_known_proofs_init(tp_known_proofs *known, const tp_resting *r, tp_message *message) {
  const size_t blocks = (size_t)r->rows / 3;
  *known = (tp_known_proofs){.resting = r,
                             .root = calloc(blocks + 1, sizeof *known->root),
                             .proven_root = calloc(blocks + 1, sizeof *known->proven_root)};
  if (known->root == NULL || known->proven_root == NULL) {
    tp_known_proofs_clear(known);
    return tp_fail_memory(message, "the proofs");
  }
  for (size_t b = 0; b < blocks; b++) known->root[b] = known->proven_root[b] = -1;
  return TP_OK;
}

static bool add(tp_known_proofs *known, const tp_known_proof *own) {
  tp_known_proof *more = tp_grow(known->all, known->count, &known->room, sizeof *more);
  if (more == NULL) return false;
  known->all = more;
  more[known->count++] = *own;
  return true;
}

static bool copy_node(tp_modes_node *to, const tp_modes_node *from, const tp_resting *r) {
  if (!tp_modes_node_init(to, r)) return false;
  memcpy(to->sets, from->sets, (size_t)r->contact_count * sizeof *to->sets);
  memcpy(to->still, from->still, (size_t)(r->rows / 3) * sizeof *to->still);
  return true;
}

/* Those that act. */
static bool copy_reactions(tp_known_proof *own, const tp_bearing_reactions *reactions,
                           const double *factors) {
  const long count = reactions->count;
  own->reactions.all = calloc((size_t)count + 1, sizeof *own->reactions.all);
  own->factors = calloc((size_t)count + 1, sizeof *own->factors);
  if (own->reactions.all == NULL || own->factors == NULL) return false;
  for (long k = 0; k < count; k++) {
    if (factors[k] == 0) continue;
    own->factors[own->reactions.count] = factors[k];
    own->reactions.all[own->reactions.count++] = reactions->all[k];
  }
  return true;
}

static void add_copy(tp_known_proofs *known, const tp_modes_node *node,
                     const tp_bearing_reactions *reactions, const double *factors, double share) {
  if (known == NULL || known->count >= MOST) return;
  tp_known_proof own = {.by_forces = reactions != NULL, .share = share, .nogood = -1};
  const bool is_kept = copy_node(&own.node, node, known->resting) &&
                       (reactions == NULL || copy_reactions(&own, reactions, factors)) &&
                       add(known, &own);
  if (!is_kept) clear_one(&own);
}

void tp_known_proofs_add_forces(tp_known_proofs *known, const tp_forces_proof *p) {
  add_copy(known, p->node, p->reactions, p->factors, p->share);
}

void tp_known_proofs_add_reactions(tp_known_proofs *known, const tp_modes_node *refuted) {
  add_copy(known, refuted, NULL, NULL, 0);
}

void tp_known_proofs_copy(tp_known_proofs *known, const tp_known_proofs *from) {
  for (long k = 0; k < from->count; k++) {
    const tp_known_proof *own = from->all + k;
    add_copy(known, &own->node, own->by_forces ? &own->reactions : NULL, own->factors, own->share);
  }
  for (long b = 0; b < known->resting->rows / 3; b++) {
    known->root[b] = known->proven_root[b] =
        tp_search_tree_copy(&known->tree, &from->tree, from->root[b]);
  }
}

void tp_known_proofs_keep_used(tp_known_proofs *known, const tp_nogoods *nogoods) {
  long kept = 0;
  for (long k = 0; k < known->count; k++) {
    tp_known_proof own = known->all[k];
    const bool is_needed = !own.was_asked || (own.nogood >= 0 && nogoods->all[own.nogood].is_used);
    if (!is_needed) {
      clear_one(&own);
      continue;
    }
    own.was_asked = false;
    own.nogood = -1;
    known->all[kept++] = own;
  }
  known->count = kept;
}

/* Steps that are still of use, in a tree of their own. */
static void prune(tp_known_proofs *known) {
  tp_search_tree own = {.count = 0};
  for (long b = 0; b < known->resting->rows / 3; b++) {
    const bool same = known->root[b] == known->proven_root[b];
    known->root[b] = tp_search_tree_copy(&own, &known->tree, known->root[b]);
    known->proven_root[b] =
        same ? known->root[b] : tp_search_tree_copy(&own, &known->tree, known->proven_root[b]);
  }
  tp_search_tree_clear(&known->tree);
  known->tree = own;
}

/* Where a mode was left the search had divided what is proven only as a whole, maybe. */
void tp_known_proofs_end(tp_known_proofs *known, long first_block, tp_search_end end, long told) {
  long *root = known->root + first_block, *proven = known->proven_root + first_block;
  if (end == TP_SEARCH_PROVEN) *proven = told;
  *root = end == TP_SEARCH_LEFT ? *proven : told;
  prune(known);
}
