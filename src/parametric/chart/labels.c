/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Counts the curves and points that a label's box would strike on either side of its point, and
 * returns the freer side. */

#include "chart/labels.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* On the panel, mm. */
typedef struct box {
  double low[2], high[2];
} box;

static double share(double value, const tp_panel_axis *axis) {
  const double from = axis->range.from, to = axis->range.to;
  return axis->logarithmic ? log10(value / from) / log10(to / from) : (value - from) / (to - from);
}

static void locate(double at[2], const tp_chart *chart, double x, double y) {
  const tp_chart_panel *panel = chart->panels + chart->panel_count - 1;
  at[0] = share(x, &panel->x) * chart->panel_width_mm;
  at[1] = share(y, &panel->y) * chart->panel_height_mm;
}

/* Letters of 7 points, as chart/script.c puts them. */
static box box_of(tp_label_side side, const double at[2], const char *text) {
  /* mm: a letter wide, half a line high, as far from the point */
  const double letter = 1.25, half = 1.3, away = 1.2, down = 1.3;
  const double width = letter * (double)strlen(text), x = at[0], y = at[1];
  switch (side) {
  case TP_LABEL_LEFT:
    return (box){{x - away - width, y - half}, {x - away, y + half}};
  case TP_LABEL_RIGHT:
    return (box){{x + away, y - half}, {x + away + width, y + half}};
  case TP_LABEL_ABOVE:
    return (box){{x - width / 2, y + down - half}, {x + width / 2, y + down + half}};
  default:
    return (box){{x + away, y - down - half}, {x + away + width, y - down + half}};
  }
}

/* Does the line from p to q run through the box? */
static bool crosses(const box *b, const double p[2], const double q[2]) {
  double from = 0, to = 1;
  for (int k = 0; k < 2; k++) {
    const double run = q[k] - p[k];
    if (run == 0) {
      if (p[k] < b->low[k] || p[k] > b->high[k]) return false;
      continue;
    }
    const double one = (b->low[k] - p[k]) / run, other = (b->high[k] - p[k]) / run;
    from = fmax(from, fmin(one, other));
    to = fmin(to, fmax(one, other));
  }
  return from <= to;
}

/* Lines and points of the last panel that would strike the box. */
static size_t strikes(const tp_chart *chart, const box *b) {
  size_t count = 0;
  for (size_t k = 0; k < chart->series_count; k++) {
    const tp_chart_series *s = chart->series + k;
    if (s->panel + 1 != chart->panel_count || s->style.mark == TP_MARK_REGION) continue;
    for (size_t i = 0; i < s->count; i++) {
      const bool joined = s->style.mark == TP_MARK_LINE && i + 1 < s->count;
      const tp_chart_point *one = s->points + i, *other = joined ? one + 1 : one;
      double p[2], q[2];
      locate(p, chart, one->x.value, one->y.value);
      locate(q, chart, other->x.value, other->y.value);
      const bool known = isfinite(p[0]) && isfinite(p[1]) && isfinite(q[0]) && isfinite(q[1]);
      count += known && crosses(b, p, q);
    }
  }
  return count;
}

tp_label_side tp_chart_free_side(const tp_chart *chart, double x, double y, const char *text) {
  static const tp_label_side sides[] = {TP_LABEL_BELOW, TP_LABEL_LEFT, TP_LABEL_RIGHT,
                                        TP_LABEL_ABOVE};
  const size_t outside = 1000; /* worse than any number of curves struck */
  tp_label_side best = sides[0];
  size_t least = SIZE_MAX;
  double at[2];
  if (chart->failed) return best;
  locate(at, chart, x, y);
  for (size_t k = 0; k < sizeof sides / sizeof sides[0]; k++) {
    const box own = box_of(sides[k], at, text);
    const bool inside = own.low[0] > 0 && own.low[1] > 0 && own.high[0] < chart->panel_width_mm &&
                        own.high[1] < chart->panel_height_mm;
    const size_t struck = strikes(chart, &own) + (inside ? 0 : outside);
    if (struck >= least) continue;
    best = sides[k];
    least = struck;
  }
  return best;
}
