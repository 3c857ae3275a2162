/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Is a ring a simple polygon? */

#ifndef TP_CHECK_RING_H
#define TP_CHECK_RING_H

#include "geom.h"
#include "message.h"
#include "plane/lattice.h"

/* The chains from `first` on, `count` of them, as rings of the geometry. `start` has room for
 * count + 1 entries and must outlive the view. */
tp_geom_rings tp_check_rings(const tp_lattice *lattice, long first, long count, size_t *start);

/* A status of the geometry as one of the library, with its message. */
tp_status tp_check_geometry(tp_geom_status geometry, const char *what, tp_message *message);

/* "the edge from vertex 2 (30, 5) to vertex 3 (60, 0)" for the k-th edge of a closed ring. */
void tp_check_edge_text(char *text, size_t size, const tp_polyline *ring, long edge);

/* The first meeting in the order of edges; a mess of meetings is cut off after a million. */
typedef struct tp_first_meeting {
  bool found;
  long seen;
  tp_geom_meeting meeting;
  bool (*counts)(const void *context, tp_geom_meeting meeting);
  const void *context;
} tp_first_meeting;

/* A tp_geom_visitor for a tp_first_meeting. */
bool tp_check_keep_first(void *context, tp_geom_meeting meeting);

/* "crosses", "touches", "lies on". */
const char *tp_check_verb(tp_geom_meeting_kind kind);

/* Refuse a closed ring with a vertex given twice in a row, all vertices on a line, or one that
 * meets itself. `name` is the ring in the message, which offers a repair where it is `repairable`
 * and that would help. */
TP_MUST_USE tp_status tp_check_ring(const tp_polyline *ring, const tp_lattice *lattice, long chain,
                                    bool repairable, const char *name, tp_message *message);

#endif
