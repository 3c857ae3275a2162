/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sorts pieces by points and bulges, each from its lesser end on, and drops equal neighbours. */

#include "format/twins.h"

#include <stdlib.h>

static int compare_points(const tp_polyline *a, long k, const tp_polyline *b, long j) {
  const int x = fmpq_cmp(a->x + k, b->x + j);
  return x != 0 ? x : fmpq_cmp(a->y + k, b->y + j);
}

/* Does it run from its greater end to its lesser one? */
static bool runs_back(const tp_drawing_object *object) {
  return compare_points(&object->line, 0, &object->line, object->line.count - 1) > 0;
}

static int compare_bulges(const tp_drawing_object *a, long k, bool back_a,
                          const tp_drawing_object *b, long j, bool back_b) {
  fmpq_t one, other;
  fmpq_init(one);
  fmpq_init(other);
  const fmpq *first = tp_drawing_bulge(a, k), *second = tp_drawing_bulge(b, j);
  if (first != NULL) fmpq_set(one, first);
  if (second != NULL) fmpq_set(other, second);
  if (back_a) fmpq_neg(one, one);
  if (back_b) fmpq_neg(other, other);
  const int order = fmpq_cmp(one, other);
  fmpq_clear(one);
  fmpq_clear(other);
  return order;
}

/* An order of pieces, each taken from its lesser end on: equal are those that are the same curve.
 */
static int compare_pieces(const void *one, const void *other) {
  const tp_drawing_object *a = *(const tp_drawing_object *const *)one;
  const tp_drawing_object *b = *(const tp_drawing_object *const *)other;
  const long count = a->line.count;
  if (count != b->line.count) return count < b->line.count ? -1 : 1;
  const bool back_a = runs_back(a), back_b = runs_back(b);
  int order = 0;
  for (long k = 0; k < count && order == 0; k++) {
    order =
        compare_points(&a->line, back_a ? count - 1 - k : k, &b->line, back_b ? count - 1 - k : k);
  }
  for (long k = 0; k + 1 < count && order == 0; k++) {
    order = compare_bulges(a, back_a ? count - 2 - k : k, back_a, b, back_b ? count - 2 - k : k,
                           back_b);
  }
  return order;
}

static int compare_addresses(const void *one, const void *other) {
  const tp_drawing_object *a = *(const tp_drawing_object *const *)one;
  const tp_drawing_object *b = *(const tp_drawing_object *const *)other;
  return a < b ? -1 : a > b;
}

/* Objects of one drawing stand in one array, in the order of the file. */
long tp_drawing_drop_twins(const tp_drawing_object **pieces, long count, tp_place *place) {
  long kept = 0;
  qsort(pieces, (size_t)count, sizeof *pieces, compare_pieces);
  for (long k = 0; k < count; k++) {
    if (kept > 0 && compare_pieces(pieces + kept - 1, pieces + k) == 0) {
      if (kept == k) *place = tp_drawing_place(pieces[k]);
    } else {
      pieces[kept++] = pieces[k];
    }
  }
  qsort(pieces, (size_t)kept, sizeof *pieces, compare_addresses);
  return kept;
}
