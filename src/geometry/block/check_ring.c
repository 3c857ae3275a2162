/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Is one ring a simple polygon? Of the rock under a profile that runs from left to right its order
 * says so; else by CGAL's sweep, and meetings of its edges, the first told in the user's vertices.
 */

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
  return tp_refuse(message, TP_FAULT_GEOMETRY, tp_polyline_place(ring, twin),
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
    return tp_refuse(message, TP_FAULT_GEOMETRY, tp_polyline_place(ring, -1), "%s crosses itself",
                     name);
  }
  char advice[300];
  status = tp_repair_advice(advice, sizeof advice, ring, repairable, message);
  if (status != TP_OK) return status;
  const long a = (long)first.meeting.a, b = (long)first.meeting.b;
  char one[320], other[320], where[300];
  tp_rings_edge_text(one, sizeof one, ring, a);
  tp_rings_edge_text(other, sizeof other, ring, b);
  tp_place_text(where, sizeof where, tp_polyline_place(ring, b));
  return tp_refuse(message, TP_FAULT_GEOMETRY, tp_polyline_place(ring, a),
                   "%s %s itself: %s %s %s (%s); %s", name,
                   first.meeting.kind == TP_GEOM_CROSS ? "crosses" : "touches", one,
                   tp_rings_verb(first.meeting.kind), other, where, advice);
}

/* Does an upright step up or down to vertex k go on as it began? The first goes up, the last down.
 */
static bool step_goes_on(const tp_lattice *l, long first, long k, long last) {
  const bool up = fmpz_cmp(l->y + k, l->y + k - 1) > 0;
  bool goes_on = true;
  if (k == first + 1) {
    goes_on = up;
  } else if (fmpz_equal(l->x + k - 1, l->x + k - 2)) {
    goes_on = up == (fmpz_cmp(l->y + k - 1, l->y + k - 2) > 0);
  }
  return goes_on && !(k == last && up);
}

/* A chain that never goes back in x, closed by two corners below all of it at its ends: the rock
 * under a profile, which is simple. */
static bool is_ground(const tp_lattice *l, long first, long count) {
  const long last = first + count - 3, floor = last + 1; /* of the chain; the corner below that */
  if (count < 4 || !fmpz_equal(l->x + floor, l->x + last) ||
      !fmpz_equal(l->x + floor + 1, l->x + first)) {
    return false;
  }
  bool is = true;
  for (long k = first; k <= last && is; k++) {
    const int way = k == first ? 1 : fmpz_cmp(l->x + k, l->x + k - 1);
    is = fmpz_cmp(l->y + k, l->y + floor) > 0 && fmpz_cmp(l->y + k, l->y + floor + 1) > 0 &&
         (way > 0 || (way == 0 && step_goes_on(l, first, k, last)));
  }
  return is && fmpz_cmp(l->x + first, l->x + last) < 0;
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
    return tp_refuse(message, TP_FAULT_GEOMETRY, tp_polyline_place(ring, -1),
                     "%s has no area: all its vertices lie on one line", name);
  }
  if (is_ground(lattice, first, count)) return TP_OK;
  size_t start[2];
  const tp_geom_rings rings = tp_rings_view(lattice, chain, 1, start);
  bool simple = false;
  const tp_status status = tp_rings_status(tp_geom_is_simple(&simple, &rings, 0), name, message);
  if (status != TP_OK || simple) return status;
  return fail_not_simple(ring, &rings, repairable, name, message);
}
