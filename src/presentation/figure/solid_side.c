/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The solid from the side, on its base at its tilt, and what of it touches, seen from above. */

#include "figure/solid.h"

#include <math.h>
#include <stdio.h>

static const double radian = 3.14159265358979323846 / 180;

tp_ink tp_solid_band_ink(size_t number) {
  static const tp_ink inks[TP_SOLID_BANDS_DRAWN] = {TP_INK_VERMILION, TP_INK_BLUE,   TP_INK_GREEN,
                                                    TP_INK_ORANGE,    TP_INK_PURPLE, TP_INK_SKY};
  return inks[number % TP_SOLID_BANDS_DRAWN];
}

/* ---- where things lie on the page --------------------------------------------------------------
 */

typedef struct place {
  const tp_solid_view *view;
  double scale, x, y; /* points to a metre, and the foot on the page */
} place;

static tp_spot spot_of(const place *p, double east, double north, double up) {
  const double *r = p->view->right, *u = p->view->up;
  return (tp_spot){p->x + p->scale * (r[0] * east + r[1] * north + r[2] * up),
                   p->y - p->scale * (u[0] * east + u[1] * north + u[2] * up)};
}

/* The picture in the middle of a box. */
static place fit(const tp_solid_view *view, const tp_solid_picture *picture, tp_box box) {
  place p = {.view = view,
             .scale =
                 fmin((box.x1 - box.x0) / picture->width, (box.y1 - box.y0) / picture->height)};
  const double left = (box.x0 + box.x1 - p.scale * picture->width) / 2;
  const double top = (box.y0 + box.y1 - p.scale * picture->height) / 2;
  p.x = left - p.scale * picture->left;
  p.y = top + p.scale * picture->top;
  return p;
}

static void paint(cairo_t *cr, const place *p, const tp_solid_picture *picture) {
  cairo_save(cr);
  cairo_translate(cr, p->x + p->scale * picture->left, p->y - p->scale * picture->top);
  cairo_scale(cr, p->scale / picture->dots, p->scale / picture->dots);
  cairo_set_source_surface(cr, picture->image, 0, 0);
  cairo_paint(cr);
  cairo_restore(cr);
}

static void line(cairo_t *cr, tp_spot from, tp_spot to) {
  cairo_move_to(cr, from.x, from.y);
  cairo_line_to(cr, to.x, to.y);
  cairo_stroke(cr);
}

static void trace_support(cairo_t *cr, const place *p, const tp_solid_band *band) {
  for (size_t k = 0; k < band->corner_count; k++) {
    const tp_spot at = spot_of(p, band->support[k].east_m, band->support[k].north_m, 0);
    if (k == 0) {
      cairo_move_to(cr, at.x, at.y);
    } else {
      cairo_line_to(cr, at.x, at.y);
    }
  }
  cairo_close_path(cr);
}

/* The edge that is met first along an azimuth; false where there is none. */
static bool find_edge(size_t *found, const tp_solid_band *band, double azimuth_deg) {
  const double east = sin(radian * azimuth_deg), north = cos(radian * azimuth_deg);
  double most = 0;
  for (size_t k = 0; k < band->corner_count && band->corner_count >= 3; k++) {
    const tp_solid_corner *p = band->support + k;
    const tp_solid_corner *q = band->support + (k + 1) % band->corner_count;
    const double n[2] = {q->north_m - p->north_m, p->east_m - q->east_m};
    const double arm = n[0] * p->east_m + n[1] * p->north_m;
    const double reach = arm > 0 ? (n[0] * east + n[1] * north) / arm : 0;
    if (reach > most) *found = k;
    most = fmax(most, reach);
  }
  return most > 0;
}

static void draw_edge_met(cairo_t *cr, const place *p, const tp_solid_figure *f) {
  size_t k = 0;
  if (!f->has_way || !find_edge(&k, f->band, f->azimuth_deg)) return;
  const tp_solid_corner *a = f->band->support + k;
  const tp_solid_corner *b = f->band->support + (k + 1) % f->band->corner_count;
  tp_figure_ink(cr, TP_INK_VERMILION);
  cairo_set_line_width(cr, 2);
  line(cr, spot_of(p, a->east_m, a->north_m, 0), spot_of(p, b->east_m, b->north_m, 0));
}

/* ---- from the side -----------------------------------------------------------------------------
 */

/* A square of the base with the rock in its middle, and lines on it. */
static void draw_base(cairo_t *cr, const place *p, const tp_solid_figure *f) {
  enum { LINES = 8 };
  const double half = 0.75 * f->mesh.size, way = radian * f->azimuth_deg;
  const double a[2] = {sin(way), cos(way)}, b[2] = {cos(way), -sin(way)};
  for (int k = 0; k < 4; k++) {
    const double s = k == 0 || k == 3 ? -half : half, t = k < 2 ? -half : half;
    const tp_spot at = spot_of(p, s * a[0] + t * b[0], s * a[1] + t * b[1], 0);
    if (k == 0) cairo_move_to(cr, at.x, at.y);
    if (k > 0) cairo_line_to(cr, at.x, at.y);
  }
  cairo_close_path(cr);
  tp_figure_ink(cr, TP_INK_ROCK);
  cairo_fill(cr);
  tp_figure_ink(cr, TP_INK_WHITE);
  cairo_set_line_width(cr, 0.6);
  for (int k = 0; k <= LINES; k++) {
    const double s = half * (2.0 * k / LINES - 1);
    line(cr, spot_of(p, s * a[0] - half * b[0], s * a[1] - half * b[1], 0),
         spot_of(p, s * a[0] + half * b[0], s * a[1] + half * b[1], 0));
    line(cr, spot_of(p, s * b[0] - half * a[0], s * b[1] - half * a[1], 0),
         spot_of(p, s * b[0] + half * a[0], s * b[1] + half * a[1], 0));
  }
}

/* From the centroid down to the base: through the foot, or tilted past it. */
static void draw_weight(cairo_t *cr, const place *p, const tp_solid_figure *f) {
  const double reach = f->mesh.height * tan(f->tilt), way = radian * f->azimuth_deg;
  const tp_spot centre = spot_of(p, 0, 0, f->mesh.height);
  const tp_spot meets = spot_of(p, reach * sin(way), reach * cos(way), 0);
  tp_figure_ink(cr, TP_INK_BLACK);
  tp_figure_arrow(cr, centre, meets, 1.2);
  cairo_arc(cr, centre.x, centre.y, 2.4, 0, 360 * radian);
  cairo_fill(cr);
}

void tp_solid_draw_side(cairo_t *cr, const tp_solid_figure *f, tp_box box) {
  const place p =
      fit(&f->view, &f->side, (tp_box){box.x0 + 30, box.y0 + 4, box.x1 - 30, box.y1 - 22});
  cairo_save(cr);
  cairo_rectangle(cr, box.x0, box.y0, box.x1 - box.x0, box.y1 - box.y0);
  cairo_clip(cr);
  draw_base(cr, &p, f);
  paint(cr, &p, &f->side);
  tp_figure_ink(cr, TP_INK_VERMILION);
  cairo_set_line_width(cr, 0.7);
  trace_support(cr, &p, f->band);
  cairo_stroke(cr);
  draw_edge_met(cr, &p, f);
  draw_weight(cr, &p, f);
  cairo_restore(cr);
}

/* ---- from above --------------------------------------------------------------------------------
 */

static void draw_north(cairo_t *cr, tp_box box) {
  const tp_spot tip = {box.x1 - 10, box.y0 + 4}, tail = {box.x1 - 10, box.y0 + 26};
  tp_figure_ink(cr, TP_INK_BLACK);
  tp_figure_arrow(cr, tail, tip, 1);
  tp_figure_font(cr, TP_SMALL_SIZE, false);
  tp_figure_text(cr, tip.x - 2.4, tail.y + 8, "N");
}

/* A length that is round, about a quarter of the box. */
static void draw_length(cairo_t *cr, const place *p, tp_box box) {
  static const double round[] = {1, 2, 5, 10};
  const double wanted = (box.x1 - box.x0) / 4 / p->scale, power = pow(10, floor(log10(wanted)));
  double length = power;
  for (int k = 0; k < 4; k++) {
    if (round[k] * power <= wanted) length = round[k] * power;
  }
  char text[40];
  snprintf(text, sizeof text, "%g m", length);
  tp_figure_ink(cr, TP_INK_BLACK);
  cairo_set_line_width(cr, 1);
  line(cr, (tp_spot){box.x0 + 4, box.y1 - 6},
       (tp_spot){box.x0 + 4 + p->scale * length, box.y1 - 6});
  tp_figure_font(cr, TP_SMALL_SIZE, false);
  tp_figure_text(cr, box.x0 + 4, box.y1 - 10, text);
}

void tp_solid_draw_above(cairo_t *cr, const tp_solid_figure *f, tp_box box) {
  static const tp_solid_view above = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const place p =
      fit(&above, &f->above, (tp_box){box.x0 + 6, box.y0 + 6, box.x1 - 22, box.y1 - 20});
  const tp_solid *solid = f->solid;
  paint(cr, &p, &f->above);
  for (size_t k = solid->band_count; k > 0; k--) { /* the least, on top, at last */
    const tp_solid_band *band = solid->bands + k - 1;
    if (k > TP_SOLID_BANDS_DRAWN) continue;
    tp_figure_ink(cr, tp_solid_band_ink(k - 1));
    cairo_set_line_width(cr, band == f->band ? 1.4 : 0.9);
    trace_support(cr, &p, band);
    cairo_stroke(cr);
  }
  draw_edge_met(cr, &p, f);
  tp_figure_ink(cr, TP_INK_BLACK);
  cairo_set_line_width(cr, 0.9);
  line(cr, (tp_spot){p.x - 4, p.y}, (tp_spot){p.x + 4, p.y});
  line(cr, (tp_spot){p.x, p.y - 4}, (tp_spot){p.x, p.y + 4});
  if (f->has_way) {
    const double way = radian * f->azimuth_deg, far = 0.2 * fmin(box.x1 - box.x0, box.y1 - box.y0);
    tp_figure_arrow(cr, (tp_spot){p.x, p.y}, (tp_spot){p.x + far * sin(way), p.y - far * cos(way)},
                    1);
  }
  draw_north(cr, box);
  draw_length(cr, &p, box);
}
