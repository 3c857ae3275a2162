/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Edges of an outline that are arcs, kept as arcs.
 *
 * An arc stands in the ring as a polygon of its tangents at rational points of its circle: exact,
 * and around the block. The tips between arc and tangents are taken off all moments in closed form,
 * as those of rounded corners are. Where both the ring of tangents and the ring of chords are
 * simple no arc meets another edge: each lies between its chords and its tangents. */

#ifndef TP_ARCS_H
#define TP_ARCS_H

#include "message.h"
#include "number/polyline.h"
#include "scene/scene.h"

/* A vertex of tangents: the points of the arc on either side, counter-clockwise, and the centre. */
typedef struct tp_arc_tip {
  long vertex; /* of the ring */
  fmpq_t before_x, before_y, after_x, after_y, centre_x, centre_y;
} tp_arc_tip;

typedef struct tp_arc_tips {
  long count, capacity;
  tp_arc_tip *items;
  tp_polyline chords; /* the ring with the points of the arcs in the place of the tangents */
} tp_arc_tips;

/* Replace the edges of a counter-clockwise outline that are arcs by tangents. On failure `tips` is
 * cleared. */
TP_MUST_USE tp_status tp_arcs_apply(tp_arc_tips *tips, tp_polyline *outline,
                                    const tp_block_description *block, tp_message *message);
void tp_arc_tips_clear(tp_arc_tips *tips);

#endif
