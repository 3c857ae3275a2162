/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Normal h of the plane through two generators as their cross product, or in closed form where the
 * generators share a direction, an axis or a contact line; and the side on which a third generator
 * lies. */

#include "motion/bound_plane.h"

#include "motion/newton.h"

int tp_bound_sign(const tp_generators *g, const tp_vector *h, const tp_source *plane, double size,
                  const tp_generator *other) {
  if (tp_generator_is_in_plane(other, plane)) return 0;
  arb_t dot;
  arb_init(dot);
  tp_vector_dot(dot, h, &other->of, g->q->judge.precision);
  const bool asks = tp_judge_asks_scale(&g->q->judge, dot);
  if (asks) size += tp_vector_log2_size(&other->of);
  const int sign = tp_judge_sign(&g->q->judge, dot, size);
  arb_clear(dot);
  return sign;
}

unsigned tp_bound_bit(const tp_generators *g, long generator_index) {
  return g->items[generator_index].is_ray ? 1U << generator_index : 0;
}

void tp_bound_describe(tp_bound *own, const tp_generators *g, long i, long j) {
  const tp_generator *a = g->items + i, *b = g->items + j;
  own->source = tp_generators_source(g, a, b);
  own->rays = tp_bound_bit(g, i) | tp_bound_bit(g, j);
  own->ray_and_edge = own->source.kind == TP_FROM_PAIR && a->is_ray && !b->is_ray && b->axis >= 0;
}

bool tp_bound_sharpen(tp_bound *bound, const tp_generators *g, const tp_generator *a,
                      const tp_generator *b) {
  if (a->is_ray && b->is_ray) {
    tp_newton_normal(&bound->h, g->q, g->n, g->mode->normal);
    return true;
  }
  if (bound->source.kind == TP_FROM_PARALLEL) {
    arb_set(bound->h.of, a->of.of + 1);
    arb_neg(bound->h.of + 1, a->of.of);
    arb_zero(bound->h.of + 2);
    return true;
  }
  if (bound->source.kind != TP_FROM_SITE) return false;
  const tp_cones *cones = g->q->cones;
  const long bits = g->q->judge.precision;
  const arb_struct at_x = tp_cones_x(cones, a->point), at_y = tp_cones_y(cones, a->point);
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  tp_newton_arms(x, y, g->q, &at_x, &at_y, bits);
  tp_ball_turn(bound->h.of, x, y, bits);
  arb_clear(x);
  arb_clear(y);
  return true;
}

static bool runs_along_slide(const tp_bound *bound, const tp_generators *g,
                             const tp_generator *force) {
  return bound->source.kind == TP_FROM_AXIS && g->strength == NULL && !force->is_ray;
}

tp_motion_outcome tp_bound_sharpen_slide(tp_bound *bound, const tp_generators *g,
                                         const tp_generator *ray, const tp_generator *force,
                                         bool below) {
  if (!runs_along_slide(bound, g, force)) return TP_MOTION_PROVEN;
  const int side = tp_judge_sign(&g->q->judge, force->of.of + 2, tp_vector_log2_size(&force->of));
  if (side == TP_OPEN_SIGN) return TP_MOTION_OPEN;
  if (side == 0) return TP_MOTION_PROVEN;
  const bool turned = arb_is_negative(force->of.of + 2) != 0;
  arb_set(bound->h.of, ray->of.of + 1);
  arb_neg(bound->h.of + 1, ray->of.of);
  arb_zero(bound->h.of + 2);
  if (turned != below) tp_vector_neg(&bound->h);
  return TP_MOTION_PROVEN;
}

tp_motion_outcome tp_bound_evaluate(tp_bound *own, tp_generators *g, const tp_twists *twists,
                                    const tp_chosen_planes *chosen, int k) {
  const long i = chosen->first[k], j = chosen->second[k], beside = chosen->beside[k];
  const bool below = chosen->below[k];
  const tp_generator *a = g->items + i, *b = g->items + j;
  (void)tp_generators_evaluate(g, twists, i);
  (void)tp_generators_evaluate(g, twists, j);
  if (tp_bound_sharpen(own, g, a, b)) { /* which may point the other way */
    (void)tp_generators_evaluate(g, twists, beside);
    const double size = g->q->judge.settled ? tp_vector_log2_size(&own->h) : 0;
    const int side = tp_bound_sign(g, &own->h, &own->source, size, g->items + beside);
    if (side != 1 && side != -1) return TP_MOTION_OPEN;
    if (side < 0) tp_vector_neg(&own->h);
    return TP_MOTION_PROVEN;
  }
  if (!runs_along_slide(own, g, b) || arb_contains_zero(b->of.of + 2)) {
    tp_vector_cross(&own->h, &a->of, &b->of, g->q->judge.precision);
    if (below) tp_vector_neg(&own->h);
  }
  return tp_bound_sharpen_slide(own, g, a, b, below);
}
