/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The solid from the side, on its base at its tilt, and what of it touches, seen from above. */

#include "figure/solid.h"

#include <math.h>

static const double radian = 3.14159265358979323846 / 180;

tp_ink tp_solid_band_ink(size_t number) {
  static const tp_ink inks[TP_SOLID_BANDS_DRAWN] = {TP_INK_VERMILION, TP_INK_BLUE,   TP_INK_GREEN,
                                                    TP_INK_ORANGE,    TP_INK_PURPLE, TP_INK_SKY};
  return inks[number % TP_SOLID_BANDS_DRAWN];
}

static void trace_support(cairo_t *cr, const tp_solid_place *p, const tp_solid_band *band) {
  for (size_t k = 0; k < band->corner_count; k++) {
    const tp_spot at = tp_solid_spot(p, band->support[k].east_m, band->support[k].north_m, 0);
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

bool tp_solid_edge_met(tp_solid_corner ends[2], const tp_solid_figure *f) {
  size_t k = 0;
  if (!f->has_way || !find_edge(&k, f->band, f->azimuth_deg)) return false;
  ends[0] = f->band->support[k];
  ends[1] = f->band->support[(k + 1) % f->band->corner_count];
  return true;
}

static void draw_edge_met(cairo_t *cr, const tp_solid_place *p, const tp_solid_figure *f) {
  tp_solid_corner ends[2];
  if (!tp_solid_edge_met(ends, f)) return;
  tp_figure_ink(cr, TP_INK_VERMILION);
  cairo_set_line_width(cr, 2);
  tp_solid_line(cr, tp_solid_spot(p, ends[0].east_m, ends[0].north_m, 0),
                tp_solid_spot(p, ends[1].east_m, ends[1].north_m, 0));
}

/* ---- from the side -----------------------------------------------------------------------------
 */

/* A square of the base with the rock in its middle, and lines on it. */
static void draw_base(cairo_t *cr, const tp_solid_place *p, const tp_solid_figure *f) {
  enum { LINES = 8 };
  const double half = 0.75 * f->mesh.size, way = radian * f->azimuth_deg;
  const double a[2] = {sin(way), cos(way)}, b[2] = {cos(way), -sin(way)};
  for (int k = 0; k < 4; k++) {
    const double s = k == 0 || k == 3 ? -half : half, t = k < 2 ? -half : half;
    const tp_spot at = tp_solid_spot(p, s * a[0] + t * b[0], s * a[1] + t * b[1], 0);
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
    tp_solid_line(cr, tp_solid_spot(p, s * a[0] - half * b[0], s * a[1] - half * b[1], 0),
                  tp_solid_spot(p, s * a[0] + half * b[0], s * a[1] + half * b[1], 0));
    tp_solid_line(cr, tp_solid_spot(p, s * b[0] - half * a[0], s * b[1] - half * a[1], 0),
                  tp_solid_spot(p, s * b[0] + half * a[0], s * b[1] + half * a[1], 0));
  }
}

/* From the centroid down to the base: through the foot, or tilted past it. */
static void draw_weight(cairo_t *cr, const tp_solid_place *p, const tp_solid_figure *f) {
  const double reach = f->mesh.height * tan(f->tilt), way = radian * f->azimuth_deg;
  const tp_spot centre = tp_solid_spot(p, 0, 0, f->mesh.height);
  const tp_spot meets = tp_solid_spot(p, reach * sin(way), reach * cos(way), 0);
  tp_figure_ink(cr, TP_INK_BLACK);
  tp_figure_arrow(cr, centre, meets, 1.2);
  cairo_arc(cr, centre.x, centre.y, 2.4, 0, 360 * radian);
  cairo_fill(cr);
}

void tp_solid_draw_side(cairo_t *cr, const tp_solid_figure *f, tp_box box) {
  const tp_solid_place p =
      tp_solid_fit(&f->view, &f->side, (tp_box){box.x0 + 30, box.y0 + 4, box.x1 - 30, box.y1 - 22});
  cairo_save(cr);
  cairo_rectangle(cr, box.x0, box.y0, box.x1 - box.x0, box.y1 - box.y0);
  cairo_clip(cr);
  draw_base(cr, &p, f);
  tp_solid_paint(cr, &p, &f->side);
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

void tp_solid_draw_above(cairo_t *cr, const tp_solid_figure *f, tp_box box) {
  const tp_solid_place p = tp_solid_fit(&tp_solid_from_above, &f->above,
                                        (tp_box){box.x0 + 6, box.y0 + 6, box.x1 - 22, box.y1 - 20});
  const tp_solid *solid = f->solid;
  tp_solid_paint(cr, &p, &f->above);
  for (size_t k = solid->band_count; k > 0; k--) { /* the least, on top, at last */
    const tp_solid_band *band = solid->bands + k - 1;
    if (k > TP_SOLID_BANDS_DRAWN) continue;
    tp_figure_ink(cr, tp_solid_band_ink(k - 1));
    cairo_set_line_width(cr, band == f->band ? 1.4 : 0.9);
    trace_support(cr, &p, band);
    cairo_stroke(cr);
  }
  draw_edge_met(cr, &p, f);
  tp_solid_draw_bearings(cr, f, &p, box);
}
