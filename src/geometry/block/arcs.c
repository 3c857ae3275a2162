/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Each arc is cut at rational points of its circle, some 40 degrees apart or finer, into tangents
 * or chords for the ring; the area between them and the arc is recorded as a tip. */

#include "block/arcs.h"

#include "block/arc_begins.h"
#include "block/check_ring.h"
#include "block/circle.h"
#include "common/grow.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static tp_arc_tip *add_tip(tp_arc_tips *tips) {
  tp_arc_tip *more = tp_grow(tips->items, tips->count, &tips->capacity, sizeof *more);
  if (more == NULL) return NULL;
  tips->items = more;
  tp_arc_tip *tip = tips->items + tips->count++;
  fmpq_init(tip->before_x);
  fmpq_init(tip->before_y);
  fmpq_init(tip->after_x);
  fmpq_init(tip->after_y);
  fmpq_init(tip->centre_x);
  fmpq_init(tip->centre_y);
  return tip;
}

/* A piece of an arc, from one point of it to the next along the outline: its tangents, or inwards
 * its chord, into `ring`, the other of them into `tips->other`. */
static bool add_piece(tp_arc_tips *tips, tp_polyline *ring, const tp_circle_arc *a, bool inwards,
                      const tp_point *from, const tp_point *to, tp_mark mark) {
  tp_point m;
  tp_point_init(&m);
  tp_circle_arc_tangents_meet(&m, a, from, to);
  tp_arc_tip *tip = add_tip(tips);
  bool done = tip != NULL;
  if (done) {
    tip->inwards = inwards;
    tip->vertex = inwards ? ring->count - 1 : ring->count;
    fmpq_set(tip->before_x, from->x);
    fmpq_set(tip->before_y, from->y);
    fmpq_set(tip->after_x, to->x);
    fmpq_set(tip->after_y, to->y);
    fmpq_set(tip->centre_x, a->centre.x);
    fmpq_set(tip->centre_y, a->centre.y);
    done = tp_polyline_append(inwards ? &tips->other : ring, m.x, m.y, mark);
  }
  tp_point_clear(&m);
  return done;
}

/* Pieces of an arc are some 40 degrees over the fineness apart, so that a whole turn has
 * 1 + 2 pi / 0.7 = 9.98 at the fineness 1, and fewer than PIECES times the fineness above that. */
static const double piece = 0.7; /* radians */
enum { PIECES = 10, FINER = 4, FINEST = 64 };

/* Points of the arc, from its beginning to its end, counter-clockwise about its centre: some 40
 * degrees over `fineness` apart, the tangents of half their angles multiples of 1 / (64 fineness).
 * Their number less one. */
static int choose_points(tp_point *points, const tp_circle_arc *a, int fineness) {
  enum { STEPS = 64, MOST_TANGENT = 1000 }; /* of half an angle, which may come near 90 degrees */
  const double whole = tp_circle_arc_angle(a);
  const int pieces = 1 + (int)(whole * fineness / piece);
  fmpq_t t;
  fmpq_init(t);
  for (int k = 0; k <= pieces; k++) {
    if (k == 0 || k == pieces) {
      const tp_point *end = k == 0 ? &a->p : &a->q;
      fmpq_set(points[k].x, end->x);
      fmpq_set(points[k].y, end->y);
    } else {
      const int steps = STEPS * fineness;
      const double half = steps * tan(whole * k / pieces / 2);
      fmpq_set_si(t, lround(fmax(-MOST_TANGENT * steps, fmin(half, MOST_TANGENT * steps))),
                  (ulong)steps);
      tp_circle_arc_point(points + k, a, t);
    }
  }
  fmpq_clear(t);
  return pieces;
}

/* An arc that runs along the outline, or inwards against it. */
static bool add_arc(tp_arc_tips *tips, tp_polyline *ring, const tp_circle_arc *a, bool inwards,
                    int fineness, tp_mark mark) {
  const long room = (long)PIECES * fineness + 1;
  tp_point *points = malloc((size_t)room * sizeof *points);
  if (points == NULL) return false;
  for (long k = 0; k < room; k++) tp_point_init(points + k);
  const int pieces = choose_points(points, a, fineness);
  bool done = true;
  for (int k = 0; k < pieces && done; k++) {
    const tp_point *from = points + (inwards ? pieces - k : k);
    const tp_point *to = points + (inwards ? pieces - k - 1 : k + 1);
    if (!inwards || k == 0) done = tp_polyline_append(&tips->other, from->x, from->y, mark);
    if (inwards && k > 0) done = done && tp_polyline_append(ring, from->x, from->y, mark);
    done = done && add_piece(tips, ring, a, inwards, from, to, mark);
  }
  for (long k = 0; k < room; k++) tp_point_clear(points + k);
  free(points);
  return done;
}

/* A point that the arc goes through: given, or the middle of the chord moved outwards by half of
 * the bulge times the chord. */
static void set_through(tp_point *m, const tp_circle_arc *a, const tp_arc_description *d) {
  if (!d->bulge.given) {
    fmpq_set(m->x, d->through_x.value);
    fmpq_set(m->y, d->through_y.value);
    return;
  }
  tp_point v, normal;
  fmpq_t half;
  tp_point_init(&v);
  tp_point_init(&normal);
  fmpq_init(half);
  fmpq_set_si(half, 1, 2);
  tp_point_difference(&v, &a->q, &a->p);
  tp_point_along(m, &a->p, half, &v);
  fmpq_set(normal.x, v.y);
  fmpq_neg(normal.y, v.x);
  fmpq_mul(half, half, d->bulge.value);
  tp_point_along(&v, m, half, &normal);
  fmpq_set(m->x, v.x);
  fmpq_set(m->y, v.y);
  tp_point_clear(&v);
  tp_point_clear(&normal);
  fmpq_clear(half);
}

bool tp_arc_over_edge(tp_circle_arc *a, bool *inwards, const tp_polyline *outline, long edge,
                      const tp_arc_description *d) {
  const long next = edge + 1 == outline->count ? 0 : edge + 1;
  tp_point m;
  tp_point_init(&m);
  fmpq_set(a->p.x, outline->x + edge);
  fmpq_set(a->p.y, outline->y + edge);
  fmpq_set(a->q.x, outline->x + next);
  fmpq_set(a->q.y, outline->y + next);
  set_through(&m, a, d);
  bool arc = tp_circle_arc_set_centre(a, &m);
  *inwards = !arc;
  if (!arc) {
    const tp_point end = a->p;
    a->p = a->q;
    a->q = end;
    arc = tp_circle_arc_set_centre(a, &m);
  }
  tp_point_clear(&m);
  return arc;
}

/* One edge of the outline into the rings. */
static tp_status add_edge(tp_arc_tips *tips, tp_polyline *ring, const tp_polyline *outline,
                          long edge, const tp_arc_description *d, int fineness,
                          tp_message *message) {
  const tp_mark mark = outline->marks[edge];
  bool done = tp_polyline_append(ring, outline->x + edge, outline->y + edge, mark);
  if (d == NULL) {
    done = done && tp_polyline_append(&tips->other, outline->x + edge, outline->y + edge, mark);
    return done ? TP_OK : tp_fail_memory(message, "the arcs");
  }
  tp_circle_arc a;
  tp_circle_arc_init(&a);
  bool inwards = false;
  const bool arc = tp_arc_over_edge(&a, &inwards, outline, edge, d);
  tp_status status = TP_OK;
  if (!arc) {
    status = tp_refuse(message, TP_FAULT_GEOMETRY, d->place, "this arc is straight; leave it out");
  } else if (!done || !add_arc(tips, ring, &a, inwards, fineness, mark)) {
    status = tp_fail_memory(message, "the arcs");
  }
  tp_circle_arc_clear(&a);
  return status;
}

static void begin(tp_polyline *ring, const tp_polyline *outline) {
  *ring =
      (tp_polyline){.file = outline->file, .mark = outline->mark, .reversed = outline->reversed};
}

/* Both rings. On failure they are cleared. */
static tp_status build(tp_arc_tips *tips, tp_polyline *ring, const tp_polyline *outline,
                       const tp_block_description *block, int fineness, tp_message *message) {
  begin(ring, outline);
  begin(&tips->other, outline);
  tp_arc_begins begins;
  tp_status status =
      tp_arc_begins_init(&begins, block) ? TP_OK : tp_fail_memory(message, "the arcs");
  long found = 0;
  for (long k = 0; k < outline->count && status == TP_OK; k++) {
    const tp_arc_description *d = tp_arc_begins_find(&begins, outline, k);
    found += d != NULL;
    status = add_edge(tips, ring, outline, k, d, fineness, message);
  }
  if (status == TP_OK && found != block->arc_count) {
    status = tp_refuse(message, TP_FAULT_GEOMETRY, block->arcs[0].place,
                       "an arc begins in no vertex of the outline, or two begin in the same");
  }
  tp_arc_begins_clear(&begins);
  if (status != TP_OK) {
    tp_polyline_clear(ring);
    tp_arc_tips_clear(tips);
  }
  return status;
}

static tp_status check_ring(const tp_polyline *ring, const char *name, tp_message *message) {
  tp_lattice lattice;
  fmpq_t one;
  fmpq_init(one);
  fmpq_one(one);
  tp_status status = tp_lattice_init(&lattice, &ring, 1, one, message);
  if (status == TP_OK) {
    status = tp_check_ring(ring, &lattice, 0, false, name, message);
    tp_lattice_clear(&lattice);
  }
  fmpq_clear(one);
  return status;
}

/* Are both rings polygons that are counter-clockwise as the outline is? */
static tp_status check_rings(const tp_arc_tips *tips, const tp_polyline *ring,
                             const tp_block_description *block, tp_message *message) {
  if (tp_polyline_orientation(ring) <= 0 || tp_polyline_orientation(&tips->other) <= 0) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, block->arcs[0].place,
                     "the outline with its arcs is turned inside out");
  }
  const tp_status status = check_ring(ring, "the outline", message);
  if (status != TP_OK) return status;
  return check_ring(&tips->other, "the outline with its arcs", message);
}

/* An edge may pass an arc by less than its tangents or chords do: finer ones, if such are found.
 * What is refused then is told of the coarsest. */
static tp_status build_apart(tp_arc_tips *tips, tp_polyline *ring, const tp_polyline *outline,
                             const tp_block_description *block, tp_message *message) {
  tp_message unused = {.text = ""};
  tp_status first = TP_OK;
  for (int fineness = 1; fineness <= FINEST; fineness *= FINER) {
    tp_message *told = fineness == 1 ? message : &unused;
    tp_status status = build(tips, ring, outline, block, fineness, told);
    const bool built = status == TP_OK;
    if (built) status = check_rings(tips, ring, block, told);
    if (status == TP_OK) return TP_OK;
    if (fineness == 1) first = status;
    if (!built) break;
    tp_polyline_clear(ring);
    tp_arc_tips_clear(tips);
    if (status != TP_BAD_INPUT) break;
  }
  return first;
}

tp_status tp_arcs_apply(tp_arc_tips *tips, tp_polyline *outline, const tp_block_description *block,
                        tp_message *message) {
  memset(tips, 0, sizeof *tips);
  if (block->arc_count == 0) return TP_OK;
  if (!tp_polyline_orient_by_area(outline)) {
    return tp_refuse(
        message, TP_FAULT_GEOMETRY, block->arcs[0].place,
        "with chords for its arcs the outline has no area, so the outward direction is "
        "undetermined; give it a vertex more, on an arc");
  }
  tp_polyline ring;
  tp_status status = build_apart(tips, &ring, outline, block, message);
  if (status != TP_OK) return status;
  tp_polyline_clear(outline);
  *outline = ring;
  return TP_OK;
}

void tp_arc_tips_clear(tp_arc_tips *tips) {
  for (long k = 0; k < tips->count; k++) {
    tp_arc_tip *tip = tips->items + k;
    fmpq_clear(tip->before_x);
    fmpq_clear(tip->before_y);
    fmpq_clear(tip->after_x);
    fmpq_clear(tip->after_y);
    fmpq_clear(tip->centre_x);
    fmpq_clear(tip->centre_y);
  }
  free(tips->items);
  tp_polyline_clear(&tips->other);
  memset(tips, 0, sizeof *tips);
}
