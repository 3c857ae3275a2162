/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* All steps in one array; a copy has those that are still of use. */

#include "contact_modes/search_tree.h"

#include "common/grow.h"

#include <stdlib.h>

void tp_search_tree_clear(tp_search_tree *t) {
  free(t->steps);
  *t = (tp_search_tree){.count = 0};
}

void tp_search_tree_add(tp_search_tree *t, tp_tree_node *node, tp_tree_step step) {
  tp_tree_step *more = tp_grow(t->steps, t->count, &t->room, sizeof *more);
  if (more == NULL) return;
  t->steps = more;
  step.next = -1;
  more[t->count] = step;
  if (node->last >= 0)
    more[node->last].next = t->count;
  else
    node->first = t->count;
  node->last = t->count++;
}

long tp_search_tree_part(const tp_search_tree *t, long part, tp_mode_set own, tp_mode_set of_twin) {
  while (part >= 0 &&
         ((own & ~t->steps[part].own) != 0 || (of_twin & ~t->steps[part].of_twin) != 0)) {
    part = t->steps[part].next;
  }
  return part;
}

long tp_search_tree_copy(tp_search_tree *to, const tp_search_tree *from, long first) {
  tp_tree_node node = {-1, -1};
  for (long k = first; k >= 0; k = from->steps[k].next) {
    tp_tree_step own = from->steps[k];
    own.child = tp_search_tree_copy(to, from, own.child);
    tp_search_tree_add(to, &node, own);
  }
  return node.first;
}
