/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "motion/bounds.h"

#include <stdlib.h>
#include <string.h>

enum { OPEN_SIGN = 2, MOST_GENERATORS = 64 };

typedef struct generator {
  tp_vector of;
  bool is_ray;
  long id;          /* no two have the same */
  long axis;        /* of a force; of a ray that does not turn; else -1 */
  long site, point; /* of a force */
  bool against;
} generator;

/* One mode at work. */
typedef struct spanning {
  tp_bounds *bounds;
  const tp_motion_question *q;
  const tp_normals *n;
  const tp_mode *mode;
  const tp_strength *strength; /* or NULL */
  long count;                  /* of the generators */
  long free_count;             /* of those behind them that may be anything within bounds */
  generator *items;
} spanning;

void tp_bounds_clear(tp_bounds *bounds) {
  for (long k = 0; k < bounds->room; k++) {
    tp_vector_clear(&bounds->items[k].h);
    arb_clear(bounds->items[k].held);
  }
  free(bounds->items);
  memset(bounds, 0, sizeof *bounds);
}

static tp_bound *add_bound(tp_bounds *bounds) {
  if (bounds->count == bounds->room) {
    const long room = 2 * bounds->room + 8;
    tp_bound *more = realloc(bounds->items, (size_t)room * sizeof *more);
    if (more == NULL) return NULL;
    for (long k = bounds->room; k < room; k++) {
      tp_vector_init(&more[k].h);
      arb_init(more[k].held);
    }
    bounds->items = more;
    bounds->room = room;
  }
  arb_zero(bounds->items[bounds->count].held);
  bounds->items[bounds->count].ray_and_edge = false;
  return bounds->items + bounds->count++;
}

/* h . (w + fixed) + sum |h . free| >= 0 */
static void set_held(tp_bound *bound, const tp_strength *s, const tp_judge *judge) {
  if (s == NULL) return;
  arb_t own;
  arb_init(own);
  tp_vector_dot(bound->held, &bound->h, &s->fixed, judge->precision);
  for (long k = 0; k < s->free_count; k++) {
    tp_vector_dot(own, &bound->h, s->free + k, judge->precision);
    arb_abs(own, own);
    arb_add(bound->held, bound->held, own, judge->precision);
  }
  arb_neg(bound->held, bound->held);
  arb_clear(own);
}

/* The centroid moves by (s v_x - theta y, s v_y + theta x). */
void tp_bounds_of_ray(tp_vector *own, const tp_motion_question *q, const tp_ray *ray) {
  const long bits = q->judge.precision;
  const arb_struct *a = ray->twist.of;
  arb_mul(own->of, a, q->scale, bits);
  arb_submul(own->of, a + 2, q->y, bits);
  arb_mul(own->of + 1, a + 1, q->scale, bits);
  arb_addmul(own->of + 1, a + 2, q->x, bits);
  arb_mul(own->of + 2, a + 2, q->gyration, bits);
  if (ray->axis < 0) return;
  arb_zero(own->of + 2);
}

void tp_bounds_of_edge(tp_vector *own, const tp_motion_question *q, const tp_normals *n,
                       const tp_mode_edge *edge) {
  const long bits = q->judge.precision;
  arb_t arm;
  arb_init(arm);
  tp_normals_edge(own, n, edge->point, edge->against);
  arb_mul(arm, q->cones->x + edge->point, q->scale, bits);
  arb_sub(arm, arm, q->x, bits);
  arb_mul(own->of + 2, arm, own->of + 1, bits);
  arb_mul(arm, q->cones->y + edge->point, q->scale, bits);
  arb_sub(arm, arm, q->y, bits);
  arb_submul(own->of + 2, arm, own->of, bits);
  tp_vector_neg(own);
  arb_clear(arm);
}

static void add_ray(spanning *s, const tp_twists *twists, long ray) {
  generator *own = s->items + s->count++;
  const tp_ray *from = twists->rays + ray;
  *own = (generator){.is_ray = true, .id = 2 * s->n->cones->count + ray, .axis = from->axis};
  tp_vector_init(&own->of);
  tp_bounds_of_ray(&own->of, s->q, from);
}

static long axis_of(const tp_normals *n, long point) {
  return n->families[n->family_of[point]].axis;
}

static void add_edge(spanning *s, const tp_mode_edge *edge) {
  generator *own = s->items + s->count++;
  *own = (generator){.id = 2 * s->n->same[edge->point] + edge->against,
                     .axis = axis_of(s->n, edge->point),
                     .site = s->n->cones->points[edge->point].site,
                     .point = edge->point,
                     .against = edge->against};
  tp_vector_init(&own->of);
  tp_bounds_of_edge(&own->of, s->q, s->n, edge);
}

/* What cohesion and bonds add: pulls beside the generators, free forces behind them. */
static void add_strength(spanning *s) {
  const tp_strength *strength = s->strength;
  if (strength == NULL) return;
  for (long k = 0; k < strength->pull_count + strength->free_count; k++) {
    const bool pull = k < strength->pull_count;
    const tp_vector *from = pull ? strength->pulls + k : strength->free + k - strength->pull_count;
    const long point = pull ? strength->pulled[k] : strength->sticks[k - strength->pull_count];
    generator *own = s->items + s->count + s->free_count;
    *own = (generator){
        .id = -2 - k, .axis = -1 - k, .site = s->n->cones->points[point].site, .point = point};
    tp_vector_init(&own->of);
    for (int e = 0; e < 3; e++) arb_set(own->of.of + e, from->of + e);
    *(pull ? &s->count : &s->free_count) += 1;
  }
}

static tp_source source_of(const spanning *s, const generator *a, const generator *b) {
  if (!a->is_ray && !b->is_ray) {
    if (a->site == b->site) return (tp_source){.kind = TP_FROM_SITE, .a = a->site};
    if (a->axis == b->axis && a->against == b->against) {
      return (tp_source){.kind = TP_FROM_PARALLEL, .a = a->axis, .b = a->against};
    }
  } else {
    const generator *ray = a->is_ray ? a : b;
    const long family = a->is_ray && b->is_ray ? s->n->items[s->mode->normal].family : 0;
    if (a->is_ray && b->is_ray) {
      return s->q->through_centroid
                 ? (tp_source){.kind = TP_FROM_AXIS, .a = s->n->families[family].axis}
                 : (tp_source){.kind = TP_FROM_NORMAL, .a = s->mode->normal};
    }
    if (s->q->through_centroid && ray->axis >= 0) {
      return (tp_source){.kind = TP_FROM_AXIS, .a = ray->axis};
    }
  }
  return (tp_source){
      .kind = TP_FROM_PAIR, .a = a->id < b->id ? a->id : b->id, .b = a->id < b->id ? b->id : a->id};
}

/* Does a force lie in the plane by where it comes from? */
static bool is_in_plane(const tp_source *plane, const generator *other) {
  if (other->is_ray) return false;
  if (plane->kind == TP_FROM_SITE) return other->site == plane->a;
  return plane->kind == TP_FROM_PARALLEL && other->axis == plane->a && other->against == plane->b;
}

static int sign_against(const spanning *s, const tp_vector *h, const tp_source *plane, double size,
                        const generator *other) {
  if (is_in_plane(plane, other)) return 0;
  arb_t dot;
  arb_init(dot);
  tp_vector_dot(dot, h, &other->of, s->q->judge.precision);
  const int sign = tp_judge_sign(&s->q->judge, dot, size + tp_vector_log2_size(&other->of));
  arb_clear(dot);
  return sign;
}

/* Do two generators point along one line? 1, 0, or open. */
static int is_line(const spanning *s, const tp_vector *cross, double size) {
  int line = 1;
  for (int k = 0; k < 3; k++) {
    const int sign = tp_judge_sign(&s->q->judge, cross->of + k, size);
    if (sign == 1 || sign == -1) return 0;
    if (sign == OPEN_SIGN) line = OPEN_SIGN;
  }
  return line;
}

/* The same plane by its place or its direction alone, without the roundings of friction: forces
 * through a place have no moment about it, forces of one direction none across it. */
static void sharpen(tp_bound *bound, const spanning *s, const generator *a) {
  if (bound->source.kind == TP_FROM_PARALLEL) {
    arb_set(bound->h.of, a->of.of + 1);
    arb_neg(bound->h.of + 1, a->of.of);
    arb_zero(bound->h.of + 2);
  }
  if (bound->source.kind != TP_FROM_SITE) return;
  const tp_cones *cones = s->q->cones;
  const long bits = s->q->judge.precision;
  arb_mul(bound->h.of, cones->y + a->point, s->q->scale, bits);
  arb_sub(bound->h.of, bound->h.of, s->q->y, bits);
  arb_mul(bound->h.of + 1, cones->x + a->point, s->q->scale, bits);
  arb_sub(bound->h.of + 1, s->q->x, bound->h.of + 1, bits);
  arb_one(bound->h.of + 2);
}

/* Where the loads have no moment, the plane of a slide and a force meets them along the slide,
 * whatever the force: M r x -e is its moment times (v_y, -v_x), beside a part that does no work. */
static tp_motion_outcome sharpen_slide(tp_bound *bound, const spanning *s, const generator *ray,
                                       const generator *force, bool below) {
  if (bound->source.kind != TP_FROM_AXIS || s->strength != NULL || force->is_ray) {
    return TP_MOTION_PROVEN;
  }
  const int side = tp_judge_sign(&s->q->judge, force->of.of + 2, tp_vector_log2_size(&force->of));
  if (side == OPEN_SIGN) return TP_MOTION_OPEN;
  if (side == 0) return TP_MOTION_PROVEN;
  const bool turned = arb_is_negative(force->of.of + 2) != 0;
  arb_set(bound->h.of, ray->of.of + 1);
  arb_neg(bound->h.of + 1, ray->of.of);
  arb_zero(bound->h.of + 2);
  if (turned != below) tp_vector_neg(&bound->h);
  return TP_MOTION_PROVEN;
}

static unsigned bit_of(long generator_index, const spanning *s) {
  return s->items[generator_index].is_ray ? 1U << generator_index : 0;
}

/* The plane of two generators: a bound where all others lie on one side. */
static tp_motion_outcome try_pair(spanning *s, bool *solid, long *flat_pair, long i, long j) {
  tp_bound *own = add_bound(s->bounds);
  if (own == NULL) return TP_MOTION_OUT_OF_MEMORY;
  const generator *a = s->items + i, *b = s->items + j;
  s->bounds->count--; /* until it is one */
  const double size = tp_vector_log2_size(&a->of) + tp_vector_log2_size(&b->of);
  tp_vector_cross(&own->h, &a->of, &b->of, s->q->judge.precision);
  const int line = is_line(s, &own->h, size);
  if (line == OPEN_SIGN) return TP_MOTION_OPEN;
  if (line == 1) return TP_MOTION_PROVEN;
  own->source = source_of(s, a, b);
  own->rays = bit_of(i, s) | bit_of(j, s);
  own->ray_and_edge = own->source.kind == TP_FROM_PAIR && a->is_ray && !b->is_ray && b->axis >= 0;
  sharpen(own, s, a);
  long above = 0, below = 0;
  for (long k = 0; k < s->count; k++) {
    if (k == i || k == j) continue;
    const int sign = sign_against(s, &own->h, &own->source, size, s->items + k);
    if (sign == OPEN_SIGN) return TP_MOTION_OPEN;
    above += sign > 0;
    below += sign < 0;
    if (sign == 0) own->rays |= bit_of(k, s);
  }
  *solid = *solid || above > 0 || below > 0;
  if (above == 0 && below == 0) {
    flat_pair[0] = i;
    flat_pair[1] = j;
  }
  if ((above > 0 && below > 0) || (above == 0 && below == 0)) return TP_MOTION_PROVEN;
  if (below > 0) tp_vector_neg(&own->h);
  set_held(own, s->strength, &s->q->judge);
  s->bounds->count++;
  return sharpen_slide(own, s, a, b, below > 0);
}

/* All of C in the plane with normal N: that plane, from both sides, and within it the lines of
 * generators with all others on one side, by N x g. */
static tp_motion_outcome bound_flat(spanning *s, const long pair[2]) {
  const generator *a = s->items + pair[0], *b = s->items + pair[1];
  const tp_source source = source_of(s, a, b);
  tp_vector normal;
  tp_vector_init(&normal);
  tp_vector_cross(&normal, &a->of, &b->of, s->q->judge.precision);
  const double size = tp_vector_log2_size(&a->of) + tp_vector_log2_size(&b->of);
  tp_motion_outcome done = TP_MOTION_PROVEN;
  for (int side = 0; side < 2 && done == TP_MOTION_PROVEN; side++) {
    tp_bound *own = add_bound(s->bounds);
    if (own == NULL) {
      done = TP_MOTION_OUT_OF_MEMORY;
      break;
    }
    for (int k = 0; k < 3; k++) arb_set(own->h.of + k, normal.of + k);
    if (side == 1) tp_vector_neg(&own->h);
    own->source = source;
    own->rays = ~0U;
    set_held(own, s->strength, &s->q->judge);
  }
  for (long g = 0; g < s->count && done == TP_MOTION_PROVEN; g++) {
    tp_bound *own = add_bound(s->bounds);
    if (own == NULL) {
      done = TP_MOTION_OUT_OF_MEMORY;
      break;
    }
    s->bounds->count--;
    const tp_source line = {.kind = TP_FROM_PAIR, .a = s->items[g].id, .b = s->items[g].id};
    tp_vector_cross(&own->h, &normal, &s->items[g].of, s->q->judge.precision);
    own->source = line;
    own->rays = bit_of(g, s);
    const double log2_line = size + tp_vector_log2_size(&s->items[g].of);
    long above = 0, below = 0;
    for (long k = 0; k < s->count && done == TP_MOTION_PROVEN; k++) {
      const int sign = k == g ? 0 : sign_against(s, &own->h, &line, log2_line, s->items + k);
      if (sign == OPEN_SIGN) done = TP_MOTION_OPEN;
      above += sign > 0;
      below += sign < 0;
      if (sign == 0) own->rays |= bit_of(k, s);
    }
    if ((above > 0) == (below > 0)) continue;
    if (below > 0) tp_vector_neg(&own->h);
    set_held(own, s->strength, &s->q->judge);
    s->bounds->count++;
  }
  tp_vector_clear(&normal);
  return done;
}

static tp_motion_outcome bound_pairs(spanning *s) {
  bool solid = false;
  long flat_pair[2] = {-1, -1};
  const long all = s->count + s->free_count;
  if (all > MOST_GENERATORS ||
      !tp_work_spend(s->q->work, (double)(all * all), all, s->q->judge.bits)) {
    return TP_MOTION_TOO_DEAR;
  }
  for (long i = 0; i < all; i++) {
    for (long j = i + 1; j < all; j++) {
      const tp_motion_outcome done = try_pair(s, &solid, flat_pair, i, j);
      if (done != TP_MOTION_PROVEN) return done;
    }
  }
  if (solid) return TP_MOTION_PROVEN;
  return flat_pair[0] < 0 ? TP_MOTION_OPEN : bound_flat(s, flat_pair);
}

void tp_bounds_of_normal(tp_vector *own, const tp_motion_question *q, const tp_normals *n,
                         long normal) {
  const long bits = q->judge.precision;
  const tp_vector *h = &n->items[normal].h;
  arb_mul(own->of, h->of, q->gyration, bits);
  arb_mul(own->of + 1, h->of + 1, q->gyration, bits);
  arb_mul(own->of + 2, h->of + 2, q->scale, bits); /* s t . q - t . (x, y) */
  arb_submul(own->of + 2, h->of + 1, q->x, bits);
  arb_addmul(own->of + 2, h->of, q->y, bits);
}

/* The interior: h . a >= 0 on every face of K, for a = M^-1 w, times k^2. */
static tp_motion_outcome bound_interior(tp_bounds *bounds, const tp_motion_question *q,
                                        const tp_normals *n, const tp_twists *twists,
                                        const tp_strength *strength) {
  for (long k = 0; k < twists->face_count; k++) {
    const long normal = twists->faces[k].normal;
    if (k > 0 && normal == twists->faces[k - 1].normal) continue;
    tp_bound *own = add_bound(bounds);
    if (own == NULL) return TP_MOTION_OUT_OF_MEMORY;
    tp_bounds_of_normal(&own->h, q, n, normal);
    own->source = q->through_centroid ? (tp_source){.kind = TP_FROM_AXIS,
                                                    .a = n->families[n->items[normal].family].axis}
                                      : (tp_source){.kind = TP_FROM_NORMAL, .a = normal};
    own->rays = ~0U;
    set_held(own, strength, &q->judge);
  }
  return TP_MOTION_PROVEN;
}

tp_motion_outcome tp_bounds_find(tp_bounds *bounds, const tp_motion_question *q,
                                 const tp_normals *n, const tp_twists *twists, const tp_mode *mode,
                                 const tp_strength *strength) {
  bounds->count = 0;
  if (mode->ray_count == 0) return bound_interior(bounds, q, n, twists, strength);
  spanning s = {.bounds = bounds, .q = q, .n = n, .mode = mode, .strength = strength};
  const long more = strength != NULL ? strength->pull_count + strength->free_count : 0;
  s.items = calloc((size_t)(mode->ray_count + mode->edge_count + more), sizeof *s.items);
  if (s.items == NULL) return TP_MOTION_OUT_OF_MEMORY;
  for (int k = 0; k < mode->ray_count; k++) add_ray(&s, twists, mode->rays[k]);
  for (long k = 0; k < mode->edge_count; k++) add_edge(&s, mode->edges + k);
  add_strength(&s);
  const tp_motion_outcome done = bound_pairs(&s);
  for (long k = 0; k < s.count + s.free_count; k++) tp_vector_clear(&s.items[k].of);
  free(s.items);
  return done;
}
