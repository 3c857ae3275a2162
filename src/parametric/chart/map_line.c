/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sample positions, stretches of like samples, borders as bounded roots, and points with scalar and
 * tilt on their axes. */

#include "chart/map_line.h"

#include <math.h>

double tp_line_at(const tp_map_line *l, size_t k) {
  return l->samples[k].values[0];
}

tp_bounded tp_line_root(const tp_map_sample *low, const tp_map_sample *high) {
  const double half = (high->values[0] - low->values[0]) / 2;
  return (tp_bounded){.value = low->values[0] + half,
                      .error = half + fabs(low->values[0]) * 0x1p-52};
}

size_t tp_line_end(const tp_map_line *l, size_t begin) {
  size_t end = begin + 1;
  while (end < l->count && tp_map_sample_is_like(l->samples + end, l->samples + begin)) end++;
  return end;
}

void tp_line_add(const tp_map_line *l, tp_bounded scalar, tp_bounded tilt) {
  tp_chart_add_point(l->map->chart, l->scalar_is_x ? scalar : tilt, l->scalar_is_x ? tilt : scalar);
}

double tp_line_clamped(const tp_map_line *l, double tilt) {
  return fmin(fmax(tilt, l->tilt.from), l->tilt.to);
}

void tp_line_add_corner(const tp_map_line *l, double scalar, double tilt) {
  tp_line_add(l, tp_chart_exactly(scalar), tp_chart_exactly(tp_line_clamped(l, tilt)));
}

double tp_line_moves_from(const tp_map_line *l, const tp_map_sample *sample) {
  if (sample->has_limit) return tp_line_clamped(l, sample->limit_deg.value);
  return sample->regime == TP_REGIME_MAY_MOVE || sample->regime == TP_REGIME_INTERLOCKED
             ? l->tilt.to
             : l->tilt.from;
}

double tp_line_stands_to(const tp_map_line *l, const tp_map_sample *sample) {
  return sample->has_onset ? tp_line_clamped(l, sample->onset_deg.value)
                           : tp_line_moves_from(l, sample);
}
