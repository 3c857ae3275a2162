/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sorted array of an outline's arcs by starting point, and binary search for that of an edge. */

#include "block/arc_begins.h"

#include <stdlib.h>

static int compare(const tp_arc_description *arc, const fmpq_t x, const fmpq_t y) {
  const int order = fmpq_cmp(arc->x.value, x);
  return order != 0 ? order : fmpq_cmp(arc->y.value, y);
}

/* Of equal ones the first of the block's list is first. */
static int compare_arcs(const void *one, const void *other) {
  const tp_arc_description *a = *(const tp_arc_description *const *)one;
  const tp_arc_description *b = *(const tp_arc_description *const *)other;
  const int order = compare(a, b->x.value, b->y.value);
  return order != 0 ? order : (a > b) - (a < b);
}

bool tp_arc_begins_init(tp_arc_begins *begins, const tp_block_description *block) {
  *begins = (tp_arc_begins){.count = block->arc_count};
  begins->arcs = malloc(((size_t)begins->count + 1) * sizeof *begins->arcs);
  if (begins->arcs == NULL) return false;
  for (long k = 0; k < begins->count; k++) begins->arcs[k] = block->arcs + k;
  qsort(begins->arcs, (size_t)begins->count, sizeof *begins->arcs, compare_arcs);
  return true;
}

void tp_arc_begins_clear(tp_arc_begins *begins) {
  free(begins->arcs);
}

const tp_arc_description *tp_arc_begins_find(const tp_arc_begins *begins,
                                             const tp_polyline *outline, long edge) {
  const long next = edge + 1 == outline->count ? 0 : edge + 1;
  const long own = outline->reversed ? next : edge; /* the end that its author names */
  const fmpq *x = outline->x + own, *y = outline->y + own;
  long low = 0, high = begins->count;
  while (low < high) {
    const long middle = low + (high - low) / 2;
    if (compare(begins->arcs[middle], x, y) < 0) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  if (low == begins->count || compare(begins->arcs[low], x, y) != 0) return NULL;
  return begins->arcs[low];
}
