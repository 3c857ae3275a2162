/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Stabilising and overturning moments of all loads about a pivot at the scene's tilt, their factor
 * of safety (docs/mechanics.md section 5), and whether the block topples up-dip. */

#include "evaluation/loaded.h"

#include "evaluation/loaded_exact.h"
#include "number/ball.h"

#include <math.h>
#include <stdlib.h>

/* Sums of what stabilises and what overturns, both positive. */
typedef struct balance {
  arb_t stabilising, overturning;
  const tp_evaluation *evaluation;
  const tp_loaded *loaded;
  long pivot;
  tp_certainty *certainty;
  tp_case *account; /* NULL: none is drawn up */
  bool failed;      /* memory was exhausted */
} balance;

/* A moment whose sign is not known may be on either side: both sums are widened by its size, so
 * that they enclose what the sign would give. */
static void add_to_either(balance *b, const arb_t moment) {
  mag_t size;
  mag_init(size);
  arb_get_mag(size, moment);
  arb_add_error_mag(b->stabilising, size);
  arb_add_error_mag(b->overturning, size);
  mag_clear(size);
}

/* The force that has the moment, where it is one, and its arm. */
static void add_arm(tp_load_result *own, const tp_evaluation *e, const arb_t force,
                    const arb_t moment) {
  if (arb_contains_zero(force)) return;
  arb_t arm;
  arb_init(arm);
  arb_div(arm, moment, force, e->rung.bits);
  own->has_arm = true;
  own->force_n = tp_result_of(e, force);
  own->arm_m = tp_result_of(e, arm);
  arb_clear(arm);
}

/* `force` is zero of what is a moment alone; `told`: the moment where that is not one taken for
 * zero. */
static void add_to(balance *b, const char *name, tp_place place, const arb_t force,
                   const arb_t moment, const arb_t told, tp_load_side side) {
  const long bits = b->evaluation->rung.bits;
  if (arb_contains_zero(moment)) {
    add_to_either(b, moment);
  } else if (side == TP_STABILISES) {
    arb_sub(b->stabilising, b->stabilising, moment, bits);
  } else {
    arb_add(b->overturning, b->overturning, moment, bits);
  }
  if (b->account == NULL) return;
  tp_load_result *own = b->account->loads + b->account->load_count++;
  *own = (tp_load_result){.name = name, .side = side};
  own->moment_nm = tp_result_of(b->evaluation, told);
  add_arm(own, b->evaluation, force, told);
  own->called_for_by = tp_place_new(place);
  if (own->called_for_by == NULL) b->failed = true;
}

/* A load whose line passes through the pivot overturns nothing: asked exactly, and of what is not
 * known so, as arms from rounded corners, by the width of its ball: `told` is zero up to that then.
 */
static void settle_zero(balance *b, arb_t moment, arb_t told, const tp_load *load,
                        tp_load_part part, const arb_t x, const arb_t y) {
  const tp_evaluation *e = b->evaluation;
  arb_set(told, moment);
  if (!arb_contains_zero(moment) || arb_is_zero(moment)) return;
  const double arm = fmax(e->log2_extent, fmax(tp_ball_log2_above(x), tp_ball_log2_above(y)));
  if (tp_loaded_vanishes(load, part, b->loaded, e, b->pivot)) {
    arb_zero(moment);
    arb_zero(told);
  } else if (tp_is_zero_width(e, moment, tp_wrench_force_log2(&load->wrench) + arm)) {
    tp_certainty_take_zero(b->certainty, e);
    mag_t most;
    mag_init(most);
    arb_get_mag(most, moment);
    arb_zero(moment);
    arb_zero(told);
    arb_add_error_mag(told, most);
    mag_clear(most);
  } else {
    b->certainty->open = true;
  }
}

/* By the sign of the moment about the pivot; but what an active load holds back is taken from what
 * overturns. */
static void weigh_load(balance *b, const tp_load *load, tp_load_part part, const char *name,
                       const arb_t force, arb_t moment, const arb_t x, const arb_t y) {
  arb_t told;
  arb_init(told);
  settle_zero(b, moment, told, load, part, x, y);
  const tp_load_side holds = load->active ? TP_LESSENS_OVERTURNING : TP_STABILISES;
  add_to(b, name, load->place, force, moment, told, arb_is_positive(moment) ? TP_OVERTURNS : holds);
  arb_clear(told);
}

/* The size of a force at a tilt. */
static void size_of(arb_t size, const tp_wrench *wrench, const arb_t sine, const arb_t cosine,
                    long bits) {
  arb_t y;
  arb_init(y);
  tp_trig_evaluate(size, &wrench->x, sine, cosine, bits);
  tp_trig_evaluate(y, &wrench->y, sine, cosine, bits);
  arb_hypot(size, size, y, bits);
  arb_clear(y);
}

/* That of what turns with the cosine alone, or the sine. */
static void size_of_part(arb_t size, const tp_wrench *wrench, const arb_t times, int of,
                         long bits) {
  arb_hypot(size, wrench->x.of + of, wrench->y.of + of, bits);
  arb_mul(size, size, times, bits);
}

/* The weight by its two components, as in Eq. (2); then each load; then the bond. */
static void weigh(balance *b, const arb_t sine, const arb_t cosine) {
  const tp_evaluation *e = b->evaluation;
  const tp_loaded *loaded = b->loaded;
  const long bits = e->rung.bits;
  tp_trig about;
  arb_t x, y, moment, force;
  tp_trig_init(&about);
  arb_init(x);
  arb_init(y);
  arb_init(moment);
  arb_init(force);
  tp_loaded_axis(x, y, loaded, e, b->pivot);
  for (long k = 0; k < loaded->count; k++) {
    const tp_load *own = loaded->items + k;
    tp_wrench_moment(&about, &own->wrench, x, y, bits);
    if (own->kind == TP_LOAD_WEIGHT) {
      arb_mul(moment, about.of + TP_COS, cosine, bits);
      size_of_part(force, &own->wrench, cosine, TP_COS, bits);
      weigh_load(b, own, TP_WEIGHT_NORMAL, "weight, normal", force, moment, x, y);
      arb_mul(moment, about.of + TP_SIN, sine, bits);
      size_of_part(force, &own->wrench, sine, TP_SIN, bits);
      weigh_load(b, own, TP_WEIGHT_PARALLEL, "weight, parallel", force, moment, x, y);
      continue;
    }
    tp_trig_evaluate(moment, &about, sine, cosine, bits);
    size_of(force, &own->wrench, sine, cosine, bits);
    weigh_load(b, own, TP_LOAD_WHOLE, tp_load_name(own->kind), force, moment, x, y);
  }
  if (e->problem->scene->loads.bond_kpa.given) {
    tp_loaded_bond(moment, b->pivot, false, loaded, e);
    arb_neg(moment, moment);
    arb_zero(force);
    add_to(b, "bond", e->problem->scene->loads.bond_kpa.place, force, moment, moment,
           TP_STABILISES);
  }
  tp_trig_clear(&about);
  arb_clear(x);
  arb_clear(y);
  arb_clear(moment);
  arb_clear(force);
}

static void balance_at(balance *b, const tp_loaded *loaded, const tp_evaluation *e, long pivot,
                       tp_certainty *certainty) {
  arb_t sine, cosine;
  arb_init(sine);
  arb_init(cosine);
  arb_init(b->stabilising);
  arb_init(b->overturning);
  b->evaluation = e;
  b->loaded = loaded;
  b->pivot = pivot;
  b->certainty = certainty;
  tp_ball_sin_cos_degrees(sine, cosine, e->problem->scene->tilt_angle_deg.value, e->rung.bits);
  weigh(b, sine, cosine);
  arb_clear(sine);
  arb_clear(cosine);
}

static void balance_clear(balance *b) {
  arb_clear(b->stabilising);
  arb_clear(b->overturning);
}

tp_fos_state tp_loaded_factor(arb_t factor, const tp_loaded *loaded, const tp_evaluation *e, long k,
                              tp_certainty *certainty) {
  if (!e->problem->scene->tilt_angle_deg.given) return TP_FOS_NO_TILT;
  tp_fos_state state = TP_FOS_NO_OVERTURNING;
  balance b = {.account = NULL};
  balance_at(&b, loaded, e, k, certainty);
  if (arb_is_positive(b.overturning)) {
    arb_div(factor, b.stabilising, b.overturning, e->rung.bits);
    state = TP_FOS_NUMBER;
  } else if (!arb_is_nonpositive(b.overturning)) {
    certainty->open = true;
  }
  balance_clear(&b);
  return state;
}

void tp_loaded_pivot(tp_pivot *pivot, const tp_loaded *loaded, const tp_evaluation *e, long point,
                     const arb_t degrees, const tp_roots *roots, tp_certainty *certainty) {
  pivot->never = arb_equal_si(degrees, 180) != 0;
  pivot->always = arb_equal_si(degrees, -180) != 0;
  pivot->limit_count = 0;
  for (long k = 0; k < roots->count; k++) {
    if (!arb_is_positive(roots->degrees + k)) continue;
    pivot->limits_deg[pivot->limit_count++] = tp_result(e, roots->degrees + k, certainty);
  }
  pivot->fos_elements = (tp_fos){.state = TP_FOS_NOT_ASKED};
  arb_t factor;
  arb_init(factor);
  pivot->fos = (tp_fos){.state = tp_loaded_factor(factor, loaded, e, point, certainty)};
  if (pivot->fos.state == TP_FOS_NUMBER) {
    pivot->fos.value = tp_result(e, factor, certainty);
  }
  arb_clear(factor);
}

long tp_loaded_account_count(const tp_scene *scene) {
  return tp_loads_count(&scene->loads) + 2; /* the weight twice, and the bond */
}

void tp_loaded_account_clear(tp_case *result) {
  for (size_t k = 0; k < result->load_count; k++) free(result->loads[k].called_for_by);
  result->load_count = 0;
}

bool tp_loaded_account(tp_case *result, const tp_loaded *loaded, const tp_evaluation *e,
                       tp_certainty *certainty) {
  tp_loaded_account_clear(result);
  if (!result->has_toppling_pivot || !e->problem->scene->tilt_angle_deg.given) return true;
  balance b = {.account = result};
  balance_at(&b, loaded, e, (long)result->pivots[result->toppling_pivot].index, certainty);
  balance_clear(&b);
  return !b.failed;
}

/* The moment about a contact point at a tilt, the bond holding back against turning up-dip. */
static void moment_back(arb_t value, const tp_loaded *loaded, const tp_evaluation *e, long pivot,
                        const arb_t sine, const arb_t cosine) {
  tp_trig moment;
  arb_t x, y, held;
  tp_trig_init(&moment);
  arb_init(x);
  arb_init(y);
  arb_init(held);
  tp_loaded_axis(x, y, loaded, e, pivot);
  tp_wrench_moment(&moment, &loaded->sum, x, y, e->rung.bits);
  tp_trig_evaluate(value, &moment, sine, cosine, e->rung.bits);
  tp_loaded_bond(held, pivot, true, loaded, e);
  arb_add(value, value, held, e->rung.bits);
  tp_trig_clear(&moment);
  arb_clear(x);
  arb_clear(y);
  arb_clear(held);
}

bool tp_loaded_falls_backwards(bool *open, const tp_loaded *loaded, const tp_evaluation *e,
                               const bool *admissible, tp_certainty *certainty) {
  const tp_problem *problem = e->problem;
  arb_t sine, cosine, value;
  arb_init(sine);
  arb_init(cosine);
  arb_init(value);
  tp_ball_sin_cos_degrees(sine, cosine, problem->scene->tilt_angle_deg.value, e->rung.bits);
  bool falls = false, balances = false;
  for (long k = 0; k < problem->contact.point_count && !falls; k++) {
    if (!admissible[k]) continue;
    moment_back(value, loaded, e, k, sine, cosine);
    falls = arb_is_negative(value);
    if (!falls && !arb_is_positive(value)) balances = true;
  }
  *open = balances && !falls;
  if (*open) tp_certainty_leave_open(certainty, e);
  arb_clear(sine);
  arb_clear(cosine);
  arb_clear(value);
  return falls;
}
