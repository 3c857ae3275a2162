/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "report/tilt_svg.h"

#include <math.h>

static const double extent_units = 100;

static double extent_of(const tp_tilt_case *own) {
  double extent = 0;
  for (size_t k = 0; k < own->outline_count; k++) {
    extent = fmax(extent, hypot(own->outline[k].x_m - own->centroid_x_m,
                                own->outline[k].y_m - own->centroid_y_m));
  }
  return extent;
}

tp_tilt_view tp_tilt_view_of(const tp_tilt_case *own) {
  const double extent = extent_of(own);
  const double side = 3.6 * extent_units;
  const double down_dip = own->towards == TP_TOWARDS_LEFT ? -0.3 : 0.3;
  return (tp_tilt_view){.own = own,
                        .scale = extent > 0 ? extent_units / extent : 1,
                        .left = -side / 2 + down_dip * extent_units,
                        .top = -1.5 * extent_units,
                        .width = side,
                        .height = 0.9 * side};
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
