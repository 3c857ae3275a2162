/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The contact of a rounded block.
 *
 * Theorem. Let B be the sharp block, R what rounding leaves of it, K the rock, all closed, and let
 * B and K have no inner point in common. Then R touches K in those points of the contact of B and K
 * that lie on what rounding leaves of the edges of B, between the tangent points, and nowhere else.
 * There the block has the tangents that it has without rounding.
 *
 * Proof. R lies in B, so a common point of R and K is one of B and K, and on the boundary of B:
 * near an inner point of B there would be inner points of both. A point of an edge of B is in R
 * unless it lies between a rounded vertex and the tangent point, since tips reach no other part of
 * the outline (block/corners_init.c). An arc meets the boundary of B in its tangent points alone,
 * and has the edge's direction there.
 *
 * So the facets of the sharp outline are cut at the tangent points, compared exactly
 * (block/tangents.h); what touches a tip alone is dropped. A facet that touches the rest of its
 * edge in a single point is a contact in a point, with the edge's direction. */

#include "base/facets.h"

#include <stdlib.h>

/* The ends of a facet on the edge from t0 to t1, whose corners may be rounded. */
typedef struct edge_corners {
  const tp_corner *start, *end;
} edge_corners;

/* Of a contact in a point inside an edge: what is left? */
static bool keep_point(tp_facet *f, edge_corners c, const tp_lattice *l) {
  if (c.start != NULL && tp_tangent_compare(c.start, true, l, f->q0) < 0) return false;
  return c.end == NULL || tp_tangent_compare(c.end, false, l, f->q0) >= 0;
}

/* Of a facet along an edge: from the later of q0 and the first tangent point to the earlier of q1
 * and the last one. */
static bool keep_piece(tp_facet *f, tp_facet_rounding *r, edge_corners c, const tp_lattice *l) {
  const int first = c.start == NULL ? 1 : tp_tangent_compare(c.start, true, l, f->q0);
  const int last = c.end == NULL ? 1 : tp_tangent_compare(c.end, false, l, f->q1);
  /* the other end of the facet against the tangent point */
  const int after_first = c.start == NULL ? 1 : tp_tangent_compare(c.start, true, l, f->q1);
  const int before_last = c.end == NULL ? 1 : tp_tangent_compare(c.end, false, l, f->q0);
  if (after_first < 0 || before_last < 0) return false;
  if (after_first == 0) { /* all but its end is cut off */
    r->also = (tp_outline_point){f->q0, c.start, true};
    f->q0 = f->q1;
    return true;
  }
  if (before_last == 0) {
    r->also = (tp_outline_point){f->q1, c.end, false};
    f->q1 = f->q0;
    return true;
  }
  if (first < 0) r->cut0 = c.start;
  if (last < 0) r->cut1 = c.end;
  if (r->cut0 != NULL && r->cut1 != NULL && tp_tangents_room(c.start, c.end, l) == 0) {
    r->also =
        (tp_outline_point){f->q1, c.end, false}; /* they meet: one point is left of the edge */
    f->q1 = f->q0;
    r->cut1 = NULL;
  }
  return true;
}

static bool keep(tp_facet *f, tp_facet_rounding *r, const tp_corners *corners, const tp_lattice *l,
                 long outline_count) {
  if (f->q0 == f->q1 && f->q0 < outline_count) return tp_corners_at(corners, f->q0) == NULL;
  if (f->t0 >= outline_count)
    return true; /* of the base, pressed by a vertex that is a point too */
  const edge_corners c = {tp_corners_at(corners, f->t0), tp_corners_at(corners, f->t1)};
  return f->q0 == f->q1 ? keep_point(f, c, l) : keep_piece(f, r, c, l);
}

static bool set_rounding(tp_facet *f, const tp_facet_rounding *r) {
  if (r->cut0 == NULL && r->cut1 == NULL && r->also.cut == NULL) return true;
  f->rounding = malloc(sizeof *r);
  if (f->rounding != NULL) *f->rounding = *r;
  return f->rounding != NULL;
}

/* Does a neighbour tell of the contact in a point as well: with the same direction, and a length or
 * before it? */
static bool is_told(const tp_facets *facets, long own, const tp_lattice *l) {
  enum { NEAR = 2 };
  const tp_facet *f = facets->items + own;
  for (long k = own < NEAR ? 0 : own - NEAR; k < facets->count && k <= own + NEAR; k++) {
    const tp_facet *other = facets->items + k;
    if (k == own || !tp_facet_ends_in(l, other, tp_facet_begin(f))) continue;
    if (tp_lattice_cross(l, f->t0, f->t1, other->t0, other->t1) != 0 ||
        tp_lattice_dot(l, f->t0, f->t1, other->t0, other->t1) <= 0) {
      continue;
    }
    if (other->q0 != other->q1 || k < own) return true;
  }
  return false;
}

bool tp_facets_cut(tp_facets *facets, const tp_corners *corners, const tp_lattice *l,
                   long outline_count) {
  if (corners == NULL || corners->count == 0) return true;
  long kept = 0;
  bool done = true;
  for (long k = 0; k < facets->count; k++) {
    tp_facet f = facets->items[k];
    tp_facet_rounding rounding = {.cut0 = NULL};
    if (!keep(&f, &rounding, corners, l, outline_count)) continue;
    done = set_rounding(&f, &rounding) && done;
    facets->items[kept++] = f;
  }
  facets->count = kept;
  kept = 0;
  for (long k = 0; k < facets->count; k++) {
    const tp_facet f = facets->items[k];
    if (f.q0 != f.q1 || !is_told(facets, k, l)) {
      facets->items[kept++] = f;
    } else {
      free(f.rounding);
    }
  }
  facets->count = kept;
  return done;
}
