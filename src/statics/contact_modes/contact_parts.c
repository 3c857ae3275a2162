/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* By what is the same for most: rest, opening at one end, opening at both, a slip. */

#include "contact_modes/contact_parts.h"

#include "contact_modes/corner_modes.h"

static int part_singly(tp_mode_set parts[TP_MOST_PARTS], tp_mode_set set) {
  int count = 0;
  for (int k = 0; k < TP_MOST_PARTS; k++) {
    if ((set & (1U << k)) != 0) parts[count++] = set & (1U << k);
  }
  return count;
}

/* Of a set: at rest, opening at one end, open, forward, back; of one of these, single modes. */
static int part(tp_mode_set parts[TP_MOST_PARTS], tp_mode_set set, int ends) {
  const tp_mode_set rest = tp_modes_at_rest(ends);
  const tp_mode_set kinds[] = {rest, TP_MODES_STICK & ~rest, TP_MODES_OPEN, TP_MODES_FORWARD,
                               TP_MODES_BACK};
  int count = 0;
  for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; k++) {
    if ((set & kinds[k]) != 0) parts[count++] = set & kinds[k];
  }
  return count > 1 ? count : part_singly(parts, set);
}

static void add_part(tp_contact_parts *of, tp_mode_set own, tp_mode_set of_twin) {
  of->own[of->count] = own;
  of->of_twin[of->count++] = of_twin;
}

/* Of a pair: that it opens, past whichever side; else, and of that alone, mode by mode. */
static void part_pair(tp_contact_parts *of, tp_mode_set first, tp_mode_set second) {
  const tp_mode_set opens = TP_MODES_OPEN;
  const bool whole = ((first | second) & ~opens) != 0;
  if (whole && ((first | second) & opens) != 0) add_part(of, first & opens, second & opens);
  tp_mode_set parts[TP_MOST_PARTS];
  int count = part_singly(parts, whole ? first & ~opens : first);
  for (int k = 0; k < count; k++) add_part(of, parts[k], 0);
  count = part_singly(parts, whole ? second & ~opens : second);
  for (int k = 0; k < count; k++) add_part(of, 0, parts[k]);
}

tp_contact_parts tp_contact_parts_of(const tp_modes_node *n, const tp_resting *r, long contact) {
  const tp_resting_contact *c = r->contacts + contact;
  tp_contact_parts of = {.contact = contact, .twin = c->twin};
  if (c->twin >= 0) {
    part_pair(&of, n->sets[contact], n->sets[c->twin]);
    return of;
  }
  of.count = part(of.own, n->sets[contact], c->ends);
  return of;
}
