/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The figure of a solid: its mesh in the frame of its base, pictures of it, and who draws the parts
 * of the page. Lengths are metres from the foot of the centroid: east, north and up from the base;
 * the page is measured in points, y down. */

#ifndef TP_FIGURE_SOLID_H
#define TP_FIGURE_SOLID_H

#include "figure/figure.h"

typedef struct tp_solid_mesh {
  long vertex_count, triangle_count;
  double *points; /* east, north, up of each */
  int *triangles;
  long edge_count;
  int (*edges)[4]; /* two vertices, and the two triangles beside */
  double height;   /* of the centroid */
  double size;     /* the farthest point from the foot */
} tp_solid_mesh;

/* How it is looked at: right, up and towards the eye, unit vectors at right angles. */
typedef struct tp_solid_view {
  double right[3], up[3], eye[3];
} tp_solid_view;

/* A picture of the mesh: an image, and where it lies in lengths of the view. */
typedef struct tp_solid_picture {
  cairo_surface_t *image;
  double dots;          /* to a metre */
  double left, top;     /* of its corner, along right and up */
  double width, height; /* metres */
} tp_solid_picture;

typedef struct tp_solid_figure {
  const tp_solid *solid;
  tp_solid_mesh mesh;
  const tp_solid_band *band; /* that governs */
  bool has_way;              /* the rock has an azimuth in which it is tilted, or moves first: */
  double azimuth_deg;        /* that, to the right in the view */
  double tilt;               /* of the base as it is drawn, radians */
  tp_solid_view view;        /* from the side */
  tp_solid_picture side, above;
} tp_solid_figure;

/* The mesh of a solid, read again; to be cleared where it was made. */
TP_MUST_USE tp_status tp_solid_mesh_init(tp_solid_mesh *mesh, const tp_solid *solid,
                                         tp_message *message);
void tp_solid_mesh_clear(tp_solid_mesh *mesh);

/* Draw it, shaded or as a flat shape, into a picture of so many dots along its longer side. False
 * when memory is exhausted. */
TP_MUST_USE bool tp_solid_picture_init(tp_solid_picture *picture, const tp_solid_mesh *mesh,
                                       const tp_solid_view *view, bool shaded, int dots);
void tp_solid_picture_clear(tp_solid_picture *picture);

/* The ink of a band by its number, and how many are drawn. */
enum { TP_SOLID_BANDS_DRAWN = 6 };
tp_ink tp_solid_band_ink(size_t number);

/* Parts of the page, each within its box. */
void tp_solid_draw_side(cairo_t *cr, const tp_solid_figure *figure, tp_box box);
void tp_solid_draw_above(cairo_t *cr, const tp_solid_figure *figure, tp_box box);
void tp_solid_draw_rose(cairo_t *cr, const tp_solid_figure *figure, tp_box box);
/* The table of bands, from y on; where it ends. */
double tp_solid_draw_bands(cairo_t *cr, const tp_solid_figure *figure, double x, double y,
                           double width);

/* The whole page. */
double tp_solid_page_width(void);
TP_MUST_USE bool tp_solid_page(double *height, cairo_t *cr, const tp_solid_figure *figure);

#endif
