/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The blocks of a scene of many as chains of doubles, for drawing alone.
 *
 * Lengths are in units of the size of all free blocks (the larger of the width and the height of
 * the box around them) from a corner of one of them, which is subtracted exactly. */

#ifndef TP_SHAPE_BLOCK_SHAPES_H
#define TP_SHAPE_BLOCK_SHAPES_H

#include "shape/shape.h"

typedef struct tp_block_shape {
  tp_chain outline; /* with its holes; arcs as the chords that were solved */
  tp_chain parts;   /* of another unit weight */
  tp_spot centroid;
} tp_block_shape;

/* A contact: its ends, where it can be pressed, and the direction along which the first block lies
 * on the left, of length 1. */
typedef struct tp_contact_line {
  tp_spot ends[2], along;
} tp_contact_line;

typedef struct tp_block_shapes {
  double unit_m;
  tp_spot origin_m; /* among the results */
  tp_box box;       /* around the free blocks */
  size_t count, contact_count;
  tp_block_shape *blocks;
  tp_contact_line *contacts;
} tp_block_shapes;

/* Of a scene and its result, which is refused where it is of another one. On failure `shapes` is
 * cleared. */
TP_MUST_USE tp_status tp_block_shapes_init(tp_block_shapes *shapes, const tp_scene *scene,
                                           const tp_block_system *system, tp_message *message);
void tp_block_shapes_clear(tp_block_shapes *shapes);

/* The spot of a contact's resultant, from where it acts among the results. */
tp_spot tp_block_shapes_force(const tp_block_shapes *shapes, size_t contact, double x_m,
                              double y_m);

#endif
