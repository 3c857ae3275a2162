/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The figure of a solid: its mesh in the frame of its base, pictures of it, and who draws the parts
 * of the page. Lengths are metres from the foot of the centroid: east, north and up from the base;
 * the page is measured in points, y down. */

#ifndef TP_FIGURE_SOLID_H
#define TP_FIGURE_SOLID_H

#include "figure/drawn_page.h"
#include "figure/figure.h"

typedef struct tp_solid_mesh {
  long vertex_count, triangle_count;
  double *points; /* east, north, up of each */
  int *triangles;
  long edge_count;
  int (*edges)[4];   /* two vertices, and the two triangles beside */
  double height;     /* of the centroid */
  double size;       /* the farthest point from the foot */
  double axes[3][3]; /* east, north and up, unit vectors in the axes of the file */
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
  bool is_cut;          /* the ground goes on beyond what is drawn of it */
} tp_solid_picture;

typedef struct tp_solid_figure {
  const tp_solid *solid;
  tp_solid_mesh mesh;        /* none of a wedge */
  tp_solid_mesh ground;      /* that it rests on, in the frame of the mesh; else none */
  const tp_solid_band *band; /* that governs; NULL: it lies on contacts, or is a wedge */
  bool has_way;              /* the rock has an azimuth in which it is tilted, or moves first: */
  double azimuth_deg;        /* that, to the right in the view */
  double tilt;               /* of the base as it is drawn, radians */
  tp_solid_view view;        /* from the side */
  tp_solid_picture side, above;
  const tp_language *language; /* of its text, and the sign before decimals; NULL: English */
  bool comma;
  bool sketch; /* on a sheet, whose text has title, verdict and numbers already: without these */
} tp_solid_figure;

static inline double tp_solid_dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* point + share way */
static inline void tp_solid_go(double to[3], const double point[3], double share,
                               const double way[3]) {
  for (int k = 0; k < 3; k++) to[k] = point[k] + share * way[k];
}

/* Of a picture of the rock along its longer side: some 300 to the inch. */
enum { TP_SOLID_DOTS = 1100, TP_SOLID_SKETCH_DOTS = 700 };

/* Chooses what is shown of a solid, and reads its mesh again; to be cleared. `dots` 0: there are no
 * pictures. */
TP_MUST_USE tp_status tp_solid_figure_init(tp_solid_figure *figure, const tp_solid *solid, int dots,
                                           tp_message *message);
void tp_solid_figure_clear(tp_solid_figure *figure);

/* The mesh of a solid, read again, and that of its ground, empty where it has none, in the frame of
 * the solid's; to be cleared where they were made. */
TP_MUST_USE tp_status tp_solid_mesh_init(tp_solid_mesh *mesh, tp_solid_mesh *ground,
                                         const tp_solid *solid, tp_message *message);
void tp_solid_mesh_clear(tp_solid_mesh *mesh);

/* A vector, and a point in lengths of the file, in the frame of the base. */
void tp_solid_mesh_turn(double turned[3], const tp_solid_mesh *mesh, const double vector[3]);
void tp_solid_mesh_place(double placed[3], const tp_solid_mesh *mesh, const tp_solid *solid,
                         const double point[3]);

/* Draw the rock, shaded or as a flat shape, and the ground about it into a picture of so many dots
 * along its longer side. False when memory is exhausted. */
TP_MUST_USE bool tp_solid_picture_init(tp_solid_picture *picture, const tp_solid_figure *figure,
                                       const tp_solid_view *view, bool shaded, int dots);
void tp_solid_picture_clear(tp_solid_picture *picture);

/* The edge that is met first on the way; false: there is none. Metres to a share of the weight: the
 * largest force is as long as a third of the rock. */
bool tp_solid_edge_met(tp_solid_corner ends[2], const tp_solid_figure *figure);
double tp_solid_force_scale(const tp_solid_figure *figure);

/* As the bytes of a .glb, to be freed; not of a wedge. */
TP_MUST_USE tp_status tp_solid_gltf(char **bytes, size_t *length, const tp_solid_figure *figure,
                                    tp_message *message);

/* ---- drawing -----------------------------------------------------------------------------------
 */

/* Where a view lies on the page. */
typedef struct tp_solid_place {
  const tp_solid_view *view;
  double scale, x, y; /* points to a metre, and the foot on the page */
} tp_solid_place;

extern const tp_solid_view tp_solid_from_above;

/* The picture in the middle of a box; a point east, north and up of the foot. */
tp_solid_place tp_solid_fit(const tp_solid_view *view, const tp_solid_picture *picture, tp_box box);
tp_spot tp_solid_spot(const tp_solid_place *place, double east, double north, double up);
void tp_solid_paint(cairo_t *cr, const tp_solid_place *place, const tp_solid_picture *picture);
void tp_solid_line(cairo_t *cr, tp_spot from, tp_spot to);
/* A length that is round, at the foot of the box. */
void tp_solid_draw_length(cairo_t *cr, const tp_solid_figure *figure, const tp_solid_place *place,
                          tp_box box);
/* The foot of the centroid, the way of the tilt, north and a length, on a view from above. */
void tp_solid_draw_bearings(cairo_t *cr, const tp_solid_figure *figure, const tp_solid_place *place,
                            tp_box box);

/* The ink of a band by its number, and how many are drawn. */
enum { TP_SOLID_BANDS_DRAWN = 6 };
tp_ink tp_solid_band_ink(size_t number);

/* A text, which is English, in the language of the figure, to be drawn at once. */
const char *tp_solid_say(const tp_solid_figure *figure, char said[TP_LINE_SIZE],
                         const char *english);

/* Parts of the page, each within its box. */
void tp_solid_draw_side(cairo_t *cr, const tp_solid_figure *figure, tp_box box);
void tp_solid_draw_above(cairo_t *cr, const tp_solid_figure *figure, tp_box box);
void tp_solid_draw_rose(cairo_t *cr, const tp_solid_figure *figure, tp_box box);
/* Likewise of one on contacts, and of a wedge. */
void tp_solid_draw_held(cairo_t *cr, const tp_solid_figure *figure, tp_box box);
void tp_solid_draw_held_above(cairo_t *cr, const tp_solid_figure *figure, tp_box box);
void tp_solid_draw_stereonet(cairo_t *cr, const tp_solid_figure *figure, tp_box box);
void tp_solid_draw_wedge(cairo_t *cr, const tp_solid_figure *figure, tp_box box);
/* The table of bands, and of contacts, from y on, or a line of which ink is which band; where it
 * ends. */
double tp_solid_draw_key(cairo_t *cr, const tp_solid_figure *figure, double x, double y);
double tp_solid_draw_bands(cairo_t *cr, const tp_solid_figure *figure, double x, double y,
                           double width);
double tp_solid_draw_contacts(cairo_t *cr, const tp_solid_figure *figure, double x, double y,
                              double width);

/* The whole page, with so much room between its margins; and as what is drawn into a file. */
#define TP_SOLID_PAGE_ROOM 558.0
TP_MUST_USE bool tp_solid_page(double *height, cairo_t *cr, const tp_solid_figure *figure);
tp_drawn_page tp_solid_drawn_page(const tp_solid_figure *figure);

#endif
