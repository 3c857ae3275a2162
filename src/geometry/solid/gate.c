/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Of each kind of fault the one of the least triangle is told, and how many there are. */

#include "solid/gate.h"

#include "common/outside.h"
#include "solid/sides.h"
#include "solid/turns.h"

#include <stdio.h>
#include <stdlib.h>

/* Of one kind. */
typedef struct fault {
  long count;
  long triangle, neighbour;
  int from, to; /* the edge */
} fault;

typedef struct gate {
  const tp_surface *surface;
  tp_sides sides;
  bool is_ground; /* which may end, and have pieces */
  int *leaders;   /* of the triangles: another one of its piece, itself of one in each piece */
  fault open, crowded, turned;
} gate;

static void note(fault *own, long triangle, long neighbour, int from, int to) {
  if (own->count++ > 0 && triangle >= own->triangle) return;
  own->triangle = triangle;
  own->neighbour = neighbour;
  own->from = from;
  own->to = to;
}

/* ---- edges -------------------------------------------------------------------------------------
 */

static bool gather(gate *g) {
  const tp_surface *s = g->surface;
  g->leaders = malloc((size_t)s->triangle_count * sizeof *g->leaders);
  if (g->leaders == NULL) return false;
  for (long t = 0; t < s->triangle_count; t++) g->leaders[t] = (int)t;
  return tp_sides_init(&g->sides, s->triangles, s->triangle_count, s->vertex_count);
}

/* The sides of one edge, in the order of their triangles. */
static void judge_edge(gate *g, int vertex, const tp_side *sides, long count) {
  const int other = sides->other;
  for (long k = 1; k < count; k++) {
    tp_sides_join(g->leaders, sides[0].triangle, sides[k].triangle);
  }
  if (count == 1) note(&g->open, sides[0].triangle, -1, vertex, other);
  if (count > 2) note(&g->crowded, sides[0].triangle, sides[2].triangle, vertex, other);
  if (count == 2 && sides[0].is_ahead == sides[1].is_ahead) {
    note(&g->turned, sides[0].triangle, sides[1].triangle, vertex, other);
  }
}

static void judge_edges(gate *g) {
  for (int v = 0; v < g->surface->vertex_count; v++) {
    const tp_side *own = g->sides.items + g->sides.starts[v];
    const long count = g->sides.starts[v + 1] - g->sides.starts[v];
    for (long k = 0, next = 0; k < count; k = next) {
      while (next < count && own[next].other == own[k].other) next++;
      judge_edge(g, v, own + k, next - k);
    }
  }
}

/* ---- what is refused ---------------------------------------------------------------------------
 */

enum { EDGE = 160 };

/* What a repair may do about it, or that it did not. */
static const char *offer(const tp_surface *s, bool is_ground, const char *what) {
  if (is_ground) return "; a ground is not repaired";
  return s->mesh->is_mended ? "; its repair left them so" : what;
}

static const char *edge_text(char text[EDGE], const tp_surface *s, const fault *own) {
  double at[6];
  for (int k = 0; k < 3; k++) {
    at[k] = tp_surface_given(s, own->from, k);
    at[k + 3] = tp_surface_given(s, own->to, k);
  }
  snprintf(text, EDGE, "from (%.9g, %.9g, %.9g) to (%.9g, %.9g, %.9g)", at[0], at[1], at[2], at[3],
           at[4], at[5]);
  return text;
}

static tp_status refuse_pieces(gate *g, tp_message *message) {
  const tp_surface *s = g->surface;
  long pieces = 0, second = -1, sizes[2] = {0};
  for (int t = 0; t < s->triangle_count; t++) {
    const int first = tp_sides_leader(g->leaders, t);
    if (first == t && ++pieces == 2) second = t;
    if (first == 0) sizes[0]++;
    if (first == second) sizes[1]++;
  }
  if (pieces <= 1) return TP_OK;
  char names[2][TP_SURFACE_NAME];
  return tp_refuse(
      message, TP_FAULT_GEOMETRY, tp_surface_place(s, second),
      "%ld pieces that share no edge: %s begins one of %ld triangles, %s another of "
      "%ld; a solid is one piece: give each by itself, or name an object; cavities "
      "are 'holes' of a scene; small ones are dropped by --repair with --drop-below, in "
      "a scene 'repair: {drop_below: 0.01}'",
      pieces, tp_surface_name(names[0], s, 0), sizes[0], tp_surface_name(names[1], s, second),
      sizes[1]);
}

static tp_status refuse_faults(gate *g, tp_message *message) {
  const tp_surface *s = g->surface;
  char names[2][TP_SURFACE_NAME], edge[EDGE];
  if (g->crowded.count > 0) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, tp_surface_place(s, g->crowded.triangle),
                     "three triangles or more at one edge, %s, among them %s and %s; there are "
                     "%ld such edges: name an object, or repair the mesh%s",
                     edge_text(edge, s, &g->crowded),
                     tp_surface_name(names[0], s, g->crowded.triangle),
                     tp_surface_name(names[1], s, g->crowded.neighbour), g->crowded.count,
                     offer(s, g->is_ground,
                           "; where they are given twice --repair, in a scene 'repair: true', "
                           "drops them"));
  }
  if (g->open.count > 0 && !g->is_ground) {
    return tp_refuse(
        message, TP_FAULT_GEOMETRY, tp_surface_place(s, g->open.triangle),
        "the surface is open: at its edge %s %s has no neighbour; there are %ld such "
        "edges: close the holes of the mesh%s",
        edge_text(edge, s, &g->open), tp_surface_name(names[0], s, g->open.triangle), g->open.count,
        offer(s, g->is_ground, ", or have them closed by --repair, in a scene 'repair: true'"));
  }
  if (g->turned.count > 0) {
    return tp_refuse(
        message, TP_FAULT_GEOMETRY, tp_surface_place(s, g->turned.triangle),
        "%s and %s are oriented against each other: both pass their edge %s in one "
        "direction; there are %ld such edges: orient the faces of the mesh outwards%s",
        tp_surface_name(names[0], s, g->turned.triangle),
        tp_surface_name(names[1], s, g->turned.neighbour), edge_text(edge, s, &g->turned),
        g->turned.count,
        offer(s, g->is_ground, ", or have them turned by --repair, in a scene 'repair: true'"));
  }
  return g->is_ground ? TP_OK : refuse_pieces(g, message);
}

/* ---- areas, meetings -----
 */

static tp_status refuse_flat(const tp_surface *surface, long triangle, bool is_ground,
                             tp_message *message) {
  const int *corners = surface->triangles + 3 * triangle;
  double at[9];
  char name[TP_SURFACE_NAME];
  for (int k = 0; k < 9; k++) at[k] = tp_surface_given(surface, corners[k / 3], k % 3);
  return tp_refuse(message, TP_FAULT_GEOMETRY, tp_surface_place(surface, triangle),
                   "%s has no area: its corners (%.9g, %.9g, %.9g), (%.9g, %.9g, %.9g) and (%.9g, "
                   "%.9g, %.9g) lie on one line; repair the mesh%s",
                   tp_surface_name(name, surface, triangle), at[0], at[1], at[2], at[3], at[4],
                   at[5], at[6], at[7], at[8],
                   offer(surface, is_ground, " by --repair, in a scene 'repair: true'"));
}

static tp_status pass_areas(const tp_surface *surface, bool is_ground, tp_message *message) {
  for (long t = 0; t < surface->triangle_count; t++) {
    const int *own = surface->triangles + 3 * t;
    if (!tp_surface_is_straight(surface, own[0], own[1], own[2])) continue;
    return refuse_flat(surface, t, is_ground, message);
  }
  return TP_OK;
}

static tp_status pass_edges(const tp_surface *surface, bool is_ground, tp_message *message) {
  gate g = {.surface = surface, .is_ground = is_ground};
  tp_status status = TP_OK;
  if (gather(&g)) {
    judge_edges(&g);
    status = refuse_faults(&g, message);
  } else {
    status = tp_fail_memory(message, "the edges of a solid");
  }
  tp_sides_clear(&g.sides);
  free(g.leaders);
  return status;
}

tp_status tp_gate_edges(const tp_surface *surface, tp_message *message) {
  return pass_edges(surface, false, message);
}

tp_status tp_gate_areas(const tp_surface *surface, tp_message *message) {
  return pass_areas(surface, false, message);
}

tp_status tp_gate_ground(const tp_surface *surface, tp_message *message) {
  const tp_status status = pass_areas(surface, true, message);
  return status == TP_OK ? pass_edges(surface, true, message) : status;
}

tp_status tp_gate_clashes(const tp_surface *surface, tp_message *message) {
  const tp_geom_points points = tp_surface_points(surface);
  tp_geom_clashes clashes;
  const tp_geom_status found = tp_geom_find_clashes(&clashes, &points, surface->triangles,
                                                    (size_t)surface->triangle_count, NULL);
  if (found == TP_GEOM_OUT_OF_MEMORY) return tp_fail_memory(message, "the triangles of a solid");
  if (found != TP_GEOM_OK) {
    return tp_fail(message, TP_DEPENDENCY_FAILED, (tp_place){surface->mesh->file, 0, 0},
                   "CGAL failed to find where triangles meet");
  }
  if (clashes.count == 0) return TP_OK;
  char names[2][TP_SURFACE_NAME];
  const long first = (long)clashes.first, second = (long)clashes.second;
  if (tp_surface_object(surface, first) != tp_surface_object(surface, second) &&
      surface->mesh->objects->file != NULL) {
    return tp_refuse(
        message, TP_FAULT_GEOMETRY, tp_surface_place(surface, second),
        "%s of this mesh and %s of '%s' cross, or meet in a place where not both have "
        "the same corner, edge or triangle; there are %zu such pairs: what lies inside "
        "a rock may touch its surface, or another, in such alone",
        tp_surface_name(names[0], surface, second), tp_surface_name(names[1], surface, first),
        tp_quote_all(tp_surface_place(surface, first).file).text, clashes.count);
  }
  return tp_refuse(message, TP_FAULT_GEOMETRY, tp_surface_place(surface, first),
                   "the surface meets itself: %s and %s meet elsewhere than in an edge or a corner "
                   "that they share; there are %zu such pairs: repair the mesh",
                   tp_surface_name(names[0], surface, first),
                   tp_surface_name(names[1], surface, second), clashes.count);
}
