/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Facets of a cone of wrenches spanned by generators, by trying the plane of every pair; flat
 * cones, whose generators lie in one plane, are bounded within that plane. */

#include "motion/bounds.h"

#include "common/grow.h"
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
  tp_bound_describe(own, s->of, i, j);
  if (tp_bound_sharpen(own, s->of, a, b) && settled) size = tp_vector_log2_size(&own->h);
  long above = 0, below = 0;
  for (long k = 0; k < s->of->count; k++) {
    if (k == i || k == j) continue;
    const int sign = tp_bound_sign(s->of, &own->h, &own->source, size, s->of->items + k);
    if (sign == TP_OPEN_SIGN) return TP_MOTION_OPEN;
    above += sign > 0;
    below += sign < 0;
    if (sign == 0) own->rays |= tp_bound_bit(s->of, k);
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
  return tp_bound_sharpen_slide(own, s->of, a, b, below > 0);
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
    own->rays = tp_bound_bit(s->of, g);
    const double log2_line = size + tp_vector_log2_size(&s->of->items[g].of);
    long above = 0, below = 0;
    for (long k = 0; k < s->of->count && done == TP_MOTION_PROVEN; k++) {
      const int sign =
          k == g ? 0 : tp_bound_sign(s->of, &own->h, &line, log2_line, s->of->items + k);
      if (sign == TP_OPEN_SIGN) done = TP_MOTION_OPEN;
      above += sign > 0;
      below += sign < 0;
      if (sign == 0) own->rays |= tp_bound_bit(s->of, k);
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

/* The planes that doubles have chosen, but for h: tp_bounds_evaluate. */
static tp_motion_outcome describe_chosen(tp_bounds *bounds, const tp_motion_question *q,
                                         const tp_normals *n, const tp_twists *twists,
                                         const tp_mode *mode) {
  const tp_chosen_planes *chosen = &bounds->chosen;
  for (int k = 0; k < chosen->count; k++) {
    tp_bound *own = add_bound(bounds);
    if (own == NULL) return TP_MOTION_OUT_OF_MEMORY;
    own->lower = chosen->lower[k];
    if (mode->ray_count > 0) {
      tp_bound_describe(own, &bounds->generators, chosen->first[k], chosen->second[k]);
      continue;
    }
    own->rays = ~0U;
    own->source = tp_generators_normal_source(q, n, NULL, twists->faces[chosen->first[k]].normal);
  }
  return TP_MOTION_PROVEN;
}

tp_motion_outcome tp_bounds_evaluate(tp_bounds *bounds, long k, const tp_motion_question *q,
                                     const tp_normals *n, const tp_twists *twists,
                                     const tp_mode *mode) {
  tp_bound *own = bounds->items + k;
  if (mode->ray_count == 0) {
    tp_newton_normal(&own->h, q, n, twists->faces[bounds->chosen.first[k]].normal);
    return TP_MOTION_PROVEN;
  }
  return tp_bound_evaluate(own, &bounds->generators, twists, &bounds->chosen, (int)k);
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
    tp_newton_normal(&own->h, q, n, normal);
    own->source = tp_generators_normal_source(q, n, strength, normal);
    own->rays = ~0U;
    set_held(own, strength, &q->judge);
  }
  return TP_MOTION_PROVEN;
}

tp_motion_outcome tp_bounds_find(tp_bounds *bounds, const tp_mode_filter *filter,
                                 const tp_motion_question *q, const tp_normals *n,
                                 const tp_twists *twists, const tp_mode *mode,
                                 const tp_strength *strength) {
  const bool interior = mode->ray_count == 0;
  tp_generators *g = &bounds->generators;
  bounds->count = 0;
  if (!interior && !tp_generators_set(g, q, n, twists, mode, strength)) {
    return TP_MOTION_OUT_OF_MEMORY;
  }
  bounds->tilts = interior ? tp_mode_filter_interior(&bounds->chosen, filter, q, n, twists)
                           : tp_mode_filter_pairs(&bounds->chosen, filter, g, twists);
  if (bounds->tilts == TP_TILTS_NONE) return TP_MOTION_PROVEN;
  if (bounds->tilts == TP_TILTS_BETWEEN) return describe_chosen(bounds, q, n, twists, mode);
  if (interior) return bound_interior(bounds, q, n, twists, strength);
  tp_generators_evaluate_all(g, twists);
  spanning s = {.bounds = bounds, .of = g};
  return bound_pairs(&s);
}
