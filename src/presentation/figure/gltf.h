/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A model of glTF 2.0 in one binary file (Khronos Group, glTF 2.0 Specification, 2021): a head of
 * JSON, and a buffer of floats and indices. Under one node each shape is a mesh of its own. Lengths
 * are metres; glTF has y upwards, so that a point east, north, up is (east, up, -north). */

#ifndef TP_FIGURE_GLTF_H
#define TP_FIGURE_GLTF_H

#include "output/text.h"

typedef enum tp_gltf_material {
  TP_GLTF_ROCK,
  TP_GLTF_GROUND,
  TP_GLTF_RED,
  TP_GLTF_BLUE,
  TP_GLTF_GREEN,
  TP_GLTF_PURPLE,
  TP_GLTF_BLACK,
  TP_GLTF_MATERIALS
} tp_gltf_material;

/* Points, or indices of points, in a part of the buffer of its own. */
typedef struct tp_gltf_accessor {
  size_t start, length, count;
  bool of_points;
  float low[3], high[3]; /* of points */
} tp_gltf_accessor;

typedef struct tp_gltf_shape {
  char name[80];
  tp_gltf_material material;
  long points, indices; /* accessors; indices of triangles, or below zero: lines, two points each */
} tp_gltf_shape;

/* Begin with {0}. */
typedef struct tp_gltf {
  tp_text buffer;
  tp_gltf_accessor *accessors;
  tp_gltf_shape *shapes;
  long accessor_count, accessor_room, shape_count, shape_room;
  double centroid_height; /* over the base, metres */
  bool failed;            /* memory was exhausted */
} tp_gltf;

void tp_gltf_clear(tp_gltf *model);

/* Lines between points two by two, east, north, up of each; side by side, as loops of lines are
 * known to fewer viewers. */
void tp_gltf_add_lines(tp_gltf *model, const char *name, tp_gltf_material material,
                       const double *points, size_t count);
void tp_gltf_add_line(tp_gltf *model, const char *name, tp_gltf_material material,
                      const double from[3], const double to[3]);

/* Triangles, counter-clockwise seen from outside. */
void tp_gltf_add_triangles(tp_gltf *model, const char *name, tp_gltf_material material,
                           const double *points, size_t count, const int *corners,
                           size_t corner_count);

/* The file, of the model leant over by an angle towards an azimuth, both in radians; 4 GB at most.
 * `source` is named where it is refused. */
TP_MUST_USE tp_status tp_gltf_write(char **bytes, size_t *length, const tp_gltf *model, double lean,
                                    double azimuth, const char *source, tp_message *message);

#endif
