/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Meetings of edges of different rings that are not allowed, then the rings that each triangle of
 * the constrained Delaunay triangulation belongs to; triangles in holes are dropped. */

#include "block/check.h"

#include "block/check_ring.h"
#include "block/ring_meetings.h"

#include <stdlib.h>

/* Rings of a section may touch, and parts may share edges with anything; but no edges may cross, a
 * hole that shares an edge with the outline is no hole, and two that share one are a single hole:
 * what stands between them has no thickness. */
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
  return meeting.kind == TP_GEOM_OVERLAP && a <= view->section->hole_count &&
         b <= view->section->hole_count;
}

static tp_status check_crossings(const section_view *view, tp_message *message) {
  tp_first_meeting first = {.counts = counts_between_rings, .context = view};
  const tp_status status =
      tp_rings_status(tp_geom_find_meetings(&view->rings, -1, tp_rings_keep_first, &first),
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
  tp_rings_edge_text(one, sizeof one, b, edge_b);
  tp_rings_edge_text(other, sizeof other, a, edge_a);
  const char *advice = first.meeting.kind == TP_GEOM_CROSS ? "move its vertices"
                       : ring_a == 0                       ? "a notch belongs to the outline itself"
                                     : "nothing stands between them: give them as one hole";
  return tp_refuse(message, TP_FAULT_GEOMETRY, tp_polyline_place(b, edge_b),
                   "%s %s %s: %s %s %s; %s", name_b,
                   first.meeting.kind == TP_GEOM_CROSS ? "crosses" : "shares an edge with", name_a,
                   one, tp_rings_verb(first.meeting.kind), other, advice);
}

static tp_status fail_pair(const tp_section *section, long ring, const char *relation, long other,
                           const char *advice, tp_message *message) {
  char name[40], other_name[40];
  tp_section_ring_name(name, sizeof name, section, ring);
  tp_section_ring_name(other_name, sizeof other_name, section, other);
  return tp_refuse(message, TP_FAULT_GEOMETRY, tp_polyline_place(section->rings + ring, -1),
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
  free(t->across); /* it told of the others too */
  t->across = NULL;
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
    const tp_geom_rings rings = tp_rings_view(lattice, 0, section->ring_count, start);
    status = tp_rings_status(tp_geom_triangulate(triangulation, &rings, layer), "the triangulation",
                             message);
    if (status == TP_OK) status = check_layers(triangulation, section, message);
    if (status == TP_OK) status = tp_check_in_one_piece(triangulation, section, message);
    if (status == TP_OK) keep_block(triangulation);
    if (status == TP_OK && !tp_check_fills(triangulation, lattice, section->hole_count)) {
      status =
          tp_fail(message, TP_DEPENDENCY_FAILED, tp_polyline_place(section->rings, -1),
                  "the triangles of the block, as CGAL found them, failed their check: they do "
                  "not fill it; please report this scene");
    }
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
    status = tp_check_ring(section->rings + r, lattice, r, section->repairable, name, message);
  }
  if (status != TP_OK || section->ring_count == 1) return status;
  size_t *start = calloc((size_t)section->ring_count + 1, sizeof *start);
  if (start == NULL) return tp_fail_memory(message, "the check of the block");
  const section_view view = {section, tp_rings_view(lattice, 0, section->ring_count, start)};
  status = check_crossings(&view, message);
  free(start);
  if (status == TP_OK) status = tp_check_triangulate(triangulation, section, lattice, message);
  return status;
}
