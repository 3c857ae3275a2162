/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A picture of a mesh from one side, with what is hidden left out: for each dot the triangle that
 * is nearest to the eye (Catmull 1974), shaded by Lambert's law; edges that bend by more than 25
 * degrees, and those between what is seen and what is not, as dark dots where nothing is in front.
 * It is drawn at twice its size and made smaller by the mean of four dots, which smooths it. */

#include "figure/solid.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

enum { FINE = 2, FINE_DOTS = FINE * FINE };
#define BENT 0.906  /* the cosine of 25 degrees */
#define AHEAD 0.004 /* by which an edge may lie behind, of the size of the picture */

typedef struct canvas {
  int width, height;
  double dots;      /* to a metre, of the fine picture */
  double left, top; /* metres */
  float *depth;     /* towards the eye; -INFINITY: nothing */
  uint8_t *grey;
  double (*seen)[3]; /* vertices: dots to the right and down, metres towards the eye */
  float (*normals)[3];
} canvas;

/* ---- where it lies -----------------------------------------------------------------------------
 */

static void set_canvas(canvas *c, const tp_solid_mesh *mesh, const tp_solid_view *view, int dots) {
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
  for (long v = 0; v < mesh->vertex_count; v++) {
    const double at[2] = {tp_solid_dot(view->right, mesh->points + 3 * v),
                          tp_solid_dot(view->up, mesh->points + 3 * v)};
    for (int k = 0; k < 2; k++) {
      low[k] = fmin(low[k], at[k]);
      high[k] = fmax(high[k], at[k]);
    }
  }
  const double wide = high[0] - low[0], tall = high[1] - low[1];
  const double border = 0.01 * fmax(wide, tall);
  c->dots = FINE * dots / (fmax(wide, tall) + 2 * border);
  c->left = low[0] - border;
  c->top = high[1] + border;
  c->width = FINE * (int)ceil(c->dots * (wide + 2 * border) / FINE);
  c->height = FINE * (int)ceil(c->dots * (tall + 2 * border) / FINE);
}

static bool make_canvas(canvas *c, const tp_solid_mesh *mesh) {
  const size_t count = (size_t)c->width * (size_t)c->height;
  c->depth = malloc(count * sizeof *c->depth);
  c->grey = calloc(count, sizeof *c->grey);
  c->seen = malloc((size_t)mesh->vertex_count * sizeof *c->seen);
  c->normals = malloc((size_t)mesh->triangle_count * sizeof *c->normals);
  for (size_t k = 0; c->depth != NULL && k < count; k++) c->depth[k] = -INFINITY;
  return c->depth != NULL && c->grey != NULL && c->seen != NULL && c->normals != NULL;
}

static void look(canvas *c, const tp_solid_mesh *mesh, const tp_solid_view *view) {
  for (long v = 0; v < mesh->vertex_count; v++) {
    const double *p = mesh->points + 3 * v;
    c->seen[v][0] = c->dots * (tp_solid_dot(view->right, p) - c->left);
    c->seen[v][1] = c->dots * (c->top - tp_solid_dot(view->up, p));
    c->seen[v][2] = tp_solid_dot(view->eye, p);
  }
  for (long t = 0; t < mesh->triangle_count; t++) {
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
    for (int i = 0; i < 3; i++) c->normals[t][i] = (float)(length > 0 ? axes[i] / length : 0);
  }
}

/* ---- triangles ---------------------------------------------------------------------------------
 */

/* The light comes from the upper left, from the eye's side. */
static uint8_t shade(const float normal[3], bool shaded) {
  static const double dark = 92, bright = 150, flat = 215;
  const double light = (-0.45 * normal[0] + 0.6 * normal[1] + 0.66 * normal[2]) / 0.9997;
  return (uint8_t)(shaded ? dark + bright * fmax(light, 0) : flat);
}

static int clamp(double at, int most) {
  return at <= 0 ? 0 : at >= most ? most : (int)at;
}

static void fill_triangle(canvas *c, const int *corners, uint8_t grey) {
  const double *p = c->seen[corners[0]], *q = c->seen[corners[1]], *r = c->seen[corners[2]];
  const double area = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  if (area == 0) return;
  const int x0 = clamp(floor(fmin(p[0], fmin(q[0], r[0]))), c->width - 1);
  const int x1 = clamp(ceil(fmax(p[0], fmax(q[0], r[0]))), c->width - 1);
  const int y0 = clamp(floor(fmin(p[1], fmin(q[1], r[1]))), c->height - 1);
  const int y1 = clamp(ceil(fmax(p[1], fmax(q[1], r[1]))), c->height - 1);
  for (int y = y0; y <= y1; y++) {
    for (int x = x0; x <= x1; x++) {
      const double u = x + 0.5 - p[0], v = y + 0.5 - p[1];
      const double a = (u * (r[1] - p[1]) - v * (r[0] - p[0])) / area;
      const double b = ((q[0] - p[0]) * v - (q[1] - p[1]) * u) / area;
      if (a < 0 || b < 0 || a + b > 1) continue;
      const float depth = (float)(p[2] + a * (q[2] - p[2]) + b * (r[2] - p[2]));
      const size_t at = (size_t)y * (size_t)c->width + (size_t)x;
      if (depth <= c->depth[at]) continue;
      c->depth[at] = depth;
      c->grey[at] = grey;
    }
  }
}

/* ---- edges -------------------------------------------------------------------------------------
 */

static bool is_drawn(const canvas *c, const int edge[4]) {
  const float *a = c->normals[edge[2]], *b = c->normals[edge[3]];
  if (a[2] <= 0 && b[2] <= 0) return false; /* both face away */
  if (edge[2] == edge[3]) return true;      /* of a section */
  return (a[2] > 0) != (b[2] > 0) || a[0] * b[0] + a[1] * b[1] + a[2] * b[2] < BENT;
}

static void mark_dot(canvas *c, double x, double y, double depth, double ahead) {
  const int column = (int)floor(x), row = (int)floor(y);
  if (column < 0 || row < 0 || column >= c->width || row >= c->height) return;
  const size_t at = (size_t)row * (size_t)c->width + (size_t)column;
  if (depth + ahead < c->depth[at]) return;
  c->grey[at] = 40;
  if (c->depth[at] < (float)depth) c->depth[at] = (float)depth;
}

static void draw_edge(canvas *c, const int edge[4]) {
  const double *p = c->seen[edge[0]], *q = c->seen[edge[1]];
  const double length = hypot(q[0] - p[0], q[1] - p[1]);
  const double ahead = AHEAD * fmax(c->width, c->height) / c->dots;
  const int steps = 1 + (int)(2 * length);
  for (int k = 0; k <= steps; k++) {
    const double t = (double)k / steps;
    const double x = p[0] + t * (q[0] - p[0]), y = p[1] + t * (q[1] - p[1]);
    const double depth = p[2] + t * (q[2] - p[2]);
    mark_dot(c, x, y, depth, ahead);
    mark_dot(c, x + 1, y, depth, ahead);
    mark_dot(c, x, y + 1, depth, ahead);
  }
}

/* ---- the image ---------------------------------------------------------------------------------
 */

/* The mean of the fine dots, of which those of nothing are clear. */
static uint32_t mean_dot(const canvas *c, int x, int y) {
  unsigned sum = 0, covered = 0;
  for (int k = 0; k < FINE_DOTS; k++) {
    const size_t at =
        (size_t)(FINE * y + k / FINE) * (size_t)c->width + (size_t)(FINE * x + k % FINE);
    if (c->depth[at] == -INFINITY) continue;
    covered++;
    sum += c->grey[at];
  }
  const uint32_t alpha = 255 * covered / FINE_DOTS, grey = sum / FINE_DOTS;
  /* a warm grey; Cairo's colours are times alpha */
  const uint32_t blue = grey * 94 / 100;
  return alpha << 24 | grey << 16 | grey * 98 / 100 << 8 | blue;
}

static bool make_image(tp_solid_picture *picture, const canvas *c) {
  const int width = c->width / FINE, height = c->height / FINE;
  cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height);
  if (cairo_surface_status(image) != CAIRO_STATUS_SUCCESS) return false;
  unsigned char *data = cairo_image_surface_get_data(image);
  const size_t stride = (size_t)cairo_image_surface_get_stride(image);
  for (int y = 0; y < height; y++) {
    uint32_t *row = (uint32_t *)(void *)(data + stride * (size_t)y);
    for (int x = 0; x < width; x++) row[x] = mean_dot(c, x, y);
  }
  cairo_surface_mark_dirty(image);
  const double dots = c->dots / FINE;
  *picture = (tp_solid_picture){image, dots, c->left, c->top, width / dots, height / dots};
  return true;
}

bool tp_solid_picture_init(tp_solid_picture *picture, const tp_solid_mesh *mesh,
                           const tp_solid_view *view, bool shaded, int dots) {
  canvas c = {.width = 0};
  set_canvas(&c, mesh, view, dots);
  bool done = make_canvas(&c, mesh);
  if (done) look(&c, mesh, view);
  for (long t = 0; t < mesh->triangle_count && done; t++) {
    if (c.normals[t][2] > 0)
      fill_triangle(&c, mesh->triangles + 3 * t, shade(c.normals[t], shaded));
  }
  for (long k = 0; k < mesh->edge_count && done && shaded; k++) {
    if (is_drawn(&c, mesh->edges[k])) draw_edge(&c, mesh->edges[k]);
  }
  done = done && make_image(picture, &c);
  free(c.depth);
  free(c.grey);
  free(c.seen);
  free(c.normals);
  return done;
}

void tp_solid_picture_clear(tp_solid_picture *picture) {
  if (picture->image != NULL) cairo_surface_destroy(picture->image);
}
