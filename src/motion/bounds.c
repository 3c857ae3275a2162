/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "motion/bounds.h"

#include "grow.h"
#include "motion/newton.h"

#include <stdlib.h>
#include <string.h>

/* Pairs of them are tried against all others: 64^3 / 2, some 130000 signs a mode. */
enum { MOST_GENERATORS = 64 };

/* One mode at work. */
typedef struct spanning {
  tp_bounds *bounds;
  tp_generators *of;
} spanning;

void tp_bounds_clear(tp_bounds *bounds) {
  for (long k = 0; k < bounds->room; k++) {
    tp_vector_clear(&bounds->items[k].h);
    arb_clear(bounds->items[k].held);
  }
  free(bounds->items);
  tp_generators_clear(&bounds->generators);
  memset(bounds, 0, sizeof *bounds);
}

static tp_bound *add_bound(tp_bounds *bounds) {
  const long before = bounds->room;
  tp_bound *more = tp_grow(bounds->items, bounds->count, &bounds->room, sizeof *more);
  if (more == NULL) return NULL;
  bounds->items = more;
  for (long k = before; k < bounds->room; k++) {
    tp_vector_init(&more[k].h);
    arb_init(more[k].held);
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

static int sign_against(const spanning *s, const tp_vector *h, const tp_source *plane, double size,
                        const tp_generator *other) {
  if (tp_generator_is_in_plane(other, plane)) return 0;
  arb_t dot;
  arb_init(dot);
  tp_vector_dot(dot, h, &other->of, s->of->q->judge.precision);
  const bool asks = tp_judge_asks_scale(&s->of->q->judge, dot);
  if (asks) size += tp_vector_log2_size(&other->of);
  const int sign = tp_judge_sign(&s->of->q->judge, dot, size);
  arb_clear(dot);
  return sign;
}

/* Do two generators point along one line? 1, 0, or open. */
static int is_line(const spanning *s, const tp_vector *cross, double size) {
  int line = 1;
  for (int k = 0; k < 3; k++) {
    const int sign = tp_judge_sign(&s->of->q->judge, cross->of + k, size);
    if (sign == 1 || sign == -1) return 0;
    if (sign == TP_OPEN_SIGN) line = TP_OPEN_SIGN;
  }
  return line;
}

/* The same plane by its point or its direction alone, without the roundings of friction: forces
 * through a point have no moment about it, forces of one direction none across it, and what
 * accelerates along a normal line none along that. False: it stays as it is. */
static bool sharpen(tp_bound *bound, const spanning *s, const tp_generator *a,
                    const tp_generator *b) {
  if (a->is_ray && b->is_ray) {
    tp_newton_normal(&bound->h, s->of->q, s->of->n, s->of->mode->normal);
    return true;
  }
  if (bound->source.kind == TP_FROM_PARALLEL) {
    arb_set(bound->h.of, a->of.of + 1);
    arb_neg(bound->h.of + 1, a->of.of);
    arb_zero(bound->h.of + 2);
    return true;
  }
  if (bound->source.kind != TP_FROM_SITE) return false;
  const tp_cones *cones = s->of->q->cones;
  const long bits = s->of->q->judge.precision;
  arb_mul(bound->h.of, cones->y + a->point, s->of->q->scale, bits);
  arb_sub(bound->h.of, bound->h.of, s->of->q->y, bits);
  arb_mul(bound->h.of + 1, cones->x + a->point, s->of->q->scale, bits);
  arb_sub(bound->h.of + 1, s->of->q->x, bound->h.of + 1, bits);
  arb_one(bound->h.of + 2);
  return true;
}

/* Where the loads have no moment, the plane of a slide and a force meets them along the slide,
 * whatever the force: M r x -e is its moment times (v_y, -v_x), beside a part that does no work. */
static bool runs_along_slide(const tp_bound *bound, const spanning *s, const tp_generator *force) {
  return bound->source.kind == TP_FROM_AXIS && s->of->strength == NULL && !force->is_ray;
}

static tp_motion_outcome sharpen_slide(tp_bound *bound, const spanning *s, const tp_generator *ray,
                                       const tp_generator *force, bool below) {
  if (!runs_along_slide(bound, s, force)) return TP_MOTION_PROVEN;
  const int side =
      tp_judge_sign(&s->of->q->judge, force->of.of + 2, tp_vector_log2_size(&force->of));
  if (side == TP_OPEN_SIGN) return TP_MOTION_OPEN;
  if (side == 0) return TP_MOTION_PROVEN;
  const bool turned = arb_is_negative(force->of.of + 2) != 0;
  arb_set(bound->h.of, ray->of.of + 1);
  arb_neg(bound->h.of + 1, ray->of.of);
  arb_zero(bound->h.of + 2);
  if (turned != below) tp_vector_neg(&bound->h);
  return TP_MOTION_PROVEN;
}

static unsigned bit_of(long generator_index, const spanning *s) {
  return s->of->items[generator_index].is_ray ? 1U << generator_index : 0;
}

/* The plane of two generators, but for h. */
static void describe(tp_bound *own, const spanning *s, long i, long j) {
  const tp_generator *a = s->of->items + i, *b = s->of->items + j;
  own->source = tp_generators_source(s->of, a, b);
  own->rays = bit_of(i, s) | bit_of(j, s);
  own->ray_and_edge = own->source.kind == TP_FROM_PAIR && a->is_ray && !b->is_ray && b->axis >= 0;
}

/* A bound where all others lie on one side. */
static tp_motion_outcome try_pair(spanning *s, bool *solid, long *flat_pair, long i, long j) {
  tp_bound *own = add_bound(s->bounds);
  if (own == NULL) return TP_MOTION_OUT_OF_MEMORY;
  const tp_generator *a = s->of->items + i, *b = s->of->items + j;
  s->bounds->count--;                           /* until it is one */
  const bool settled = s->of->q->judge.settled; /* else no sign asks for its scale */
  double size = settled ? tp_vector_log2_size(&a->of) + tp_vector_log2_size(&b->of) : 0;
  tp_vector_cross(&own->h, &a->of, &b->of, s->of->q->judge.precision);
  const int line = is_line(s, &own->h, size);
  if (line == TP_OPEN_SIGN) return TP_MOTION_OPEN;
  if (line == 1) return TP_MOTION_PROVEN;
  describe(own, s, i, j);
  if (sharpen(own, s, a, b) && settled) size = tp_vector_log2_size(&own->h);
  long above = 0, below = 0;
  for (long k = 0; k < s->of->count; k++) {
    if (k == i || k == j) continue;
    const int sign = sign_against(s, &own->h, &own->source, size, s->of->items + k);
    if (sign == TP_OPEN_SIGN) return TP_MOTION_OPEN;
    above += sign > 0;
    below += sign < 0;
    if (sign == 0) own->rays |= bit_of(k, s);
  }
  *solid = *solid || above > 0 || below > 0;
  if (above == 0 && below == 0 && j < s->of->count) {
    flat_pair[0] = i;
    flat_pair[1] = j;
  }
  if ((above > 0 && below > 0) || (above == 0 && below == 0)) return TP_MOTION_PROVEN;
  if (below > 0) tp_vector_neg(&own->h);
  set_held(own, s->of->strength, &s->of->q->judge);
  s->bounds->count++;
  return sharpen_slide(own, s, a, b, below > 0);
}

/* All of C in the plane of two generators: that plane, from both sides. */
static tp_motion_outcome bound_sides(spanning *s, const long pair[2]) {
  const tp_generator *a = s->of->items + pair[0], *b = s->of->items + pair[1];
  for (int side = 0; side < 2; side++) {
    tp_bound *own = add_bound(s->bounds);
    if (own == NULL) return TP_MOTION_OUT_OF_MEMORY;
    tp_vector_cross(&own->h, &a->of, &b->of, s->of->q->judge.precision);
    if (side == 1) tp_vector_neg(&own->h);
    own->source = tp_generators_source(s->of, a, b);
    if (side == 1 && s->of->free_count > 0) { /* what is free keeps the two apart: another tilt */
      own->source = (tp_source){.kind = TP_FROM_PAIR,
                                .a = a->id > b->id ? a->id : b->id,
                                .b = a->id > b->id ? b->id : a->id};
    }
    own->rays = ~0U;
    set_held(own, s->of->strength, &s->of->q->judge);
  }
  return TP_MOTION_PROVEN;
}

/* Within the plane with normal N the lines of generators with all others on one side, by N x g. */
static tp_motion_outcome bound_flat(spanning *s, const long pair[2]) {
  const tp_generator *a = s->of->items + pair[0], *b = s->of->items + pair[1];
  tp_vector normal;
  tp_vector_init(&normal);
  tp_vector_cross(&normal, &a->of, &b->of, s->of->q->judge.precision);
  const double size = tp_vector_log2_size(&a->of) + tp_vector_log2_size(&b->of);
  tp_motion_outcome done = TP_MOTION_PROVEN;
  for (long g = 0; g < s->of->count && done == TP_MOTION_PROVEN; g++) {
    tp_bound *own = add_bound(s->bounds);
    if (own == NULL) {
      done = TP_MOTION_OUT_OF_MEMORY;
      break;
    }
    s->bounds->count--;
    const tp_source line = {.kind = TP_FROM_PAIR, .a = s->of->items[g].id, .b = s->of->items[g].id};
    tp_vector_cross(&own->h, &normal, &s->of->items[g].of, s->of->q->judge.precision);
    own->source = line;
    own->rays = bit_of(g, s);
    const double log2_line = size + tp_vector_log2_size(&s->of->items[g].of);
    long above = 0, below = 0;
    for (long k = 0; k < s->of->count && done == TP_MOTION_PROVEN; k++) {
      const int sign = k == g ? 0 : sign_against(s, &own->h, &line, log2_line, s->of->items + k);
      if (sign == TP_OPEN_SIGN) done = TP_MOTION_OPEN;
      above += sign > 0;
      below += sign < 0;
      if (sign == 0) own->rays |= bit_of(k, s);
    }
    if ((above > 0) == (below > 0)) continue;
    if (below > 0) tp_vector_neg(&own->h);
    set_held(own, s->of->strength, &s->of->q->judge);
    s->bounds->count++;
  }
  tp_vector_clear(&normal);
  return done;
}

static tp_motion_outcome bound_pairs(spanning *s) {
  bool solid = false;
  long flat_pair[2] = {-1, -1};
  const long all = s->of->count + s->of->free_count;
  if (all > MOST_GENERATORS ||
      !tp_work_spend(s->of->q->work, (double)(all * all) / 8, all, s->of->q->judge.bits)) {
    return TP_MOTION_TOO_DEAR;
  }
  for (long i = 0; i < all; i++) {
    for (long j = i + 1; j < all; j++) {
      const tp_motion_outcome done = try_pair(s, &solid, flat_pair, i, j);
      if (done != TP_MOTION_PROVEN) return done;
    }
  }
  if (!solid && flat_pair[0] < 0) return TP_MOTION_OPEN;
  tp_motion_outcome done = TP_MOTION_PROVEN;
  if (flat_pair[0] >= 0) done = bound_sides(s, flat_pair);
  return done == TP_MOTION_PROVEN && !solid ? bound_flat(s, flat_pair) : done;
}

/* The plane of a pair that is known to be a bound, and on which side of it the others lie. */
static tp_motion_outcome bound_pair(spanning *s, const tp_twists *twists,
                                    const tp_chosen_planes *chosen, int k) {
  const long i = chosen->first[k], j = chosen->second[k], beside = chosen->beside[k];
  const bool below = chosen->below[k];
  tp_bound *own = add_bound(s->bounds);
  if (own == NULL) return TP_MOTION_OUT_OF_MEMORY;
  const tp_generator *a = s->of->items + i, *b = s->of->items + j;
  (void)tp_generators_evaluate(s->of, twists, i);
  (void)tp_generators_evaluate(s->of, twists, j);
  describe(own, s, i, j);
  own->lower = chosen->lower[k];
  if (sharpen(own, s, a, b)) { /* which may point the other way */
    (void)tp_generators_evaluate(s->of, twists, beside);
    const bool settled = s->of->q->judge.settled;
    const double size = settled ? tp_vector_log2_size(&own->h) : 0;
    const int side = sign_against(s, &own->h, &own->source, size, s->of->items + beside);
    if (side != 1 && side != -1) return TP_MOTION_OPEN;
    if (side < 0) tp_vector_neg(&own->h);
    return TP_MOTION_PROVEN;
  }
  if (!runs_along_slide(own, s, b) || arb_contains_zero(b->of.of + 2)) {
    tp_vector_cross(&own->h, &a->of, &b->of, s->of->q->judge.precision);
    if (below) tp_vector_neg(&own->h);
  }
  return sharpen_slide(own, s, a, b, below);
}

static tp_motion_outcome bound_chosen(spanning *s, const tp_twists *twists,
                                      const tp_chosen_planes *chosen) {
  tp_motion_outcome done = TP_MOTION_PROVEN;
  for (int k = 0; k < chosen->count && done == TP_MOTION_PROVEN; k++) {
    done = bound_pair(s, twists, chosen, k);
  }
  return done;
}

/* The interior: h . a >= 0 on a face of K, for a = M^-1 w, times k^2. */
static bool bound_face(tp_bounds *bounds, const tp_motion_question *q, const tp_normals *n,
                       const tp_strength *strength, long normal) {
  tp_bound *own = add_bound(bounds);
  if (own == NULL) return false;
  tp_newton_normal(&own->h, q, n, normal);
  own->source = tp_generators_normal_source(q, n, strength, normal);
  own->rays = ~0U;
  set_held(own, strength, &q->judge);
  return true;
}

static tp_motion_outcome bound_interior(tp_bounds *bounds, const tp_mode_filter *filter,
                                        const tp_motion_question *q, const tp_normals *n,
                                        const tp_twists *twists, const tp_strength *strength) {
  tp_chosen_planes chosen;
  bounds->tilts = tp_mode_filter_interior(&chosen, filter, q, n, twists);
  const bool open = bounds->tilts == TP_TILTS_OPEN;
  bool done = true;
  for (int k = 0; k < chosen.count && !open && done; k++) {
    done = bound_face(bounds, q, n, strength, twists->faces[chosen.first[k]].normal);
    if (done) bounds->items[bounds->count - 1].lower = chosen.lower[k];
  }
  for (long k = 0; k < twists->face_count && open && done; k++) {
    const long normal = twists->faces[k].normal;
    if (k > 0 && normal == twists->faces[k - 1].normal) continue;
    done = bound_face(bounds, q, n, strength, normal);
  }
  return done ? TP_MOTION_PROVEN : TP_MOTION_OUT_OF_MEMORY;
}

tp_motion_outcome tp_bounds_find(tp_bounds *bounds, const tp_mode_filter *filter,
                                 const tp_motion_question *q, const tp_normals *n,
                                 const tp_twists *twists, const tp_mode *mode,
                                 const tp_strength *strength) {
  bounds->count = 0;
  if (mode->ray_count == 0) return bound_interior(bounds, filter, q, n, twists, strength);
  tp_generators *g = &bounds->generators;
  if (!tp_generators_set(g, q, n, twists, mode, strength)) return TP_MOTION_OUT_OF_MEMORY;
  spanning s = {.bounds = bounds, .of = g};
  tp_chosen_planes chosen;
  bounds->tilts = tp_mode_filter_pairs(&chosen, filter, g, twists);
  if (bounds->tilts == TP_TILTS_NONE) return TP_MOTION_PROVEN;
  if (bounds->tilts == TP_TILTS_BETWEEN) return bound_chosen(&s, twists, &chosen);
  tp_generators_evaluate_all(g, twists);
  return bound_pairs(&s);
}
