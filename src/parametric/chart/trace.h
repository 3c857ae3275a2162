/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Borders in a plane, traced as curves.
 *
 * A cell of a grid with two borders across its edges holds a piece of one curve; one with more
 * holds a point where regions meet, and is halved until that point is known to 2^-12 of a cell.
 * Pieces that share an end are joined. Where a border crosses an edge is for the caller to find. */

#ifndef TP_CHART_TRACE_H
#define TP_CHART_TRACE_H

#include "chart/map.h"

/* Of a crossing, the border lies within the error of it. */
typedef struct tp_map_point {
  double x, y;
  double x_error, y_error;
} tp_map_point;

typedef struct tp_crossing {
  bool found;
  tp_map_point point;
} tp_crossing;

/* What is traced: regions by number, and the border between two samples of different regions. */
typedef struct tp_map_field {
  void *context;
  int (*region)(const void *context, const tp_map_sample *sample);
  tp_crossing (*cross)(void *context, tp_map_sample low, tp_map_sample high);
} tp_map_field;

/* A polygon of a region, convex and counter-clockwise. */
typedef struct tp_patch {
  int region;
  size_t count;
  tp_map_point corners[5];
} tp_patch;

typedef struct tp_piece {
  tp_map_point ends[2];
  int regions[2]; /* the lesser first */
  bool used;
} tp_piece;

typedef struct tp_pieces {
  size_t count, capacity;
  tp_piece *pieces;
  size_t patch_count, patch_capacity;
  tp_patch *patches;
  bool failed; /* memory was exhausted */
} tp_pieces;

void tp_pieces_clear(tp_pieces *pieces);

/* All pieces over a grid of columns x rows samples, row by row. */
void tp_trace(tp_pieces *pieces, tp_map *map, const tp_map_field *field, const tp_map_sample *grid,
              size_t columns, size_t rows);

/* The next curve: its points in order into `points` (of room for pieces->count + 1), their number,
 * 0 when none is left, and the regions that it parts. */
size_t tp_trace_next(tp_map_point *points, int regions[2], tp_pieces *pieces);

#endif
