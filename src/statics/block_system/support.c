/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Problem: the least force at a point of a block, in a given direction, with which forces within
 * the strength of all joints over a wanted factor hold the blocks as they lie.
 *
 * At a fixed strength the force is linear: with s what is left of it below zero, it is the load of
 * the program of forces (assemblage/force_program.h), and the greatest s that can be held is minus
 * the least support. Both sides are those of the bracket (assemblage/load_bracket.h): forces hold
 * the blocks with so much, and none do with less, to 1e-6 of itself. The unit of s is first above
 * all weights and loads, as no force beyond the unit is looked for, and then about the answer.
 * More than the least may be too much: the support then pushes them up.
 *
 * Cost: two brackets. */

#include "block_system/load_results.h"

#include "block_system/block_faces.h"
#include "block_system/support_onset.h"
#include "block_system/threshold.h"
#include "common/outside.h"
#include "evaluation/certainty.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BITS = 256, ROW = 3 };
static const double newtons = 1000; /* in a kN */

typedef struct supporting {
  const tp_built_system *s;
  const tp_resultant *r;
  tp_near force[ROW]; /* of one unit of force of the assemblage, on the block */
  double divisor;
  tp_system_support *own;
} supporting;

/* A horizontal one that pushes against the side: to the right and down by the tilt, in axes of
 * which the left is lowered. */
static void set_direction(supporting *x, arb_t cosine, arb_t sine) {
  const tp_support_description *d = &x->s->scene->many.support;
  const double straight = 180;
  arb_t degrees;
  arb_init(degrees);
  if (d->direction_deg.given) {
    arb_set_fmpq(degrees, d->direction_deg.value, BITS);
  } else if (x->r->left) {
    arb_neg(degrees, x->r->tilt_deg);
  } else {
    arb_set_d(degrees, straight);
    arb_add(degrees, degrees, x->r->tilt_deg, BITS);
  }
  x->own->direction_deg = tp_ball_bounded(degrees);
  tp_ball_sin_cos(sine, cosine, degrees, BITS);
  arb_clear(degrees);
}

/* From the block's own point, in units of the assemblage. */
static void set_arm(arb_t arm, const fmpq_t at, const fmpq_t own, const tp_built_system *s) {
  fmpq_t metres;
  fmpq_init(metres);
  fmpq_mul(metres, at, s->scene->metres_per_unit);
  fmpq_sub(metres, metres, own);
  fmpq_div(metres, metres, s->assemblage.lattice.step_m);
  arb_set_fmpq(arm, metres, BITS);
  arb_mul_2exp_si(arm, arm, -s->assemblage.length_exponent);
  fmpq_clear(metres);
}

static void set_force(supporting *x) {
  const tp_support_description *d = &x->s->scene->many.support;
  const tp_assemblage *a = &x->s->assemblage;
  const tp_rigid_block *block = a->blocks + d->block;
  fmpq_t own;
  arb_t cosine, sine, arm, moment;
  fmpq_init(own);
  arb_init(cosine);
  arb_init(sine);
  arb_init(arm);
  arb_init(moment);
  set_direction(x, cosine, sine);
  tp_lattice_metres_x(own, &a->lattice, block->x);
  set_arm(arm, d->x.value, own, x->s);
  arb_mul(moment, arm, sine, BITS);
  tp_lattice_metres_y(own, &a->lattice, block->y);
  set_arm(arm, d->y.value, own, x->s);
  arb_submul(moment, arm, cosine, BITS);
  x->force[0] = tp_ball_near_exact(cosine);
  x->force[1] = tp_ball_near_exact(sine);
  x->force[2] = tp_ball_near_exact(moment);
  fmpq_clear(own);
  arb_clear(cosine);
  arb_clear(sine);
  arb_clear(arm);
  arb_clear(moment);
}

static tp_status check(const supporting *x, tp_message *message) {
  const tp_support_description *d = &x->s->scene->many.support;
  const tp_placed_blocks blocks = {
      .scene = x->s->scene, .assemblage = &x->s->assemblage, .sections = x->s->sections};
  const char *name = x->s->given[d->block].name;
  if (x->s->given[d->block].fixed) {
    return tp_refuse(message, TP_FAULT_KEY, d->place,
                     "block '%s' is ground, which needs no support: name one that is free",
                     tp_quote_all(name).text);
  }
  if (tp_block_is_near(&blocks, d->block, d->x.value, d->y.value)) return TP_OK;
  return tp_refuse(message, TP_FAULT_GEOMETRY, d->place,
                   "the support does not act on block '%s': 'at' lies outside it",
                   tp_quote_all(name).text);
}

/* Weights and loads, with the earthquake and all that it does, as they are; the support is s. */
static tp_weight_loads loads_as_they_lie(const supporting *x, const tp_near *push) {
  tp_weight_loads loads = x->r->loads;
  for (int axis = 0; axis < 2; axis++) {
    loads.dead[axis] =
        tp_near_plus(loads.dead[axis], tp_near_times(x->r->target, loads.live[axis]));
    loads.live[axis] = (tp_near){0, 0};
  }
  loads.push = push;
  return loads;
}

/* With a unit of s that is so many of the assemblage's. */
static tp_status find_bracket(tp_load_bracket *b, const supporting *x, double unit,
                              tp_message *message) {
  const tp_assemblage *a = &x->s->assemblage;
  tp_near *push = calloc(ROW * (size_t)a->free_count + 1, sizeof *push);
  if (push == NULL) return tp_fail_memory(message, "the support");
  tp_near *own = push + ROW * a->blocks[x->s->scene->many.support.block].number;
  for (int e = 0; e < ROW; e++) own[e] = tp_near_times(x->force[e], (tp_near){-unit, 0});
  const tp_system_state state = {loads_as_they_lie(x, push), x->divisor};
  const tp_status status = tp_state_limit_find(b, x->s, &state, NULL, message);
  free(push);
  return status;
}

/* Above all weights and loads together by some factor, a power of two. */
static double greatest_unit(const supporting *x) {
  static const int above = 4;
  const tp_assemblage *a = &x->s->assemblage;
  double sum = 1;
  for (long k = 0; k < a->count; k++) {
    if (a->blocks[k].number >= 0) sum += a->blocks[k].weight.value;
  }
  for (long r = 0; r < ROW * a->free_count && x->r->applied != NULL; r++) {
    const tp_applied_load *own = x->r->applied + r;
    sum += fabs(own->steady.value) + fabs(own->down[0].value) + fabs(own->down[1].value);
  }
  return ldexp(1, ilogb(sum) + above);
}

/* A number that is proven on both sides. */
static void set_force_found(const supporting *x, const tp_load_bracket *b, double unit) {
  const double scale = ldexp(newtons * x->r->along_normal, (int)x->s->assemblage.weight_exponent);
  const double most = -b->held * unit * scale, least = -b->bound * unit * scale;
  const double value = least + (most - least) / 2, rounding = 4 * DBL_EPSILON * most;
  x->own->state = TP_SYSTEM_SUPPORT_NUMBER;
  x->own->force_n_m =
      (tp_bounded){.value = value, .error = fmax(most - value, value - least) + rounding};
}

/* The blocks are held with some force below zero, a pull: are they without one, or with none above
 * zero? The greatest force tells, that of the other way. */
static tp_status find_whether_needed(const supporting *x, double unit, tp_message *message) {
  tp_load_bracket b;
  const tp_status status = find_bracket(&b, x, -unit, message);
  if (status != TP_OK) return status;
  if (b.is_held && b.held >= 0) {
    x->own->state = TP_SYSTEM_SUPPORT_NOT_NEEDED;
  } else if (b.is_bounded && b.bound < 0) {
    x->own->state = TP_SYSTEM_SUPPORT_NONE;
  }
  tp_load_bracket_clear(&b);
  return status;
}

/* With a unit near the answer. */
static tp_status find_nearer(const supporting *x, double unit, tp_message *message) {
  tp_load_bracket b;
  const tp_status status = find_bracket(&b, x, unit, message);
  if (status != TP_OK) return status;
  if (b.is_held && b.is_bounded && b.bound < 0) set_force_found(x, &b, unit);
  tp_load_bracket_clear(&b);
  return status;
}

static tp_status find(const supporting *x, tp_message *message) {
  const double unit = greatest_unit(x);
  tp_load_bracket b;
  tp_status status = find_bracket(&b, x, unit, message);
  if (status != TP_OK) return status;
  if (b.is_held && b.held >= 0) {
    status = find_whether_needed(x, unit, message);
  } else if (b.is_bounded && b.bound < -1) {
    x->own->state = TP_SYSTEM_SUPPORT_NONE;
  } else if (b.is_held) {
    status = find_nearer(x, ldexp(1, ilogb(-b.held * unit) + 1), message);
  }
  tp_load_bracket_clear(&b);
  return status;
}

/* Where forces do hold with some force: the greatest one with which they do, within what is looked
 * at. */
static tp_status find_most(double *most, const supporting *x, tp_message *message) {
  const double unit = greatest_unit(x);
  tp_load_bracket b;
  const tp_status status = find_bracket(&b, x, -unit, message);
  if (status != TP_OK) return status;
  *most = b.is_held ? fmin(b.held, 1) * unit : 0;
  tp_load_bracket_clear(&b);
  return TP_OK;
}

tp_status tp_support_onset(tp_system_case *own, const tp_built_system *s, const tp_resultant *r,
                           tp_message *message) {
  tp_system_support *support = &own->support;
  const bool needed = support->state == TP_SYSTEM_SUPPORT_NUMBER;
  if (!own->has_support || r->beyond ||
      (!needed && support->state != TP_SYSTEM_SUPPORT_NOT_NEEDED)) {
    return TP_OK;
  }
  const double wanted = support->fos.value;
  if (own->verdict == TP_SYSTEM_STANDS &&
      (wanted <= 1 || (own->has_standing_fos && own->standing_fos >= wanted))) {
    return TP_OK; /* none is needed */
  }
  supporting x = {.s = s, .r = r, .divisor = wanted, .own = support};
  const double scale = ldexp(newtons * r->along_normal, (int)s->assemblage.weight_exponent);
  set_force(&x);
  tp_near *push = calloc(ROW * (size_t)s->assemblage.free_count + 1, sizeof *push);
  if (push == NULL) return tp_fail_memory(message, "the support");
  for (int e = 0; e < ROW; e++) {
    push[ROW * s->assemblage.blocks[support->block].number + e] = x.force[e];
  }
  tp_support_task task = {.system = s,
                          .resultant = r,
                          .loads = loads_as_they_lie(&x, push),
                          .divisor = x.divisor,
                          .newtons = scale};
  if (needed) {
    task.fails = (support->force_n_m.value - support->force_n_m.error) / scale;
    task.held = (support->force_n_m.value + support->force_n_m.error) / scale;
  }
  if (support->has_goodman_bray) task.by_method = support->goodman_bray_n_m / scale;
  tp_status status = find_most(&task.most, &x, message);
  if (status == TP_OK) status = tp_support_onset_find(support, &task, message);
  free(push);
  return status;
}

tp_status tp_support_find(tp_system_case *own, const tp_built_system *s, const tp_resultant *r,
                          tp_message *message) {
  const tp_support_description *d = &s->scene->many.support;
  if (d->place.file == NULL) return TP_OK;
  supporting x = {.s = s, .r = r, .divisor = 1, .own = &own->support};
  fmpq_t metres;
  fmpq_init(metres);
  own->has_support = true;
  x.own->block = (size_t)d->block;
  x.own->state = TP_SYSTEM_SUPPORT_UNDECIDED;
  fmpq_mul(metres, d->x.value, s->scene->metres_per_unit);
  x.own->x_m = tp_result_rational(metres);
  fmpq_mul(metres, d->y.value, s->scene->metres_per_unit);
  x.own->y_m = tp_result_rational(metres);
  fmpq_one(metres);
  if (d->fos.given || s->scene->required_fos.given) {
    fmpq_set(metres, d->fos.given ? d->fos.value : s->scene->required_fos.value);
  }
  x.own->fos = tp_result_rational(metres);
  x.divisor = x.own->fos.value;
  fmpq_clear(metres);
  tp_status status = check(&x, message);
  if (status != TP_OK || r->beyond) return status;
  set_force(&x);
  return find(&x, message);
}
