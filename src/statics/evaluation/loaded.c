/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sum of the wrenches of all loads, critical angle about a pivot as the first zero of the moment,
 * range of tilts under level water, and the check for water above the block's top
 * (docs/mechanics.md section 5). */

#include "evaluation/loaded.h"

#include "common/clock.h"
#include "load/zeros.h"
#include "number/ball.h"

#include <stdlib.h>
#include <string.h>

static void mul_fmpq(arb_t value, const fmpq_t factor, long bits) {
  arb_mul_fmpz(value, value, fmpq_numref(factor), bits);
  arb_div_fmpz(value, value, fmpq_denref(factor), bits);
}

/* A coordinate of the lattice in metres. */
static void to_metres(arb_t value, const fmpz_t origin, const tp_evaluation *e) {
  arb_add_fmpz(value, value, origin, e->rung.bits);
  mul_fmpq(value, e->problem->lattice.step_m, e->rung.bits);
}

static void set_joint_end(arb_t x, arb_t y, const tp_evaluation *e, int side, bool mirrored) {
  const tp_base_joint *joint = &e->problem->joint;
  arb_set_fmpq(x, joint->x + side, e->rung.bits);
  arb_set_fmpq(y, joint->y + side, e->rung.bits);
  if (mirrored) arb_neg(x, x);
}

static void fill_setting(tp_load_setting *s, const tp_evaluation *e) {
  const tp_problem *problem = e->problem;
  const tp_lattice *l = &problem->lattice;
  const arb_struct *sums = e->moments.weighted;
  const long bits = e->rung.bits;
  fmpq_t factor;
  fmpq_init(factor);
  tp_problem_weight_factor(factor, problem);
  arb_set(s->weight, sums + TP_A2);
  mul_fmpq(s->weight, factor, bits);
  tp_problem_thickness(factor, problem);
  arb_set_fmpq(s->thickness, factor, bits);
  fmpq_clear(factor);
  arb_div(s->x, sums + TP_X6, sums + TP_A2, bits);
  arb_div_ui(s->x, s->x, 3, bits);
  to_metres(s->x, l->origin_x, e);
  if (s->mirrored) arb_neg(s->x, s->x);
  arb_div(s->y, sums + TP_Y6, sums + TP_A2, bits);
  arb_div_ui(s->y, s->y, 3, bits);
  to_metres(s->y, l->origin_y, e);
  if (tp_problem_has_wetted(problem)) s->wetted = problem->wetted + (s->mirrored ? 1 : 0);
  if (!problem->scene->loads.water.given) return;
  set_joint_end(s->toe_x, s->toe_y, e, s->mirrored ? 1 : 0, s->mirrored);
  set_joint_end(s->heel_x, s->heel_y, e, s->mirrored ? 0 : 1, s->mirrored);
}

/* How far the table is tilted in search of a limit: to upright, or where 1 / cos grows beyond all
 * bounds to all but a millionth of that. */
static double range_deg(const tp_water_description *water) {
  const bool level = water->given && water->stays_level && !water->lifts_alone &&
                     !fmpq_is_zero(water->height.value);
  return level ? 90 * (1 - 0x1p-20) : 90;
}

void tp_loaded_overtops(tp_case *result, const tp_evaluation *e, tp_certainty *certainty) {
  const tp_water_description *water = &e->problem->scene->loads.water;
  const tp_lattice *l = &e->problem->lattice;
  const int heel = result->towards == TP_TOWARDS_LEFT ? 1 : 0;
  result->water_overtops = water->given && water->stays_level && !water->lifts_alone &&
                           !fmpq_is_zero(water->height.value);
  if (!result->water_overtops) return;
  long top = 0;
  for (long k = 1; k < l->start[1]; k++) {
    if (fmpz_cmp(l->y + k, l->y + top) > 0) top = k;
  }
  fmpq_t face, height;
  arb_t cosine, angle;
  fmpq_init(face);
  fmpq_init(height);
  arb_init(cosine);
  arb_init(angle);
  tp_lattice_metres_y(face, l, l->y + top);
  fmpq_sub(face, face, e->problem->joint.y + heel);
  fmpq_mul(height, water->height.value, e->problem->scene->metres_per_unit);
  fmpq_div(height, height, face); /* the face is as high as the water at least */
  if (!fmpq_is_one(height)) {
    arb_set_fmpq(cosine, height, e->rung.bits);
    arb_acos(angle, cosine, e->rung.bits);
    arb_const_pi(cosine, e->rung.bits);
    arb_mul_ui(angle, angle, 180, e->rung.bits);
    arb_div(angle, angle, cosine, e->rung.bits);
  }
  result->water_overtops_deg = tp_result(e, angle, certainty);
  fmpq_clear(face);
  fmpq_clear(height);
  arb_clear(cosine);
  arb_clear(angle);
}

bool tp_loaded_init(tp_loaded *loaded, const tp_evaluation *e, tp_direction towards) {
  const tp_scene *scene = e->problem->scene;
  *loaded = (tp_loaded){.mirrored = towards == TP_TOWARDS_RIGHT};
  loaded->items = calloc((size_t)tp_loads_count(&scene->loads), sizeof *loaded->items);
  if (loaded->items == NULL) return false;
  loaded->count = tp_loads_count(&scene->loads);
  for (long k = 0; k < loaded->count; k++) tp_wrench_init(&loaded->items[k].wrench);
  tp_wrench_init(&loaded->sum);
  if (!fmpq_is_zero(scene->loads.bond_kpa.value)) {
    loaded->bond = tp_bond_new(e);
    if (loaded->bond == NULL) {
      tp_loaded_clear(loaded);
      return false;
    }
  }
  tp_load_setting setting;
  tp_load_setting_init(&setting, scene, loaded->mirrored, e->rung.bits);
  fill_setting(&setting, e);
  tp_loads_evaluate(loaded->items, &setting);
  loaded->evaluated = tp_clock_now();
  loaded->range_deg = range_deg(&scene->loads.water);
  tp_load_setting_clear(&setting);
  for (long k = 0; k < loaded->count; k++) {
    const tp_load *own = loaded->items + k;
    tp_trig_add(&loaded->sum.x, &own->wrench.x, e->rung.bits);
    tp_trig_add(&loaded->sum.y, &own->wrench.y, e->rung.bits);
    tp_trig_add(&loaded->sum.moment, &own->wrench.moment, e->rung.bits);
  }
  return true;
}

void tp_loaded_clear(tp_loaded *loaded) {
  for (long k = 0; k < loaded->count; k++) tp_wrench_clear(&loaded->items[k].wrench);
  free(loaded->items);
  tp_wrench_clear(&loaded->sum);
  tp_bond_free(loaded->bond);
}

void tp_loaded_metres(arb_t x, arb_t y, const tp_evaluation *e) {
  to_metres(x, e->problem->lattice.origin_x, e);
  to_metres(y, e->problem->lattice.origin_y, e);
}

void tp_loaded_local_metres(arb_t x, arb_t y, const tp_evaluation *e) {
  mul_fmpq(x, e->problem->lattice.step_m, e->rung.bits);
  mul_fmpq(y, e->problem->lattice.step_m, e->rung.bits);
}

void tp_loaded_local(tp_wrench *local, const tp_wrench *loads, const tp_loaded *loaded,
                     const tp_evaluation *e) {
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  tp_loaded_metres(x, y, e);
  if (loaded->mirrored) arb_neg(x, x);
  tp_trig_add(&local->x, &loads->x, e->rung.bits);
  tp_trig_add(&local->y, &loads->y, e->rung.bits);
  tp_wrench_moment(&local->moment, loads, x, y, e->rung.bits);
  arb_clear(x);
  arb_clear(y);
}

void tp_loaded_local_sum(tp_wrench *sum, const tp_loaded *loaded, const tp_evaluation *e) {
  tp_loaded_local(sum, &loaded->sum, loaded, e);
}

void tp_loaded_axis(arb_t x, arb_t y, const tp_loaded *loaded, const tp_evaluation *e, long k) {
  tp_evaluation_axis(x, y, e, k);
  tp_loaded_metres(x, y, e);
  if (loaded->mirrored) arb_neg(x, x);
}

void tp_loaded_bond(arb_t moment, long k, bool back, const tp_loaded *loaded,
                    const tp_evaluation *e) {
  const tp_problem *problem = e->problem;
  arb_zero(moment);
  if (loaded->bond == NULL) return;
  tp_bond_moment(moment, loaded->bond, e, k, loaded->mirrored == back);
  fmpq_t factor;
  fmpq_init(factor);
  tp_problem_thickness(factor, problem);
  fmpq_mul(factor, factor, problem->scene->loads.bond_kpa.value);
  fmpq_mul_ui(factor, factor, TP_KILO);
  fmpq_mul(factor, factor, problem->lattice.step_m);
  fmpq_mul(factor, factor, problem->lattice.step_m);
  mul_fmpq(moment, factor, e->rung.bits);
  fmpq_clear(factor);
}

void tp_loaded_moment(tp_trig *moment, const tp_loaded *loaded, const tp_evaluation *e, long k) {
  arb_t x, y, held;
  arb_init(x);
  arb_init(y);
  arb_init(held);
  tp_loaded_axis(x, y, loaded, e, k);
  tp_wrench_moment(moment, &loaded->sum, x, y, e->rung.bits);
  tp_loaded_bond(held, k, false, loaded, e);
  arb_sub(moment->of + TP_ONE, moment->of + TP_ONE, held, e->rung.bits);
  arb_clear(x);
  arb_clear(y);
  arb_clear(held);
}

void tp_loaded_critical(arb_t degrees, tp_roots *roots, const tp_loaded *loaded,
                        const tp_evaluation *e, long k, tp_certainty *certainty) {
  tp_trig moment;
  arb_t level, sine, cosine;
  tp_trig_init(&moment);
  arb_init(level);
  arb_init(sine);
  arb_init(cosine);
  tp_loaded_moment(&moment, loaded, e, k);
  tp_roots_find(roots, &moment, e->rung.bits);
  arb_one(cosine);
  tp_trig_evaluate(level, &moment, sine, cosine, e->rung.bits);
  bool always = false;
  if (!tp_roots_critical(degrees, &always, roots, level)) arb_set_si(degrees, always ? -180 : 180);
  if (!roots->certain) certainty->open = true;
  tp_trig_clear(&moment);
  arb_clear(level);
  arb_clear(sine);
  arb_clear(cosine);
}
