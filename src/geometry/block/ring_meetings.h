/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rings of a lattice as the geometry sees them, and meetings of their edges told in the user's
 * vertices. */

#ifndef TP_BLOCK_RING_MEETINGS_H
#define TP_BLOCK_RING_MEETINGS_H

#include "common/message.h"
#include "geom/geom.h"
#include "plane/lattice.h"

/* The chains from `first` on, `count` of them, as rings of the geometry. `start` has room for
 * count + 1 entries and must outlive the view. */
tp_geom_rings tp_rings_view(const tp_lattice *lattice, long first, long count, size_t *start);

/* A status of the geometry as one of the library, with its message. */
tp_status tp_rings_status(tp_geom_status geometry, const char *what, tp_message *message);

/* "the edge from vertex 2 (30, 5) to vertex 3 (60, 0)" for the k-th edge of a closed ring. */
void tp_rings_edge_text(char *text, size_t size, const tp_polyline *ring, long edge);

/* The first meeting in the order of edges; the search ends after a million of them. */
typedef struct tp_first_meeting {
  bool found;
  long seen;
  tp_geom_meeting meeting;
  bool (*counts)(const void *context, tp_geom_meeting meeting);
  const void *context;
} tp_first_meeting;

/* A tp_geom_visitor for a tp_first_meeting. */
bool tp_rings_keep_first(void *context, tp_geom_meeting meeting);

/* "crosses", "touches", "lies on". */
const char *tp_rings_verb(tp_geom_meeting_kind kind);

#endif
