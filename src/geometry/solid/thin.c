/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The hull, then rounds of collapses, each judged by where its triangles meet. */

#include "solid/thin.h"

#include "solid/collapse.h"
#include "solid/gate.h"
#include "solid/hull.h"
#include "solid/mending.h"

#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 9 };

typedef struct thinning {
  const tp_surface *surface;
  tp_solid_thinning *record;
  double reach; /* as the surface's `near`, with room for its roundings */
  bool *stay;
  tp_collapse collapse;
  int *sources; /* of each vertex that is left which of the surface it is */
  tp_message *message;
} thinning;

static tp_status fail_memory(const thinning *x) {
  return tp_fail_memory(x->message, "the thinning of a mesh");
}

/* ---- what stays --------------------------------------------------------------------------------
 */

static tp_status keep_hull(thinning *x) {
  tp_hull hull;
  const tp_status status = tp_hull_find(&hull, x->surface, x->message);
  for (long k = 0; k < 3 * hull.count; k++) {
    bool *own = x->stay + hull.corners[k];
    if (!*own) x->record->hull_corners++;
    *own = true;
  }
  tp_hull_clear(&hull);
  return status;
}

/* What came to a vertex that is left stays as well; did all of it already? */
static bool keep(thinning *x, int left) {
  bool stays = true;
  for (int v = x->sources[left]; v >= 0; v = x->collapse.moved[v]) {
    if (x->stay[v]) continue;
    x->stay[v] = true;
    x->record->left_points++;
    stays = false;
  }
  return stays;
}

/* What came to the corners of triangles that meet; where nothing had, what came to those of their
 * neighbours: `marks` are of triangles. */
static void keep_marked(thinning *x, const tp_surface *thinned, const bool *marks) {
  const int *corners = thinned->triangles;
  const long count = 3 * thinned->triangle_count;
  bool *beside = calloc((size_t)thinned->vertex_count, sizeof *beside);
  for (long k = 0; k < count; k++) {
    if (marks[k / 3] && keep(x, corners[k]) && beside != NULL) beside[corners[k]] = true;
  }
  for (long k = 0; beside != NULL && k < count; k++) {
    if (!beside[corners[k]]) continue;
    for (long n = k - k % 3; n < k - k % 3 + 3; n++) (void)keep(x, corners[n]);
  }
  free(beside);
}

static void keep_all(thinning *x) {
  for (long v = 0; v < x->surface->vertex_count; v++) {
    if (!x->stay[v]) x->record->left_points++;
    x->stay[v] = true;
  }
}

/* ---- what is left ------------------------------------------------------------------------------
 */

static bool make_room(tp_surface *thinned, long vertices, long triangles) {
  thinned->sources = malloc((size_t)vertices * sizeof *thinned->sources);
  thinned->whole = calloc(3 * (size_t)vertices, sizeof *thinned->whole);
  thinned->near = malloc(3 * (size_t)vertices * sizeof *thinned->near);
  thinned->triangles = malloc(3 * (size_t)triangles * sizeof *thinned->triangles);
  thinned->faces = malloc((size_t)triangles * sizeof *thinned->faces);
  return thinned->sources != NULL && thinned->whole != NULL && thinned->near != NULL &&
         thinned->triangles != NULL && thinned->faces != NULL;
}

/* `places` of vertices that are left; how many these are. */
static long number_vertices(int *places, const tp_collapse *c) {
  long count = 0;
  for (long v = 0; v < c->surface->vertex_count; v++) {
    places[v] = c->first_last[2 * v] >= 0 ? (int)count++ : -1;
  }
  return count;
}

static void put_vertices(thinning *x, tp_surface *thinned, const int *places) {
  const tp_surface *s = x->surface;
  for (long v = 0; v < s->vertex_count; v++) {
    if (places[v] < 0) continue;
    const long own = places[v];
    x->sources[own] = (int)v;
    thinned->sources[own] = s->sources[v];
    for (int k = 0; k < 3; k++) {
      fmpz_set(thinned->whole + 3 * own + k, s->whole + 3 * v + k);
      thinned->near[3 * own + k] = s->near[3 * v + k];
      if (s->given != NULL) thinned->given[3 * own + k] = s->given[3 * v + k];
    }
  }
}

static long count_triangles(const tp_collapse *c) {
  long count = 0;
  for (long t = 0; t < c->surface->triangle_count; t++) count += c->triangles[3 * t] >= 0;
  return count;
}

static void put_triangles(tp_surface *thinned, const tp_collapse *c, const int *places) {
  for (long t = 0; t < c->surface->triangle_count; t++) {
    const int *corners = c->triangles + 3 * t;
    if (corners[0] < 0) continue;
    int *own = thinned->triangles + 3 * thinned->triangle_count;
    for (int k = 0; k < 3; k++) own[k] = places[corners[k]];
    thinned->faces[thinned->triangle_count++] = c->surface->faces[t];
  }
}

static bool take(thinning *x, tp_surface *thinned) {
  const tp_surface *s = x->surface;
  int *places = malloc((size_t)s->vertex_count * sizeof *places);
  if (places == NULL) return false;
  const long count = number_vertices(places, &x->collapse);
  *thinned = (tp_surface){.mesh = s->mesh,
                          .vertex_count = count,
                          .is_exact = s->is_exact,
                          .exponent = s->exponent,
                          .split = s->split};
  bool done = make_room(thinned, count, count_triangles(&x->collapse));
  if (thinned->whole != NULL) { /* what tp_surface_clear clears with these */
    fmpz_init_set(thinned->divisor, s->divisor);
    for (int k = 0; k < 3; k++) fmpz_init_set(thinned->origin[k], s->origin[k]);
  }
  if (done && s->given != NULL) {
    thinned->given = malloc(3 * (size_t)count * sizeof *thinned->given);
    done = thinned->given != NULL;
  }
  if (done) {
    put_vertices(x, thinned, places);
    put_triangles(thinned, &x->collapse, places);
  }
  free(places);
  return done;
}

/* ---- rounds ------------------------------------------------------------------------------------
 */

/* Where triangles of it meet, `*meets`, and the vertices that came to them stay from now on. */
static tp_status judge(thinning *x, const tp_surface *thinned, bool *meets) {
  const tp_geom_points points = tp_surface_points(thinned);
  tp_geom_clashes clashes;
  bool *marks = calloc((size_t)thinned->triangle_count, sizeof *marks);
  if (marks == NULL) return fail_memory(x);
  const tp_geom_status found = tp_geom_find_clashes(&clashes, &points, thinned->triangles,
                                                    (size_t)thinned->triangle_count, marks);
  *meets = clashes.count > 0;
  if (found == TP_GEOM_OK && *meets) keep_marked(x, thinned, marks);
  free(marks);
  if (found == TP_GEOM_OUT_OF_MEMORY) return fail_memory(x);
  return found == TP_GEOM_OK
             ? TP_OK
             : tp_fail(x->message, TP_DEPENDENCY_FAILED, tp_surface_place(thinned, 0),
                       "CGAL failed to find where triangles meet");
}

static tp_status thin_once(thinning *x, tp_surface *thinned, bool *meets) {
  tp_collapse_clear(&x->collapse);
  tp_surface_clear(thinned);
  if (!tp_collapse_run(&x->collapse, x->surface, x->reach, x->stay) || !take(x, thinned)) {
    return fail_memory(x);
  }
  const tp_status status = tp_gate_areas(thinned, x->message);
  return status == TP_OK ? judge(x, thinned, meets) : status;
}

static tp_status thin(thinning *x, tp_surface *thinned) {
  bool meets = true;
  tp_status status = keep_hull(x);
  for (int k = 0; k < ROUNDS && meets && status == TP_OK; k++) {
    if (k == ROUNDS - 1) keep_all(x); /* the mesh as it is, which meets itself or does not */
    status = thin_once(x, thinned, &meets);
  }
  if (status == TP_OK && meets) status = tp_gate_clashes(thinned, x->message);
  return status;
}

tp_status tp_surface_thin(tp_surface *thinned, tp_solid_thinning *record, const tp_surface *surface,
                          double length, tp_message *message) {
  const double step = tp_mending_step(surface), rounding = 1e-14;
  thinning x = {.surface = surface,
                .record = record,
                .reach = length / step * (1 - rounding),
                .stay = calloc((size_t)surface->vertex_count, sizeof *x.stay),
                .sources = malloc((size_t)surface->vertex_count * sizeof *x.sources),
                .message = message};
  *thinned = (tp_surface){.mesh = NULL};
  *record = (tp_solid_thinning){.length = length,
                                .scan_vertices = (size_t)surface->vertex_count,
                                .scan_triangles = (size_t)surface->triangle_count};
  const tp_status status =
      x.stay != NULL && x.sources != NULL ? thin(&x, thinned) : fail_memory(&x);
  if (status == TP_OK) {
    record->farthest = fmin(length, x.collapse.farthest * step * (1 + rounding));
  } else {
    tp_surface_clear(thinned);
  }
  tp_collapse_clear(&x.collapse);
  free(x.stay);
  free(x.sources);
  return status;
}
