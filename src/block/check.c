/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "block/check.h"

#include "number/ratio.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

tp_geom_rings tp_check_rings(const tp_lattice *lattice, long first, long count, size_t *start) {
  const long offset = lattice->start[first];
  for (long r = 0; r <= count; r++) start[r] = (size_t)(lattice->start[first + r] - offset);
  return (tp_geom_rings){.count = (size_t)count,
                         .start = start,
                         .u = lattice->u + offset,
                         .v = lattice->v + offset,
                         .x = lattice->x + offset,
                         .y = lattice->y + offset,
                         .small = lattice->exponent == 0};
}

tp_status tp_check_geometry(tp_geom_status geometry, const char *what, tp_message *message) {
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

void tp_check_edge_text(char *text, size_t size, const tp_polyline *ring, long edge) {
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

static bool collinear(const tp_lattice *lattice, long first, long count) {
  const fmpz *x = lattice->x + first, *y = lattice->y + first;
  fmpz_t dx, dy, turn;
  fmpz_init(dx);
  fmpz_init(dy);
  fmpz_init(turn);
  bool straight = true;
  for (long k = 2; k < count && straight; k++) {
    fmpz_sub(dx, x + 1, x);
    fmpz_sub(dy, y + k, y);
    fmpz_mul(turn, dx, dy);
    fmpz_sub(dx, x + k, x);
    fmpz_sub(dy, y + 1, y);
    fmpz_submul(turn, dx, dy);
    straight = fmpz_is_zero(turn);
  }
  fmpz_clear(dx);
  fmpz_clear(dy);
  fmpz_clear(turn);
  return straight;
}

/* The first meeting in the order of edges; a mess of meetings is cut off after a million. */
typedef struct first_meeting {
  bool found;
  long seen;
  tp_geom_meeting meeting;
  bool (*counts)(const void *context, tp_geom_meeting meeting);
  const void *context;
} first_meeting;

static bool keep_first(void *context, tp_geom_meeting meeting) {
  first_meeting *first = context;
  if (first->counts != NULL && !first->counts(first->context, meeting)) return true;
  const tp_geom_meeting *best = &first->meeting;
  if (!first->found || meeting.a < best->a || (meeting.a == best->a && meeting.b < best->b)) {
    first->meeting = meeting;
  }
  first->found = true;
  return ++first->seen < 1000000;
}

static const char *verb(tp_geom_meeting_kind kind) {
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

static tp_status fail_not_simple(const tp_polyline *ring, const tp_geom_rings *rings,
                                 const char *name, tp_message *message) {
  first_meeting first = {0};
  const tp_status status = tp_check_geometry(tp_geom_find_meetings(rings, -1, keep_first, &first),
                                             "a crossing outline", message);
  if (status != TP_OK) return status;
  if (!first.found) {
    return tp_fail(message, TP_BAD_INPUT, tp_polyline_place(ring, -1), "%s crosses itself", name);
  }
  const long a = (long)first.meeting.a, b = (long)first.meeting.b;
  char one[320], other[320], where[300];
  tp_check_edge_text(one, sizeof one, ring, a);
  tp_check_edge_text(other, sizeof other, ring, b);
  tp_place_text(where, sizeof where, tp_polyline_place(ring, b));
  return tp_fail(message, TP_BAD_INPUT, tp_polyline_place(ring, a),
                 "%s %s itself: %s %s %s (%s); reorder or move the vertices", name,
                 first.meeting.kind == TP_GEOM_CROSS ? "crosses" : "touches", one,
                 verb(first.meeting.kind), other, where);
}

tp_status tp_check_ring(const tp_polyline *ring, const tp_lattice *lattice, long chain,
                        const char *name, tp_message *message) {
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
  const tp_geom_rings rings = tp_check_rings(lattice, chain, 1, start);
  bool simple = false;
  const tp_status status = tp_check_geometry(tp_geom_is_simple(&simple, &rings, 0), name, message);
  if (status != TP_OK || simple) return status;
  return fail_not_simple(ring, &rings, name, message);
}

/* Rings of a section may touch, and parts may share edges with anything; but no edges may cross,
 * and a hole that shares an edge with the outline is no hole. */
typedef struct section_view {
  const tp_section *section;
  tp_geom_rings rings;
} section_view;

static long ring_of_edge(const section_view *view, size_t edge) {
  long low = 0, high = (long)view->rings.count;
  while (high - low > 1) {
    const long middle = low + (high - low) / 2;
    if (view->rings.start[middle] <= edge) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}

static bool counts_between_rings(const void *context, tp_geom_meeting meeting) {
  const section_view *view = context;
  const long a = ring_of_edge(view, meeting.a), b = ring_of_edge(view, meeting.b);
  if (meeting.kind == TP_GEOM_CROSS) return true;
  return meeting.kind == TP_GEOM_OVERLAP && a == 0 && b <= view->section->hole_count;
}

static tp_status check_crossings(const section_view *view, tp_message *message) {
  first_meeting first = {.counts = counts_between_rings, .context = view};
  const tp_status status =
      tp_check_geometry(tp_geom_find_meetings(&view->rings, -1, keep_first, &first),
                        "the rings of the block", message);
  if (status != TP_OK || !first.found) return status;
  const long ring_a = ring_of_edge(view, first.meeting.a);
  const long ring_b = ring_of_edge(view, first.meeting.b);
  const tp_polyline *a = view->section->rings + ring_a, *b = view->section->rings + ring_b;
  const long edge_a = (long)(first.meeting.a - view->rings.start[ring_a]);
  const long edge_b = (long)(first.meeting.b - view->rings.start[ring_b]);
  char name_a[40], name_b[40], one[320], other[320];
  tp_section_ring_name(name_a, sizeof name_a, view->section, ring_a);
  tp_section_ring_name(name_b, sizeof name_b, view->section, ring_b);
  tp_check_edge_text(one, sizeof one, b, edge_b);
  tp_check_edge_text(other, sizeof other, a, edge_a);
  return tp_fail(message, TP_BAD_INPUT, tp_polyline_place(b, edge_b), "%s %s %s: %s %s %s; %s",
                 name_b, first.meeting.kind == TP_GEOM_CROSS ? "crosses" : "shares an edge with",
                 name_a, one, verb(first.meeting.kind), other,
                 first.meeting.kind == TP_GEOM_CROSS ? "move its vertices"
                                                     : "a notch belongs to the outline itself");
}

static tp_status fail_pair(const tp_section *section, long ring, const char *relation, long other,
                           const char *advice, tp_message *message) {
  char name[40], other_name[40];
  tp_section_ring_name(name, sizeof name, section, ring);
  tp_section_ring_name(other_name, sizeof other_name, section, other);
  return tp_fail(message, TP_BAD_INPUT, tp_polyline_place(section->rings + ring, -1),
                 "%s %s %s; %s", name, relation, other_name, advice);
}

/* Which of the rings of every triangle exclude each other? */
static tp_status check_layers(const tp_geom_triangulation *t, const tp_section *section,
                              tp_message *message) {
  if (t->conflict) {
    const size_t a = t->conflict_a, b = t->conflict_b;
    return fail_pair(section, (long)(a > b ? a : b), "overlaps", (long)(a > b ? b : a),
                     "move one of them", message);
  }
  for (size_t k = 0; k < t->count; k++) {
    const int *in = t->triangles[k].ring_in_layer;
    if (in[1] != 0 && in[0] == 0) {
      return fail_pair(section, in[1] - 1, "lies outside", 0, "move it inside", message);
    }
    if (in[2] != 0 && in[0] == 0) {
      return fail_pair(section, in[2] - 1, "lies in part or in whole outside", 0,
                       "cut it off at the outline", message);
    }
    if (in[2] != 0 && in[1] != 0) {
      return fail_pair(section, in[2] - 1, "overlaps", in[1] - 1, "cut it off at the hole",
                       message);
    }
  }
  return TP_OK;
}

/* Drop the triangles that are not of the block: those in holes. */
static void keep_block(tp_geom_triangulation *t) {
  size_t kept = 0;
  for (size_t k = 0; k < t->count; k++) {
    const int *in = t->triangles[k].ring_in_layer;
    if (in[0] != 0 && in[1] == 0) t->triangles[kept++] = t->triangles[k];
  }
  t->count = kept;
}

tp_status tp_check_triangulate(tp_geom_triangulation *triangulation, const tp_section *section,
                               const tp_lattice *lattice, tp_message *message) {
  const size_t count = (size_t)section->ring_count;
  size_t *start = calloc(count + 1, sizeof *start);
  int *layer = calloc(count + 1, sizeof *layer);
  tp_status status = TP_OK;
  if (start == NULL || layer == NULL) {
    status = tp_fail_memory(message, "the triangulation");
  } else {
    for (long r = 1; r < section->ring_count; r++) layer[r] = r <= section->hole_count ? 1 : 2;
    const tp_geom_rings rings = tp_check_rings(lattice, 0, section->ring_count, start);
    status = tp_check_geometry(tp_geom_triangulate(triangulation, &rings, layer),
                               "the triangulation", message);
    if (status == TP_OK) status = check_layers(triangulation, section, message);
    if (status == TP_OK) keep_block(triangulation);
  }
  free(start);
  free(layer);
  return status;
}

tp_status tp_check_section(tp_geom_triangulation *triangulation, const tp_section *section,
                           const tp_lattice *lattice, tp_message *message) {
  tp_status status = TP_OK;
  for (long r = 0; r < section->ring_count && status == TP_OK; r++) {
    char name[40];
    tp_section_ring_name(name, sizeof name, section, r);
    status = tp_check_ring(section->rings + r, lattice, r, name, message);
  }
  if (status != TP_OK || section->ring_count == 1) return status;
  size_t *start = calloc((size_t)section->ring_count + 1, sizeof *start);
  if (start == NULL) return tp_fail_memory(message, "the check of the block");
  const section_view view = {section, tp_check_rings(lattice, 0, section->ring_count, start)};
  status = check_crossings(&view, message);
  free(start);
  if (status == TP_OK) status = tp_check_triangulate(triangulation, section, lattice, message);
  return status;
}
