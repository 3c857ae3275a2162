/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Is one ring a simple polygon? Meetings of its edges by CGAL's exact predicates, the first told in
 * the user's vertices. */

#include "block/check_ring.h"

#include "block/repair.h"
#include "block/ring_meetings.h"
#include "number/ratio.h"

#include <stdio.h>
#include <string.h>

static tp_status fail_repeated(const tp_polyline *ring, long k, long next, const char *name,
                               tp_message *message) {
  const bool later = tp_polyline_number(ring, next) > tp_polyline_number(ring, k);
  const long twin = later ? next : k, original = later ? k : next;
  char x[64], y[64];
  tp_ratio_text(x, sizeof x, ring->x + twin);
  tp_ratio_text(y, sizeof y, ring->y + twin);
  return tp_fail(message, TP_BAD_INPUT, tp_polyline_place(ring, twin),
                 "%s: vertex %ld repeats vertex %ld at (%s, %s); delete one of them%s", name,
                 tp_polyline_number(ring, twin), tp_polyline_number(ring, original), x, y,
                 tp_polyline_number(ring, original) == 1 &&
                         tp_polyline_number(ring, twin) == ring->count
                     ? " (an outline closes itself)"
                     : "");
}

static bool collinear(const tp_lattice *l, long first, long count) {
  bool straight = true;
  for (long k = first + 2; k < first + count && straight; k++) {
    straight = tp_lattice_cross(l, first, first + 1, first, k) == 0;
  }
  return straight;
}

static tp_status fail_not_simple(const tp_polyline *ring, const tp_geom_rings *rings,
                                 bool repairable, const char *name, tp_message *message) {
  tp_first_meeting first = {0};
  tp_status status = tp_rings_status(tp_geom_find_meetings(rings, -1, tp_rings_keep_first, &first),
                                     "a crossing outline", message);
  if (status != TP_OK) return status;
  if (!first.found) {
    return tp_fail(message, TP_BAD_INPUT, tp_polyline_place(ring, -1), "%s crosses itself", name);
  }
  char advice[300];
  status = tp_repair_advice(advice, sizeof advice, ring, repairable, message);
  if (status != TP_OK) return status;
  const long a = (long)first.meeting.a, b = (long)first.meeting.b;
  char one[320], other[320], where[300];
  tp_rings_edge_text(one, sizeof one, ring, a);
  tp_rings_edge_text(other, sizeof other, ring, b);
  tp_place_text(where, sizeof where, tp_polyline_place(ring, b));
  return tp_fail(message, TP_BAD_INPUT, tp_polyline_place(ring, a),
                 "%s %s itself: %s %s %s (%s); %s", name,
                 first.meeting.kind == TP_GEOM_CROSS ? "crosses" : "touches", one,
                 tp_rings_verb(first.meeting.kind), other, where, advice);
}

tp_status tp_check_ring(const tp_polyline *ring, const tp_lattice *lattice, long chain,
                        bool repairable, const char *name, tp_message *message) {
  const long first = lattice->start[chain], count = ring->count;
  for (long k = 0; k < count; k++) {
    const long next = k + 1 == count ? 0 : k + 1;
    if (fmpz_equal(lattice->x + first + k, lattice->x + first + next) &&
        fmpz_equal(lattice->y + first + k, lattice->y + first + next)) {
      return fail_repeated(ring, k, next, name, message);
    }
  }
  if (collinear(lattice, first, count)) {
    return tp_fail(message, TP_BAD_INPUT, tp_polyline_place(ring, -1),
                   "%s has no area: all its vertices lie on one line", name);
  }
  size_t start[2];
  const tp_geom_rings rings = tp_rings_view(lattice, chain, 1, start);
  bool simple = false;
  const tp_status status = tp_rings_status(tp_geom_is_simple(&simple, &rings, 0), name, message);
  if (status != TP_OK || simple) return status;
  return fail_not_simple(ring, &rings, repairable, name, message);
}
