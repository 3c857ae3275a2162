/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "block/arcs.h"

#include "block/circle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static tp_arc_tip *add_tip(tp_arc_tips *tips) {
  if (tips->count == tips->capacity) {
    const long capacity = 2 * tips->capacity + 16;
    tp_arc_tip *items = realloc(tips->items, (size_t)capacity * sizeof *items);
    if (items == NULL) return NULL;
    tips->items = items;
    tips->capacity = capacity;
  }
  tp_arc_tip *tip = tips->items + tips->count++;
  fmpq_init(tip->before_x);
  fmpq_init(tip->before_y);
  fmpq_init(tip->after_x);
  fmpq_init(tip->after_y);
  fmpq_init(tip->centre_x);
  fmpq_init(tip->centre_y);
  return tip;
}

/* The tangents between two points of the arc. */
static bool add_piece(tp_arc_tips *tips, tp_polyline *ring, const tp_circle_arc *a,
                      const tp_point *from, const tp_point *to, tp_mark mark) {
  tp_point m;
  tp_point_init(&m);
  tp_circle_arc_tangents_meet(&m, a, from, to);
  tp_arc_tip *tip = add_tip(tips);
  bool done = tip != NULL;
  if (done) {
    tip->vertex = ring->count;
    fmpq_set(tip->before_x, from->x);
    fmpq_set(tip->before_y, from->y);
    fmpq_set(tip->after_x, to->x);
    fmpq_set(tip->after_y, to->y);
    fmpq_set(tip->centre_x, a->centre.x);
    fmpq_set(tip->centre_y, a->centre.y);
    done = tp_polyline_append(ring, m.x, m.y, mark) &&
           tp_polyline_append(&tips->chords, from->x, from->y, mark);
  }
  tp_point_clear(&m);
  return done;
}

/* The arc in pieces of about 40 degrees: tangents into `ring`, points into `tips->chords`. */
static bool add_arc(tp_arc_tips *tips, tp_polyline *ring, const tp_circle_arc *a, tp_mark mark) {
  enum { STEPS = 64, MOST = 64000 }; /* tangents of half angles are multiples of 1 / STEPS */
  const double whole = tp_circle_arc_angle(a);
  const int pieces = 1 + (int)(whole / 0.7);
  tp_point from, to;
  fmpq_t t;
  tp_point_init(&from);
  tp_point_init(&to);
  fmpq_init(t);
  fmpq_set(from.x, a->p.x);
  fmpq_set(from.y, a->p.y);
  bool done = true;
  for (int k = 1; k <= pieces && done; k++) {
    if (k == pieces) {
      fmpq_set(to.x, a->q.x);
      fmpq_set(to.y, a->q.y);
    } else {
      const double half = STEPS * tan(whole * k / pieces / 2);
      fmpq_set_si(t, lround(fmax(-MOST, fmin(half, MOST))), STEPS);
      tp_circle_arc_point(&to, a, t);
    }
    done = add_piece(tips, ring, a, &from, &to, mark);
    fmpq_set(from.x, to.x);
    fmpq_set(from.y, to.y);
  }
  tp_point_clear(&from);
  tp_point_clear(&to);
  fmpq_clear(t);
  return done;
}

/* The arc of an edge of the outline, or NULL. */
static const tp_arc_description *find_arc(const tp_block_description *block,
                                          const tp_polyline *outline, long edge) {
  const long next = edge + 1 == outline->count ? 0 : edge + 1;
  const long own = outline->reversed ? next : edge; /* the end that its author names */
  for (long k = 0; k < block->arc_count; k++) {
    if (fmpq_equal(block->arcs[k].x.value, outline->x + own) &&
        fmpq_equal(block->arcs[k].y.value, outline->y + own)) {
      return block->arcs + k;
    }
  }
  return NULL;
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

/* One edge of the outline into the rings. */
static tp_status add_edge(tp_arc_tips *tips, tp_polyline *ring, const tp_polyline *outline,
                          long edge, const tp_arc_description *d, tp_message *message) {
  const long next = edge + 1 == outline->count ? 0 : edge + 1;
  const tp_mark mark = outline->marks[edge];
  bool done = tp_polyline_append(ring, outline->x + edge, outline->y + edge, mark);
  if (d == NULL) {
    done = done && tp_polyline_append(&tips->chords, outline->x + edge, outline->y + edge, mark);
    return done ? TP_OK : tp_fail_memory(message, "the arcs");
  }
  tp_circle_arc a;
  tp_point m;
  tp_circle_arc_init(&a);
  tp_point_init(&m);
  fmpq_set(a.p.x, outline->x + edge);
  fmpq_set(a.p.y, outline->y + edge);
  fmpq_set(a.q.x, outline->x + next);
  fmpq_set(a.q.y, outline->y + next);
  set_through(&m, &a, d);
  tp_status status = TP_OK;
  if (!tp_circle_arc_set_centre(&a, &m)) {
    status = tp_fail(message, TP_BAD_INPUT, d->place,
                     "this arc does not bulge outwards: arcs inwards and straight ones are not "
                     "taken");
  } else if (!done || !add_arc(tips, ring, &a, mark)) {
    status = tp_fail_memory(message, "the arcs");
  }
  tp_circle_arc_clear(&a);
  tp_point_clear(&m);
  return status;
}

tp_status tp_arcs_apply(tp_arc_tips *tips, tp_polyline *outline, const tp_block_description *block,
                        tp_message *message) {
  memset(tips, 0, sizeof *tips);
  if (block->arc_count == 0) return TP_OK;
  tp_polyline ring = {.file = outline->file, .mark = outline->mark, .reversed = outline->reversed};
  tips->chords.file = outline->file;
  tips->chords.mark = outline->mark;
  tips->chords.reversed = outline->reversed;
  tp_status status = TP_OK;
  long found = 0;
  for (long k = 0; k < outline->count && status == TP_OK; k++) {
    const tp_arc_description *d = find_arc(block, outline, k);
    found += d != NULL;
    status = add_edge(tips, &ring, outline, k, d, message);
  }
  if (status == TP_OK && found != block->arc_count) {
    status = tp_fail(message, TP_BAD_INPUT, block->arcs[0].place,
                     "an arc begins in no vertex of the outline, or two begin in the same");
  }
  if (status == TP_OK) {
    tp_polyline_clear(outline);
    *outline = ring;
  } else {
    tp_polyline_clear(&ring);
    tp_arc_tips_clear(tips);
  }
  return status;
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
  tp_polyline_clear(&tips->chords);
  memset(tips, 0, sizeof *tips);
}
