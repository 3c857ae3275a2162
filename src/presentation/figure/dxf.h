/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A figure as a drawing of CAD: DXF of release 12, which every program reads. Lengths are those of
 * the scene, at its own coordinates, as the block lies: on a slope they are turned by its dip. */

#ifndef TP_FIGURE_DXF_H
#define TP_FIGURE_DXF_H

#include "figure/figure.h"
#include "problem/world_turn.h"

typedef enum tp_cad_layer {
  TP_CAD_BLOCK,
  TP_CAD_HOLE,
  TP_CAD_PART,
  TP_CAD_BASE,
  TP_CAD_CONTACT,
  TP_CAD_WATER,
  TP_CAD_BOLTS,
  TP_CAD_FORCES,
  TP_CAD_MECHANISM,
  TP_CAD_TEXT,
  TP_CAD_LAYERS
} tp_cad_layer;

typedef struct tp_cad {
  tp_text text;
  const tp_figure *figure;
  bool turned;
  tp_turn lie; /* if turned: from the frame of the problem to how it lies */
} tp_cad;

/* ---- entities, in the drawing's coordinates ---- */

/* Header and table of layers; the rest of the file. `unit`: mm, cm, m, km, in or ft. */
void tp_cad_begin(tp_text *text, const char *unit);
void tp_cad_end(tp_text *text);
/* Vertices follow, each with the bulge of what goes on from it (0: straight), then the end. */
void tp_cad_polyline(tp_text *text, tp_cad_layer layer, bool closed);
void tp_cad_vertex(tp_text *text, tp_cad_layer layer, tp_spot at, double bulge);
void tp_cad_polyline_end(tp_text *text, tp_cad_layer layer);
void tp_cad_line(tp_text *text, tp_cad_layer layer, tp_spot from, tp_spot to);
void tp_cad_arrow(tp_text *text, tp_cad_layer layer, tp_spot tail, tp_spot tip);
void tp_cad_circle(tp_text *text, tp_cad_layer layer, tp_spot centre, double radius);
/* On one line, its lower left corner at the point. */
void tp_cad_text(tp_text *text, tp_cad_layer layer, tp_spot at, double height, const char *words);

/* ---- places ---- */

/* A point of the problem's frame in scene lengths, a point of the shape, a point of the lattice:
 * where it lies, rounded once. */
tp_spot tp_cad_of_scene(const tp_cad *d, const fmpq_t x, const fmpq_t y);
tp_spot tp_cad_of_spot(const tp_cad *d, tp_spot spot);
tp_spot tp_cad_of_point(const tp_cad *d, long point);
/* The shape's unit in scene lengths. */
double tp_cad_unit(const tp_cad *d);

/* ---- the drawing ---- */

void tp_cad_add_loads(tp_cad *d, const tp_state *state);

/* All of it, to be freed. */
TP_MUST_USE tp_status tp_cad_draw(char **bytes, size_t *length, const tp_figure *figure,
                                  tp_message *message);

#endif
