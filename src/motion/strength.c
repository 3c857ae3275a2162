/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "motion/strength.h"

#include "motion/closed.h"
#include "number/ball.h"

enum { OPEN_SIGN = 2 };

void tp_strength_init(tp_strength *s) {
  tp_vector_init(&s->fixed);
  for (int k = 0; k < TP_STRENGTH_FREE; k++) tp_vector_init(s->free + k);
  for (int k = 0; k < TP_STRENGTH_PULLS; k++) tp_vector_init(s->pulls + k);
  s->free_count = s->pull_count = 0;
}

void tp_strength_clear(tp_strength *s) {
  tp_vector_clear(&s->fixed);
  for (int k = 0; k < TP_STRENGTH_FREE; k++) tp_vector_clear(s->free + k);
  for (int k = 0; k < TP_STRENGTH_PULLS; k++) tp_vector_clear(s->pulls + k);
}

/* One mode at work. */
typedef struct gathering {
  tp_strength *strength;
  const tp_motion_question *q;
  const tp_normals *n;
  const tp_twists *twists;
  const tp_mode *mode;
} gathering;

/* Does the point stay closed in all of the mode? 1, 0, or open. */
static int is_closed(const gathering *g, long point) {
  if (g->mode->ray_count == 0) return 0;
  const tp_normal *line = g->n->items + g->n->normal_of[point];
  for (int k = 0; k < g->mode->ray_count; k++) {
    const tp_ray *ray = g->twists->rays + g->mode->rays[k];
    const int sign = tp_normal_sign(g->n, line, &ray->twist, ray->near, ray->site);
    if (sign != 0) return sign == OPEN_SIGN ? OPEN_SIGN : 0;
  }
  return 1;
}

/* The sense of slip within the mode. */
static int slip_of(const gathering *g, long point) {
  int slip = 0;
  for (int k = 0; k < g->mode->ray_count && slip == 0; k++) {
    slip = tp_closed_slip(g->n, point, g->twists->rays + g->mode->rays[k]);
  }
  return slip;
}

/* A force times a factor at a place of the cones, with its moment about the centroid. */
static void set_force(tp_vector *force, const gathering *g, const arb_t x, const arb_t y,
                      const arb_t factor, long point, bool pull) {
  const tp_motion_question *q = g->q;
  const long bits = q->judge.bits;
  const fmpz *tx = q->cones->tx + point, *ty = q->cones->ty + point;
  arb_t arm;
  arb_init(arm);
  arb_mul_fmpz(force->of, factor, pull ? ty : tx, bits);
  arb_mul_fmpz(force->of + 1, factor, pull ? tx : ty, bits);
  if (pull) arb_neg(force->of + 1, force->of + 1);
  arb_mul(arm, x, q->scale, bits);
  arb_sub(arm, arm, q->x, bits);
  arb_mul(force->of + 2, arm, force->of + 1, bits);
  arb_mul(arm, y, q->scale, bits);
  arb_sub(arm, arm, q->y, bits);
  arb_submul(force->of + 2, arm, force->of, bits);
  arb_clear(arm);
}

static void set_pull(tp_vector *force, const gathering *g, const tp_allowance *own,
                     const arb_t factor) {
  const tp_cones *cones = g->q->cones;
  const long point = own->point, bits = g->q->judge.bits;
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  arb_add(x, cones->x + point, cones->x + point + 1, bits);
  arb_add(y, cones->y + point, cones->y + point + 1, bits);
  arb_mul_2exp_si(x, x, -1);
  arb_mul_2exp_si(y, y, -1);
  set_force(force, g, x, y, factor, point, true);
  arb_clear(x);
  arb_clear(y);
}

static void add_fixed(gathering *g, const tp_vector *force, bool back) {
  for (int k = 0; k < 3; k++) {
    arb_struct *sum = g->strength->fixed.of + k;
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
      tp_vector *pull = s->pulls + s->pull_count++;
      set_force(pull, g, n->cones->x + point, n->cones->y + point, one, point, true);
      tp_vector_neg(pull);
      arb_clear(one);
    }
  }
}

static tp_motion_outcome add_shear(gathering *g, const tp_allowance *own, long closed_end) {
  tp_strength *s = g->strength;
  const tp_cones *cones = g->q->cones;
  const int slip = slip_of(g, closed_end);
  if (slip == OPEN_SIGN) return TP_MOTION_OPEN;
  if (arb_is_zero(own->shear)) return TP_MOTION_PROVEN;
  if (slip == 0) {
    if (s->free_count == TP_STRENGTH_FREE) return TP_MOTION_TOO_DEAR;
    set_force(s->free + s->free_count++, g, cones->x + own->point, cones->y + own->point,
              own->shear, own->point, false);
    return TP_MOTION_PROVEN;
  }
  tp_vector force;
  tp_vector_init(&force);
  set_force(&force, g, cones->x + own->point, cones->y + own->point, own->shear, own->point, false);
  add_fixed(g, &force, slip > 0);
  tp_vector_clear(&force);
  return TP_MOTION_PROVEN;
}

static tp_motion_outcome add_facet(gathering *g, const tp_allowance *own) {
  const int first = is_closed(g, own->point), last = is_closed(g, own->point + 1);
  if (first == OPEN_SIGN || last == OPEN_SIGN) return TP_MOTION_OPEN;
  if ((first == 0 || last == 0) && !arb_is_zero(own->pull)) {
    tp_vector pull;
    tp_vector_init(&pull);
    set_pull(&pull, g, own, own->pull);
    add_fixed(g, &pull, false);
    tp_vector_clear(&pull);
  }
  if (first == 0 && last == 0) return TP_MOTION_PROVEN;
  return add_shear(g, own, own->point + (first == 0 ? 1 : 0));
}

tp_motion_outcome tp_strength_find(tp_strength *s, const tp_motion_question *q, const tp_normals *n,
                                   const tp_twists *twists, const tp_mode *mode) {
  gathering g = {.strength = s, .q = q, .n = n, .twists = twists, .mode = mode};
  const tp_cones *strong = q->strong;
  s->free_count = s->pull_count = 0;
  for (int k = 0; k < 3; k++) arb_zero(s->fixed.of + k);
  if (!tp_work_spend(q->work, 2, strong->allowance_count, q->judge.bits)) return TP_MOTION_TOO_DEAR;
  bool bonds = false;
  tp_motion_outcome done = TP_MOTION_PROVEN;
  for (long k = 0; k < strong->allowance_count && done == TP_MOTION_PROVEN; k++) {
    bonds = bonds || !arb_is_zero(strong->allowances[k].pull);
    done = add_facet(&g, strong->allowances + k);
  }
  const bool slides = mode->ray_count == 1 && twists->rays[mode->rays[0]].axis >= 0;
  if (done == TP_MOTION_PROVEN && slides && bonds) add_slide_pulls(&g);
  return done;
}
