/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Triangles of the hull that share an edge and a plane are joined; what is left of their edges is
 * put in a ring for each facet, and the rings in order. The hull is proven (solid/hull.h): a facet
 * is convex, and its edges are one ring. */

#include "solid/hull_facets.h"

#include "solid/hull.h"
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
  tp_hull hull;
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

static void join_level(maker *m) {
  for (int t = 0; t < (int)m->hull.count; t++) {
    for (int c = 0; c < 3; c++) {
      if (m->hull.level[3L * t + c]) tp_sides_join(m->facet_of, t, m->hull.across[3L * t + c]);
    }
  }
}

/* `facet_of` from leaders to numbers: a leader is before all that it leads. */
static void number_facets(maker *m) {
  for (int t = 0; t < (int)m->hull.count; t++) {
    const int leader = tp_sides_leader(m->facet_of, t);
    m->places[t] = leader == t ? (int)m->facet_count++ : m->places[leader];
  }
  memcpy(m->facet_of, m->places, (size_t)m->hull.count * sizeof *m->places);
}

/* The facet beyond a side of a triangle; below 0: its own. */
static int facet_beyond(const maker *m, long side) {
  const int other = m->facet_of[m->hull.across[side]];
  return other == m->facet_of[side / 3] ? -1 : other;
}

static void put_sides(maker *m) {
  const long count = 3 * m->hull.count;
  for (long k = 0; k < count; k++) {
    if (facet_beyond(m, k) >= 0) m->rings[m->facet_of[k / 3]].count++;
  }
  for (long f = 0, start = 0; f < m->facet_count; f++) {
    m->rings[f].start = start;
    start += m->rings[f].count;
    m->rings[f].count = 0; /* to be counted again as they are put */
  }
  for (long k = 0; k < count; k++) {
    const int beyond = facet_beyond(m, k);
    if (beyond < 0) continue;
    ring *own = m->rings + m->facet_of[k / 3];
    const int from = m->hull.corners[k], to = m->hull.corners[k - k % 3 + (k + 1) % 3];
    m->sides[own->start + own->count++] = (tp_hull_side){from, to, beyond};
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
  facets->sides = malloc(3 * (size_t)m->hull.count * sizeof *facets->sides);
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
  const size_t count = (size_t)m->hull.count;
  m->facet_of = malloc(count * sizeof *m->facet_of);
  m->places = malloc(count * sizeof *m->places);
  m->rings = calloc(count, sizeof *m->rings);
  m->sides = malloc(3 * count * sizeof *m->sides);
  m->loop = malloc(3 * count * sizeof *m->loop);
  if (m->facet_of == NULL || m->places == NULL || m->rings == NULL || m->sides == NULL ||
      m->loop == NULL) {
    return false;
  }
  for (size_t t = 0; t < count; t++) m->facet_of[t] = (int)t;
  join_level(m);
  number_facets(m);
  put_sides(m);
  for (long f = 0; f < m->facet_count; f++) close_ring(m, m->rings + f);
  return put_in_order(facets, m);
}

tp_status tp_hull_facets_init(tp_hull_facets *facets, const tp_surface *surface,
                              tp_message *message) {
  maker m = {.surface = surface};
  *facets = (tp_hull_facets){.count = 0};
  tp_status status = tp_hull_find(&m.hull, surface, message);
  if (status == TP_OK && !gather(facets, &m)) {
    status = tp_fail_memory(message, "the convex hull of a solid");
  }
  tp_hull_clear(&m.hull);
  free(m.facet_of);
  free(m.places);
  free(m.rings);
  free(m.sides);
  free(m.loop);
  return status;
}
