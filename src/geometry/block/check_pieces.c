/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Is the block in one piece?
 *
 * Holes may touch the outline and each other in points, and so cut the block where they touch often
 * enough. Triangles that share a side hang together, those of the block and those of holes each
 * among themselves: pieces and gaps. The outline without the finitely many vertices is connected,
 * and no gap shares an edge with the outline, so from one piece to another there is always a way
 * over sides of triangles, by pieces and gaps in turn: where there are two pieces, some gap lies
 * beside two. Cost: linear in the number of triangles. */

#include "block/check.h"

#include <stdlib.h>

static bool is_hole(const tp_geom_triangulation *t, size_t triangle) {
  return t->triangles[triangle].ring_in_layer[1] != 0;
}

/* Give all that hangs together with `first` its number. `stack` has room for all triangles. */
static void flood(size_t *region, size_t *stack, const tp_geom_triangulation *t, size_t first) {
  size_t height = 0;
  region[first] = first;
  stack[height++] = first;
  while (height > 0) {
    const size_t k = stack[--height];
    for (size_t side = 3 * k; side < 3 * k + 3; side++) {
      const size_t next = t->across[side];
      if (next == TP_GEOM_NONE || region[next] != TP_GEOM_NONE) continue;
      if (is_hole(t, next) != is_hole(t, k)) continue;
      region[next] = first;
      stack[height++] = next;
    }
  }
}

/* The first hole in the order of the scene, counted from 1, with a side beside another piece than
 * the one that its gap was found beside before. `beside` is filled by that. */
static int find_cutting_hole(size_t *beside, const tp_geom_triangulation *t, const size_t *region) {
  int found = 0;
  for (size_t k = 0; k < t->count; k++) beside[k] = TP_GEOM_NONE;
  for (size_t side = 0; side < 3 * t->count; side++) {
    const size_t k = side / 3, next = t->across[side];
    if (!is_hole(t, k) || next == TP_GEOM_NONE || is_hole(t, next)) continue;
    size_t *piece = beside + region[k];
    const int ring = t->triangles[k].ring_in_layer[1];
    if (*piece == TP_GEOM_NONE) *piece = region[next];
    if (*piece != region[next] && (found == 0 || ring < found)) found = ring;
  }
  return found == 0 ? 0 : found - 1;
}

static tp_status fail_pieces(const tp_section *section, int hole, long pieces,
                             tp_message *message) {
  char name[40];
  tp_section_ring_name(name, sizeof name, section, hole);
  return tp_refuse(
      message, TP_FAULT_GEOMETRY, tp_polyline_place(section->rings + hole, -1),
      "%s%s the block into %ld pieces that meet in points at most; leave rock beside it, "
      "or give each piece a separate scene",
      name, section->hole_count > 1 ? ", alone or with others, cuts" : " cuts", pieces);
}

tp_status tp_check_in_one_piece(const tp_geom_triangulation *t, const tp_section *section,
                                tp_message *message) {
  if (section->hole_count == 0 || t->count == 0) return TP_OK;
  size_t *region = malloc(t->count * sizeof *region);
  size_t *stack = malloc(t->count * sizeof *stack);
  tp_status status = TP_OK;
  if (region == NULL || stack == NULL) {
    status = tp_fail_memory(message, "the check of the block's pieces");
  } else {
    long pieces = 0;
    for (size_t k = 0; k < t->count; k++) region[k] = TP_GEOM_NONE;
    for (size_t k = 0; k < t->count; k++) {
      if (region[k] != TP_GEOM_NONE) continue;
      flood(region, stack, t, k);
      pieces += !is_hole(t, k);
    }
    if (pieces > 1) {
      status = fail_pieces(section, find_cutting_hole(stack, t, region), pieces, message);
    }
  }
  free(region);
  free(stack);
  return status;
}
