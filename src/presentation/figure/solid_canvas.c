/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Two layers of dots, of rock and of ground, each with what is nearest to the eye (Catmull 1974).
 * Where the ground is in front of the rock, the rock shows through. It is drawn at twice its size
 * and made smaller by the mean of four dots, which smooths it. */

#include "figure/solid_canvas.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FINE = 2, FINE_DOTS = FINE * FINE };
#define AHEAD 0.004 /* by which an edge may lie behind, of the size of the picture */

bool tp_solid_canvas_init(tp_solid_canvas *c, const tp_solid_view *view, const double low[2],
                          const double high[2], int dots, bool with_ground) {
  const double wide = high[0] - low[0], tall = high[1] - low[1];
  const double border = 0.01 * fmax(wide, tall);
  *c = (tp_solid_canvas){.view = *view};
  c->dots = FINE * dots / (fmax(wide, tall) + 2 * border);
  c->left = low[0] - border;
  c->top = high[1] + border;
  c->width = FINE * (int)ceil(c->dots * (wide + 2 * border) / FINE);
  c->height = FINE * (int)ceil(c->dots * (tall + 2 * border) / FINE);
  const size_t count = (size_t)c->width * (size_t)c->height;
  for (int layer = 0; layer < (with_ground ? TP_LAYERS : TP_LAYER_GROUND); layer++) {
    c->depth[layer] = malloc(count * sizeof *c->depth[layer]);
    c->grey[layer] = calloc(count, sizeof *c->grey[layer]);
    if (c->depth[layer] == NULL || c->grey[layer] == NULL) return false;
    for (size_t k = 0; k < count; k++) c->depth[layer][k] = -INFINITY;
  }
  return true;
}

void tp_solid_canvas_clear(tp_solid_canvas *c) {
  for (int layer = 0; layer < TP_LAYERS; layer++) {
    free(c->depth[layer]);
    free(c->grey[layer]);
  }
}

void tp_solid_canvas_see(double seen[3], const tp_solid_canvas *c, const double point[3]) {
  seen[0] = c->dots * (tp_solid_dot(c->view.right, point) - c->left);
  seen[1] = c->dots * (c->top - tp_solid_dot(c->view.up, point));
  seen[2] = tp_solid_dot(c->view.eye, point);
}

/* ---- triangles ---------------------------------------------------------------------------------
 */

static int clamp(double at, int most) {
  return at <= 0 ? 0 : at >= most ? most : (int)at;
}

void tp_solid_canvas_fill(tp_solid_canvas *c, tp_solid_layer layer, const double corners[3][3],
                          uint8_t grey) {
  const double *p = corners[0], *q = corners[1], *r = corners[2];
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
      if (depth <= c->depth[layer][at]) continue;
      c->depth[layer][at] = depth;
      c->grey[layer][at] = grey;
    }
  }
}

/* ---- lines -------------------------------------------------------------------------------------
 */

static void mark_dot(tp_solid_canvas *c, tp_solid_layer layer, const double at[3], uint8_t grey) {
  const int column = (int)floor(at[0]), row = (int)floor(at[1]);
  if (column < 0 || row < 0 || column >= c->width || row >= c->height) return;
  const size_t dot = (size_t)row * (size_t)c->width + (size_t)column;
  const double ahead = AHEAD * fmax(c->width, c->height) / c->dots;
  float *depth = c->depth[layer] + dot;
  if (at[2] + ahead < *depth) return;
  c->grey[layer][dot] = grey;
  if (*depth < (float)at[2]) *depth = (float)at[2];
}

void tp_solid_canvas_line(tp_solid_canvas *c, tp_solid_layer layer, const double from[3],
                          const double to[3], uint8_t grey) {
  const int steps = 1 + (int)(2 * hypot(to[0] - from[0], to[1] - from[1]));
  for (int k = 0; k <= steps; k++) {
    const double t = (double)k / steps;
    double at[3];
    for (int i = 0; i < 3; i++) at[i] = from[i] + t * (to[i] - from[i]);
    mark_dot(c, layer, at, grey);
    mark_dot(c, layer, (double[]){at[0] + 1, at[1], at[2]}, grey);
    mark_dot(c, layer, (double[]){at[0], at[1] + 1, at[2]}, grey);
  }
}

/* ---- the image ---------------------------------------------------------------------------------
 */

/* Red, green and blue of a grey, in hundredths: the rock is a warm grey, the ground like sand. */
static const unsigned tints[TP_LAYERS][3] = {
    [TP_LAYER_ROCK] = {100, 98, 94}, [TP_LAYER_GROUND] = {100, 93, 78}};

/* Adds a fine dot to a sum; false where there is nothing. */
static bool add_dot(unsigned sum[3], const tp_solid_canvas *c, size_t dot) {
  enum { WHOLE = 100, OF_ROCK = 55 }; /* that is seen through ground */
  const bool rock = c->depth[TP_LAYER_ROCK][dot] > -INFINITY;
  const bool ground =
      c->depth[TP_LAYER_GROUND] != NULL && c->depth[TP_LAYER_GROUND][dot] > -INFINITY;
  const bool before =
      ground && rock && c->depth[TP_LAYER_GROUND][dot] > c->depth[TP_LAYER_ROCK][dot];
  const unsigned share = !rock ? 0 : before ? OF_ROCK : WHOLE;
  for (int k = 0; k < 3 && (rock || ground); k++) {
    const unsigned own = rock ? c->grey[TP_LAYER_ROCK][dot] * tints[TP_LAYER_ROCK][k] : 0;
    const unsigned other = ground ? c->grey[TP_LAYER_GROUND][dot] * tints[TP_LAYER_GROUND][k] : 0;
    sum[k] += (share * own + (WHOLE - share) * other) / (100 * WHOLE);
  }
  return rock || ground;
}

/* The mean of the fine dots, of which those of nothing are clear; Cairo's colours are times alpha.
 */
static uint32_t mean_dot(const tp_solid_canvas *c, int x, int y) {
  unsigned sum[3] = {0}, covered = 0;
  for (int k = 0; k < FINE_DOTS; k++) {
    const size_t at =
        (size_t)(FINE * y + k / FINE) * (size_t)c->width + (size_t)(FINE * x + k % FINE);
    if (add_dot(sum, c, at)) covered++;
  }
  uint32_t dot = 255 * covered / FINE_DOTS << 24;
  for (int k = 0; k < 3; k++) dot |= sum[k] / FINE_DOTS << (16 - 8 * k);
  return dot;
}

bool tp_solid_canvas_image(tp_solid_picture *picture, const tp_solid_canvas *c) {
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
  *picture = (tp_solid_picture){.image = image,
                                .dots = dots,
                                .left = c->left,
                                .top = c->top,
                                .width = width / dots,
                                .height = height / dots};
  return true;
}
