/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Each refutation becomes a nogood, of the node as it was divided, so that no branch repeats what
 * another has found. */

#include "contact_modes/branching.h"

#include "contact_modes/settling.h"

bool tp_branching_settle(tp_branching *b) {
  return tp_search_settle(&b->refuted, b->work, &b->state, &b->nogoods);
}

/* By linear programs, of which that of reactions is a tenth of that of forces, but where a relaxed
 * motion shows that they would be in vain. It does so in doubles: a node that can be divided no
 * more is asked for in any case. */
static tp_status refute_by_programs(bool *refuted, tp_branching *b, bool in_any_case,
                                    tp_message *message) {
  const tp_modes_node *own = &b->state.node;
  long *work = b->work;
  tp_status status = TP_OK;
  *refuted = false;
  if (in_any_case || !tp_relaxed_motions_have(&b->relaxed, TP_RELAXED_DRIVEN, work, own)) {
    status = tp_modes_refute_by_reactions(refuted, &b->found, work, own, b->q, message);
  }
  if (status != TP_OK || *refuted) return status;
  if (!in_any_case && tp_relaxed_motions_have(&b->relaxed, TP_RELAXED_BY_FORCES, work, own)) {
    return TP_OK;
  }
  return tp_modes_refute_by_forces(refuted, &b->found, work, own, b->q, message);
}

tp_status tp_branching_refute(bool *refuted, tp_branching *b, tp_message *message) {
  *refuted = !tp_branching_settle(b);
  return *refuted ? TP_OK : refute_by_programs(refuted, b, false, message);
}

tp_status tp_branching_refute_mode(bool *refuted, tp_branching *b, tp_message *message) {
  b->found.is_last = true;
  const tp_status status = refute_by_programs(refuted, b, true, message);
  b->found.is_last = false;
  return status;
}

/* ---- parts -------------------------------------------------------------------------------------
 */

bool tp_branching_has(const tp_branching *b, const tp_contact_part *p) {
  const tp_mode_set *sets = b->state.node.sets;
  const long twin = b->q->resting->contacts[p->contact].twin;
  return (sets[p->contact] & p->own) != 0 || (twin >= 0 && (sets[twin] & p->of_twin) != 0);
}

void tp_branching_take(tp_branching *b, const tp_contact_part *p) {
  tp_search_narrow(&b->state, p->contact, p->own, p->of_twin, TP_REASON_DECIDED);
}

tp_status tp_branching_leave_out(bool *refuted, tp_branching *b, long contact,
                                 tp_message *message) {
  const tp_mode_set *sets = b->state.node.sets, *of = b->refuted.sets;
  const long twin = b->q->resting->contacts[contact].twin;
  *refuted = (sets[contact] & ~of[contact]) == 0 && (twin < 0 || (sets[twin] & ~of[twin]) == 0);
  const tp_status status = tp_nogoods_add(&b->nogoods, &b->refuted, message);
  if (status == TP_OK && !*refuted) *refuted = !tp_branching_settle(b);
  return status;
}

tp_status tp_branching_try(bool *gone, bool *refuted, long *modes, tp_branching *b,
                           const tp_contact_part *p, tp_message *message) {
  const long mark = b->state.count;
  tp_branching_take(b, p);
  const long decided = b->state.count;
  const tp_status status = tp_branching_refute(gone, b, message);
  if (*gone)
    tp_search_explain(&b->refuted, &b->state, &b->nogoods, decided);
  else
    *modes += tp_modes_node_count(&b->state.node, b->q->resting);
  tp_search_undo(&b->state, mark);
  if (status != TP_OK || !*gone) return status;
  tp_branching_tell(b, p, false, -1);
  return tp_branching_leave_out(refuted, b, p->contact, message);
}

void tp_branching_tell(tp_branching *b, const tp_contact_part *p, bool is_part, long child) {
  if (b->found.known == NULL) return;
  const tp_tree_step step = {.contact = p->contact,
                             .own = p->own,
                             .of_twin = p->of_twin,
                             .is_part = is_part,
                             .child = child};
  tp_search_tree_add(&b->found.known->tree, b->told, step);
}
