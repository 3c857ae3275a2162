/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What both proofs (contact_modes/refutation.h) ask of a contact they ask of each of its modes by
 * itself: that reactions do no work against it, and that its forces do none with y. Only cohesion
 * and bonds they ask of all contacts together. */

#include "contact_modes/refuted_node.h"

#include "contact_modes/bond_pull.h"
#include "contact_modes/corner_modes.h"

#include <string.h>

static bool rest_both(const tp_modes_node *n, const tp_resting_contact *c) {
  return tp_modes_rests(n, c->along.row[0]) && tp_modes_rests(n, c->along.row[1]);
}

void tp_refuted_node_begin(tp_modes_node *refuted, const tp_modes_node *node,
                           const tp_modes_question *q) {
  const tp_resting *r = q->resting;
  tp_modes_node_widen(refuted, r);
  memcpy(refuted->still, node->still, (size_t)(r->rows / 3) * sizeof *refuted->still);
  for (long k = 0; k < r->contact_count; k++) {
    if (rest_both(node, r->contacts + k)) continue;
    if (tp_bond_is_given(q, k)) refuted->sets[k] = node->sets[k];
    if (tp_near_is_zero(q->cohesion[1][k])) continue;
    for (long i = 0; i < r->contact_count; i++) {
      if (r->contacts[i].line == r->contacts[k].line) refuted->sets[i] = node->sets[i];
    }
  }
}

/* Of a pair of corners only modes that its side tells of. */
void tp_refuted_node_bears(tp_modes_node *refuted, const tp_resting *r,
                           const tp_bearing_reaction *own, tp_factor_sign sign) {
  const long k = own->contact, twin = r->contacts[k].twin;
  if (sign == TP_FACTOR_NONE) return;
  if (twin >= 0) refuted->sets[twin] = 0;
  if (own->end >= 0) {
    if (sign != TP_FACTOR_POSITIVE) refuted->sets[k] &= tp_modes_closed(own->end);
    return;
  }
  const bool forward = (sign == TP_FACTOR_POSITIVE) == (own->sign > 0);
  const tp_mode_set slips = sign == TP_FACTOR_EITHER ? 0
                            : forward                ? TP_MODES_FORWARD
                                                     : TP_MODES_BACK;
  refuted->sets[k] &= TP_MODES_STICK | slips;
}

static bool resists(tp_near normal, tp_near along, tp_near shear) {
  const tp_near power = tp_near_plus(normal, tp_near_times(shear, along));
  return !(power.value + power.error <= 0);
}

/* Modes with this end closed of which a force resists. */
static tp_mode_set resisting(const tp_modes_question *q, long k, int end, const tp_near *y) {
  const tp_resting_contact *c = q->resting->contacts + k;
  const tp_near normal = tp_resting_along(c->normal + end, y);
  const tp_near along = tp_resting_along(&c->along, y);
  const tp_near least = q->friction[0][k], most = q->friction[1][k];
  tp_mode_set set = 0;
  if (resists(normal, along, tp_near_neg(least))) set |= TP_MODES_FORWARD;
  if (resists(normal, along, tp_near_neg(most))) set |= TP_MODES_STICK | TP_MODES_FORWARD;
  if (resists(normal, along, least)) set |= TP_MODES_BACK;
  if (resists(normal, along, most)) set |= TP_MODES_STICK | TP_MODES_BACK;
  return set & tp_modes_closed(end);
}

/* Where a pair of corners sticks its second side bears too. */
void tp_refuted_node_yields(tp_modes_node *refuted, const tp_modes_node *node,
                            const tp_modes_question *q, const tp_near *y) {
  const tp_resting *r = q->resting;
  for (long k = 0; k < r->contact_count; k++) {
    const tp_resting_contact *c = r->contacts + k;
    if (rest_both(node, c)) continue;
    for (int e = 0; e < c->ends; e++) {
      const tp_mode_set set = resisting(q, k, e, y);
      refuted->sets[k] &= ~set;
      if (tp_modes_is_second_side(r, k)) refuted->sets[c->twin] &= ~(set & TP_MODES_STICK);
    }
  }
}
