/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* qsort and qsort_r by merging, as glibc's: what compares equal keeps its order, so that the same
 * input gives the same output as natively. musl's qsort keeps no order, and its qsort_r came later
 * than this emscripten. */

#include <stdlib.h>
#include <string.h>

typedef int comparison(const void *, const void *, void *);

typedef struct {
  size_t size;
  comparison *compare;
  void *context;
} order;

static void sort_range(const order *o, char *items, size_t count, char *room) {
  if (count < 2) return;
  const size_t half = count / 2, size = o->size;
  char *left = items, *right = items + half * size, *out = room;
  size_t lefts = half, rights = count - half;
  sort_range(o, left, lefts, room);
  sort_range(o, right, rights, room);
  while (lefts > 0 && rights > 0) {
    char **first = o->compare(left, right, o->context) <= 0 ? &left : &right;
    size_t *rest = first == &left ? &lefts : &rights;
    memcpy(out, *first, size);
    *first += size;
    out += size;
    --*rest;
  }
  memcpy(out, left, lefts * size); /* of the right half, the rest is in its place */
  memcpy(items, room, (count - rights) * size);
}

void qsort_r(void *items, size_t count, size_t size, comparison *compare, void *context) {
  if (count < 2 || size == 0) return;
  char *room = malloc(count * size);
  if (room == NULL) abort(); /* qsort has no way to say so; the page starts the core anew */
  sort_range(&(order){size, compare, context}, items, count, room);
  free(room);
}

static int compare_plainly(const void *a, const void *b, void *compare) {
  return (*(int (**)(const void *, const void *))compare)(a, b);
}

void qsort(void *items, size_t count, size_t size, int (*compare)(const void *, const void *)) {
  qsort_r(items, count, size, compare_plainly, &compare);
}
