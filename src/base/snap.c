/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "base/snap.h"

#include "grow.h"

#include <stdlib.h>
#include <string.h>

/* The nearest point of the other body to a vertex, by an edge and a share of it. */
typedef struct foot {
  tp_closeness_pair pair;
  fmpq_t share, square;
  int side;
  long corner; /* of the block alone: the nearest point of the profile that it fits; or -1 */
  fmpq_t corner_square;
} foot;

/* A point of the profile to be taken into an edge. */
typedef struct taken {
  long edge, point;
} taken;

typedef struct search {
  const tp_closeness *near;
  const tp_polyline *outline, *ring;
  fmpq_t limit; /* the square of w */
  long count, capacity;
  foot *feet;
  long *of_vertex, *of_point; /* the foot of a vertex; or -1 */
  bool *has_vertex;           /* of a point of the profile: a vertex lies in it */
  long taken_count, taken_capacity;
  taken *points;
} search;

void tp_snap_init(tp_snap *snap) {
  memset(snap, 0, sizeof *snap);
  fmpq_init(snap->most);
  fmpq_init(snap->overlap);
  fmpq_init(snap->left);
  fmpq_init(snap->right);
}

void tp_snap_clear(tp_snap *snap) {
  tp_polyline_clear(&snap->outline);
  tp_polyline_clear(&snap->moved);
  fmpq_clear(snap->most);
  fmpq_clear(snap->overlap);
  fmpq_clear(snap->left);
  fmpq_clear(snap->right);
}

/* ---- what lies within w ------------------------------------------------------------------------
 */

static long next_of(const search *s, long vertex) {
  return vertex + 1 == s->outline->count ? 0 : vertex + 1;
}

static long before(const search *s, long vertex) {
  return (vertex == 0 ? s->outline->count : vertex) - 1;
}

/* 1 where the block, or the air above the rock, has less than half a turn there; -1 for more. */
static int sense_of_vertex(const search *s, long k) {
  return tp_polyline_turn(s->outline, before(s, k), k, next_of(s, k));
}

static int sense_of_point(const search *s, long p) {
  if (p == 0 || p + 1 == s->near->points) return -1;
  return tp_polyline_turn(s->ring, p - 1, p, p + 1);
}

static void square_between(fmpq_t square, const search *s, long vertex, long point) {
  fmpq_t d;
  fmpq_init(d);
  fmpq_sub(d, s->outline->x + vertex, s->ring->x + point);
  fmpq_mul(square, d, d);
  fmpq_sub(d, s->outline->y + vertex, s->ring->y + point);
  fmpq_addmul(square, d, d);
  fmpq_clear(d);
}

static void consider_corner(const search *s, foot *f, long point) {
  const int sense = sense_of_point(s, point);
  fmpq_t square;
  if (sense == 0 || sense != sense_of_vertex(s, f->pair.vertex)) return;
  fmpq_init(square);
  square_between(square, s, f->pair.vertex, point);
  if (fmpq_cmp(square, s->limit) <= 0 &&
      (f->corner < 0 || fmpq_cmp(square, f->corner_square) < 0)) {
    f->corner = point;
    fmpq_swap(f->corner_square, square);
  }
  fmpq_clear(square);
}

static foot *add_foot(search *s, const tp_closeness_pair *pair) {
  foot *room = tp_grow(s->feet, s->count, &s->capacity, sizeof *room);
  if (room == NULL) return NULL;
  s->feet = room;
  foot *f = s->feet + s->count;
  *f = (foot){.pair = *pair, .corner = -1};
  fmpq_init(f->share);
  fmpq_init(f->square);
  fmpq_init(f->corner_square);
  (pair->of_base ? s->of_point : s->of_vertex)[pair->vertex] = s->count++;
  return f;
}

static bool take(void *context, const tp_closeness_pair *pair, double distance) {
  search *s = context;
  fmpq_t share, square;
  int side = 0;
  bool done = true;
  (void)distance;
  fmpq_init(share);
  fmpq_init(square);
  tp_closeness_foot(share, square, &side, s->near, pair);
  if (fmpq_cmp(square, s->limit) <= 0) {
    const long known = (pair->of_base ? s->of_point : s->of_vertex)[pair->vertex];
    foot *f = known >= 0 ? s->feet + known : add_foot(s, pair);
    done = f != NULL;
    if (done && (known < 0 || fmpq_cmp(square, f->square) < 0)) {
      f->pair = *pair;
      f->side = side;
      fmpq_swap(f->share, share);
      fmpq_swap(f->square, square);
    }
    if (done && !pair->of_base) {
      consider_corner(s, f, pair->edge);
      consider_corner(s, f, pair->edge + 1);
    }
  }
  fmpq_clear(share);
  fmpq_clear(square);
  return done;
}

/* Does the vertex lie inside the other body? Over an end of its edge it does where that is a notch
 * of the body. */
static bool is_inside(const search *s, const foot *f) {
  const bool first = fmpq_is_zero(f->share), last = fmpq_is_one(f->share);
  if (fmpq_is_zero(f->square)) return false;
  if (!first && !last) return f->pair.of_base ? f->side > 0 : f->side < 0;
  if (!f->pair.of_base) return sense_of_point(s, f->pair.edge + (last ? 1 : 0)) > 0;
  return sense_of_vertex(s, last ? next_of(s, f->pair.edge) : f->pair.edge) < 0;
}

/* ---- where vertices go -------------------------------------------------------------------------
 */

/* A vertex that touches stays; each point of the profile takes the nearest vertex that would have
 * it; the others go where they are nearest. */
static bool settle_corners(search *s) {
  long *taker = malloc((size_t)s->near->points * sizeof *taker);
  if (taker == NULL) return false;
  for (long p = 0; p < s->near->points; p++) taker[p] = -1;
  for (long k = 0; k < s->count; k++) {
    foot *f = s->feet + k;
    if (fmpq_is_zero(f->square)) f->corner = -1;
    if (f->corner < 0) continue;
    const long rival = taker[f->corner];
    if (rival < 0 || fmpq_cmp(f->corner_square, s->feet[rival].corner_square) < 0) {
      taker[f->corner] = k;
    }
  }
  for (long k = 0; k < s->count; k++) {
    foot *f = s->feet + k;
    if (f->corner >= 0 && taker[f->corner] != k) f->corner = -1;
    if (f->corner < 0) continue;
    f->pair.edge = f->corner;
    fmpq_zero(f->share);
    fmpq_swap(f->square, f->corner_square);
  }
  free(taker);
  return true;
}

/* By the profile's points, which the last edge's end is too. */
static void normalise(search *s) {
  for (long k = 0; k < s->count; k++) {
    foot *f = s->feet + k;
    if (f->pair.of_base) continue;
    if (fmpq_is_one(f->share)) {
      f->pair.edge++;
      fmpq_zero(f->share);
    }
    if (fmpq_is_zero(f->share)) s->has_vertex[f->pair.edge] = true;
  }
}

static void place(fmpq_t x, fmpq_t y, const search *s, const foot *f) {
  const tp_polyline *ring = s->ring;
  const long e = f->pair.edge;
  fmpq_set(x, ring->x + e);
  fmpq_set(y, ring->y + e);
  if (fmpq_is_zero(f->share)) return;
  fmpq_t along;
  fmpq_init(along);
  fmpq_sub(along, ring->x + e + 1, ring->x + e);
  fmpq_addmul(x, along, f->share);
  fmpq_sub(along, ring->y + e + 1, ring->y + e);
  fmpq_addmul(y, along, f->share);
  fmpq_clear(along);
}

static bool move_vertices(tp_snap *snap, const search *s) {
  if (!tp_polyline_copy(&snap->moved, s->outline)) return false;
  for (long k = 0; k < s->outline->count; k++) {
    const foot *f = s->of_vertex[k] < 0 ? NULL : s->feet + s->of_vertex[k];
    if (f == NULL || fmpq_is_zero(f->square)) continue;
    place(snap->moved.x + k, snap->moved.y + k, s, f);
    snap->moved_count++;
    if (fmpq_cmp(f->square, snap->most) > 0) fmpq_set(snap->most, f->square);
  }
  return true;
}

static void find_extent(tp_snap *snap, const search *s) {
  for (long k = 0; k < s->count; k++) {
    const long vertex = s->feet[k].pair.vertex;
    const fmpq *x = (s->feet[k].pair.of_base ? s->ring->x : snap->moved.x) + vertex;
    if (k == 0 || fmpq_cmp(x, snap->left) < 0) fmpq_set(snap->left, x);
    if (k == 0 || fmpq_cmp(x, snap->right) > 0) fmpq_set(snap->right, x);
  }
}

/* ---- points of the profile ---------------------------------------------------------------------
 */

/* Does the vertex lie on the profile now, before the point (-1) or behind it (1)? */
static int place_by(const search *s, long vertex, long point) {
  if (s->of_vertex[vertex] < 0) return 0;
  return s->feet[s->of_vertex[vertex]].pair.edge < point ? -1 : 1;
}

/* The edges follow one another along the profile: a point that its edge's ends have passed belongs
 * to the one before, or behind. */
static long edge_for(const search *s, const foot *f) {
  long edge = f->pair.edge;
  for (long k = 0; k < s->outline->count && place_by(s, edge, f->pair.vertex) > 0; k++) {
    edge = before(s, edge);
  }
  for (long k = 0; k < s->outline->count && place_by(s, next_of(s, edge), f->pair.vertex) < 0;
       k++) {
    edge = next_of(s, edge);
  }
  return edge;
}

static int compare_taken(const void *a, const void *b) {
  const taken *one = a, *other = b;
  if (one->edge != other->edge) return one->edge < other->edge ? -1 : 1;
  return (one->point > other->point) - (one->point < other->point);
}

static bool list_points(search *s) {
  for (long p = 0; p < s->near->points; p++) {
    if (s->of_point[p] < 0 || s->has_vertex[p]) continue;
    taken *room = tp_grow(s->points, s->taken_count, &s->taken_capacity, sizeof *room);
    if (room == NULL) return false;
    s->points = room;
    s->points[s->taken_count++] = (taken){edge_for(s, s->feet + s->of_point[p]), p};
  }
  if (s->taken_count > 1) {
    qsort(s->points, (size_t)s->taken_count, sizeof *s->points, compare_taken);
  }
  return true;
}

static bool is_moved(const search *s, long vertex) {
  return s->of_vertex[vertex] >= 0 && !fmpq_is_zero(s->feet[s->of_vertex[vertex]].square);
}

/* Points that lie on an edge already need not become vertices, if nothing else of it moves. */
static bool edge_stays(const search *s, long first, long last) {
  const long edge = s->points[first].edge;
  if (is_moved(s, edge) || is_moved(s, next_of(s, edge))) return false;
  for (long k = first; k < last; k++) {
    if (!fmpq_is_zero(s->feet[s->of_point[s->points[k].point]].square)) return false;
  }
  return true;
}

/* Sign of (B - A) x (R - P), of an edge of the outline and two points of the profile. */
static int side_of_edge(const search *s, long edge, long p, long r) {
  const tp_polyline *o = s->outline, *ring = s->ring;
  const long next = next_of(s, edge);
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
static bool lies_on(const search *s, long vertex, long edge) {
  if (s->of_vertex[vertex] < 0) return false;
  const foot *f = s->feet + s->of_vertex[vertex];
  return f->pair.edge == edge || (f->pair.edge == edge + 1 && fmpq_is_zero(f->share));
}

/* Would the point carry the block by itself: a crest below the edge, no end of a facet? With the
 * share of the edge up to which there is room on either side of it. */
static bool stands_alone(fmpq_t room, const search *s, long own, long first, long last) {
  const taken *t = s->points + own;
  const foot *f = s->feet + s->of_point[t->point];
  const long p = t->point;
  if (f->pair.edge != t->edge || fmpq_is_zero(f->share) || fmpq_is_one(f->share)) return false;
  if (lies_on(s, t->edge, p - 1) || lies_on(s, next_of(s, t->edge), p)) return false;
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
static bool append_beside(tp_snap *snap, const search *s, const taken *t, const fmpq_t share) {
  const tp_polyline *o = s->outline;
  const long next = next_of(s, t->edge);
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

/* A vertex; or where that would be a corner on a corner, a piece of the edge through it, as steep
 * as the edge. */
static bool take_point(tp_snap *snap, const search *s, long own, long first, long last) {
  enum { PART = 4 };
  const taken *t = s->points + own;
  const foot *f = s->feet + s->of_point[t->point];
  if (!fmpq_is_zero(f->square)) snap->taken_count++;
  if (fmpq_cmp(f->square, snap->most) > 0) fmpq_set(snap->most, f->square);
  fmpq_t room, part;
  fmpq_init(room);
  fmpq_init(part);
  bool done;
  if (stands_alone(room, s, own, first, last)) {
    fmpq_set_si(part, -1, PART);
    fmpq_mul(room, room, part);
    done = append_beside(snap, s, t, room);
    fmpq_neg(room, room);
    done = done && append_beside(snap, s, t, room);
  } else {
    done = tp_polyline_append(&snap->outline, s->ring->x + t->point, s->ring->y + t->point,
                              s->outline->marks[t->edge]);
  }
  fmpq_clear(room);
  fmpq_clear(part);
  return done;
}

static bool build(tp_snap *snap, const search *s) {
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

/* ------------------------------------------------------------------------------------------------
 */

static bool search_init(search *s, const tp_closeness *near, const fmpq_t within) {
  *s = (search){.near = near, .outline = near->section->rings, .ring = &near->base->ring};
  fmpq_init(s->limit);
  fmpq_mul(s->limit, within, within);
  s->of_vertex = malloc((size_t)s->outline->count * sizeof *s->of_vertex);
  s->of_point = malloc((size_t)near->points * sizeof *s->of_point);
  s->has_vertex = calloc((size_t)near->points, sizeof *s->has_vertex);
  if (s->of_vertex == NULL || s->of_point == NULL || s->has_vertex == NULL) return false;
  for (long k = 0; k < s->outline->count; k++) s->of_vertex[k] = -1;
  for (long k = 0; k < near->points; k++) s->of_point[k] = -1;
  return true;
}

static void search_clear(search *s) {
  for (long k = 0; k < s->count; k++) {
    fmpq_clear(s->feet[k].share);
    fmpq_clear(s->feet[k].square);
    fmpq_clear(s->feet[k].corner_square);
  }
  fmpq_clear(s->limit);
  free(s->feet);
  free(s->of_vertex);
  free(s->of_point);
  free(s->has_vertex);
  free(s->points);
}

bool tp_snap_find(tp_snap *snap, const tp_closeness *near, const fmpq_t within) {
  search s;
  const tp_closeness_reach reach = {.within = fmpq_get_d(within) / near->unit * (1 + 0x1p-50)};
  bool done = search_init(&s, near, within) && tp_closeness_visit(near, &reach, take, &s);
  for (long k = 0; k < s.count && done; k++) {
    const foot *f = s.feet + k;
    if (is_inside(&s, f) && fmpq_cmp(f->square, snap->overlap) > 0) {
      fmpq_set(snap->overlap, f->square);
    }
  }
  snap->touches = s.count > 0;
  done = done && settle_corners(&s);
  if (done) normalise(&s);
  done = done && move_vertices(snap, &s) && list_points(&s) && build(snap, &s);
  if (done) find_extent(snap, &s);
  search_clear(&s);
  return done;
}
