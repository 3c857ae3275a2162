/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Outlines out of the cycles of a tidy map: corners exact, or each rounded once. */

#include "jointing/outlines.h"

#include "common/grow.h"
#include "jointing/names.h"
#include "jointing/section_outline.h"
#include "jointing/slope_base.h"
#include "jointing/slope_cells.h"
#include "jointing/traces.h"
#include "number/grid.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_BITS = 1024, GRID_BITS = 64 };

/* ---- corners -----------------------------------------------------------------------------------
 */

/* Between two half-edges one of whose ends is no corner: pieces of one segment, of one strength. */
static bool goes_on(const tp_slope_cells *cells, size_t half_edge, size_t next) {
  return tp_slope_cells_same_segment(cells, half_edge / 2, next / 2) &&
         tp_slope_cells_edge_set(cells, half_edge / 2) == tp_slope_cells_edge_set(cells, next / 2);
}

/* Have the corners of all blocks a common denominator that is small enough? */
static bool is_exact(const tp_slope_cells *cells) {
  const tp_planar_map *map = &cells->map;
  fmpz_t denominator;
  fmpz_init(denominator);
  fmpz_one(denominator);
  bool small = true;
  for (size_t h = 0; h < 2 * map->a.edge_count && small; h++) {
    if (map->gone[h / 2] || cells->kind[h] == TP_CELL_AIR || goes_on(cells, map->previous[h], h)) {
      continue;
    }
    const fmpq *corner = map->a.points + 2 * map->a.origin[h];
    for (int axis = 0; axis < 2; axis++) {
      if (fmpz_divisible(denominator, fmpq_denref(corner + axis))) continue;
      fmpz_lcm(denominator, denominator, fmpq_denref(corner + axis));
    }
    small = fmpz_bits(denominator) <= MOST_BITS;
  }
  fmpz_clear(denominator);
  return small;
}

/* By how much it was moved. */
static double round_to(fmpq_t value, long exponent) {
  fmpq_t old;
  fmpq_init(old);
  fmpq_set(old, value);
  tp_round_to_grid(value, exponent);
  fmpq_sub(old, value, old);
  const double moved = fabs(fmpq_get_d(old));
  fmpq_clear(old);
  return moved;
}

static double round_corners(tp_slope_cells *cells) {
  const long exponent = ilogb(tp_cuts_size(cells->cuts)) - GRID_BITS;
  double most = 0;
  for (size_t v = 0; v < cells->map.a.vertex_count; v++) {
    const double x = round_to(cells->map.a.points + 2 * v, exponent);
    const double y = round_to(cells->map.a.points + 2 * v + 1, exponent);
    most = fmax(most, hypot(x, y));
  }
  return most;
}

/* ---- outlines ----------------------------------------------------------------------------------
 */

typedef struct outlining {
  tp_cut_blocks *blocks;
  tp_slope_cells *cells;
  long room;
} outlining;

static bool is_corner(const outlining *x, size_t h) {
  return !x->blocks->exact || !goes_on(x->cells, x->cells->map.previous[h], h);
}

/* Mirrored where the face dips to the right: then against the order of the half-edges, whose edge
 * comes before its own corner. */
static size_t step(const outlining *x, size_t h) {
  const tp_planar_map *map = &x->cells->map;
  return x->cells->cuts->slope->right ? map->previous[h] : map->a.next[h];
}

static bool append_corner(const outlining *x, tp_cut_block *own, size_t h) {
  const tp_jointed_slope *slope = x->cells->cuts->slope;
  const fmpq *corner = x->cells->map.a.points + 2 * x->cells->map.a.origin[h];
  fmpq_t number;
  fmpq_init(number);
  fmpq_set(number, corner);
  if (slope->right) fmpq_neg(number, number);
  const bool done = tp_polyline_append(&own->outline, number, corner + 1,
                                       (tp_mark){slope->place.line, slope->place.column});
  fmpq_clear(number);
  const size_t edge = (slope->right ? x->cells->map.previous[h] : h) / 2;
  if (done) own->sets[own->outline.count - 1] = tp_slope_cells_edge_set(x->cells, edge);
  return done;
}

static bool add_outline(outlining *x, size_t start) {
  tp_cut_blocks *blocks = x->blocks;
  tp_cut_block *all = tp_grow(blocks->blocks, blocks->count, &x->room, sizeof *all);
  if (all == NULL) return false;
  blocks->blocks = all;
  tp_cut_block *own = all + blocks->count++;
  *own = (tp_cut_block){.ground = x->cells->kind[start] == TP_CELL_GROUND};
  own->outline.file = x->cells->cuts->slope->place.file;
  own->outline.mark =
      (tp_mark){x->cells->cuts->slope->place.line, x->cells->cuts->slope->place.column};
  long corners = 0;
  size_t h = start;
  do {
    corners += is_corner(x, h);
    h = step(x, h);
  } while (h != start);
  own->sets = calloc((size_t)corners + 1, sizeof *own->sets);
  bool done = own->sets != NULL && tp_polyline_reserve(&own->outline, corners);
  do {
    if (is_corner(x, h)) done = done && append_corner(x, own, h);
    h = step(x, h);
  } while (h != start && done);
  return done;
}

static tp_status set_outlines(outlining *x, tp_message *message) {
  const tp_planar_map *map = &x->cells->map;
  bool *seen = calloc(map->cycle_count + 1, sizeof *seen);
  bool done = seen != NULL;
  for (size_t h = 0; h < 2 * map->a.edge_count && done; h++) {
    if (map->gone[h / 2] || x->cells->kind[h] == TP_CELL_AIR || seen[map->cycle[h]]) continue;
    seen[map->cycle[h]] = true;
    done = add_outline(x, h);
  }
  free(seen);
  return done ? TP_OK : tp_fail_memory(message, "the blocks of the slope");
}

static tp_status outline_all(tp_cut_blocks *blocks, const tp_cuts *cuts, tp_message *message) {
  tp_slope_cells cells;
  tp_status status = tp_slope_cells_init(&cells, cuts, message);
  if (status != TP_OK) return status;
  outlining x = {.blocks = blocks, .cells = &cells};
  blocks->cut_off = cells.cut_off;
  blocks->exact = is_exact(&cells);
  if (!blocks->exact) blocks->moved = round_corners(&cells);
  status = set_outlines(&x, message);
  tp_slope_cells_clear(&cells);
  return status == TP_OK ? tp_cut_blocks_name(blocks, cuts, message) : status;
}

tp_status tp_cut_blocks_init(tp_cut_blocks *blocks, const tp_jointed_slope *slope,
                             tp_message *message) {
  memset(blocks, 0, sizeof *blocks);
  tp_cuts cuts;
  tp_status status = tp_cuts_init(&cuts, slope, message);
  if (status != TP_OK) return status;
  status = tp_cuts_outline(&cuts, message);
  if (status == TP_OK) status = tp_cuts_traces(&cuts, message);
  if (status == TP_OK) status = tp_cuts_base(&cuts, message);
  if (status == TP_OK) status = outline_all(blocks, &cuts, message);
  tp_cuts_clear(&cuts);
  if (status != TP_OK) tp_cut_blocks_clear(blocks);
  return status;
}
