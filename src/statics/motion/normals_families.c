/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Contact points on a lattice in order: counted into their families, which are found by hashing and
 * sorted, and sorted along each family, by words alone; O(n) and what sorting takes. */

#include "motion/normals_order.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Where all is whole one slope is one axis. */
static int compare_whole(const void *left, const void *right) {
  const tp_normal_entry *a = left, *b = right;
  if (a->slope != b->slope) return a->slope < b->slope ? -1 : 1;
  const bool against = tp_normal_entry_is_against(a);
  if (against != tp_normal_entry_is_against(b)) return against ? -1 : 1;
  if (a->along.whole != b->along.whole) return a->along.whole < b->along.whole ? -1 : 1;
  if (a->site != b->site) return a->site < b->site ? -1 : 1;
  return a->tag < b->tag ? -1 : a->tag > b->tag; /* by points */
}

/* A family by its slope and its sense. */
typedef struct family {
  double slope;
  long is_against;
  long index, count;
} family;

static int compare_families(const void *left, const void *right) {
  const family *a = left, *b = right;
  if (a->slope != b->slope) return a->slope < b->slope ? -1 : 1;
  return a->is_against < b->is_against ? 1 : a->is_against > b->is_against ? -1 : 0;
}

/* Families as they come, found by hashing with open addresses. */
typedef struct grouping {
  int32_t *of;    /* by entry: the index of its family */
  int32_t *table; /* an index and one more; 0: none */
  int bits;       /* 2^bits places, more than twice as many as points */
  int32_t count, capacity;
  family *families;
} grouping;

static int32_t add_family(grouping *g, double slope, bool is_against) {
  if (g->count == g->capacity) {
    const int32_t capacity = g->capacity < INT32_MAX / 2 ? 2 * g->capacity + 16 : INT32_MAX;
    family *families = realloc(g->families, (size_t)capacity * sizeof *families);
    if (families == NULL) return -1;
    g->families = families;
    g->capacity = capacity;
  }
  g->families[g->count] = (family){.slope = slope, .is_against = is_against, .index = g->count};
  return g->count++;
}

/* -1 without memory. */
static int32_t find_family(grouping *g, double slope, bool is_against) {
  uint64_t key;
  memcpy(&key, &slope, sizeof key);
  const uint64_t golden = 0x9e3779b97f4a7c15; /* 2^64 over the golden ratio: Knuth's hashing */
  uint64_t place = ((key ^ (uint64_t)is_against) * golden) >> (64 - g->bits);
  for (; g->table[place] != 0; place = (place + 1) & (((uint64_t)1 << g->bits) - 1)) {
    const family *own = g->families + g->table[place] - 1;
    if (own->slope == slope && own->is_against == is_against) return g->table[place] - 1;
  }
  const int32_t added = add_family(g, slope, is_against);
  if (added >= 0) g->table[place] = added + 1;
  return added;
}

/* More points than an index has are beyond any memory. */
static bool grouping_init(grouping *g, const tp_normals_order *order) {
  const size_t room = (size_t)order->count + 1;
  memset(g, 0, sizeof *g);
  if (room > INT32_MAX / 2) return false;
  g->bits = (int)FLINT_BIT_COUNT(room) + 1;
  g->of = calloc(room, sizeof *g->of);
  g->table = calloc((size_t)1 << g->bits, sizeof *g->table);
  if (g->of == NULL || g->table == NULL) return false;
  for (long k = 0; k < order->count; k++) {
    const tp_normal_entry *e = order->entries + k;
    g->of[k] = find_family(g, e->slope, tp_normal_entry_is_against(e));
    if (g->of[k] < 0) return false;
    g->families[g->of[k]].count++;
  }
  return true;
}

/* Entries family by family: there are few of them as a rule, and along each one points come nearly
 * in order, so that little is left to be sorted. `starts` has room for an index of each family. */
static void place_entries(tp_normal_entry *sorted, const tp_normals_order *order, grouping *g,
                          long *starts) {
  if (g->count == 0) return; /* nothing touches the block, and there is no list */
  qsort(g->families, (size_t)g->count, sizeof *g->families, compare_families);
  long next = 0;
  for (long f = 0; f < g->count; f++) {
    starts[g->families[f].index] = next;
    next += g->families[f].count;
  }
  for (long k = 0; k < order->count; k++) sorted[starts[g->of[k]]++] = order->entries[k];
  tp_normal_entry *first = sorted;
  for (long f = 0; f < g->count; f++) {
    qsort(first, (size_t)g->families[f].count, sizeof *first, compare_whole);
    first += g->families[f].count;
  }
}

bool tp_normals_order_by_families(tp_normals_order *order) {
  grouping g;
  const bool grouped = grouping_init(&g, order);
  tp_normal_entry *sorted = calloc((size_t)order->count + 1, sizeof *sorted);
  long *starts = calloc((size_t)g.count + 1, sizeof *starts);
  const bool done = grouped && sorted != NULL && starts != NULL;
  if (done) {
    place_entries(sorted, order, &g, starts);
    free(order->entries);
    order->entries = sorted;
  } else {
    free(sorted);
  }
  free(starts);
  free(g.of);
  free(g.table);
  free(g.families);
  return done;
}
