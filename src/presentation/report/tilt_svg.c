/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* View of a test: scale, bounding box over all moments within four extents of the start, and
 * outlines as SVG paths in that view. */

#include "report/tilt_svg.h"

#include <math.h>

static const double extent_units = 100;

/* Extents of the block that it is followed from where it stood. */
enum { FARTHEST = 4 };

static double extent_of(const tp_tilt_case *own) {
  double extent = 0;
  for (size_t k = 0; k < own->outline_count; k++) {
    extent = fmax(extent, hypot(own->outline[k].x_m - own->centroid_x_m,
                                own->outline[k].y_m - own->centroid_y_m));
  }
  return extent;
}

double tp_tilt_view_way(const tp_tilt_view *view, size_t moment) {
  const tp_tilt_moment *m = view->own->moments + moment;
  const double moved = hypot(m->moved_x_m - m[-1].moved_x_m, m->moved_y_m - m[-1].moved_y_m);
  return view->scale / extent_units * moved + fabs(m->turned_deg - m[-1].turned_deg) * (M_PI / 180);
}

/* Extend what is seen by the circle about the block at a moment. */
static void take_in(tp_tilt_view *view, const tp_tilt_moment *m) {
  const double turn = tp_tilt_view_turn(view, m->angle_deg) * (M_PI / 180);
  const double x = view->scale * m->moved_x_m, y = -view->scale * m->moved_y_m;
  const double across = x * cos(turn) - y * sin(turn), down = x * sin(turn) + y * cos(turn);
  const double margin = 1.05 * extent_units;
  const double right = fmax(view->left + view->width, across + margin),
               bottom = fmax(view->top + view->height, down + margin);
  view->left = fmin(view->left, across - margin);
  view->top = fmin(view->top, down - margin);
  view->width = right - view->left;
  view->height = bottom - view->top;
}

tp_tilt_view tp_tilt_view_of(const tp_tilt_case *own) {
  const double extent = extent_of(own);
  const double side = 3.2 * extent_units;
  tp_tilt_view view = {.own = own,
                       .scale = extent > 0 ? extent_units / extent : 1,
                       .left = -side / 2,
                       .top = -1.5 * extent_units,
                       .width = side,
                       .height = side};
  for (; view.moments < own->moment_count; view.moments++) {
    const tp_tilt_moment *m = own->moments + view.moments;
    if (hypot(m->moved_x_m, m->moved_y_m) > FARTHEST * extent) break;
    take_in(&view, m);
  }
  return view;
}

double tp_tilt_view_x(const tp_tilt_view *view, double x_m) {
  return view->scale * (x_m - view->own->centroid_x_m);
}

double tp_tilt_view_y(const tp_tilt_view *view, double y_m) {
  return -view->scale * (y_m - view->own->centroid_y_m);
}

double tp_tilt_view_turn(const tp_tilt_view *view, double angle_deg) {
  return view->own->towards == TP_TOWARDS_LEFT ? -angle_deg : angle_deg;
}

/* The base may reach far beyond what is seen: brought nearer, as numbers of a drawing are short. */
static double clamp(double value) {
  const double far = 100 * extent_units;
  return fmin(far, fmax(-far, value));
}

void tp_tilt_svg_ring(tp_text *t, const tp_tilt_view *view, const tp_tilt_point *points,
                      size_t count) {
  for (size_t k = 0; k < count; k++) {
    tp_text_add(t, "%s%.2f %.2f", k == 0 ? "M" : "L", clamp(tp_tilt_view_x(view, points[k].x_m)),
                clamp(tp_tilt_view_y(view, points[k].y_m)));
  }
  tp_text_add(t, "Z");
}

void tp_tilt_svg_begin(tp_text *t, double width, double height) {
  tp_text_add(t,
              "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
              "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" "
              "viewBox=\"0 0 %.2f %.2f\" font-family=\"sans-serif\" font-size=\"12\">\n"
              "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
              width, height, width, height);
}
