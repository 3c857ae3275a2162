/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* By end of a contact, from the modes in which it is closed. */

#include "contact_modes/resisting_edges.h"

#include "contact_modes/corner_modes.h"

#include <stdlib.h>

void tp_resisting_edges_clear(tp_resisting_edges *s) {
  free(s->all);
  *s = (tp_resisting_edges){.count = 0};
}

static void add_edge(tp_resisting_edges *s, const tp_resting_contact *c, long contact, int end,
                     tp_near shear) {
  s->all[s->count++] = (tp_resisting_edge){c->normal + end, &c->along, shear, contact, end};
}

/* Of an end that can be closed: both edges of the cone where it can stick, and against the slip
 * else, with the least friction and the greatest. */
static void add_end(tp_resisting_edges *s, const tp_modes_node *n, const tp_modes_question *q,
                    long contact, int end) {
  const tp_resting_contact *c = q->resting->contacts + contact;
  const tp_mode_set set = tp_modes_bearing(n->sets, q->resting, contact) & tp_modes_closed(end);
  if (set == 0) return;
  const bool sticks = (set & TP_MODES_STICK) != 0;
  const tp_near least = q->friction[0][contact], most = q->friction[1][contact];
  const bool same = least.value == most.value && least.error == most.error;
  if (sticks || (set & TP_MODES_FORWARD) != 0) {
    add_edge(s, c, contact, end, tp_near_neg(most));
    if (!sticks && !same) add_edge(s, c, contact, end, tp_near_neg(least));
  }
  if (sticks || (set & TP_MODES_BACK) != 0) {
    add_edge(s, c, contact, end, most);
    if (!sticks && !same) add_edge(s, c, contact, end, least);
  }
}

bool tp_resisting_edges_init(tp_resisting_edges *s, const tp_modes_node *n,
                             const tp_modes_question *q) {
  enum { MOST = 8 }; /* of a contact */
  const tp_resting *r = q->resting;
  s->count = 0;
  s->all = calloc(MOST * (size_t)r->contact_count + 1, sizeof *s->all);
  for (long k = 0; k < r->contact_count && s->all != NULL; k++) {
    const tp_resting_contact *c = r->contacts + k;
    if (tp_modes_rests(n, c->along.row[0]) && tp_modes_rests(n, c->along.row[1])) {
      continue;
    }
    for (int e = 0; e < c->ends; e++) add_end(s, n, q, k, e);
  }
  return s->all != NULL;
}
