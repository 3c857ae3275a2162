/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Two surfaces that meet in corners, edges and triangles of both alone cut each other into patches
 * at the edges that they share. Each patch lies wholly inside or outside of the other surface, or
 * is one triangle of both. So one triangle tells for its patch. */

#include "solid/pieces.h"

#include "common/outside.h"
#include "solid/inside.h"
#include "solid/sides.h"

#include <stdlib.h>

typedef enum lie { INSIDE, OUTSIDE, ON_ALIKE, ON_OPPOSITE } lie;

/* Two of them under way. */
typedef struct pair {
  const tp_surface *own, *other;
  const tp_sides *own_sides, *other_sides;
  int *leaders; /* of own triangles, by patches */
} pair;

/* ---- what both share --------------------------------------------------------------------------
 */

/* The sides of an edge of a surface; how many there are. */
static long find_edge(const tp_side **found, const tp_sides *sides, const tp_surface *s, int a,
                      int b) {
  long count = 0;
  if ((a < b ? a : b) >= s->vertex_count) return 0;
  *found = tp_sides_edge(&count, sides, a, b);
  return count;
}

static bool has_corner(const int *corners, int vertex) {
  return corners[0] == vertex || corners[1] == vertex || corners[2] == vertex;
}

/* Is it also a triangle of the other? */
static bool find_same(lie *how, const pair *p, long triangle) {
  const int *own = p->own->triangles + 3 * triangle;
  const tp_side *sides = NULL;
  const long count = find_edge(&sides, p->other_sides, p->other, own[0], own[1]);
  for (long k = 0; k < count; k++) {
    if (!has_corner(p->other->triangles + 3L * sides[k].triangle, own[2])) continue;
    *how = sides[k].is_ahead == (own[0] < own[1]) ? ON_ALIKE : ON_OPPOSITE;
    return true;
  }
  return false;
}

/* Triangles to patches, across edges that the other has not. */
static void set_patches(pair *p) {
  for (long t = 0; t < p->own->triangle_count; t++) p->leaders[t] = (int)t;
  for (int v = 0; v < p->own->vertex_count; v++) {
    for (long k = p->own_sides->starts[v]; k + 1 < p->own_sides->starts[v + 1]; k += 2) {
      const tp_side *sides = p->own_sides->items + k, *found = NULL;
      if (find_edge(&found, p->other_sides, p->other, v, sides->other) > 0) continue;
      tp_sides_join(p->leaders, sides[0].triangle, sides[1].triangle);
    }
  }
}

static lie find_lie(const pair *p, long triangle) {
  lie how = OUTSIDE;
  if (find_same(&how, p, triangle)) return how;
  return tp_surface_has_inside(p->other, p->own, triangle) ? INSIDE : OUTSIDE;
}

/* The first triangle that lies where it may not; below zero: none. */
static long find_astray(pair *p, lie *how, lie allowed, lie also) {
  set_patches(p);
  for (long t = 0; t < p->own->triangle_count; t++) {
    if (p->leaders[t] != t) continue;
    *how = find_lie(p, t);
    if (*how != allowed && *how != also) return t;
  }
  return -1;
}

/* ---- what is refused --------------------------------------------------------------------------
 */

static const char *kind(const tp_solid_piece *piece) {
  return piece->is_hole ? "hole" : "part";
}

static tp_status refuse_touching(const tp_solid_piece *hole, const tp_solid_piece *other,
                                 bool is_rock, long triangle, tp_message *message) {
  char name[TP_SURFACE_NAME];
  return tp_refuse(message, TP_FAULT_GEOMETRY, tp_surface_place(&hole->surface, triangle),
                   "%s of this hole touches the %s of '%s': a hole lies wholly inside the rock and "
                   "apart from others; %s",
                   tp_surface_name(name, &hole->surface, triangle), is_rock ? "surface" : "hole",
                   tp_quote_all(tp_surface_place(&other->surface, 0).file).text,
                   is_rock ? "what is open outwards belongs to the rock's own mesh"
                           : "give two that touch as one mesh");
}

/* Holes that have a vertex of the rock, or of a hole before them. */
static tp_status check_holes(const tp_solid_piece *pieces, long count, int *owners,
                             tp_message *message) {
  for (long n = 0; n < count; n++) {
    const tp_surface *s = &pieces[n].surface;
    if (n > 0 && !pieces[n].is_hole) continue;
    for (long k = 0; k < 3 * s->triangle_count; k++) {
      int *owner = owners + s->triangles[k];
      if (*owner == 0) *owner = (int)n + 1;
      if (*owner == n + 1) continue;
      return refuse_touching(pieces + n, pieces + *owner - 1, *owner == 1, k / 3, message);
    }
  }
  return TP_OK;
}

static tp_status check_pair(pair *p, const tp_solid_piece *own, const tp_solid_piece *other,
                            bool is_rock, tp_message *message) {
  lie how = INSIDE;
  const long astray =
      is_rock ? find_astray(p, &how, INSIDE, ON_ALIKE) : find_astray(p, &how, OUTSIDE, ON_OPPOSITE);
  if (astray < 0) return TP_OK;
  char name[TP_SURFACE_NAME];
  const tp_place place = tp_surface_place(p->own, astray);
  tp_surface_name(name, p->own, astray);
  if (is_rock) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, place,
                     "%s of this %s lies outside of the rock: a %s lies inside", name, kind(own),
                     kind(own));
  }
  return tp_refuse(message, TP_FAULT_GEOMETRY, place,
                   "%s of this %s %s the %s of '%s': they may touch, but not overlap", name,
                   kind(own), how == INSIDE ? "lies inside" : "lies on the same side as",
                   kind(other), tp_quote_all(tp_surface_place(p->other, 0).file).text);
}

static tp_status check_pairs(const tp_solid_piece *pieces, const tp_sides *sides, long count,
                             int *leaders, tp_message *message) {
  tp_status status = TP_OK;
  for (long a = 1; a < count && status == TP_OK; a++) {
    for (long b = 0; b < count && status == TP_OK; b++) {
      if (a == b) continue;
      pair p = {&pieces[a].surface, &pieces[b].surface, sides + a, sides + b, leaders};
      status = check_pair(&p, pieces + a, pieces + b, b == 0, message);
    }
  }
  return status;
}

tp_status tp_gate_pieces(const tp_solid_piece *pieces, long count, tp_message *message) {
  long vertices = 0, triangles = 0;
  tp_sides *sides = calloc((size_t)count, sizeof *sides);
  bool done = sides != NULL;
  for (long n = 0; n < count && done; n++) {
    const tp_surface *s = &pieces[n].surface;
    if (s->vertex_count > vertices) vertices = s->vertex_count;
    if (s->triangle_count > triangles) triangles = s->triangle_count;
    done = tp_sides_init(sides + n, s->triangles, s->triangle_count, s->vertex_count);
  }
  int *owners = calloc((size_t)vertices + 1, sizeof *owners);
  int *leaders = malloc(((size_t)triangles + 1) * sizeof *leaders);
  tp_status status = TP_OK;
  if (!done || owners == NULL || leaders == NULL) {
    status = tp_fail_memory(message, "the parts of a solid");
  }
  if (status == TP_OK) status = check_holes(pieces, count, owners, message);
  if (status == TP_OK) status = check_pairs(pieces, sides, count, leaders, message);
  for (long n = 0; n < count && sides != NULL; n++) tp_sides_clear(sides + n);
  free(sides);
  free(owners);
  free(leaders);
  return status;
}
