/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sides by counting: how many each vertex has, where they begin, then each at its place. */

#include "solid/sides.h"

#include <stdlib.h>

static void each_side(tp_sides *sides, const int *triangles, long count, bool fill) {
  for (long t = 0; t < count; t++) {
    for (int c = 0; c < 3; c++) {
      const int a = triangles[3 * t + c], b = triangles[3 * t + (c + 1) % 3];
      const int low = a < b ? a : b, high = a < b ? b : a;
      if (fill) {
        sides->items[sides->starts[low]++] = (tp_side){high, (int)t, a < b};
      } else {
        sides->starts[low + 1]++;
      }
    }
  }
}

static int compare(const void *one, const void *other) {
  const tp_side *a = one, *b = other;
  if (a->other != b->other) return a->other < b->other ? -1 : 1;
  return (a->triangle > b->triangle) - (a->triangle < b->triangle);
}

bool tp_sides_init(tp_sides *sides, const int *triangles, long count, long vertex_count) {
  sides->starts = calloc((size_t)vertex_count + 1, sizeof *sides->starts);
  sides->items = malloc(3 * (size_t)count * sizeof *sides->items);
  if (sides->starts == NULL || sides->items == NULL) return false;
  each_side(sides, triangles, count, false);
  for (long v = 0; v < vertex_count; v++) sides->starts[v + 1] += sides->starts[v];
  each_side(sides, triangles, count, true);
  /* filling has moved each start to the next one */
  for (long v = vertex_count; v > 0; v--) sides->starts[v] = sides->starts[v - 1];
  sides->starts[0] = 0;
  for (long v = 0; v < vertex_count; v++) {
    const long own = sides->starts[v + 1] - sides->starts[v];
    if (own > 1) qsort(sides->items + sides->starts[v], (size_t)own, sizeof(tp_side), compare);
  }
  return true;
}

void tp_sides_clear(tp_sides *sides) {
  free(sides->starts);
  free(sides->items);
}

int tp_sides_leader(int *leaders, int triangle) {
  while (leaders[triangle] != triangle) {
    leaders[triangle] = leaders[leaders[triangle]];
    triangle = leaders[triangle];
  }
  return triangle;
}

void tp_sides_join(int *leaders, int one, int other) {
  one = tp_sides_leader(leaders, one);
  other = tp_sides_leader(leaders, other);
  if (one < other) leaders[other] = one;
  if (other < one) leaders[one] = other;
}

const tp_side *tp_sides_edge(long *count, const tp_sides *sides, int one, int other) {
  const int low = one < other ? one : other, high = one < other ? other : one;
  long first = sides->starts[low], end = sides->starts[low + 1];
  while (first < end) {
    const long middle = first + (end - first) / 2;
    if (sides->items[middle].other < high) {
      first = middle + 1;
    } else {
      end = middle;
    }
  }
  *count = 0;
  while (first + *count < sides->starts[low + 1] && sides->items[first + *count].other == high) {
    ++*count;
  }
  return sides->items + first;
}
