/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Forces of cohesion and bonds for one mode: fixed where contacts slip or separate, free within
 * bounds where they stick, pulls where a bonded facet slides (Mohr-Coulomb). */

#include "motion/strength.h"

#include "motion/closed.h"
#include "motion/newton.h"

#include <stdlib.h>

void tp_strength_init(tp_strength *s) {
  tp_vector_init(&s->fixed);
  tp_vector_init(&s->cohesion);
  tp_vector_init(&s->bond);
  arb_init(s->most_pull);
  for (int k = 0; k < TP_STRENGTH_FREE; k++) tp_vector_init(s->free + k);
  for (int k = 0; k < TP_STRENGTH_PULLS; k++) tp_vector_init(s->pulls + k);
  s->free_count = s->pull_count = 0;
  s->capacity_of = NULL;
  tp_vector_init(&s->bonds);
}

void tp_strength_clear(tp_strength *s) {
  free(s->capacity_of);
  tp_vector_clear(&s->bonds);
  tp_vector_clear(&s->fixed);
  tp_vector_clear(&s->cohesion);
  tp_vector_clear(&s->bond);
  arb_clear(s->most_pull);
  for (int k = 0; k < TP_STRENGTH_FREE; k++) tp_vector_clear(s->free + k);
  for (int k = 0; k < TP_STRENGTH_PULLS; k++) tp_vector_clear(s->pulls + k);
}

static void divide(tp_vector *force, const arb_t by, long bits) {
  for (int k = 0; k < 3; k++) arb_div(force->of + k, force->of + k, by, bits);
}

void tp_strength_divide(tp_strength *s, const arb_t force, long bits) {
  divide(&s->fixed, force, bits);
  divide(&s->cohesion, force, bits);
  divide(&s->bond, force, bits);
  arb_div(s->most_pull, s->most_pull, force, bits);
  for (long k = 0; k < s->free_count; k++) divide(s->free + k, force, bits);
}

/* One mode at work. */
typedef struct gathering {
  tp_strength *strength;
  const tp_motion_question *q;
  const tp_normals *n;
  const tp_twists *twists;
  const tp_mode *mode;
} gathering;

/* A force times a factor at a point of the cones, with its moment about the centroid. */
static void set_force(tp_vector *force, const gathering *g, const arb_t x, const arb_t y,
                      const arb_t factor, long point, bool pull) {
  const tp_motion_question *q = g->q;
  const long bits = q->judge.bits;
  const fmpz *tx = q->cones->tx + point, *ty = q->cones->ty + point;
  arb_mul_fmpz(force->of, factor, pull ? ty : tx, bits);
  arb_mul_fmpz(force->of + 1, factor, pull ? tx : ty, bits);
  if (pull) arb_neg(force->of + 1, force->of + 1);
  tp_newton_moment(force, q, x, y, bits);
}

static void begin_free(tp_strength *s, long point) {
  s->sticks[s->free_count] = point;
  for (int k = 0; k < 3; k++) arb_zero(s->free[s->free_count].of + k);
  s->free_count++;
}

static void set_pull(tp_vector *force, const gathering *g, const tp_capacity *own,
                     const arb_t factor) {
  const tp_cones *cones = g->q->cones;
  const long point = own->point, bits = g->q->judge.bits;
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  tp_cones_middle(x, y, cones, point, bits);
  set_force(force, g, x, y, factor, point, true);
  arb_clear(x);
  arb_clear(y);
}

static void add_cohesion(gathering *g, const tp_vector *force, bool back) {
  for (int k = 0; k < 3; k++) {
    arb_struct *sum = g->strength->cohesion.of + k;
    if (back) {
      arb_sub(sum, sum, force->of + k, g->q->judge.bits);
    } else {
      arb_add(sum, sum, force->of + k, g->q->judge.bits);
    }
  }
}

/* The bonds of facets that slide in one piece, turned round: along n, between the first and the
 * last normal line of each of their families. */
static void add_slide_pulls(gathering *g) {
  tp_strength *s = g->strength;
  const tp_normals *n = g->n;
  const long axis = g->twists->rays[g->mode->rays[0]].axis;
  for (long k = 0; k < n->family_count; k++) {
    const tp_contact_family *own = n->families + k;
    if (own->axis != axis) continue;
    for (int end = 0; end < 2; end++) {
      const tp_normal *line = n->items + own->first + (end == 0 ? 0 : own->count - 1);
      const long point = n->order[line->first];
      arb_t one;
      arb_init(one);
      arb_one(one);
      s->pulled[s->pull_count] = point;
      tp_vector *pull = s->pulls + s->pull_count++;
      const arb_struct x = tp_cones_x(n->cones, point), y = tp_cones_y(n->cones, point);
      set_force(pull, g, &x, &y, one, point, true);
      tp_vector_neg(pull);
      arb_clear(one);
    }
  }
}

/* The cohesion of a facet of which a point of its line stays closed: fixed, or, where that point
 * sticks, with that of all other facets of the line. */
static tp_motion_outcome add_shear(gathering *g, const tp_capacity *own, long closed) {
  tp_strength *s = g->strength;
  const tp_cones *cones = g->q->cones;
  const int slip = tp_closed_slip_in(g->n, g->twists, g->mode, closed);
  if (slip == TP_OPEN_SIGN) return TP_MOTION_OPEN;
  if (arb_is_zero(own->shear)) return TP_MOTION_PROVEN;
  tp_vector force;
  tp_vector_init(&force);
  const arb_struct x = tp_cones_x(cones, own->point), y = tp_cones_y(cones, own->point);
  set_force(&force, g, &x, &y, own->shear, own->point, false);
  tp_motion_outcome done = TP_MOTION_PROVEN;
  if (slip != 0) {
    add_cohesion(g, &force, slip > 0);
  } else {
    long at = 0;
    while (at < s->free_count && s->sticks[at] != closed) at++;
    if (at == TP_STRENGTH_FREE) {
      done = TP_MOTION_TOO_DEAR;
    } else {
      if (at == s->free_count) begin_free(s, closed);
      for (int k = 0; k < 3; k++) {
        arb_add(s->free[at].of + k, s->free[at].of + k, force.of + k, g->q->judge.bits);
      }
    }
  }
  tp_vector_clear(&force);
  return done;
}

/* The first edge of a mode on the facet's line, or -1. */
static tp_motion_outcome find_edge(long *edge, const gathering *g, const tp_capacity *own) {
  *edge = -1;
  for (long k = 0; k < g->mode->edge_count && *edge < 0; k++) {
    const int shared = tp_normals_share_line(g->n, g->mode->edges[k].point, own->point);
    if (shared == TP_OPEN_SIGN) return TP_MOTION_OPEN;
    if (shared == 1) *edge = k;
  }
  return TP_MOTION_PROVEN;
}

static void add_bond(tp_vector *sum, const gathering *g, const tp_capacity *own) {
  if (arb_is_zero(own->pull)) return;
  tp_vector pull;
  tp_vector_init(&pull);
  set_pull(&pull, g, own, own->pull);
  for (int k = 0; k < 3; k++) arb_add(sum->of + k, sum->of + k, pull.of + k, g->q->judge.bits);
  tp_vector_clear(&pull);
}

void tp_strength_add_pull(arb_t sum, const arb_t factor, const tp_motion_question *q, long point) {
  fmpz_t steps;
  fmpz_init(steps);
  fmpz_gcd(steps, q->cones->tx + point, q->cones->ty + point);
  arb_addmul_fmpz(sum, factor, steps, q->judge.bits);
  fmpz_clear(steps);
}

/* What slides shears the facets along it, and opens all others. */
static tp_motion_outcome add_slide(gathering *g) {
  const tp_cones *strong = g->q->strong;
  const long sliding = g->twists->rays[g->mode->rays[0]].axis;
  bool bonds = false;
  tp_motion_outcome done = TP_MOTION_PROVEN;
  for (long k = 0; k < strong->capacity_count && done == TP_MOTION_PROVEN; k++) {
    const tp_capacity *own = strong->capacities + k;
    bonds = bonds || !arb_is_zero(own->pull);
    if (g->n->families[g->n->family_of[own->point]].axis == sliding) {
      tp_strength_add_pull(g->strength->most_pull, own->pull, g->q, own->point);
      done = add_shear(g, own, own->point);
    } else {
      add_bond(&g->strength->bond, g, own);
    }
  }
  if (done == TP_MOTION_PROVEN && bonds) add_slide_pulls(g);
  return done;
}

/* Of what turns all facets open but for closed points, each of which is one of the edges': those on
 * the line of an edge and of none before it are sheared. */
static tp_motion_outcome add_turn(gathering *g) {
  const tp_normals *n = g->n;
  tp_motion_outcome done = TP_MOTION_PROVEN;
  for (int k = 0; k < 3; k++) arb_set(g->strength->bond.of + k, g->strength->bonds.of + k);
  for (long e = 0; e < g->mode->edge_count && done == TP_MOTION_PROVEN; e++) {
    long ends[2], edge = -1;
    tp_normals_of_family(ends, n, n->family_of[g->mode->edges[e].point]);
    if (!tp_work_spend(g->q->work, 2, ends[1] - ends[0], g->q->judge.bits)) {
      return TP_MOTION_TOO_DEAR;
    }
    for (long k = ends[0]; k < ends[1] && done == TP_MOTION_PROVEN; k++) {
      const long capacity = g->strength->capacity_of[n->order[k]];
      if (capacity < 0) continue;
      const tp_capacity *own = g->q->strong->capacities + capacity;
      done = find_edge(&edge, g, own);
      if (done == TP_MOTION_PROVEN && edge == e) {
        done = add_shear(g, own, g->mode->edges[e].point);
      }
    }
  }
  return done;
}

/* What all modes share, once. */
static bool prepare(gathering *g) {
  tp_strength *s = g->strength;
  if (s->capacity_of != NULL) return true;
  s->capacity_of = malloc((size_t)(g->q->cones->count + 1) * sizeof *s->capacity_of);
  if (s->capacity_of == NULL) return false;
  for (long k = 0; k < g->q->cones->count; k++) s->capacity_of[k] = -1;
  for (long k = 0; k < g->q->strong->capacity_count; k++) {
    const tp_capacity *own = g->q->strong->capacities + k;
    s->capacity_of[own->point] = k;
    add_bond(&s->bonds, g, own);
  }
  return true;
}

tp_motion_outcome tp_strength_find(tp_strength *s, const tp_motion_question *q, const tp_normals *n,
                                   const tp_twists *twists, const tp_mode *mode) {
  gathering g = {.strength = s, .q = q, .n = n, .twists = twists, .mode = mode};
  s->free_count = s->pull_count = 0;
  tp_vector *parts[] = {&s->fixed, &s->cohesion, &s->bond};
  for (int k = 0; k < 9; k++) arb_zero(parts[k / 3]->of + k % 3);
  arb_zero(s->most_pull);
  if (!prepare(&g)) return TP_MOTION_OUT_OF_MEMORY;
  tp_motion_outcome done = TP_MOTION_TOO_DEAR;
  if (!tp_mode_slides(mode, twists)) {
    done = add_turn(&g);
  } else if (tp_work_spend(q->work, 2, q->strong->capacity_count, q->judge.bits)) {
    done = add_slide(&g);
  }
  for (int k = 0; k < 3; k++) {
    arb_add(s->fixed.of + k, s->cohesion.of + k, s->bond.of + k, q->judge.bits);
  }
  return done;
}
