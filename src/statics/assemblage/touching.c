/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Pairs of blocks by contact, both ways, sorted; each is kept once. */

#include "assemblage/touching.h"

#include <stdlib.h>

typedef struct joined {
  long block, other;
} joined;

static int compare(const void *first, const void *second) {
  const joined *a = first, *b = second;
  if (a->block != b->block) return a->block < b->block ? -1 : 1;
  return a->other < b->other ? -1 : a->other > b->other;
}

static long gather(joined *pairs, const tp_force_program *p) {
  long count = 0;
  for (long k = 0; k < p->assemblage->contact_count; k++) {
    if (p->first[k] == p->first[k + 1]) continue;
    const long *row = p->columns[p->first[k]].row;
    if (row[0] < 0 || row[1] < 0) continue;
    pairs[count++] = (joined){row[0] / 3, row[1] / 3};
    pairs[count++] = (joined){row[1] / 3, row[0] / 3};
  }
  qsort(pairs, (size_t)count, sizeof *pairs, compare);
  return count;
}

bool tp_touching_find(long *first, long **neighbours, const tp_force_program *p) {
  const size_t room = 2 * (size_t)p->assemblage->contact_count + 1;
  joined *pairs = calloc(room, sizeof *pairs);
  *neighbours = calloc(room, sizeof **neighbours);
  const bool done = pairs != NULL && *neighbours != NULL;
  const long count = done ? gather(pairs, p) : 0;
  long kept = 0, at = 0;
  for (long b = 0; b < p->rows / 3; b++) {
    first[b] = kept;
    for (; at < count && pairs[at].block == b; at++) {
      if (at == 0 || compare(pairs + at - 1, pairs + at) != 0) {
        (*neighbours)[kept++] = pairs[at].other;
      }
    }
  }
  first[p->rows / 3] = kept;
  free(pairs);
  return done;
}
