/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* View of lattice rings for the predicates of geom/geom.h, the first meeting in the order of edges,
 * and texts that name edges by the user's coordinates. */

#include "block/ring_meetings.h"

#include "number/ratio.h"

#include <stdio.h>

/* Meetings that are looked through for the first: a ring of n edges can have n^2 / 2, and one that
 * has a million is wrong wherever the user begins to look. */
enum { MOST_SEEN = 1000000 };

tp_geom_rings tp_rings_view(const tp_lattice *lattice, long first, long count, size_t *start) {
  const long offset = lattice->start[first];
  for (long r = 0; r <= count; r++) start[r] = (size_t)(lattice->start[first + r] - offset);
  return (tp_geom_rings){.count = (size_t)count,
                         .start = start,
                         .u = lattice->u + offset,
                         .v = lattice->v + offset,
                         .x = lattice->x + offset,
                         .y = lattice->y + offset,
                         .small = tp_lattice_is_exact(lattice)};
}

tp_status tp_rings_status(tp_geom_status geometry, const char *what, tp_message *message) {
  switch (geometry) {
  case TP_GEOM_OK:
    return TP_OK;
  case TP_GEOM_OUT_OF_MEMORY:
    return tp_fail_memory(message, what);
  case TP_GEOM_FAILED:
    break;
  }
  return tp_fail(message, TP_DEPENDENCY_FAILED, (tp_place){0},
                 "the geometry library failed on %s; please report this scene", what);
}

void tp_rings_edge_text(char *text, size_t size, const tp_polyline *ring, long edge) {
  long from = edge, to = edge + 1 == ring->count ? 0 : edge + 1;
  if (ring->reversed) {
    const long held = from;
    from = to;
    to = held;
  }
  char p[4][64];
  tp_ratio_text(p[0], sizeof p[0], ring->x + from);
  tp_ratio_text(p[1], sizeof p[1], ring->y + from);
  tp_ratio_text(p[2], sizeof p[2], ring->x + to);
  tp_ratio_text(p[3], sizeof p[3], ring->y + to);
  snprintf(text, size, "the edge from vertex %ld (%s, %s) to vertex %ld (%s, %s)",
           tp_polyline_number(ring, from), p[0], p[1], tp_polyline_number(ring, to), p[2], p[3]);
}

bool tp_rings_keep_first(void *context, tp_geom_meeting meeting) {
  tp_first_meeting *first = context;
  if (first->counts != NULL && !first->counts(first->context, meeting)) return true;
  const tp_geom_meeting *best = &first->meeting;
  if (!first->found || meeting.a < best->a || (meeting.a == best->a && meeting.b < best->b)) {
    first->meeting = meeting;
  }
  first->found = true;
  return ++first->seen < MOST_SEEN;
}

const char *tp_rings_verb(tp_geom_meeting_kind kind) {
  switch (kind) {
  case TP_GEOM_CROSS:
    return "crosses";
  case TP_GEOM_TOUCH:
    return "touches";
  case TP_GEOM_OVERLAP:
    break;
  }
  return "lies on";
}
