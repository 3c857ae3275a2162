/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Edges of an outline that are arcs, kept as arcs.
 *
 * An arc outwards stands in the ring as a polygon of its tangents at rational points of its circle,
 * one inwards as the polygon of its chords: exact, and around the block. The tips between arc and
 * tangents, and the segments between chords and arc, are taken off all moments in closed form.
 * Where this ring and the other one, of chords outwards and tangents inwards, are both simple no
 * arc meets another edge: each lies between the two. */

#ifndef TP_BLOCK_ARCS_H
#define TP_BLOCK_ARCS_H

#include "block/circle.h"
#include "common/message.h"
#include "plane/polyline.h"
#include "scene/scene.h"

/* A piece of an arc between two points of it, in the order of the outline, and its centre. */
typedef struct tp_arc_tip {
  bool inwards;
  long vertex; /* of the ring: where the tangents meet, or inwards where the chord begins */
  fmpq_t before_x, before_y, after_x, after_y, centre_x, centre_y;
} tp_arc_tip;

typedef struct tp_arc_tips {
  long count, capacity;
  tp_arc_tip *items;
  tp_polyline other; /* the ring with chords and tangents exchanged */
} tp_arc_tips;

/* Turn the outline counter-clockwise by the area within its chords and replace its edges that are
 * arcs. On failure `tips` is cleared. */
TP_MUST_USE tp_status tp_arcs_apply(tp_arc_tips *tips, tp_polyline *outline,
                                    const tp_block_description *block, tp_message *message);
void tp_arc_tips_clear(tp_arc_tips *tips);

/* The arc that stands for an edge, counter-clockwise about its centre, from the edge's end to its
 * beginning where it bends inwards; false: it is straight. */
bool tp_arc_over_edge(tp_circle_arc *arc, bool *inwards, const tp_polyline *outline, long edge,
                      const tp_arc_description *description);

#endif
