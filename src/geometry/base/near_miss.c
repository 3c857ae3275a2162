/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What nearly touches, by the criterion of base/closeness.h, and its words. */

#include "base/closeness.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double share_of_size = 1e-3, share_of_edge = 1e-2;

/* Of a vertex: its least distance so far, and the edge. */
typedef struct least {
  double distance; /* 0: it touches */
  long edge;
} least;

typedef struct search {
  const tp_closeness *near;
  least *vertices, *points; /* of the outline; of the profile */
} search;

static least *least_of(const search *s, const tp_closeness_pair *pair) {
  return (pair->of_base ? s->points : s->vertices) + pair->vertex;
}

static bool is_on(const tp_closeness *n, const tp_closeness_pair *pair) {
  const long outline = n->lattice->start[1];
  const long point = pair->of_base ? n->ring + pair->vertex : pair->vertex;
  const long from = pair->of_base ? pair->edge : n->ring + pair->edge;
  const long to = pair->of_base ? (pair->edge + 1) % outline : from + 1;
  return tp_lattice_cross(n->lattice, from, to, from, point) == 0 &&
         tp_lattice_dot(n->lattice, from, point, from, to) >= 0 &&
         tp_lattice_dot(n->lattice, to, point, to, from) >= 0;
}

/* In the unit of the search; exact where doubles do not tell it from 0. */
static bool take(void *context, const tp_closeness_pair *pair, double distance) {
  const search *s = context;
  least *own = least_of(s, pair);
  enum { ROOM = 16 };
  if (own->distance == 0) return true;
  if (distance <= ROOM * s->near->error) {
    if (is_on(s->near, pair)) {
      distance = 0;
    } else {
      fmpq_t share, square;
      int side;
      fmpq_init(share);
      fmpq_init(square);
      tp_closeness_foot(share, square, &side, s->near, pair);
      /* a gap too small for a double is the least of one */
      distance = fmax(tp_closeness_root(square) / s->near->unit, 0x1p-1074);
      fmpq_clear(share);
      fmpq_clear(square);
    }
  }
  if (distance < own->distance) *own = (least){distance, pair->edge};
  return true;
}

static void describe(tp_near_miss *miss, const tp_closeness *n, tp_closeness_pair pair) {
  const long outline = n->lattice->start[1];
  const long from = pair.of_base ? pair.edge : n->ring + pair.edge;
  const long to = pair.of_base ? (pair.edge + 1) % outline : from + 1;
  const tp_lattice *l = n->lattice;
  fmpq_t share, square;
  int side;
  fmpq_init(share);
  fmpq_init(square);
  tp_closeness_foot(share, square, &side, n, &pair);
  miss->pair = pair;
  miss->gap = tp_closeness_root(square);
  miss->beside =
      fabs((l->v[to] - l->v[from]) * n->scale_v) > fabs((l->u[to] - l->u[from]) * n->scale_u);
  fmpq_clear(share);
  fmpq_clear(square);
}

/* Of the vertices of one body: how many miss nearly, and the farthest of them; or the nearest. */
static void pick(const search *s, bool of_base, bool apart, long *count, double *most,
                 tp_closeness_pair *pair) {
  const tp_closeness *n = s->near;
  const long vertices = of_base ? n->points : n->lattice->start[1];
  for (long k = 0; k < vertices; k++) {
    const tp_closeness_pair own = {of_base, k, 0};
    const least *found = least_of(s, &own);
    if (found->distance == 0 || isinf(found->distance)) continue;
    if (!apart && found->distance > share_of_edge * tp_closeness_shorter_edge(n, of_base, k))
      continue;
    if (*count == 0 || (apart ? found->distance < *most : found->distance > *most)) {
      *most = found->distance;
      *pair = (tp_closeness_pair){of_base, k, found->edge};
    }
    (*count)++;
  }
}

bool tp_near_miss_find(tp_near_miss *miss, const tp_closeness *near, bool apart) {
  const long outline = near->lattice->start[1];
  search s = {.near = near};
  *miss = (tp_near_miss){.count = 0};
  s.vertices = malloc((size_t)outline * sizeof *s.vertices);
  s.points = malloc((size_t)near->points * sizeof *s.points);
  const bool done = s.vertices != NULL && s.points != NULL;
  for (long k = 0; k < outline && done; k++) s.vertices[k] = (least){INFINITY, 0};
  for (long k = 0; k < near->points && done; k++) s.points[k] = (least){INFINITY, 0};
  double most = 0;
  tp_closeness_pair pair = {false, 0, 0};
  const tp_closeness_reach reach = {.within = apart ? INFINITY : share_of_size * near->size,
                                    .share_of_edge = apart ? 0 : share_of_edge,
                                    .upright = apart};
  if (done) {
    (void)tp_closeness_visit(near, &reach, take, &s);
    pick(&s, false, apart, &miss->count, &most, &pair);
    pick(&s, true, apart, &miss->count, &most, &pair);
  }
  if (miss->count > 0) {
    if (apart) miss->count = 1;
    describe(miss, near, pair);
  }
  free(s.vertices);
  free(s.points);
  return done;
}

void tp_near_miss_text(char *text, size_t size, const tp_near_miss *miss,
                       const tp_closeness *near) {
  const tp_closeness_pair *p = &miss->pair;
  const char *unit = near->base->unit;
  if (p->of_base) {
    snprintf(text, size, "point %ld of the profile lies %.2g %s %s the block",
             tp_polyline_number(&near->base->ring, p->vertex), miss->gap, unit,
             miss->beside ? "beside" : "below");
  } else {
    snprintf(text, size, "vertex %ld of the outline lies %.2g %s %s the base",
             tp_polyline_number(near->section->rings, p->vertex), miss->gap, unit,
             miss->beside ? "beside" : "above");
  }
}
