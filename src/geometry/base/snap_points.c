/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Points of the profile that become vertices of the block's edges: each is assigned to the edge
 * within whose moved ends it lies, by exact signs, and sorted along the profile. */

#include "base/snap_search.h"

#include "common/grow.h"

#include <stdlib.h>

/* Does the vertex lie on the profile now, before the point (-1) or behind it (1)? */
static int place_by(const tp_snap_search *s, long vertex, long point) {
  if (s->of_vertex[vertex] < 0) return 0;
  return s->feet[s->of_vertex[vertex]].pair.edge < point ? -1 : 1;
}

/* The edges follow one another along the profile: a point that its edge's ends have passed belongs
 * to the one before, or behind. */
static long edge_for(const tp_snap_search *s, const tp_snap_foot *f) {
  long edge = f->pair.edge;
  for (long k = 0; k < s->outline->count && place_by(s, edge, f->pair.vertex) > 0; k++) {
    edge = tp_snap_before(s, edge);
  }
  for (long k = 0; k < s->outline->count && place_by(s, tp_snap_next(s, edge), f->pair.vertex) < 0;
       k++) {
    edge = tp_snap_next(s, edge);
  }
  return edge;
}

static int compare_taken(const void *a, const void *b) {
  const tp_snap_taken *one = a, *other = b;
  if (one->edge != other->edge) return one->edge < other->edge ? -1 : 1;
  return (one->point > other->point) - (one->point < other->point);
}

bool tp_snap_list_points(tp_snap_search *s) {
  for (long p = 0; p < s->near->points; p++) {
    if (s->of_point[p] < 0 || s->has_vertex[p]) continue;
    tp_snap_taken *room = tp_grow(s->points, s->taken_count, &s->taken_capacity, sizeof *room);
    if (room == NULL) return false;
    s->points = room;
    s->points[s->taken_count++] = (tp_snap_taken){edge_for(s, s->feet + s->of_point[p]), p};
  }
  if (s->taken_count > 1) {
    qsort(s->points, (size_t)s->taken_count, sizeof *s->points, compare_taken);
  }
  return true;
}

static bool is_moved(const tp_snap_search *s, long vertex) {
  return s->of_vertex[vertex] >= 0 && !fmpq_is_zero(s->feet[s->of_vertex[vertex]].square);
}

/* Points that lie on an edge already need not become vertices, if nothing else of it moves. */
static bool edge_stays(const tp_snap_search *s, long first, long last) {
  const long edge = s->points[first].edge;
  if (is_moved(s, edge) || is_moved(s, tp_snap_next(s, edge))) return false;
  for (long k = first; k < last; k++) {
    if (!fmpq_is_zero(s->feet[s->of_point[s->points[k].point]].square)) return false;
  }
  return true;
}

/* Sign of (B - A) x (R - P), of an edge of the outline and two points of the profile. */
static int side_of_edge(const tp_snap_search *s, long edge, long p, long r) {
  const tp_polyline *o = s->outline, *ring = s->ring;
  const long next = tp_snap_next(s, edge);
  fmpq_t ex, ey, rx, ry;
  fmpq_init(ex);
  fmpq_init(ey);
  fmpq_init(rx);
  fmpq_init(ry);
  fmpq_sub(ex, o->x + next, o->x + edge);
  fmpq_sub(ey, o->y + next, o->y + edge);
  fmpq_sub(rx, ring->x + r, ring->x + p);
  fmpq_sub(ry, ring->y + r, ring->y + p);
  fmpq_mul(ex, ex, ry);
  fmpq_submul(ex, ey, rx);
  const int sign = fmpq_sgn(ex);
  fmpq_clear(ex);
  fmpq_clear(ey);
  fmpq_clear(rx);
  fmpq_clear(ry);
  return sign;
}

/* Is the vertex on the profile's edge, ends included? */
static bool lies_on(const tp_snap_search *s, long vertex, long edge) {
  if (s->of_vertex[vertex] < 0) return false;
  const tp_snap_foot *f = s->feet + s->of_vertex[vertex];
  return f->pair.edge == edge || (f->pair.edge == edge + 1 && fmpq_is_zero(f->share));
}

/* Would the point carry the block by itself: a crest below the edge, no end of a facet? With the
 * share of the edge up to which there is room on either side of it. */
static bool stands_alone(fmpq_t room, const tp_snap_search *s, long own, long first, long last) {
  const tp_snap_taken *t = s->points + own;
  const tp_snap_foot *f = s->feet + s->of_point[t->point];
  const long p = t->point;
  if (f->pair.edge != t->edge || fmpq_is_zero(f->share) || fmpq_is_one(f->share)) return false;
  if (lies_on(s, t->edge, p - 1) || lies_on(s, tp_snap_next(s, t->edge), p)) return false;
  if (p > 0 && side_of_edge(s, t->edge, p, p - 1) >= 0) return false;
  if (p + 1 < s->near->points && side_of_edge(s, t->edge, p, p + 1) >= 0) return false;
  fmpq_set(room, f->share);
  if (own > first) {
    if (t[-1].point + 1 == p) return false;
    fmpq_sub(room, room, s->feet[s->of_point[t[-1].point]].share);
  }
  fmpq_t other;
  fmpq_init(other);
  fmpq_one(other);
  bool alone = true;
  if (own + 1 < last) {
    alone = t[1].point != p + 1;
    fmpq_set(other, s->feet[s->of_point[t[1].point]].share);
  }
  fmpq_sub(other, other, f->share);
  if (fmpq_cmp(other, room) < 0) fmpq_set(room, other);
  fmpq_clear(other);
  return alone && fmpq_sgn(room) > 0;
}

/* A point of the edge's direction through P, a share of its length away. */
static bool append_beside(tp_snap *snap, const tp_snap_search *s, const tp_snap_taken *t,
                          const fmpq_t share) {
  const tp_polyline *o = s->outline;
  const long next = tp_snap_next(s, t->edge);
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  fmpq_sub(x, o->x + next, o->x + t->edge);
  fmpq_mul(x, x, share);
  fmpq_add(x, x, s->ring->x + t->point);
  fmpq_sub(y, o->y + next, o->y + t->edge);
  fmpq_mul(y, y, share);
  fmpq_add(y, y, s->ring->y + t->point);
  const bool done = tp_polyline_append(&snap->outline, x, y, o->marks[t->edge]);
  fmpq_clear(x);
  fmpq_clear(y);
  return done;
}

/* Less a quarter of the room; of one with many digits, of the power of two below it. */
static void take_part(fmpq_t room) {
  enum { SHORT_BITS = 64 };
  const long above = (long)fmpz_bits(fmpq_numref(room)), below = (long)fmpz_bits(fmpq_denref(room));
  if (below > SHORT_BITS) {
    fmpq_one(room);
    fmpq_div_2exp(room, room, (ulong)(below + 1 - above)); /* at most a half, as room is below 1 */
  }
  fmpq_div_2exp(room, room, 2);
  fmpq_neg(room, room);
}

/* A vertex; or where that would be a corner on a corner, a piece of the edge through it, as steep
 * as the edge. */
static bool take_point(tp_snap *snap, const tp_snap_search *s, long own, long first, long last) {
  const tp_snap_taken *t = s->points + own;
  const tp_snap_foot *f = s->feet + s->of_point[t->point];
  if (!fmpq_is_zero(f->square)) snap->taken_count++;
  if (fmpq_cmp(f->square, snap->most) > 0) fmpq_set(snap->most, f->square);
  fmpq_t room;
  fmpq_init(room);
  bool done;
  if (stands_alone(room, s, own, first, last)) {
    take_part(room);
    done = append_beside(snap, s, t, room);
    fmpq_neg(room, room);
    done = done && append_beside(snap, s, t, room);
  } else {
    done = tp_polyline_append(&snap->outline, s->ring->x + t->point, s->ring->y + t->point,
                              s->outline->marks[t->edge]);
  }
  fmpq_clear(room);
  return done;
}

bool tp_snap_build(tp_snap *snap, const tp_snap_search *s) {
  long k = 0;
  if (!tp_polyline_reserve(&snap->outline, s->outline->count + 2 * s->taken_count)) return false;
  snap->outline.file = s->outline->file;
  snap->outline.mark = s->outline->mark;
  snap->outline.reversed = s->outline->reversed;
  for (long v = 0; v < s->outline->count; v++) {
    if (!tp_polyline_append(&snap->outline, snap->moved.x + v, snap->moved.y + v,
                            s->outline->marks[v])) {
      return false;
    }
    long end = k;
    while (end < s->taken_count && s->points[end].edge == v) end++;
    if (end > k && edge_stays(s, k, end)) k = end;
    for (const long first = k; k < end; k++) {
      if (!take_point(snap, s, k, first, end)) return false;
    }
  }
  return true;
}
