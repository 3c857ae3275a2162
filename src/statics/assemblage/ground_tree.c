/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Breadth first from the ground, over contacts that can exert any wrench by themselves; then blocks
 * that rest on corners, by all their contacts with what is reached. Three columns of largest
 * determinant, by Cramer's rule. */

#include "assemblage/ground_tree.h"

#include "plane/contact_rows.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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
      for (int side = 0; side < 2 && p->first[k] < p->first[k + 1]; side++) {
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

typedef struct growing {
  const tp_force_program *p;
  neighbours n;
  bool *reached; /* by number */
} growing;

/* Columns by which a block can be held; of very many the first. */
enum { MOST_COLUMNS = 20 };
typedef struct holders {
  int count;
  long columns[MOST_COLUMNS];
  int sides[MOST_COLUMNS];
} holders;

static void take(holders *h, const growing *g, long block, long contact) {
  const tp_force_program *p = g->p;
  const long *row = p->columns[p->first[contact]].row;
  const int side = row[0] == 3 * block ? 0 : 1;
  if (row[!side] >= 0 && !g->reached[row[!side] / 3]) return;
  for (long c = p->first[contact]; c < p->first[contact + 1] && h->count < MOST_COLUMNS; c++) {
    h->columns[h->count] = c;
    h->sides[h->count++] = side;
  }
}

/* Of one contact, or of all. */
static void gather(holders *h, const growing *g, long block, long contact, bool all) {
  h->count = 0;
  if (!all) take(h, g, block, contact);
  for (long k = g->n.first[block]; k < g->n.first[block + 1] && all; k++) {
    take(h, g, block, g->n.contacts[k]);
  }
}

static const tp_near *entry_of(const tp_force_program *p, const holders *h, int k) {
  return p->columns[h->columns[k]].entry[h->sides[k]];
}

/* False where they span less than all. */
static bool choose_columns(tp_tree_link *link, const tp_force_program *p, const holders *h) {
  double most = 0;
  for (int i = 0; i < h->count; i++) {
    for (int j = i + 1; j < h->count; j++) {
      for (int k = j + 1; k < h->count; k++) {
        const tp_near volume =
            tp_near_determinant(entry_of(p, h, i), entry_of(p, h, j), entry_of(p, h, k));
        if (tp_near_sign(volume) == 0 || fabs(volume.value) <= most) continue;
        const int own[3] = {i, j, k};
        most = fabs(volume.value);
        for (int c = 0; c < 3; c++) {
          link->columns[c] = h->columns[own[c]];
          link->sides[c] = h->sides[own[c]];
        }
      }
    }
  }
  return most > 0;
}

/* Those that touch a block that was reached, or the ground (`at` past the last). */
static void grow_from(tp_ground_tree *t, const growing *g, long at, bool all) {
  const tp_force_program *p = g->p;
  for (long k = g->n.first[at]; k < g->n.first[at + 1]; k++) {
    const long *row = p->columns[p->first[g->n.contacts[k]]].row;
    for (int side = 0; side < 2; side++) {
      tp_tree_link link = {.number = row[side] / 3, .of_one_contact = !all};
      holders h;
      if (row[side] < 0 || link.number == at || g->reached[link.number]) continue;
      gather(&h, g, link.number, g->n.contacts[k], all);
      if (!choose_columns(&link, p, &h)) continue;
      g->reached[link.number] = true;
      t->links[t->count++] = link;
    }
  }
}

bool tp_ground_tree_init(tp_ground_tree *t, const tp_force_program *p) {
  const long blocks = p->rows / 3;
  growing g = {.p = p, .reached = calloc((size_t)blocks + 1, sizeof *g.reached)};
  t->count = 0;
  t->links = calloc((size_t)blocks + 1, sizeof *t->links);
  const bool done = g.reached != NULL && t->links != NULL &&
                    find_neighbours(&g.n, p, p->assemblage->contact_count);
  for (long before = -1; done && t->count > before;) {
    before = t->count;
    grow_from(t, &g, blocks, false);
    for (long k = 0; k < t->count; k++) grow_from(t, &g, t->links[k].number, false);
    if (t->count == blocks) break;
    grow_from(t, &g, blocks, true);
    for (long k = 0; k < before; k++) grow_from(t, &g, t->links[k].number, true);
  }
  free(g.n.first);
  free(g.n.contacts);
  free(g.reached);
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
  for (int k = 0; k < 3; k++) own[k] = p->columns[link->columns[k]].entry[link->sides[k]];
  const tp_near volume = tp_near_determinant(own[0], own[1], own[2]);
  for (int k = 0; k < 3; k++) {
    const tp_near part = tp_sparse_determinant(wrench, own[(k + 1) % 3], own[(k + 2) % 3]);
    factors[k] = tp_near_is_zero(part) ? part : tp_near_div(part, volume);
  }
}
