/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Made with all modes and no block at rest, from which a search begins, and to which a refutation
 * is widened before each of its steps narrows it. */

#include "contact_modes/node.h"

#include "contact_modes/corner_modes.h"

#include <stdlib.h>
#include <string.h>

bool tp_modes_node_init(tp_modes_node *n, const tp_resting *r) {
  n->sets = calloc((size_t)r->contact_count + 1, sizeof *n->sets);
  n->still = calloc((size_t)r->rows / 3 + 1, sizeof *n->still);
  if (n->sets == NULL || n->still == NULL) {
    tp_modes_node_clear(n);
    return false;
  }
  tp_modes_node_widen(n, r);
  return true;
}

void tp_modes_node_clear(tp_modes_node *n) {
  free(n->sets);
  free(n->still);
  *n = (tp_modes_node){.sets = NULL};
}

void tp_modes_node_widen(tp_modes_node *n, const tp_resting *r) {
  for (long k = 0; k < r->contact_count; k++) n->sets[k] = tp_modes_of_contact(r, k);
  memset(n->still, 0, (size_t)(r->rows / 3) * sizeof *n->still);
}

long tp_modes_node_count(const tp_modes_node *n, const tp_resting *r) {
  long count = 0;
  for (long k = 0; k < r->contact_count; k++) {
    for (tp_mode_set set = n->sets[k]; set != 0; set &= set - 1) count++;
  }
  return count;
}
