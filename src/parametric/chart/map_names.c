/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Searches heights along a region for the place where the region's name keeps farthest from all
 * curves, and adds the name there. */

#include "chart/map_names.h"

#include <math.h>
#include <string.h>

/* How far a name keeps from the curves of moments and of sliding, and from the bounds of its
 * region, over the width of a name; in degrees. */
static double clearance(const tp_map_line *l, double scalar, double tilt, double half_name,
                        const tp_line_region *region) {
  double least = INFINITY;
  for (size_t k = region->begin; k < region->end; k++) {
    const tp_map_sample *sample = l->samples + k;
    if (fabs(tp_line_at(l, k) - scalar) > half_name) continue;
    double low = 0, high = 0;
    region->part(&low, &high, l, sample, region->strip);
    least = fmin(least, fmin(tilt - low, high - tilt));
    if (sample->has_toppling) least = fmin(least, fabs(sample->toppling_deg.value - tilt));
    if (sample->has_sliding) least = fmin(least, fabs(sample->sliding_deg.value - tilt));
  }
  return least;
}

void tp_line_find_name(tp_line_name *best, const tp_map_line *l, const char *name,
                       const tp_line_region *region) {
  enum { HEIGHTS = 40 };
  const double first = tp_line_at(l, region->begin), last = tp_line_at(l, region->end - 1);
  const double high = l->tilt.to - l->tilt.from, wide = l->scalar.to - l->scalar.from;
  /* letters of 7 points in a panel of 72 mm by 62 mm: shares of its width and height */
  static const double letter_of_width = 0.011, letter_of_height = 0.013, half_a_line = 0.03;
  const double length = (double)strlen(name);
  const double half_name = (l->scalar_is_x ? letter_of_width * length : half_a_line) * wide;
  const double half_line = (l->scalar_is_x ? half_a_line : letter_of_height * length) * high;
  for (size_t k = region->begin; k < region->end; k++) {
    const double x = tp_line_at(l, k);
    if (x - first < half_name || last - x < half_name) continue;
    for (int h = 1; h < HEIGHTS; h++) {
      const double y = l->tilt.from + high * h / HEIGHTS;
      const double clear = clearance(l, x, y, half_name, region);
      /* where much is free, the middle is best */
      static const double much = 0.15, off_middle = 0.1;
      const double worth =
          fmin(clear, much * high) - off_middle * high * fabs(x - (first + last) / 2) / wide;
      if (clear < half_line || (best->found && worth <= best->worth)) continue;
      *best = (tp_line_name){true, worth, x, y};
    }
  }
}

bool tp_line_add_name(const tp_map_line *l, const char *name, const tp_line_name *at) {
  if (!at->found) return false;
  tp_chart_add_label(l->map->chart, l->scalar_is_x ? at->scalar : at->tilt,
                     l->scalar_is_x ? at->tilt : at->scalar, TP_LABEL_CENTRE, name);
  return true;
}
