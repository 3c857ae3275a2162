/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The outline crosses the line an even number of times. Sorted along it, crossings are pairs, and
 * between the two of a pair the line lies inside: a walk goes along the outline above the line, and
 * over to the other crossing of the pair where it comes down to it, until it is back. A corner on
 * the line counts as below it. */

#include "report/section_above.h"

#include "solid/surface.h"

#include <math.h>
#include <stdlib.h>

typedef struct crossing {
  double x;
  long edge; /* from this corner of the outline to the next */
  bool up;
} crossing;

typedef struct walk {
  const tp_polyline *outline;
  double level;
  double *x, *y; /* of the outline */
  long count;    /* of crossings */
  crossing *crossings;
  bool *passed;
} walk;

static int compare(const void *one, const void *other) {
  const crossing *a = one, *b = other;
  if (a->x != b->x) return a->x < b->x ? -1 : 1;
  return (a->edge > b->edge) - (a->edge < b->edge);
}

static void find_crossings(walk *w) {
  const long corners = w->outline->count;
  for (long k = 0; k < corners; k++) {
    const long next = (k + 1) % corners;
    const bool from = w->y[k] > w->level, to = w->y[next] > w->level;
    if (from == to) continue;
    const double share = (w->level - w->y[k]) / (w->y[next] - w->y[k]);
    w->crossings[w->count++] = (crossing){w->x[k] + share * (w->x[next] - w->x[k]), k, to};
  }
  qsort(w->crossings, (size_t)w->count, sizeof *w->crossings, compare);
}

static void add(tp_section_above *piece, double x, double y) {
  const long last = piece->count - 1;
  if (last >= 0 && piece->x[last] == x && piece->y[last] == y) return;
  piece->x[piece->count] = x;
  piece->y[piece->count++] = y;
}

static long crossing_of_edge(const walk *w, long edge) {
  long k = 0;
  while (k + 1 < w->count && w->crossings[k].edge != edge) k++;
  return k;
}

/* From a crossing where the outline comes up. */
static void go(tp_section_above *piece, walk *w, long start) {
  const long corners = w->outline->count;
  piece->count = 0;
  for (long at = start; !w->passed[at]; at ^= 1) {
    w->passed[at] = true;
    add(piece, w->crossings[at].x, w->level);
    long k = (w->crossings[at].edge + 1) % corners;
    for (; w->y[k] > w->level; k = (k + 1) % corners) add(piece, w->x[k], w->y[k]);
    at = crossing_of_edge(w, (k + corners - 1) % corners);
    w->passed[at] = true;
    add(piece, w->crossings[at].x, w->level);
  }
}

static double area(const tp_section_above *piece) {
  double sum = 0;
  for (long k = 0; k < piece->count; k++) {
    const long next = (k + 1) % piece->count;
    sum += piece->x[k] * piece->y[next] - piece->x[next] * piece->y[k];
  }
  return fabs(sum);
}

static bool make_room(tp_section_above *piece, size_t corners) {
  *piece = (tp_section_above){.x = malloc(2 * corners * sizeof *piece->x),
                              .y = malloc(2 * corners * sizeof *piece->y)};
  return piece->x != NULL && piece->y != NULL;
}

static void take_largest(tp_section_above *above, tp_section_above *piece, walk *w) {
  for (long k = 0; k < w->count; k++) {
    if (!w->crossings[k].up || w->passed[k]) continue;
    go(piece, w, k);
    if (area(piece) <= area(above)) continue;
    const tp_section_above larger = *piece;
    *piece = *above;
    *above = larger;
  }
}

bool tp_section_above_init(tp_section_above *above, const tp_polyline *outline, double level) {
  const size_t corners = (size_t)outline->count;
  tp_section_above piece;
  walk w = {.outline = outline,
            .level = level,
            .x = malloc(corners * sizeof *w.x),
            .y = malloc(corners * sizeof *w.y),
            .crossings = malloc(corners * sizeof *w.crossings),
            .passed = calloc(corners, sizeof *w.passed)};
  const bool has_room = make_room(above, corners);
  const bool done = make_room(&piece, corners) && has_room && w.x != NULL && w.y != NULL &&
                    w.crossings != NULL && w.passed != NULL;
  if (done) {
    for (size_t k = 0; k < corners; k++) {
      w.x[k] = tp_surface_nearest(outline->x + k);
      w.y[k] = tp_surface_nearest(outline->y + k);
    }
    find_crossings(&w);
    take_largest(above, &piece, &w);
  }
  tp_section_above_clear(&piece);
  free(w.x);
  free(w.y);
  free(w.crossings);
  free(w.passed);
  return done;
}

void tp_section_above_clear(tp_section_above *above) {
  free(above->x);
  free(above->y);
}
