/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Breadth first from the ground over contacts of two ends with friction or cohesion; of each the
 * three columns of largest determinant, by Cramer's rule. */

#include "assemblage/ground_tree.h"

#include "plane/contact_rows.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double volume_of(const tp_force_program *p, const long own[3], int side) {
  const tp_near volume =
      tp_near_determinant(p->columns[own[0]].entry[side], p->columns[own[1]].entry[side],
                          p->columns[own[2]].entry[side]);
  return tp_near_sign(volume) == 0 ? 0 : fabs(volume.value);
}

/* Three of the contact's columns; false where they span less than all. */
static bool choose_columns(tp_tree_link *link, const tp_force_program *p, long contact) {
  const long first = p->first[contact], end = p->first[contact + 1];
  double most = 0;
  for (long i = first; i < end; i++) {
    for (long j = i + 1; j < end; j++) {
      for (long k = j + 1; k < end; k++) {
        const long own[3] = {i, j, k};
        const double volume = volume_of(p, own, link->side);
        if (volume <= most) continue;
        most = volume;
        memcpy(link->columns, own, sizeof own);
      }
    }
  }
  return most > 0;
}

/* Contacts by block, ground as the last. */
typedef struct neighbours {
  long *first, *contacts;
} neighbours;

static bool find_neighbours(neighbours *n, const tp_force_program *p, long contact_count) {
  const long blocks = p->rows / 3;
  n->first = calloc((size_t)blocks + 3, sizeof *n->first);
  n->contacts = calloc(2 * (size_t)contact_count + 1, sizeof *n->contacts);
  if (n->first == NULL || n->contacts == NULL) return false;
  for (int fills = 0; fills < 2; fills++) {
    for (long k = 0; k < contact_count; k++) {
      for (int side = 0; side < 2; side++) {
        const long row = p->columns[p->first[k]].row[side];
        const long block = row < 0 ? blocks : row / 3;
        if (fills == 0) {
          n->first[block + 2]++;
        } else {
          n->contacts[n->first[block + 1]++] = k;
        }
      }
    }
    for (long b = 0; b < blocks + 2 && fills == 0; b++) n->first[b + 1] += n->first[b];
  }
  return true;
}

static void grow_from(tp_ground_tree *t, const tp_force_program *p, const neighbours *n,
                      long parent, bool *reached) {
  const long blocks = p->rows / 3, at = parent < 0 ? blocks : parent;
  for (long k = n->first[at]; k < n->first[at + 1]; k++) {
    const long *row = p->columns[p->first[n->contacts[k]]].row;
    for (int side = 0; side < 2; side++) {
      tp_tree_link link = {.number = row[side] / 3, .parent = parent, .side = side};
      if (row[side] < 0 || link.number == parent || reached[link.number]) continue;
      if (!choose_columns(&link, p, n->contacts[k])) continue;
      reached[link.number] = true;
      t->links[t->count++] = link;
    }
  }
}

bool tp_ground_tree_init(tp_ground_tree *t, const tp_force_program *p) {
  const long blocks = p->rows / 3;
  neighbours n = {NULL, NULL};
  bool *reached = calloc((size_t)blocks + 1, sizeof *reached);
  t->count = 0;
  t->links = calloc((size_t)blocks + 1, sizeof *t->links);
  const bool done =
      reached != NULL && t->links != NULL && find_neighbours(&n, p, p->assemblage->contact_count);
  if (done) {
    grow_from(t, p, &n, -1, reached);
    for (long k = 0; k < t->count; k++) grow_from(t, p, &n, t->links[k].number, reached);
  }
  free(n.first);
  free(n.contacts);
  free(reached);
  return done;
}

void tp_ground_tree_clear(tp_ground_tree *t) {
  free(t->links);
  t->links = NULL;
  t->count = 0;
}

void tp_tree_link_share(tp_near factors[3], const tp_tree_link *link, const tp_force_program *p,
                        const tp_near wrench[3]) {
  const tp_near *own[3];
  for (int k = 0; k < 3; k++) own[k] = p->columns[link->columns[k]].entry[link->side];
  const tp_near volume = tp_near_determinant(own[0], own[1], own[2]);
  for (int k = 0; k < 3; k++) {
    const tp_near part = tp_near_determinant(wrench, own[(k + 1) % 3], own[(k + 2) % 3]);
    factors[k] = tp_near_div(part, volume);
  }
}
