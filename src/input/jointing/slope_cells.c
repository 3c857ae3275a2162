/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Kinds of cells, flooded from the edges of the section over all edges that do not bound them. */

#include "jointing/slope_cells.h"

#include <stdlib.h>
#include <string.h>

/* What is known of the face of a cycle before all is. */
typedef enum mark { UNKNOWN, AIR, GROUND, CUT_OFF, ENCLOSED, BLOCK } mark;

typedef struct marking {
  tp_slope_cells *cells;
  mark *marks;         /* of a cycle */
  size_t *list, count; /* half-edges, one of each cycle that is still to be flooded from */
} marking;

void tp_slope_cells_clear(tp_slope_cells *cells) {
  tp_planar_map_clear(&cells->map);
  free(cells->kind);
  memset(cells, 0, sizeof *cells);
}

/* ---- edges -------------------------------------------------------------------------------------
 */

/* The first segment of an edge that is of a kind; -1: none is. */
static long find_segment(const tp_slope_cells *cells, size_t edge, tp_cut_kind kind) {
  const tp_geom_arrangement *a = &cells->map.a;
  for (size_t k = a->first[edge]; k < a->first[edge + 1]; k++) {
    if (cells->cuts->of[a->segments[k]].kind == kind) return (long)a->segments[k];
  }
  return -1;
}

/* Of the outline of the section; -1: none. */
static long outline_segment(const tp_slope_cells *cells, size_t edge) {
  long found = -1;
  for (int kind = TP_CUT_SURFACE; kind <= TP_CUT_BOTTOM && found < 0; kind++) {
    found = find_segment(cells, edge, (tp_cut_kind)kind);
  }
  return found;
}

int tp_slope_cells_edge_set(const tp_slope_cells *cells, size_t edge) {
  const tp_cut *of = cells->cuts->of;
  const tp_joint_set *base = &cells->cuts->slope->base;
  const long along = find_segment(cells, edge, TP_CUT_BASE);
  const long trace = find_segment(cells, edge, TP_CUT_TRACE);
  const bool has_strength =
      base->friction_angle_deg.given || base->cohesion_kpa.given || base->tension_kpa.given;
  if (along >= 0 && (of[along].set >= 0 || has_strength || trace < 0)) return of[along].set;
  return trace >= 0 ? of[trace].set : TP_EDGE_OF_NONE;
}

bool tp_slope_cells_same_segment(const tp_slope_cells *cells, size_t edge, size_t other) {
  const tp_geom_arrangement *a = &cells->map.a;
  size_t i = a->first[edge], k = a->first[other];
  while (i < a->first[edge + 1] && k < a->first[other + 1]) {
    if (a->segments[i] == a->segments[k]) return true;
    if (a->segments[i] < a->segments[k]) {
      i++;
    } else {
      k++;
    }
  }
  return false;
}

/* The side of an edge of the outline that is outside: the outline runs clockwise. */
static size_t outer_side(const tp_slope_cells *cells, size_t edge, long segment) {
  const fmpq *ends = cells->cuts->ends + 4 * segment;
  const fmpq *p = cells->map.a.points + 2 * cells->map.a.origin[2 * edge];
  const fmpq *q = cells->map.a.points + 2 * cells->map.a.origin[2 * edge + 1];
  int order = fmpq_cmp(ends + 2, ends), own = fmpq_cmp(q, p);
  if (order == 0) {
    order = fmpq_cmp(ends + 3, ends + 1);
    own = fmpq_cmp(q + 1, p + 1);
  }
  return 2 * edge + ((order > 0) == (own > 0) ? 0 : 1);
}

static long any_of_bottom(const tp_slope_cells *cells) {
  for (size_t e = 0; e < cells->map.a.edge_count; e++) {
    if (!cells->map.gone[e] && find_segment(cells, e, TP_CUT_BOTTOM) >= 0) return (long)e;
  }
  return -1;
}

/* Two edges of the outline meet in each of its corners, or none. */
static tp_status check_outline(const tp_slope_cells *cells, tp_message *message) {
  const tp_geom_arrangement *a = &cells->map.a;
  const tp_jointed_slope *slope = cells->cuts->slope;
  int *count = calloc(a->vertex_count + 1, sizeof *count);
  if (count == NULL) return tp_fail_memory(message, "the blocks of the slope");
  bool simple = true;
  for (size_t e = 0; e < a->edge_count && simple; e++) {
    int own = 0;
    for (size_t k = a->first[e]; k < a->first[e + 1]; k++) {
      own += cells->cuts->of[a->segments[k]].kind <= TP_CUT_BOTTOM;
    }
    const int at = count[a->origin[2 * e]] += own, end = count[a->origin[2 * e + 1]] += own;
    simple = own <= 1 && at <= 2 && end <= 2;
  }
  free(count);
  if (simple) return TP_OK;
  return tp_refuse(message, TP_FAULT_GEOMETRY,
                   slope->surface.count > 0 ? tp_polyline_place(&slope->surface, -1) : slope->place,
                   "the surface of this slope crosses or touches itself, or an end of the section");
}

/* ---- marks -------------------------------------------------------------------------------------
 */

static void put(marking *x, size_t half_edge, mark as) {
  const size_t cycle = x->cells->map.cycle[half_edge];
  if (x->marks[cycle] != UNKNOWN) return;
  x->marks[cycle] = as;
  x->list[x->count++] = half_edge;
}

/* From all that is on the list, to faces that nothing is known of: over no edge of the outline, nor
 * of the base where that counts. */
static void flood(marking *x, bool base_bounds) {
  const tp_planar_map *map = &x->cells->map;
  for (; x->count > 0;) {
    const size_t start = x->list[--x->count];
    const mark own = x->marks[map->cycle[start]];
    size_t h = start;
    do {
      const bool bounds = outline_segment(x->cells, h / 2) >= 0 ||
                          (base_bounds && find_segment(x->cells, h / 2, TP_CUT_BASE) >= 0);
      if (!bounds) put(x, h ^ 1, own);
      h = map->a.next[h];
    } while (h != start);
  }
}

/* Outer and inner sides of the outline's edges of a kind, or of all (-1). */
static void put_sides(marking *x, int kind, bool outer, mark as) {
  const tp_planar_map *map = &x->cells->map;
  for (size_t e = 0; e < map->a.edge_count; e++) {
    const long segment = map->gone[e] ? -1 : outline_segment(x->cells, e);
    if (segment < 0 || (kind >= 0 && (int)x->cells->cuts->of[segment].kind != kind)) continue;
    const size_t outside = outer_side(x->cells, e, segment);
    put(x, outer ? outside : outside ^ 1, as);
  }
}

/* What is left, by pieces that hang together: with a free surface they are blocks. */
static void put_rest(marking *x) {
  const tp_planar_map *map = &x->cells->map;
  put_sides(x, TP_CUT_SURFACE, false, BLOCK);
  flood(x, true);
  for (size_t h = 0; h < 2 * map->a.edge_count; h++) {
    if (!map->gone[h / 2] && x->marks[map->cycle[h]] == UNKNOWN) x->marks[map->cycle[h]] = ENCLOSED;
  }
}

static void mark_all(marking *x) {
  put_sides(x, -1, true, AIR);
  flood(x, false);
  put_sides(x, TP_CUT_BOTTOM, false, GROUND);
  flood(x, true);
  put_sides(x, TP_CUT_END, false, CUT_OFF);
  x->cells->cut_off = (long)x->count;
  x->count = 0; /* a cell that ends there is ground, and not those beside it */
  put_rest(x);
}

static tp_status fail_no_block(const tp_slope_cells *cells, tp_message *message) {
  const tp_jointed_slope *slope = cells->cuts->slope;
  if (cells->cut_off > 0) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, slope->place,
                     "this slope has no blocks: all that its joints cut off above the base reaches "
                     "an end of the section, where it goes on as ground; give a longer section, a "
                     "base that meets the surface, or a set that crosses the others");
  }
  return tp_refuse(message, TP_FAULT_GEOMETRY, slope->base.place,
                   "this slope has no blocks: joints and base cut nothing off; does the base begin "
                   "on the surface and meet it again, or the end of the section, and do joints run "
                   "through?");
}

static tp_status set_kinds(tp_slope_cells *cells, tp_message *message) {
  const tp_planar_map *map = &cells->map;
  const size_t sides = 2 * map->a.edge_count;
  marking x = {.cells = cells,
               .marks = calloc(map->cycle_count + 1, sizeof *x.marks),
               .list = calloc(map->cycle_count + 1, sizeof *x.list)};
  cells->kind = calloc(sides + 1, sizeof *cells->kind);
  bool any = false;
  const bool done = x.marks != NULL && x.list != NULL && cells->kind != NULL;
  if (done) mark_all(&x);
  for (size_t h = 0; h < sides && done; h++) {
    if (map->gone[h / 2]) continue;
    const mark own = x.marks[map->cycle[h]];
    cells->kind[h] = own == BLOCK ? TP_CELL_BLOCK : own == AIR ? TP_CELL_AIR : TP_CELL_GROUND;
    any = any || own == BLOCK;
  }
  free(x.marks);
  free(x.list);
  if (!done) return tp_fail_memory(message, "the blocks of the slope");
  return any ? TP_OK : fail_no_block(cells, message);
}

/* Ground is one, and so is the air. */
static void merge(tp_slope_cells *cells) {
  for (size_t e = 0; e < cells->map.a.edge_count; e++) {
    const tp_cell_kind kind = cells->kind[2 * e];
    if (cells->map.gone[e] || kind != cells->kind[2 * e + 1] || kind == TP_CELL_BLOCK) continue;
    tp_planar_map_remove(&cells->map, e);
  }
}

static tp_status tidy(tp_slope_cells *cells, tp_message *message) {
  const long kept = any_of_bottom(cells);
  return tp_planar_map_tidy(&cells->map, (size_t)kept, message);
}

tp_status tp_slope_cells_init(tp_slope_cells *cells, const tp_cuts *cuts, tp_message *message) {
  memset(cells, 0, sizeof *cells);
  cells->cuts = cuts;
  tp_status status = tp_planar_map_init(&cells->map, cuts->ends, (size_t)cuts->count, message);
  if (status == TP_OK) status = check_outline(cells, message);
  if (status == TP_OK) status = tidy(cells, message);
  if (status == TP_OK) status = set_kinds(cells, message);
  if (status == TP_OK) {
    merge(cells);
    status = tidy(cells, message);
  }
  if (status != TP_OK) tp_slope_cells_clear(cells);
  return status;
}
