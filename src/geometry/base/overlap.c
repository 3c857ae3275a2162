/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Angular sectors of the interiors around each point of contact, compared by signs of cross
 * products; ray crossing where two rings do not touch. */

#include "base/overlap.h"

/* From one point of the lattice to another. */
typedef struct way {
  long from, to;
} way;

/* Around a point of a ring its inside lies counter-clockwise from `begin` to `end`. */
typedef struct sector {
  way begin, end;
} sector;

static int cross(const tp_lattice *l, way a, way b) {
  return tp_lattice_cross(l, a.from, a.to, b.from, b.to);
}

static bool same_way(const tp_lattice *l, way a, way b) {
  return cross(l, a, b) == 0 && tp_lattice_dot(l, a.from, a.to, b.from, b.to) > 0;
}

static long next_of(const tp_overlap_ring *ring, long point) {
  return point + 1 == ring->first + ring->count ? ring->first : point + 1;
}

static long before(const tp_overlap_ring *ring, long point) {
  return (point == ring->first ? ring->first + ring->count : point) - 1;
}

/* Of a point on the edge: an end of it, or between them. */
static sector sector_at(const tp_lattice *l, const tp_overlap_ring *ring, long edge, long point) {
  const long far = next_of(ring, edge);
  way to_next = {edge, far}, to_last = {far, edge};
  if (tp_lattice_same_point(l, point, edge)) {
    to_last = (way){edge, before(ring, edge)};
  } else if (tp_lattice_same_point(l, point, far)) {
    to_next = (way){far, next_of(ring, far)};
  }
  return ring->clockwise ? (sector){to_last, to_next} : (sector){to_next, to_last};
}

/* Does the sector hold the way, its begin included? It is neither empty nor a whole turn. */
static bool holds(const tp_lattice *l, const sector *s, way w) {
  if (same_way(l, w, s->begin)) return true;
  if (same_way(l, w, s->end)) return false;
  const bool after_begin = cross(l, s->begin, w) > 0, before_end = cross(l, w, s->end) > 0;
  const int turn = cross(l, s->begin, s->end);
  if (turn == 0) return after_begin;
  return turn > 0 ? after_begin && before_end : after_begin || before_end;
}

void tp_overlap_meet(tp_overlap *o, tp_geom_meeting_kind kind, long edge_a, long edge_b) {
  const tp_lattice *l = o->lattice;
  const way a = {edge_a, next_of(&o->a, edge_a)}, b = {edge_b, next_of(&o->b, edge_b)};
  o->touch = true;
  if (o->found) return;
  if (kind == TP_GEOM_OVERLAP) { /* its ends are touches of their own */
    o->found = same_way(l, a, b) == (o->a.clockwise == o->b.clockwise);
    return;
  }
  const long point = tp_facet_touch(l, a.from, a.to, b.from, b.to);
  const sector of_a = sector_at(l, &o->a, edge_a, point), of_b = sector_at(l, &o->b, edge_b, point);
  o->found = holds(l, &of_a, of_b.begin) || holds(l, &of_b, of_a.begin);
}

/* Does a point that is on no edge lie in the ring? By the edges that a ray to the right crosses. */
static bool lies_in(const tp_lattice *l, const tp_overlap_ring *ring, long point) {
  bool in = false;
  for (long k = ring->first; k < ring->first + ring->count; k++) {
    const long next = next_of(ring, k);
    const bool from = fmpz_cmp(l->y + k, l->y + point) > 0;
    const bool to = fmpz_cmp(l->y + next, l->y + point) > 0;
    if (from != to) in ^= (tp_lattice_cross(l, k, next, k, point) > 0) == to;
  }
  return in;
}

bool tp_overlap_is(const tp_overlap *o) {
  if (o->touch) return o->found;
  return lies_in(o->lattice, &o->a, o->b.first) || lies_in(o->lattice, &o->b, o->a.first);
}
