/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Generators of one mode in the order rays, edges, pulls, free shears; their balls are evaluated
 * when first asked for, and the source of each pair identifies planes that coincide. */

#include "motion/generators.h"

#include "motion/newton.h"

#include "common/grow.h"

#include <stdlib.h>
#include <string.h>

/* The next one behind those there are; NULL when memory is exhausted. */
static tp_generator *add(tp_generators *g) {
  const long before = g->room, count = g->count + g->free_count;
  tp_generator *more = tp_grow(g->items, count, &g->room, sizeof *more);
  if (more == NULL) return NULL;
  g->items = more;
  for (long k = before; k < g->room; k++) tp_vector_init(&more[k].of);
  return more + count;
}

/* All but the balls, whose room stays. */
static void describe(tp_generator *own, const tp_generator *as) {
  own->is_evaluated = false;
  own->is_ray = as->is_ray;
  own->id = as->id;
  own->axis = as->axis;
  own->site = as->site;
  own->point = as->point;
  own->against = as->against;
  own->edge = as->edge;
}

static bool add_ray(tp_generators *g, const tp_twists *twists, long ray) {
  tp_generator *own = add(g);
  if (own == NULL) return false;
  describe(own, &(tp_generator){.is_ray = true,
                                .id = 2 * g->n->cones->count + ray,
                                .axis = twists->rays[ray].axis});
  g->count++;
  return true;
}

static long axis_of(const tp_normals *n, long point) {
  return n->families[n->family_of[point]].axis;
}

static bool add_edge(tp_generators *g, const tp_cone_edge *edge) {
  tp_generator *own = add(g);
  if (own == NULL) return false;
  const tp_cone_point *point = g->n->cones->points + edge->point;
  describe(own,
           &(tp_generator){.id = 2 * g->n->same[edge->point] + edge->against,
                           .axis = axis_of(g->n, edge->point),
                           .site = point->site,
                           .point = edge->point,
                           .against = edge->against,
                           .edge = 2 * tp_cones_own(g->n->cones, edge->point) + edge->against});
  g->count++;
  return true;
}

/* What cohesion and bonds add: pulls beside the generators, free forces behind them. */
static bool add_strength(tp_generators *g) {
  const tp_strength *strength = g->strength;
  const long all = strength == NULL ? 0 : strength->pull_count + strength->free_count;
  for (long k = 0; k < all; k++) {
    const bool pull = k < strength->pull_count;
    const long point = pull ? strength->pulled[k] : strength->sticks[k - strength->pull_count];
    tp_generator *own = add(g);
    if (own == NULL) return false;
    describe(own, &(tp_generator){.id = -2 - k,
                                  .axis = -1 - k,
                                  .site = g->n->cones->points[point].site,
                                  .point = point});
    *(pull ? &g->count : &g->free_count) += 1;
  }
  return true;
}

bool tp_generators_set(tp_generators *g, const tp_motion_question *q, const tp_normals *n,
                       const tp_twists *twists, const tp_mode *mode, const tp_strength *strength) {
  g->q = q;
  g->n = n;
  g->mode = mode;
  g->strength = strength;
  g->count = g->free_count = 0;
  bool done = true;
  for (int k = 0; k < mode->ray_count && done; k++) done = add_ray(g, twists, mode->rays[k]);
  for (long k = 0; k < mode->edge_count && done; k++) done = add_edge(g, mode->edges + k);
  return done && add_strength(g);
}

void tp_generators_clear(tp_generators *g) {
  for (long k = 0; k < g->room; k++) tp_vector_clear(&g->items[k].of);
  free(g->items);
  memset(g, 0, sizeof *g);
}

const tp_vector *tp_generators_evaluate(tp_generators *g, const tp_twists *twists, long k) {
  const tp_mode *mode = g->mode;
  tp_vector *own = &g->items[k].of;
  if (g->items[k].is_evaluated) return own;
  const long edge = k - mode->ray_count, added = edge - mode->edge_count;
  if (edge < 0) {
    tp_newton_inertia(own, g->q, twists->rays + mode->rays[k]);
  } else if (added < 0) {
    tp_newton_force(own, g->q, g->n, mode->edges + edge);
  } else {
    const long pulls = g->strength->pull_count;
    const tp_vector *from =
        added < pulls ? g->strength->pulls + added : g->strength->free + added - pulls;
    for (int e = 0; e < 3; e++) arb_set(own->of + e, from->of + e);
  }
  g->items[k].is_evaluated = true;
  return own;
}

void tp_generators_evaluate_all(tp_generators *g, const tp_twists *twists) {
  for (long k = 0; k < g->count + g->free_count; k++) (void)tp_generators_evaluate(g, twists, k);
}

tp_source tp_generators_normal_source(const tp_motion_question *q, const tp_normals *n,
                                      const tp_strength *strength, long normal) {
  /* cohesion and bonds have a moment of their own */
  return q->through_centroid && strength == NULL
             ? (tp_source){.kind = TP_FROM_AXIS, .a = n->families[n->items[normal].family].axis}
             : (tp_source){.kind = TP_FROM_NORMAL, .a = normal};
}

tp_source tp_generators_source(const tp_generators *g, const tp_generator *a,
                               const tp_generator *b) {
  if (!a->is_ray && !b->is_ray) {
    if (a->site == b->site) return (tp_source){.kind = TP_FROM_SITE, .a = a->site};
    if (a->axis == b->axis && a->edge == b->edge) {
      return (tp_source){.kind = TP_FROM_PARALLEL, .a = a->axis, .b = a->edge};
    }
  } else {
    const tp_generator *ray = a->is_ray ? a : b;
    if (a->is_ray && b->is_ray) {
      return tp_generators_normal_source(g->q, g->n, g->strength, g->mode->normal);
    }
    if (g->q->through_centroid && g->strength == NULL && ray->axis >= 0) {
      return (tp_source){.kind = TP_FROM_AXIS, .a = ray->axis};
    }
  }
  return (tp_source){
      .kind = TP_FROM_PAIR, .a = a->id < b->id ? a->id : b->id, .b = a->id < b->id ? b->id : a->id};
}

bool tp_generator_is_in_plane(const tp_generator *g, const tp_source *plane) {
  if (g->is_ray) return false;
  if (plane->kind == TP_FROM_SITE) return g->site == plane->a;
  return plane->kind == TP_FROM_PARALLEL && g->axis == plane->a && g->edge == plane->b;
}
