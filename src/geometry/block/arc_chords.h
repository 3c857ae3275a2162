/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Chords in place of the arcs of an outline, for what takes straight edges alone.
 *
 * Chords leave an arc by no more than a tolerance (format/curve.h), so the block by no more,
 * outwards or inwards; an arc outwards loses what lies between it and its chords, one inwards gains
 * it, at most the tolerance times the length of the arcs. */

#ifndef TP_BLOCK_ARC_CHORDS_H
#define TP_BLOCK_ARC_CHORDS_H

#include "common/message.h"
#include "scene/scene.h"

typedef struct tp_arc_chords {
  tp_polyline ring; /* the outline, counter-clockwise by the area within its chords */
  long count;       /* of the chords */
  double area;      /* by how much that of the block is off at most, in scene lengths */
} tp_arc_chords;

/* By the block's `arc_tolerance`. On failure `*chords` is empty. */
TP_MUST_USE tp_status tp_arc_chords_init(tp_arc_chords *chords, const tp_block_description *block,
                                         tp_message *message);
void tp_arc_chords_clear(tp_arc_chords *chords);

#endif
