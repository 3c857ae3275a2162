/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The outline as an object of a drawing, each arc by its bulge: as given, or of an arc through a
 * point the tangent of a quarter of its angle as a double, which moves it by a share of 1e-15 of
 * its radius. What makes chords of drawings does the rest. */

#include "block/arc_chords.h"

#include "block/arc_begins.h"
#include "block/arcs.h"
#include "format/curve.h"
#include "number/ratio.h"

#include <math.h>
#include <string.h>

enum { MOST_CHORDS = 500000 };

/* The angle of an arc through a point, below 0 inwards; 0: it is straight. */
static double angle_through(const tp_polyline *ring, long edge, const tp_arc_description *d) {
  tp_circle_arc a;
  bool inwards = false;
  tp_circle_arc_init(&a);
  const double angle = tp_arc_over_edge(&a, &inwards, ring, edge, d) ? tp_circle_arc_angle(&a) : 0;
  tp_circle_arc_clear(&a);
  return inwards ? -angle : angle;
}

/* False: the arc is straight. */
static bool find_bulge(fmpq_t bulge, const tp_polyline *ring, long edge,
                       const tp_arc_description *d) {
  if (d->bulge.given) {
    fmpq_set(bulge, d->bulge.value);
  } else if (!tp_ratio_read_double(bulge, tan(angle_through(ring, edge, d) / 4))) {
    fmpq_zero(bulge);
  }
  return !fmpq_is_zero(bulge);
}

/* Length of the arc over a chord, rounded up. */
static double length_of(const tp_polyline *ring, long edge, const fmpq_t bulge) {
  const double up = 1 + 1e-12;
  const long next = edge + 1 == ring->count ? 0 : edge + 1;
  const double chord = hypot(fmpq_get_d(ring->x + next) - fmpq_get_d(ring->x + edge),
                             fmpq_get_d(ring->y + next) - fmpq_get_d(ring->y + edge));
  const double b = fabs(fmpq_get_d(bulge));
  return up * chord * (1 + b * b) / b * atan(b);
}

/* The edges of the ring with their bulges; `*length` of all arcs. */
static tp_status add_edges(tp_drawing_object *object, double *length, const tp_polyline *ring,
                           const tp_block_description *block, tp_message *message) {
  tp_arc_begins begins;
  fmpq_t bulge;
  long found = 0;
  if (!tp_arc_begins_init(&begins, block)) return tp_fail_memory(message, "the chords");
  fmpq_init(bulge);
  tp_status status = TP_OK;
  for (long k = 0; k < ring->count && status == TP_OK; k++) {
    const tp_arc_description *d = tp_arc_begins_find(&begins, ring, k);
    bool done = tp_drawing_add_point(object, ring->x + k, ring->y + k, ring->marks[k]);
    if (d != NULL && !find_bulge(bulge, ring, k, d)) {
      status =
          tp_refuse(message, TP_FAULT_GEOMETRY, d->place, "this arc is straight; leave it out");
    } else if (d != NULL) {
      done = done && tp_drawing_bend(object, bulge);
      *length += length_of(ring, k, bulge);
      found++;
    }
    if (status == TP_OK && !done) status = tp_fail_memory(message, "the chords");
  }
  fmpq_clear(bulge);
  tp_arc_begins_clear(&begins);
  if (status != TP_OK || found == block->arc_count) return status;
  return tp_refuse(message, TP_FAULT_GEOMETRY, block->arcs[0].place,
                   "an arc begins in no vertex of the outline, or two begin in the same");
}

static tp_status flatten(tp_arc_chords *chords, tp_drawing_object *object, const tp_polyline *ring,
                         const tp_block_description *block, tp_message *message) {
  const fmpq *tolerance = block->arc_tolerance.value;
  double length = 0;
  object->closure = TP_DRAWING_CLOSED;
  object->most_points = MOST_CHORDS;
  const tp_status status = add_edges(object, &length, ring, block, message);
  if (status != TP_OK) return status;
  const tp_curve_outcome outcome = tp_curve_flatten(object, tolerance);
  if (outcome == TP_CURVE_TOO_FINE) {
    return tp_refuse(message, TP_FAULT_RANGE, block->arc_tolerance.place,
                     "the outline takes more than half a million chords at this 'arc_tolerance'; "
                     "give a larger one");
  }
  if (outcome != TP_CURVE_DONE || !tp_polyline_copy(&chords->ring, &object->line)) {
    return tp_fail_memory(message, "the chords");
  }
  chords->ring.file = ring->file;
  chords->ring.mark = ring->mark;
  chords->ring.reversed = ring->reversed;
  chords->count = chords->ring.count - ring->count + block->arc_count;
  chords->area = length * fmpq_get_d(tolerance) * (1 + 1e-12);
  return TP_OK;
}

tp_status tp_arc_chords_init(tp_arc_chords *chords, const tp_block_description *block,
                             tp_message *message) {
  memset(chords, 0, sizeof *chords);
  tp_polyline ring = {0};
  tp_drawing drawing;
  tp_drawing_init(&drawing, block->outline.file);
  tp_drawing_object *object = tp_drawing_add(&drawing, "outline", NULL, NULL, block->outline.mark);
  tp_status status = object != NULL && tp_polyline_copy(&ring, &block->outline)
                         ? TP_OK
                         : tp_fail_memory(message, "the chords");
  if (status == TP_OK && !tp_polyline_orient_by_area(&ring)) {
    status =
        tp_refuse(message, TP_FAULT_GEOMETRY, block->arcs[0].place,
                  "with chords for its arcs the outline has no area, so the outward direction is "
                  "undetermined; give it a vertex more, on an arc");
  }
  if (status == TP_OK) status = flatten(chords, object, &ring, block, message);
  tp_polyline_clear(&ring);
  tp_drawing_clear(&drawing);
  if (status != TP_OK) tp_arc_chords_clear(chords);
  return status;
}

void tp_arc_chords_clear(tp_arc_chords *chords) {
  tp_polyline_clear(&chords->ring);
  memset(chords, 0, sizeof *chords);
}
