/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "motion/generators.h"

#include "motion/newton.h"

#include <stdlib.h>

static void add_ray(tp_generators *g, const tp_twists *twists, long ray) {
  tp_generator *own = g->items + g->count++;
  const tp_ray *from = twists->rays + ray;
  *own = (tp_generator){.is_ray = true, .id = 2 * g->n->cones->count + ray, .axis = from->axis};
  tp_vector_init(&own->of);
  tp_newton_inertia(&own->of, g->q, from);
}

static long axis_of(const tp_normals *n, long point) {
  return n->families[n->family_of[point]].axis;
}

static void add_edge(tp_generators *g, const tp_mode_edge *edge) {
  tp_generator *own = g->items + g->count++;
  *own = (tp_generator){.id = 2 * g->n->same[edge->point] + edge->against,
                        .axis = axis_of(g->n, edge->point),
                        .site = g->n->cones->points[edge->point].site,
                        .point = edge->point,
                        .against = edge->against};
  tp_vector_init(&own->of);
  tp_newton_force(&own->of, g->q, g->n, edge);
}

/* What cohesion and bonds add: pulls beside the generators, free forces behind them. */
static void add_strength(tp_generators *g) {
  const tp_strength *strength = g->strength;
  if (strength == NULL) return;
  for (long k = 0; k < strength->pull_count + strength->free_count; k++) {
    const bool pull = k < strength->pull_count;
    const tp_vector *from = pull ? strength->pulls + k : strength->free + k - strength->pull_count;
    const long point = pull ? strength->pulled[k] : strength->sticks[k - strength->pull_count];
    tp_generator *own = g->items + g->count + g->free_count;
    *own = (tp_generator){
        .id = -2 - k, .axis = -1 - k, .site = g->n->cones->points[point].site, .point = point};
    tp_vector_init(&own->of);
    for (int e = 0; e < 3; e++) arb_set(own->of.of + e, from->of + e);
    *(pull ? &g->count : &g->free_count) += 1;
  }
}

bool tp_generators_init(tp_generators *g, const tp_motion_question *q, const tp_normals *n,
                        const tp_twists *twists, const tp_mode *mode, const tp_strength *strength) {
  *g = (tp_generators){.q = q, .n = n, .mode = mode, .strength = strength};
  const long more = strength != NULL ? strength->pull_count + strength->free_count : 0;
  g->items = calloc((size_t)(mode->ray_count + mode->edge_count + more), sizeof *g->items);
  if (g->items == NULL) return false;
  for (int k = 0; k < mode->ray_count; k++) add_ray(g, twists, mode->rays[k]);
  for (long k = 0; k < mode->edge_count; k++) add_edge(g, mode->edges + k);
  add_strength(g);
  return true;
}

void tp_generators_clear(tp_generators *g) {
  for (long k = 0; k < g->count + g->free_count; k++) tp_vector_clear(&g->items[k].of);
  free(g->items);
}

tp_source tp_generators_source(const tp_generators *g, const tp_generator *a,
                               const tp_generator *b) {
  /* cohesion and bonds have a moment of their own */
  const bool through_centroid = g->q->through_centroid && g->strength == NULL;
  if (!a->is_ray && !b->is_ray) {
    if (a->site == b->site) return (tp_source){.kind = TP_FROM_SITE, .a = a->site};
    if (a->axis == b->axis && a->against == b->against) {
      return (tp_source){.kind = TP_FROM_PARALLEL, .a = a->axis, .b = a->against};
    }
  } else {
    const tp_generator *ray = a->is_ray ? a : b;
    const long family = a->is_ray && b->is_ray ? g->n->items[g->mode->normal].family : 0;
    if (a->is_ray && b->is_ray) {
      return through_centroid ? (tp_source){.kind = TP_FROM_AXIS, .a = g->n->families[family].axis}
                              : (tp_source){.kind = TP_FROM_NORMAL, .a = g->mode->normal};
    }
    if (through_centroid && ray->axis >= 0) {
      return (tp_source){.kind = TP_FROM_AXIS, .a = ray->axis};
    }
  }
  return (tp_source){
      .kind = TP_FROM_PAIR, .a = a->id < b->id ? a->id : b->id, .b = a->id < b->id ? b->id : a->id};
}

bool tp_generator_is_in_plane(const tp_generator *g, const tp_source *plane) {
  if (g->is_ray) return false;
  if (plane->kind == TP_FROM_SITE) return g->site == plane->a;
  return plane->kind == TP_FROM_PARALLEL && g->axis == plane->a && g->against == plane->b;
}
