/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which edges of an outline are arcs: those whose end, as its author named it, an arc begins in.
 * Arcs are sorted once, by the points that they begin in; each edge is then looked up in
 * logarithmic time. */

#ifndef TP_BLOCK_ARC_BEGINS_H
#define TP_BLOCK_ARC_BEGINS_H

#include "scene/scene.h"

typedef struct tp_arc_begins {
  const tp_arc_description **arcs; /* of the block, from left to right and upwards */
  long count;
} tp_arc_begins;

/* False when memory is exhausted; there is nothing to clear then. */
TP_MUST_USE bool tp_arc_begins_init(tp_arc_begins *begins, const tp_block_description *block);
void tp_arc_begins_clear(tp_arc_begins *begins);

/* The arc of an edge, the first of the block's list where several begin in one point; or NULL. */
const tp_arc_description *tp_arc_begins_find(const tp_arc_begins *begins,
                                             const tp_polyline *outline, long edge);

#endif
