/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Facets of a base with a profile of its own: every pair of an edge of the outline and an edge of
 * the profile that meet, by an exact search, and what each meeting restrains. */

#define _GNU_SOURCE /* qsort_r */
#include "base/closeness.h"
#include "base/facets.h"
#include "base/overlap.h"
#include "block/check_ring.h"
#include "block/ring_meetings.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct search {
  const tp_section *section;
  const tp_base *base;
  const tp_lattice *lattice;
  long outline, outline_count; /* points of the outline in the lattice */
  long ring;                   /* first point of the base's ring */
  tp_facets *facets;
  tp_facets touches; /* q0: the point, t0 -> t1: edge of the outline, base_edge: of the ring */
  tp_facets points;  /* what the touches restrain beyond the facets of positive length */
  bool out_of_memory;
  bool cuts;
  tp_geom_meeting cut;
  tp_overlap overlap; /* of the outline and the base's ring */
} search;

/* Points between which an edge of the base runs; of the end faces too. */
static long base_from(const search *s, long edge) {
  return s->ring + (edge < 0 ? s->base->edge_count + 2 : edge);
}

static long base_to(const search *s, long edge) {
  return s->ring + edge + 1;
}

static long next_of_outline(const search *s, long edge) {
  return edge + 1 == s->outline + s->outline_count ? s->outline : edge + 1;
}

static long before_in_outline(const search *s, long vertex) {
  return (vertex == s->outline ? s->outline + s->outline_count : vertex) - 1;
}

/* The common piece of two edges on one line. */
static bool add_overlap(search *s, long a0, long a1, long base_edge) {
  const tp_lattice *l = s->lattice;
  const long b0 = base_from(s, base_edge), b1 = base_to(s, base_edge);
  if (tp_lattice_dot(l, a0, a1, b0, b1) < 0) return true; /* back to back: the overlap check's */
  const long q0 = tp_lattice_dot(l, a0, b0, a0, a1) > 0 ? b0 : a0;
  const long q1 = tp_lattice_dot(l, a1, b1, a1, a0) > 0 ? b1 : a1;
  return tp_facets_append(s->facets, tp_facet_of(q0, q1, a0, a1, base_edge));
}

static bool add_touch(search *s, long a0, long a1, long base_edge) {
  const tp_lattice *l = s->lattice;
  const long b0 = base_from(s, base_edge), b1 = base_to(s, base_edge);
  const long q = tp_facet_touch(l, a0, a1, b0, b1);
  return tp_facets_append(&s->touches, tp_facet_of(q, q, a0, a1, base_edge));
}

static bool take_meeting(void *context, tp_geom_meeting meeting) {
  search *s = context;
  const long a0 = (long)meeting.a, b0 = (long)meeting.b;
  if (a0 >= s->outline + s->outline_count) return true; /* a hole or a part */
  if (meeting.kind == TP_GEOM_CROSS) {
    if (!s->cuts || meeting.a < s->cut.a || (meeting.a == s->cut.a && meeting.b < s->cut.b)) {
      s->cut = meeting;
    }
    s->cuts = true;
    return true;
  }
  tp_overlap_meet(&s->overlap, meeting.kind, a0, b0);
  const long a1 = next_of_outline(s, a0), last = s->base->edge_count + 2;
  const long base_edge = b0 - s->ring == last ? -1 : b0 - s->ring; /* left of all: its left face */
  const bool done = meeting.kind == TP_GEOM_OVERLAP ? add_overlap(s, a0, a1, base_edge)
                                                    : add_touch(s, a0, a1, base_edge);
  s->out_of_memory = !done;
  return done;
}

/* Of a crossing that may be one of last digits: by how much an end of one edge has passed the
 * other, where that is 1/1000 of the block at most. */
static void slight_cut(char *text, size_t size, const search *s, long edge_a, long edge_b) {
  static const double share_of_size = 1e-3;
  const tp_closeness_pair pairs[] = {{false, edge_a, edge_b},
                                     {false, next_of_outline(s, s->outline + edge_a), edge_b},
                                     {true, edge_b, edge_a},
                                     {true, edge_b + 1, edge_a}};
  tp_closeness near;
  fmpq_t share, square, least;
  int side;
  tp_closeness_init(&near, s->section, s->base, s->lattice);
  fmpq_init(share);
  fmpq_init(square);
  fmpq_init(least);
  for (size_t k = 0; k < sizeof pairs / sizeof pairs[0]; k++) {
    tp_closeness_foot(share, square, &side, &near, pairs + k);
    if (k == 0 || fmpq_cmp(square, least) < 0) fmpq_set(least, square);
  }
  const double by = tp_closeness_root(least);
  text[0] = '\0';
  if (s->base->mated_count == 0 && by <= share_of_size * near.size * near.unit) {
    snprintf(text, size,
             ", by %.2g %s; contact is exact: where they should touch there, say 'place: rest', or "
             "'contact: {within: …}'",
             by, s->base->unit);
  }
  fmpq_clear(share);
  fmpq_clear(square);
  fmpq_clear(least);
}

static tp_status fail_cut(const search *s, tp_message *message) {
  const tp_polyline *outline = s->section->rings, *ring = &s->base->ring;
  const long edge_a = (long)s->cut.a - s->outline, edge_b = (long)s->cut.b - s->ring;
  char one[320], other[320];
  tp_rings_edge_text(one, sizeof one, outline, edge_a);
  tp_rings_edge_text(other, sizeof other, ring, edge_b);
  if (edge_b >= s->base->edge_count) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, tp_polyline_place(outline, edge_a),
                     "the base ends below the block: its upright end face cuts into %s; let the "
                     "profile go on, or end it where the block ends",
                     one);
  }
  char slight[200];
  slight_cut(slight, sizeof slight, s, edge_a, edge_b);
  return tp_refuse(message, TP_FAULT_GEOMETRY, tp_polyline_place(ring, edge_b),
                   "the base cuts into the block: of the profile, %s crosses %s of the outline%s",
                   other, one, slight);
}

/* Order along the base: the edge, then the distance from the edge's beginning. */
static int compare_points(const search *s, long edge_p, long p, long edge_q, long q) {
  if (edge_p != edge_q) return edge_p < edge_q ? -1 : 1;
  if (tp_lattice_same_point(s->lattice, p, q)) return 0;
  return tp_lattice_dot(s->lattice, p, q, base_from(s, edge_p), base_to(s, edge_p)) > 0 ? -1 : 1;
}

/* Does a facet of positive length end in the point q: in any direction, or in that of t0 -> t1?
 * The facets are sorted by then, and only neighbours in that order can end in the same point. */
static bool facet_ends_in(const search *s, long q, long base_edge, long t0, long t1) {
  const tp_lattice *l = s->lattice;
  long low = 0, high = s->facets->count;
  while (low < high) { /* the first facet that does not begin before q */
    const long middle = low + (high - low) / 2;
    const tp_facet *f = s->facets->items + middle;
    if (compare_points(s, f->base_edge, f->q0, base_edge, q) < 0) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  for (long k = low > 2 ? low - 2 : 0; k < s->facets->count && k < low + 2; k++) {
    const tp_facet *f = s->facets->items + k;
    if (!tp_facet_ends_in(l, f, (tp_outline_point){.point = q})) continue;
    if (t0 == t1 || (tp_lattice_cross(l, f->t0, f->t1, t0, t1) == 0 &&
                     tp_lattice_dot(l, f->t0, f->t1, t0, t1) > 0)) {
      return true;
    }
  }
  return false;
}

static bool add_point(search *s, long q, long t0, long t1, long base_edge) {
  if (facet_ends_in(s, q, base_edge, t0, t1)) return true;
  return tp_facets_append(&s->points, tp_facet_of(q, q, t0, t1, base_edge));
}

/* A vertex of the outline in a vertex of the profile: a notch of either restrains by both its
 * edges, a straight one as the edge that it lies on; a corner on a corner restrains nothing, but
 * may be pivoted about. */
static bool add_corner(search *s, long vertex, long corner, long base_edge) {
  const tp_lattice *l = s->lattice;
  const long before = before_in_outline(s, vertex), after = next_of_outline(s, vertex);
  const long base_before = base_from(s, corner - s->ring - 1);
  const int up = tp_lattice_cross(l, base_before, corner, corner, corner + 1);
  const int down = tp_lattice_cross(l, before, vertex, vertex, after);
  if (up > 0) {
    return add_point(s, vertex, base_before, corner, corner - s->ring - 1) &&
           add_point(s, vertex, corner, corner + 1, corner - s->ring);
  }
  if (down < 0) {
    return add_point(s, vertex, before, vertex, base_edge) &&
           add_point(s, vertex, vertex, after, base_edge);
  }
  if (up == 0) return add_point(s, vertex, corner, corner + 1, corner - s->ring);
  if (down == 0) return add_point(s, vertex, vertex, after, base_edge);
  return add_point(s, vertex, vertex, vertex, base_edge);
}

static int compare_facets(const void *a, const void *b, void *context) {
  const tp_facet *one = a, *other = b;
  const int begins = compare_points(context, one->base_edge, one->q0, other->base_edge, other->q0);
  if (begins != 0) return begins;
  return compare_points(context, one->base_edge, one->q1, other->base_edge, other->q1);
}

static void sort(search *s, tp_facets *facets) {
  if (facets->count < 2) return; /* there may be no array to sort */
  qsort_r(facets->items, (size_t)facets->count, sizeof *facets->items, compare_facets, s);
}

static bool same_direction(const search *s, const tp_facet *a, const tp_facet *b) {
  const tp_lattice *l = s->lattice;
  return tp_lattice_cross(l, a->t0, a->t1, b->t0, b->t1) == 0 &&
         tp_lattice_dot(l, a->t0, a->t1, b->t0, b->t1) >= 0;
}

/* Several touches tell of one point: keep one facet for each direction, then merge. */
static bool merge_points(search *s) {
  sort(s, &s->points);
  for (long k = 0; k < s->points.count; k++) {
    const tp_facet *own = s->points.items + k;
    bool known = false;
    for (long j = k - 1; j >= 0 && !known; j--) {
      if (!tp_lattice_same_point(s->lattice, s->points.items[j].q0, own->q0)) break;
      known = same_direction(s, s->points.items + j, own);
    }
    if (!known && !tp_facets_append(s->facets, *own)) return false;
  }
  sort(s, s->facets);
  return true;
}

/* The vertex of an edge that lies in point q, or -1. */
static long vertex_in(const tp_lattice *l, long q, long from, long to) {
  if (tp_lattice_same_point(l, q, from)) return from;
  return tp_lattice_same_point(l, q, to) ? to : -1;
}

static bool resolve_touches(search *s) {
  for (long k = 0; k < s->touches.count; k++) {
    const tp_facet *touch = s->touches.items + k;
    const long b0 = base_from(s, touch->base_edge), b1 = base_to(s, touch->base_edge);
    const long vertex = vertex_in(s->lattice, touch->q0, touch->t0, touch->t1);
    const long corner = vertex_in(s->lattice, touch->q0, b0, b1);
    bool done = true;
    if (vertex >= 0 && corner >= 0) {
      done = add_corner(s, vertex, corner, touch->base_edge);
    } else if (vertex >= 0) {
      done = add_point(s, vertex, b0, b1, touch->base_edge);
    } else {
      done = add_point(s, corner, touch->t0, touch->t1, touch->base_edge);
    }
    if (!done) return false;
  }
  return true;
}

tp_status tp_facets_of_profile(tp_facets *facets, const tp_section *section, const tp_base *base,
                               const tp_lattice *lattice, tp_message *message) {
  const long rings = section->ring_count;
  search s = {.section = section,
              .base = base,
              .lattice = lattice,
              .outline_count = lattice->start[1],
              .ring = lattice->start[rings],
              .facets = facets};
  s.overlap = (tp_overlap){.lattice = lattice,
                           .a = {s.outline, s.outline_count, false},
                           .b = {s.ring, lattice->start[rings + 1] - s.ring, true}};
  size_t *start = calloc((size_t)rings + 2, sizeof *start);
  if (start == NULL) return tp_fail_memory(message, "the contact");
  const tp_geom_rings all = tp_rings_view(lattice, 0, rings + 1, start);
  tp_status status = tp_check_ring(&base->ring, lattice, rings, false, "the base profile", message);
  if (status == TP_OK) {
    status = tp_rings_status(tp_geom_find_meetings(&all, rings, take_meeting, &s), "the contact",
                             message);
  }
  if (status == TP_OK && s.cuts) status = fail_cut(&s, message);
  if (status == TP_OK && tp_overlap_is(&s.overlap)) {
    status = tp_refuse(message, TP_FAULT_GEOMETRY, tp_polyline_place(&base->ring, -1),
                       "the base cuts into the block: a part of the block lies below the profile");
  }
  if (status == TP_OK) {
    sort(&s, facets);
    if (s.out_of_memory || !resolve_touches(&s) || !merge_points(&s)) {
      status = tp_fail_memory(message, "the contact");
    }
  }
  free(s.points.items);
  free(s.touches.items);
  free(start);
  return status;
}
