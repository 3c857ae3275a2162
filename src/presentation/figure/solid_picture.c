/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A picture of a rock, and of the ground about it, from one side, with what is hidden left out:
 * triangles shaded by Lambert's law; edges that bend by more than 25 degrees, and those between
 * what is seen and what is not, as dark lines. */

#include "figure/solid_canvas.h"
#include "figure/solid_surroundings.h"

#include <math.h>
#include <stdlib.h>

#define BENT 0.906 /* the cosine of 25 degrees */

enum { ROCK_LINE = 40, GROUND_LINE = 140 };

/* The normals of a mesh's triangles along right, up and towards the eye. */
typedef float seen_normal[3];

static seen_normal *find_normals(const tp_solid_mesh *mesh, const tp_solid_view *view) {
  seen_normal *normals = malloc((size_t)mesh->triangle_count * sizeof *normals);
  for (long t = 0; t < mesh->triangle_count && normals != NULL; t++) {
    const int *k = mesh->triangles + 3 * t;
    double one[3], other[3], turn[3];
    for (int i = 0; i < 3; i++) {
      one[i] = mesh->points[3L * k[1] + i] - mesh->points[3L * k[0] + i];
      other[i] = mesh->points[3L * k[2] + i] - mesh->points[3L * k[0] + i];
    }
    for (int i = 0; i < 3; i++) {
      const int a = (i + 1) % 3, b = (i + 2) % 3;
      turn[i] = one[a] * other[b] - one[b] * other[a];
    }
    const double length = sqrt(tp_solid_dot(turn, turn));
    const double axes[3] = {tp_solid_dot(turn, view->right), tp_solid_dot(turn, view->up),
                            tp_solid_dot(turn, view->eye)};
    for (int i = 0; i < 3; i++) normals[t][i] = (float)(length > 0 ? axes[i] / length : 0);
  }
  return normals;
}

/* The light comes from the upper left, from the eye's side. */
static double light_on(const float normal[3]) {
  return fmax(0, (-0.45 * normal[0] + 0.6 * normal[1] + 0.66 * normal[2]) / 0.9997);
}

static bool is_outline(const float *a, const float *b) {
  return (a[2] > 0) != (b[2] > 0);
}

static bool is_bent(const float *a, const float *b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] < BENT;
}

/* ---- where it lies -----------------------------------------------------------------------------
 */

typedef struct bounds {
  double low[2], high[2]; /* along right and up */
} bounds;

static void add_point(bounds *b, const tp_solid_view *view, const double point[3]) {
  const double at[2] = {tp_solid_dot(view->right, point), tp_solid_dot(view->up, point)};
  for (int k = 0; k < 2; k++) {
    b->low[k] = fmin(b->low[k], at[k]);
    b->high[k] = fmax(b->high[k], at[k]);
  }
}

static bounds bounds_of(const tp_solid_mesh *rock, const tp_solid_mesh *ground,
                        const tp_surroundings *box, const tp_solid_view *view) {
  bounds b = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
  for (long v = 0; v < rock->vertex_count; v++) add_point(&b, view, rock->points + 3 * v);
  for (long t = 0; t < ground->triangle_count; t++) {
    double polygon[TP_CLIPPED_CORNERS][3];
    const int count = tp_surroundings_clip(polygon, box, ground, t);
    for (int k = 0; k < count; k++) add_point(&b, view, polygon[k]);
  }
  return b;
}

/* ---- the rock ----------------------------------------------------------------------------------
 */

/* Shaded with its edges; or flat, with its outline where there is a ground about it. */
static bool draw_rock(tp_solid_canvas *c, const tp_solid_mesh *mesh, bool shaded, bool outlined) {
  enum { FLAT = 215, DARK = 92, BRIGHT = 150 };
  seen_normal *normals = find_normals(mesh, &c->view);
  for (long t = 0; t < mesh->triangle_count && normals != NULL; t++) {
    double corners[3][3];
    if (normals[t][2] <= 0) continue;
    for (int k = 0; k < 3; k++) {
      tp_solid_canvas_see(corners[k], c, mesh->points + 3L * mesh->triangles[3 * t + k]);
    }
    tp_solid_canvas_fill(c, TP_LAYER_ROCK, corners,
                         (uint8_t)(shaded ? DARK + BRIGHT * light_on(normals[t]) : FLAT));
  }
  for (long k = 0; k < mesh->edge_count && normals != NULL && (shaded || outlined); k++) {
    const int *edge = mesh->edges[k];
    const float *a = normals[edge[2]], *b = normals[edge[3]];
    double ends[2][3];
    if (a[2] <= 0 && b[2] <= 0) continue; /* both face away */
    const bool of_section = edge[2] == edge[3];
    if (!of_section && !is_outline(a, b) && !(shaded && is_bent(a, b))) continue;
    for (int i = 0; i < 2; i++) tp_solid_canvas_see(ends[i], c, mesh->points + 3L * edge[i]);
    tp_solid_canvas_line(c, TP_LAYER_ROCK, ends[0], ends[1], ROCK_LINE);
  }
  const bool done = normals != NULL;
  free(normals);
  return done;
}

/* ---- the ground --------------------------------------------------------------------------------
 */

/* Lighter than the rock; darker from its back, which is seen where it is open. */
static uint8_t ground_grey(const float normal[3]) {
  enum { DARK = 150, BRIGHT = 92, BACK = 128 };
  return (uint8_t)(normal[2] > 0 ? DARK + BRIGHT * light_on(normal) : BACK);
}

static void draw_ground_triangle(tp_solid_canvas *c, const tp_solid_mesh *mesh,
                                 const tp_surroundings *box, long triangle, uint8_t grey) {
  double polygon[TP_CLIPPED_CORNERS][3], corners[3][3];
  const int count = tp_surroundings_clip(polygon, box, mesh, triangle);
  if (count < 3) return;
  tp_solid_canvas_see(corners[0], c, polygon[0]);
  for (int k = 1; k + 1 < count; k++) {
    tp_solid_canvas_see(corners[1], c, polygon[k]);
    tp_solid_canvas_see(corners[2], c, polygon[k + 1]);
    tp_solid_canvas_fill(c, TP_LAYER_GROUND, corners, grey);
  }
}

static bool draw_ground(tp_solid_canvas *c, const tp_solid_mesh *mesh, const tp_surroundings *box) {
  seen_normal *normals = find_normals(mesh, &c->view);
  for (long t = 0; t < mesh->triangle_count && normals != NULL; t++) {
    draw_ground_triangle(c, mesh, box, t, ground_grey(normals[t]));
  }
  for (long k = 0; k < mesh->edge_count && normals != NULL; k++) {
    const int *edge = mesh->edges[k];
    double ends[2][3], seen[2][3];
    const bool ends_here = edge[2] == edge[3];
    if (!ends_here && !is_outline(normals[edge[2]], normals[edge[3]])) continue;
    if (!tp_surroundings_clip_line(ends, box, mesh->points + 3L * edge[0],
                                   mesh->points + 3L * edge[1])) {
      continue;
    }
    for (int i = 0; i < 2; i++) tp_solid_canvas_see(seen[i], c, ends[i]);
    tp_solid_canvas_line(c, TP_LAYER_GROUND, seen[0], seen[1], GROUND_LINE);
  }
  const bool done = normals != NULL;
  free(normals);
  return done;
}

/* ---- both --------------------------------------------------------------------------------------
 */

bool tp_solid_picture_init(tp_solid_picture *picture, const tp_solid_figure *f,
                           const tp_solid_view *view, bool shaded, int dots) {
  const bool has_ground = f->ground.triangle_count > 0;
  const tp_surroundings box = tp_surroundings_of(&f->mesh, &f->ground, view);
  const bounds b = bounds_of(&f->mesh, &f->ground, &box, view);
  tp_solid_canvas c;
  bool done = tp_solid_canvas_init(&c, view, b.low, b.high, dots, has_ground);
  done = done && draw_rock(&c, &f->mesh, shaded, has_ground);
  done = done && (!has_ground || draw_ground(&c, &f->ground, &box));
  done = done && tp_solid_canvas_image(picture, &c);
  picture->is_cut = box.cuts;
  tp_solid_canvas_clear(&c);
  return done;
}

void tp_solid_picture_clear(tp_solid_picture *picture) {
  if (picture->image != NULL) cairo_surface_destroy(picture->image);
}
