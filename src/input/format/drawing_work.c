/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Counters of points made and of bits of nested transforms, each refused beyond its budget. */

#include "format/drawing_work.h"

#include "common/budget.h"

double tp_drawing_points_allowed(size_t bytes) {
  return bytes > TP_BUDGET_DRAWN_POINTS ? (double)bytes : TP_BUDGET_DRAWN_POINTS;
}

tp_status tp_drawing_count(tp_drawing *drawing, const tp_drawing_object *object,
                           tp_message *message) {
  enum { OF_ITSELF = 4 }; /* points that an object without any is as dear as */
  drawing->points_made += OF_ITSELF + (double)object->line.count;
  if (drawing->points_made <= drawing->points_allowed) return TP_OK;
  return tp_refuse(message, TP_FAULT_RANGE, tp_drawing_place(object),
                   "with this %s, curves and inserted blocks of the drawing come to more than %.0f "
                   "points; give a larger 'drawing: {tolerance: …}', name the layer of the block "
                   "with 'drawing: {block: …}', or export the layers of block and base alone",
                   object->kind, drawing->points_allowed);
}

const char *tp_drawing_map_problem(const tp_affine_map *map) {
  if (tp_affine_map_bits(map) <= TP_BUDGET_TRANSFORM_BITS) return NULL;
  return "has more transforms, with those of the groups around it, than are multiplied out "
         "exactly: their numbers have more than 4096 bits; apply them in the drawing program";
}
