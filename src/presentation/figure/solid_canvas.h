/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What of a rock and of its ground is seen from one side, as dots. */

#ifndef TP_FIGURE_SOLID_CANVAS_H
#define TP_FIGURE_SOLID_CANVAS_H

#include "figure/solid.h"

#include <stdint.h>

typedef enum tp_solid_layer { TP_LAYER_ROCK, TP_LAYER_GROUND, TP_LAYERS } tp_solid_layer;

typedef struct tp_solid_canvas {
  tp_solid_view view;
  int width, height;       /* of the fine picture */
  double dots;             /* to a metre, of the fine picture */
  double left, top;        /* metres along right and up of the view */
  float *depth[TP_LAYERS]; /* towards the eye; -INFINITY: nothing. NULL: no such layer */
  uint8_t *grey[TP_LAYERS];
} tp_solid_canvas;

/* For what lies between `low` and `high` along right and up, so many dots of the picture along the
 * longer side; with a layer of ground or without. False when memory is exhausted; to be cleared
 * also then. */
TP_MUST_USE bool tp_solid_canvas_init(tp_solid_canvas *canvas, const tp_solid_view *view,
                                      const double low[2], const double high[2], int dots,
                                      bool with_ground);
void tp_solid_canvas_clear(tp_solid_canvas *canvas);

/* A point as it is seen: dots to the right and down, metres towards the eye. */
void tp_solid_canvas_see(double seen[3], const tp_solid_canvas *canvas, const double point[3]);

/* A triangle and a line between points as they are seen; a line dark where nothing of its layer is
 * in front of it. */
void tp_solid_canvas_fill(tp_solid_canvas *canvas, tp_solid_layer layer, const double corners[3][3],
                          uint8_t grey);
void tp_solid_canvas_line(tp_solid_canvas *canvas, tp_solid_layer layer, const double from[3],
                          const double to[3], uint8_t grey);

TP_MUST_USE bool tp_solid_canvas_image(tp_solid_picture *picture, const tp_solid_canvas *canvas);

#endif
