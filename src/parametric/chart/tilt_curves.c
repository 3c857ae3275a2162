/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Ranges of axes with a margin, names of directions, and level lines of the charts of a tilt
 * test. */

#include "chart/tilt_curves.h"

#include <math.h>

const char *tp_chart_towards(tp_direction towards) {
  return towards == TP_TOWARDS_LEFT ? "left" : "right";
}

tp_chart_range tp_chart_range_empty(void) {
  return (tp_chart_range){INFINITY, -INFINITY};
}

void tp_chart_range_take(tp_chart_range *range, double value) {
  if (!isfinite(value)) return;
  range->from = fmin(range->from, value);
  range->to = fmax(range->to, value);
}

tp_chart_range tp_chart_range_drawn(tp_chart_range range) {
  static const double margin = 0.05;
  if (!(range.from <= range.to)) return (tp_chart_range){0, 1};
  const double spread = range.to - range.from;
  const double pad = spread > 0 ? margin * spread : fmax(margin * fabs(range.to), 1e-9);
  return (tp_chart_range){range.from - pad, range.to + pad};
}

void tp_chart_add_level(tp_chart *chart, tp_chart_range x, tp_chart_range y, double level) {
  static const tp_chart_style style = {TP_MARK_LINE, TP_COLOUR_GREY, TP_DASH_SOLID, 0.3};
  if (!(level > y.from && level < y.to)) return;
  tp_chart_add_guide(chart, style);
  tp_chart_add_corner(chart, x.from, level);
  tp_chart_add_corner(chart, x.to, level);
}
