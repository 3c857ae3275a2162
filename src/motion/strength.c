/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "motion/strength.h"

#include "motion/closed.h"
#include "number/ball.h"

#include <math.h>

enum { OPEN_SIGN = 2 };

void tp_strength_init(tp_strength *s) {
  tp_vector_init(&s->fixed);
  tp_vector_init(&s->cohesion);
  tp_vector_init(&s->bond);
  arb_init(s->most_pull);
  for (int k = 0; k < TP_STRENGTH_FREE; k++) tp_vector_init(s->free + k);
  for (int k = 0; k < TP_STRENGTH_PULLS; k++) tp_vector_init(s->pulls + k);
  s->free_count = s->pull_count = 0;
}

void tp_strength_clear(tp_strength *s) {
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

static void begin_free(tp_strength *s, long point) {
  s->sticks[s->free_count] = point;
  for (int k = 0; k < 3; k++) arb_zero(s->free[s->free_count].of + k);
  s->free_count++;
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

/* To `part`, cohesion or bond, and to what is fixed. */
static void add_fixed(gathering *g, tp_vector *part, const tp_vector *force, bool back) {
  const long bits = g->q->judge.bits;
  tp_vector *sums[] = {part, &g->strength->fixed};
  for (int k = 0; k < 6; k++) {
    arb_struct *sum = sums[k / 3]->of + k % 3;
    if (back) {
      arb_sub(sum, sum, force->of + k % 3, bits);
    } else {
      arb_add(sum, sum, force->of + k % 3, bits);
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
      set_force(pull, g, n->cones->x + point, n->cones->y + point, one, point, true);
      tp_vector_neg(pull);
      arb_clear(one);
    }
  }
}

/* The cohesion of a facet of which a point of its line stays closed: fixed, or, where that point
 * sticks, with that of all other facets of the line. */
static tp_motion_outcome add_shear(gathering *g, const tp_allowance *own, long closed) {
  tp_strength *s = g->strength;
  const tp_cones *cones = g->q->cones;
  const int slip = slip_of(g, closed);
  if (slip == OPEN_SIGN) return TP_MOTION_OPEN;
  if (arb_is_zero(own->shear)) return TP_MOTION_PROVEN;
  tp_vector force;
  tp_vector_init(&force);
  set_force(&force, g, cones->x + own->point, cones->y + own->point, own->shear, own->point, false);
  tp_motion_outcome done = TP_MOTION_PROVEN;
  if (slip != 0) {
    add_fixed(g, &s->cohesion, &force, slip > 0);
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

/* Do a point and a facet lie on one straight line, with the same side of it free? 1, 0, or open. */
static int share_line(const gathering *g, long point, long end) {
  const tp_normals *n = g->n;
  const tp_cones *cones = g->q->cones;
  if (n->family_of[point] != n->family_of[end]) return 0;
  if (cones->points[point].facet >= 0 && cones->points[point].facet == cones->points[end].facet) {
    return 1;
  }
  const long bits = n->judge.precision;
  arb_t across, part;
  arb_init(across);
  arb_init(part);
  arb_sub(part, cones->y + end, cones->y + point, bits);
  arb_mul_fmpz(across, part, n->tx + point, bits);
  const double log2_scale =
      fmax(tp_ball_log2_above(cones->y + end), tp_ball_log2_above(cones->x + end)) +
      (double)fmpz_bits(n->tx + point) + (double)fmpz_bits(n->ty + point);
  arb_sub(part, cones->x + end, cones->x + point, bits);
  arb_submul_fmpz(across, part, n->ty + point, bits);
  const int sign = tp_judge_sign(&n->judge, across, log2_scale);
  arb_clear(across);
  arb_clear(part);
  return sign == OPEN_SIGN ? OPEN_SIGN : sign == 0;
}

/* Of a mode that turns, every closed point is one of its edges': the first on the facet's line. */
static tp_motion_outcome add_turning(gathering *g, const tp_allowance *own) {
  for (long k = 0; k < g->mode->edge_count; k++) {
    const int shared = share_line(g, g->mode->edges[k].point, own->point);
    if (shared == OPEN_SIGN) return TP_MOTION_OPEN;
    if (shared == 1) return add_shear(g, own, g->mode->edges[k].point);
  }
  return TP_MOTION_PROVEN;
}

static tp_motion_outcome add_facet(gathering *g, const tp_allowance *own) {
  const long axis = g->n->families[g->n->family_of[own->point]].axis;
  const tp_ray *ray = g->twists->rays + g->mode->rays[0];
  if (g->mode->ray_count == 1 && ray->axis == axis) {
    arb_add(g->strength->most_pull, g->strength->most_pull, own->pull, g->q->judge.bits);
    return add_shear(g, own, own->point);
  }
  if (!arb_is_zero(own->pull)) {
    tp_vector pull;
    tp_vector_init(&pull);
    set_pull(&pull, g, own, own->pull);
    add_fixed(g, &g->strength->bond, &pull, false);
    tp_vector_clear(&pull);
  }
  return add_turning(g, own);
}

tp_motion_outcome tp_strength_find(tp_strength *s, const tp_motion_question *q, const tp_normals *n,
                                   const tp_twists *twists, const tp_mode *mode) {
  gathering g = {.strength = s, .q = q, .n = n, .twists = twists, .mode = mode};
  const tp_cones *strong = q->strong;
  s->free_count = s->pull_count = 0;
  for (int k = 0; k < 3; k++) {
    arb_zero(s->fixed.of + k);
    arb_zero(s->cohesion.of + k);
    arb_zero(s->bond.of + k);
  }
  arb_zero(s->most_pull);
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

/* A slide with bonds is pulled otherwise than a turn that the line's bonds hold. */
static bool is_alone(const tp_motion_question *q, const tp_twists *twists, const tp_mode *mode) {
  const tp_cones *strong = q->strong;
  if (mode->ray_count == 0 || mode->edge_count == 0) return true;
  if (mode->ray_count != 1 || twists->rays[mode->rays[0]].axis < 0) return false;
  for (long k = 0; k < strong->allowance_count; k++) {
    if (!arb_is_zero(strong->allowances[k].pull)) return true;
  }
  return false;
}

tp_motion_outcome tp_strength_number(long *number, const tp_motion_question *q, const tp_normals *n,
                                     const tp_twists *twists, const tp_mode *mode) {
  const gathering g = {.q = q, .n = n, .twists = twists, .mode = mode};
  *number = 0;
  if (is_alone(q, twists, mode)) return TP_MOTION_PROVEN;
  const long first = mode->edges[0].point;
  const bool slides = mode->ray_count == 1 && twists->rays[mode->rays[0]].axis >= 0;
  for (long k = 1; k < mode->edge_count; k++) {
    const int shared = share_line(&g, first, mode->edges[k].point);
    if (shared == OPEN_SIGN) return TP_MOTION_OPEN;
    if (shared == 0) return TP_MOTION_PROVEN;
  }
  long least = first;
  for (long k = 0; k < q->cones->count; k++) { /* the line goes by its first point */
    const int shared = k == first ? 1 : share_line(&g, first, k);
    if (shared == OPEN_SIGN) return TP_MOTION_OPEN;
    if (shared == 1 && k < least) least = k;
    const bool slides_too =
        n->families[n->family_of[k]].axis == n->families[n->family_of[first]].axis;
    if (slides && shared == 0 && slides_too) return TP_MOTION_PROVEN; /* on more lines than one */
  }
  *number = least + 1;
  return TP_MOTION_PROVEN;
}
