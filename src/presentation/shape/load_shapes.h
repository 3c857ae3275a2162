/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Loads on many blocks, and the water that they stand in, as spots of their shapes, for drawing
 * alone. */

#ifndef TP_SHAPE_LOAD_SHAPES_H
#define TP_SHAPE_LOAD_SHAPES_H

#include "shape/block_shapes.h"

typedef enum tp_load_shape_kind {
  TP_LOAD_PRESSES, /* along a line, to its left */
  TP_LOAD_WEIGHS,  /* along a line, as gravity does */
  TP_LOAD_PULLS,   /* a bolt, at its head */
  TP_LOAD_PUSHES   /* a force, at a point */
} tp_load_shape_kind;

typedef struct tp_load_shape {
  tp_load_shape_kind kind;
  tp_spot at, to;     /* ends of a line; the point, and of a bolt that has an end that */
  bool ends;          /* it has */
  double first, last; /* kPa, at the ends of a line */
  tp_spot along;      /* of a pull or a push, of length 1 */
} tp_load_shape;

typedef struct tp_load_shapes {
  size_t count;
  tp_load_shape *items;
  tp_chain water; /* its surface; none: empty */
} tp_load_shapes;

/* As the blocks lie in a case that goes to a side. On failure cleared. */
TP_MUST_USE tp_status tp_load_shapes_init(tp_load_shapes *loads, const tp_block_shapes *blocks,
                                          const tp_scene *scene, bool left, tp_message *message);
void tp_load_shapes_clear(tp_load_shapes *loads);

#endif
