/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Gaps: loops of sides that have no neighbour, walked from each side to the next around the fan of
 * triangles at their common point, so that sheets which touch in a point stay apart. A loop that
 * comes back to a point is closed as two. */

#include "solid/mend_patch.h"
#include "solid/mend_steps.h"
#include "solid/sides.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct tracing {
  tp_mending *m;
  tp_sides sides;
  bool *walked; /* three of each triangle */
  int *loop;    /* points of the loop under way */
  long *places; /* of points: one more than where they are in it, or 0 */
  int *patch;   /* triangles that close a loop */
  long gap_room;
} tracing;

static long sides_of(const tracing *x, long t, int c) {
  long count = 0;
  const int *own = x->m->triangles + 3 * t;
  tp_sides_edge(&count, &x->sides, own[c], own[(c + 1) % 3]);
  return count;
}

/* The triangle over a side that has two. */
static long across(const tracing *x, long t, int c) {
  long count = 0;
  const int *own = x->m->triangles + 3 * t;
  const tp_side *edge = tp_sides_edge(&count, &x->sides, own[c], own[(c + 1) % 3]);
  return edge[0].triangle == t ? edge[1].triangle : edge[0].triangle;
}

/* From an open side to the next one around its end; false: it ends at an edge of three triangles.
 */
static bool step(const tracing *x, long *t, int *c) {
  const int turning = x->m->triangles[3 * *t + (*c + 1) % 3];
  *c = (*c + 1) % 3;
  for (;;) {
    const long count = sides_of(x, *t, *c);
    if (count == 1) return true;
    if (count != 2) return false;
    *t = across(x, *t, *c);
    *c = 0;
    while (x->m->triangles[3 * *t + *c] != turning) ++*c;
  }
}

/* ---- closing -----------------------------------------------------------------------------------
 */

static bool add_gap(tracing *x, const int *points, long count) {
  tp_solid_repair *record = x->m->record;
  const tp_surface *s = x->m->surface;
  if ((long)record->gap_count == x->gap_room) {
    const size_t room = 2 * record->gap_count + 4;
    tp_solid_gap *gaps = realloc(record->gaps, room * sizeof *gaps);
    if (gaps == NULL) return false;
    record->gaps = gaps;
    x->gap_room = (long)room;
  }
  tp_solid_gap *own = record->gaps + record->gap_count++;
  *own = (tp_solid_gap){.corners = (size_t)count};
  for (long k = 0; k < count; k++) {
    for (int axis = 0; axis < 3; axis++) {
      own->middle[axis] += tp_surface_given(s, points[k], axis) / (double)count;
    }
  }
  return true;
}

/* The triangles run against the sides that the loop is made of. */
static bool close_loop(tracing *x, const int *points, long count) {
  tp_mending *m = x->m;
  long patched = 0;
  if (!tp_mend_patch(x->patch, &patched, m->surface, &x->sides, points, count)) return false;
  if (patched == 0) {
    m->record->open_gaps++;
    return true;
  }
  const int face = -1 - (int)m->record->gap_count;
  if (!add_gap(x, points, count) || !tp_mending_reserve(m, patched)) return false;
  for (long k = 0; k < patched; k++) {
    const int *own = x->patch + 3 * k;
    tp_mending_add(m, points[own[0]], points[own[2]], points[own[1]], face);
  }
  return true;
}

/* From an open side on, until it comes back. */
static bool walk(tracing *x, long t, int c) {
  const long first = t;
  const int first_side = c;
  long count = 0;
  bool done = true, whole = true;
  do {
    const int point = x->m->triangles[3 * t + c];
    x->walked[3 * t + c] = true;
    if (x->places[point] > 0) { /* a loop within */
      const long from = x->places[point] - 1;
      done = done && close_loop(x, x->loop + from, count - from);
      for (long k = from; k < count; k++) x->places[x->loop[k]] = 0;
      count = from;
    }
    x->loop[count++] = point;
    x->places[point] = count;
    whole = step(x, &t, &c);
  } while (done && whole && !(t == first && c == first_side));
  if (done && whole) done = close_loop(x, x->loop, count);
  for (long k = 0; k < count; k++) x->places[x->loop[k]] = 0;
  return done;
}

bool tp_mending_close(tp_mending *m) {
  const long count = m->count;
  const size_t points = (size_t)m->surface->vertex_count + 1;
  tracing x = {.m = m};
  bool done = tp_sides_init(&x.sides, m->triangles, count, m->surface->vertex_count);
  x.walked = calloc(3 * (size_t)count + 1, sizeof *x.walked);
  x.loop = malloc(points * sizeof *x.loop);
  x.places = calloc(points, sizeof *x.places);
  x.patch = malloc(3 * points * sizeof *x.patch);
  done = done && x.walked != NULL && x.loop != NULL && x.places != NULL && x.patch != NULL;
  for (long k = 0; k < 3 * count && done; k++) {
    if (x.walked[k] || sides_of(&x, k / 3, (int)(k % 3)) != 1) continue;
    done = walk(&x, k / 3, (int)(k % 3));
  }
  tp_sides_clear(&x.sides);
  free(x.walked);
  free(x.loop);
  free(x.places);
  free(x.patch);
  return done;
}
