/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Triangles of the hull that share an edge and a plane are joined; what is left of their edges is
 * put in a ring for each facet, and the rings in order. */

#include "solid/hull_facets.h"

#include "solid/sides.h"
#include "solid/turns.h"

#include <stdlib.h>
#include <string.h>

/* A facet while it is made. */
typedef struct ring {
  long start, count; /* of its sides */
} ring;

typedef struct maker {
  const tp_surface *surface;
  tp_geom_hull hull;
  tp_sides edges;
  int *facet_of; /* of each triangle: another one of its facet; then the facet's number */
  long facet_count;
  ring *rings;
  tp_hull_side *sides; /* of each ring: in the order of `from`, then one behind the other */
  tp_hull_side *loop;  /* room for one */
  int *places;         /* of each facet in the final order */
} maker;

void tp_hull_facets_clear(tp_hull_facets *facets) {
  free(facets->starts);
  free(facets->sides);
  memset(facets, 0, sizeof *facets);
}

/* ---- facets ------------------------------------------------------------------------------------
 */

/* The corner of a triangle that two vertices are not. */
static int opposite(const int *triangle, int a, int b) {
  for (int c = 0; c < 3; c++) {
    if (triangle[c] != a && triangle[c] != b) return triangle[c];
  }
  return triangle[0];
}

/* Both sides of an edge of the hull, and its lesser vertex. */
typedef void (*edge_visitor)(maker *m, int low, const tp_side sides[2]);

static void each_edge(maker *m, edge_visitor visit) {
  for (int v = 0; v < m->surface->vertex_count; v++) {
    for (long k = m->edges.starts[v]; k + 1 < m->edges.starts[v + 1]; k += 2) {
      visit(m, v, m->edges.items + k);
    }
  }
}

static void join_level(maker *m, int low, const tp_side sides[2]) {
  const int one = sides[0].triangle, other = sides[1].triangle;
  const int beyond = opposite(m->hull.triangles + 3L * other, low, sides[0].other);
  if (tp_surface_side(m->surface, m->hull.triangles + 3L * one, beyond) == 0) {
    tp_sides_join(m->facet_of, one, other);
  }
}

/* `facet_of` from leaders to numbers: a leader is before all that it leads. */
static void number_facets(maker *m) {
  for (int t = 0; t < (int)m->hull.count; t++) {
    const int leader = tp_sides_leader(m->facet_of, t);
    m->places[t] = leader == t ? (int)m->facet_count++ : m->places[leader];
  }
  memcpy(m->facet_of, m->places, m->hull.count * sizeof *m->places);
}

static bool is_inner(const maker *m, const tp_side sides[2]) {
  return m->facet_of[sides[0].triangle] == m->facet_of[sides[1].triangle];
}

static void count_sides(maker *m, int low, const tp_side sides[2]) {
  (void)low;
  if (is_inner(m, sides)) return;
  for (int k = 0; k < 2; k++) m->rings[m->facet_of[sides[k].triangle]].count++;
}

static void put_sides(maker *m, int low, const tp_side sides[2]) {
  if (is_inner(m, sides)) return;
  for (int k = 0; k < 2; k++) {
    ring *own = m->rings + m->facet_of[sides[k].triangle];
    const int high = sides[k].other;
    const bool ahead = sides[k].is_ahead;
    m->sides[own->start + own->count++] =
        (tp_hull_side){ahead ? low : high, ahead ? high : low, m->facet_of[sides[1 - k].triangle]};
  }
}

/* ---- rings -------------------------------------------------------------------------------------
 */

static int compare_from(const void *one, const void *other) {
  const int a = ((const tp_hull_side *)one)->from, b = ((const tp_hull_side *)other)->from;
  return (a > b) - (a < b);
}

/* One side behind the other, from the least vertex on; then those on one line as one, from the
 * least corner on. */
static void close_ring(maker *m, ring *own) {
  tp_hull_side *sides = m->sides + own->start, *loop = m->loop;
  qsort(sides, (size_t)own->count, sizeof *sides, compare_from);
  const tp_hull_side *at = sides;
  for (long k = 0; k < own->count && at != NULL; k++) {
    loop[k] = *at;
    const tp_hull_side next = {.from = at->to};
    at = bsearch(&next, sides, (size_t)own->count, sizeof *sides, compare_from);
  }
  long kept = 0, least = 0;
  for (long k = 0; k < own->count; k++) {
    const int before = loop[(k + own->count - 1) % own->count].from;
    if (tp_surface_is_straight(m->surface, before, loop[k].from, loop[k].to)) continue;
    sides[kept] = loop[k];
    if (sides[kept].from < sides[least].from) least = kept;
    kept++;
  }
  own->count = kept;
  memcpy(loop, sides, (size_t)kept * sizeof *loop);
  for (long k = 0; k < kept; k++) {
    sides[k] = loop[(least + k) % kept];
    sides[k].to = loop[(least + k + 1) % kept].from;
  }
}

/* A ring with what its order is told by. */
typedef struct ordered {
  const tp_hull_side *sides;
  ring own;
  long number;
} ordered;

static int compare_rings(const void *one, const void *other) {
  const ordered *a = one, *b = other;
  for (long k = 0; k < a->own.count && k < b->own.count; k++) {
    const int p = a->sides[a->own.start + k].from, q = b->sides[b->own.start + k].from;
    if (p != q) return p < q ? -1 : 1;
  }
  return 0; /* two facets share two corners at most */
}

static bool put_in_order(tp_hull_facets *facets, maker *m) {
  ordered *all = calloc((size_t)m->facet_count + 1, sizeof *all);
  facets->starts = calloc((size_t)m->facet_count + 1, sizeof *facets->starts);
  facets->sides = malloc(3 * m->hull.count * sizeof *facets->sides);
  const bool done = all != NULL && facets->starts != NULL && facets->sides != NULL;
  for (long f = 0; done && f < m->facet_count; f++) all[f] = (ordered){m->sides, m->rings[f], f};
  if (done) qsort(all, (size_t)m->facet_count, sizeof *all, compare_rings);
  for (long f = 0; done && f < m->facet_count; f++) m->places[all[f].number] = (int)f;
  for (long f = 0; done && f < m->facet_count; f++) {
    const ring own = all[f].own;
    tp_hull_side *sides = facets->sides + facets->starts[f];
    memcpy(sides, m->sides + own.start, (size_t)own.count * sizeof *sides);
    for (long k = 0; k < own.count; k++) sides[k].neighbour = m->places[sides[k].neighbour];
    facets->starts[f + 1] = facets->starts[f] + own.count;
  }
  facets->count = m->facet_count;
  free(all);
  return done;
}

static bool gather(tp_hull_facets *facets, maker *m) {
  const size_t count = m->hull.count;
  m->facet_of = malloc(count * sizeof *m->facet_of);
  m->places = malloc(count * sizeof *m->places);
  m->rings = calloc(count, sizeof *m->rings);
  m->sides = malloc(3 * count * sizeof *m->sides);
  m->loop = malloc(3 * count * sizeof *m->loop);
  if (m->facet_of == NULL || m->places == NULL || m->rings == NULL || m->sides == NULL ||
      m->loop == NULL ||
      !tp_sides_init(&m->edges, m->hull.triangles, (long)count, m->surface->vertex_count)) {
    return false;
  }
  for (size_t t = 0; t < count; t++) m->facet_of[t] = (int)t;
  each_edge(m, join_level);
  number_facets(m);
  each_edge(m, count_sides);
  for (long f = 0, start = 0; f < m->facet_count; f++) {
    m->rings[f].start = start;
    start += m->rings[f].count;
    m->rings[f].count = 0; /* to be counted anew as they are put */
  }
  each_edge(m, put_sides);
  for (long f = 0; f < m->facet_count; f++) close_ring(m, m->rings + f);
  return put_in_order(facets, m);
}

tp_status tp_hull_facets_init(tp_hull_facets *facets, const tp_surface *surface,
                              tp_message *message) {
  const tp_geom_points points = tp_surface_points(surface);
  maker m = {.surface = surface};
  *facets = (tp_hull_facets){.count = 0};
  const tp_geom_status found = tp_geom_find_hull(&m.hull, &points);
  tp_status status = TP_OK;
  if (found == TP_GEOM_FAILED) {
    status = tp_fail(message, TP_DEPENDENCY_FAILED, (tp_place){surface->mesh->file, 0, 0},
                     "CGAL failed to find the convex hull of the solid");
  } else if (found != TP_GEOM_OK || !gather(facets, &m)) {
    status = tp_fail_memory(message, "the convex hull of a solid");
  }
  tp_geom_hull_clear(&m.hull);
  tp_sides_clear(&m.edges);
  free(m.facet_of);
  free(m.places);
  free(m.rings);
  free(m.sides);
  free(m.loop);
  return status;
}
