/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Of each contact, by what its set of modes says for certain: an end that stays closed, a slip that
 * has one side only; of a pair of corners, once one of its sides has nothing left. */

#include "contact_modes/reactions.h"

#include "contact_modes/corner_modes.h"

#include <stdlib.h>

static void add(tp_bearing_reactions *r, tp_bearing_reaction own) {
  r->all[r->count++] = own;
}

static void add_contact(tp_bearing_reactions *r, const tp_resting_contact *c, long k,
                        tp_mode_set set) {
  for (int e = 0; e < c->ends; e++) {
    add(r, (tp_bearing_reaction){c->normal + e, 1, (set & ~tp_modes_closed(e)) == 0, k, e});
  }
  const bool forward = (set & (TP_MODES_FORWARD | TP_MODES_OPEN)) != 0;
  const bool back = (set & (TP_MODES_BACK | TP_MODES_OPEN)) != 0;
  if (!forward || !back)
    add(r, (tp_bearing_reaction){&c->along, back ? -1 : 1, !forward && !back, k, -1});
}

bool tp_reactions_init(tp_bearing_reactions *r, const tp_modes_node *n, const tp_resting *resting) {
  enum { MOST = 3 }; /* of a contact */
  r->count = 0;
  r->all = calloc(MOST * (size_t)resting->contact_count + 1, sizeof *r->all);
  for (long k = 0; k < resting->contact_count && r->all != NULL; k++) {
    const tp_resting_contact *c = resting->contacts + k;
    if (tp_modes_rests(n, c->along.row[0]) && tp_modes_rests(n, c->along.row[1])) continue;
    if (n->sets[k] != 0 && tp_modes_is_told(n->sets, resting, k)) add_contact(r, c, k, n->sets[k]);
  }
  return r->all != NULL;
}

void tp_reactions_clear(tp_bearing_reactions *r) {
  free(r->all);
  r->all = NULL;
  r->count = 0;
}

long tp_reactions_columns(const tp_bearing_reactions *r) {
  long count = r->count;
  for (long k = 0; k < r->count; k++) count += r->all[k].is_free;
  return count;
}

void tp_reactions_join(double *factors, const tp_bearing_reactions *r, const double *columns) {
  long at = 0;
  for (long k = 0; k < r->count; k++) {
    factors[k] = columns[at++];
    if (r->all[k].is_free) factors[k] -= columns[at++];
  }
}
