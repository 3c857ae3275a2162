/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The map along one scalar: what its parts share. */

#ifndef TP_CHART_MAP_LINE_H
#define TP_CHART_MAP_LINE_H

#include "chart/map.h"

typedef struct tp_map_line {
  tp_map *map;
  bool scalar_is_x;
  tp_chart_range scalar, tilt;
  size_t count;
  tp_map_sample *samples; /* along the scalar; where two are not alike, they are a double apart */
} tp_map_line;

/* The scalar of the k-th sample. */
double tp_line_at(const tp_map_line *line, size_t k);

/* Where two samples a double apart part. */
tp_bounded tp_line_root(const tp_map_sample *low, const tp_map_sample *high);

/* One past the last of the samples from `begin` on that are alike. */
size_t tp_line_end(const tp_map_line *line, size_t begin);

/* A tilt within the map; a point of the series at hand; a corner of what is drawn, within the map.
 */
double tp_line_clamped(const tp_map_line *line, double tilt);
void tp_line_add(const tp_map_line *line, tp_bounded scalar, tp_bounded tilt);
void tp_line_add_corner(const tp_map_line *line, double scalar, double tilt);

/* Up to where a sample is certain to stand; from where no forces hold the block: its limit, or the
 * top where they do at any tilt, or the bottom where they do at none, or that is not known. */
double tp_line_stands_to(const tp_map_line *line, const tp_map_sample *sample);
double tp_line_moves_from(const tp_map_line *line, const tp_map_sample *sample);

/* The part of a region at a sample. */
typedef void (*tp_line_part)(double *low, double *high, const tp_map_line *line,
                             const tp_map_sample *sample, size_t strip);

/* Over the samples from `begin` to `end`, which is one past the last. */
typedef struct tp_line_region {
  size_t begin, end;
  tp_line_part part;
  size_t strip;
} tp_line_region;

#endif
