/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "stability/loaded.h"

#include "number/ball.h"
#include "stability/effects.h"

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

static void set_contact_end(arb_t x, arb_t y, const tp_evaluation *e, long k, bool mirrored) {
  const tp_lattice *l = &e->problem->lattice;
  const long point = e->problem->contact.points[k].point;
  arb_set_fmpz(x, l->x + point);
  arb_set_fmpz(y, l->y + point);
  to_metres(x, l->origin_x, e);
  to_metres(y, l->origin_y, e);
  if (mirrored) arb_neg(x, x);
}

static void fill_setting(tp_load_setting *s, const tp_evaluation *e) {
  const tp_problem *problem = e->problem;
  const tp_lattice *l = &problem->lattice;
  const arb_struct *sums = e->moments.weighted;
  const long bits = e->rung.bits, last = problem->contact.point_count - 1;
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
  set_contact_end(s->toe_x, s->toe_y, e, s->mirrored ? last : 0, s->mirrored);
  set_contact_end(s->heel_x, s->heel_y, e, s->mirrored ? 0 : last, s->mirrored);
}

/* acos(height / face), the face reaching from the heel to the top of the block. */
static void set_limit(arb_t limit, const tp_load_setting *s, const tp_evaluation *e) {
  const tp_water_description *water = &e->problem->scene->loads.water;
  const tp_lattice *l = &e->problem->lattice;
  arb_const_pi(limit, s->bits);
  arb_mul_2exp_si(limit, limit, -1);
  if (!water->given || !water->stays_level) return;
  long top = 0;
  for (long k = 1; k < l->start[1]; k++) {
    if (fmpz_cmp(l->y + k, l->y + top) > 0) top = k;
  }
  arb_t face, height;
  arb_init(face);
  arb_init(height);
  arb_set_fmpz(face, l->y + top);
  to_metres(face, l->origin_y, e);
  arb_sub(face, face, s->heel_y, s->bits);
  tp_load_metres(height, water->height.value, s);
  arb_div(face, height, face, s->bits);
  arb_acos(face, face, s->bits);
  if (arb_is_finite(face)) arb_set(limit, face);
  arb_clear(face);
  arb_clear(height);
}

bool tp_loaded_init(tp_loaded *loaded, const tp_evaluation *e, tp_direction towards,
                    tp_solution *solution) {
  const tp_scene *scene = e->problem->scene;
  const double began = tp_effects_now();
  *loaded = (tp_loaded){.mirrored = towards == TP_TOWARDS_RIGHT};
  loaded->items = calloc((size_t)tp_loads_count(&scene->loads), sizeof *loaded->items);
  if (loaded->items == NULL) return false;
  loaded->count = tp_loads_count(&scene->loads);
  for (long k = 0; k < loaded->count; k++) tp_wrench_init(&loaded->items[k].wrench);
  tp_wrench_init(&loaded->sum);
  arb_init(loaded->limit);
  tp_load_setting setting;
  tp_load_setting_init(&setting, scene, loaded->mirrored, e->rung.bits);
  fill_setting(&setting, e);
  tp_loads_evaluate(loaded->items, &setting);
  set_limit(loaded->limit, &setting, e);
  tp_load_setting_clear(&setting);
  for (long k = 0; k < loaded->count; k++) {
    const tp_load *own = loaded->items + k;
    tp_trig_add(&loaded->sum.x, &own->wrench.x, e->rung.bits);
    tp_trig_add(&loaded->sum.y, &own->wrench.y, e->rung.bits);
    tp_trig_add(&loaded->sum.moment, &own->wrench.moment, e->rung.bits);
    if (own->kind == TP_LOAD_WEIGHT) continue;
    tp_effects_note(solution, tp_load_name(own->kind), own->place, "", began);
  }
  return true;
}

void tp_loaded_clear(tp_loaded *loaded) {
  for (long k = 0; k < loaded->count; k++) tp_wrench_clear(&loaded->items[k].wrench);
  free(loaded->items);
  tp_wrench_clear(&loaded->sum);
  arb_clear(loaded->limit);
}

void tp_loaded_axis(arb_t x, arb_t y, const tp_loaded *loaded, const tp_evaluation *e, long point) {
  const tp_lattice *l = &e->problem->lattice;
  tp_evaluation_axis(x, y, e, point, loaded->mirrored ? TP_TOWARDS_RIGHT : TP_TOWARDS_LEFT);
  to_metres(x, l->origin_x, e);
  to_metres(y, l->origin_y, e);
  if (loaded->mirrored) arb_neg(x, x);
}

/* The moment of a tensile bond on a facet that opens as the block turns about the axis, overturning
 * or back: strength times thickness times the distance along the facet, summed over its length. */
static void facet_bond(arb_t sum, const tp_facet *f, const arb_t px, const arb_t py, bool back,
                       const tp_loaded *loaded, const tp_evaluation *e) {
  const tp_lattice *l = &e->problem->lattice;
  const long bits = e->rung.bits;
  arb_t x[2], y[2], dot, part;
  arb_init(dot);
  arb_init(part);
  for (int k = 0; k < 2; k++) {
    const long end = (k == 0) != loaded->mirrored ? f->q0 : f->q1;
    arb_init(x[k]);
    arb_init(y[k]);
    arb_set_fmpz(x[k], l->x + end);
    arb_set_fmpz(y[k], l->y + end);
    to_metres(x[k], l->origin_x, e);
    to_metres(y[k], l->origin_y, e);
    if (loaded->mirrored) arb_neg(x[k], x[k]);
  }
  /* (middle - P) . (q1 - q0): the mean distance times the length */
  arb_add(part, x[0], x[1], bits);
  arb_mul_2exp_si(part, part, -1);
  arb_sub(part, part, px, bits);
  arb_sub(dot, x[1], x[0], bits);
  arb_mul(dot, dot, part, bits);
  arb_add(part, y[0], y[1], bits);
  arb_mul_2exp_si(part, part, -1);
  arb_sub(part, part, py, bits);
  arb_sub(y[1], y[1], y[0], bits);
  arb_addmul(dot, part, y[1], bits);
  if (back) arb_neg(dot, dot);
  if (!arb_is_nonpositive(dot)) arb_add(sum, sum, dot, bits);
  for (int k = 0; k < 2; k++) {
    arb_clear(x[k]);
    arb_clear(y[k]);
  }
  arb_clear(dot);
  arb_clear(part);
}

/* The moment of the bond about an axis, positive, in N m. */
static void bond(arb_t moment, const arb_t px, const arb_t py, bool back, const tp_loaded *loaded,
                 const tp_evaluation *e) {
  const tp_problem *problem = e->problem;
  arb_zero(moment);
  if (!problem->scene->loads.bond_kpa.given) return;
  for (long k = 0; k < problem->contact.facet_count; k++) {
    facet_bond(moment, problem->contact.facets + k, px, py, back, loaded, e);
  }
  fmpq_t factor;
  fmpq_init(factor);
  tp_problem_thickness(factor, problem);
  fmpq_mul(factor, factor, problem->scene->loads.bond_kpa.value);
  fmpq_mul_ui(factor, factor, 1000);
  mul_fmpq(moment, factor, e->rung.bits);
  fmpq_clear(factor);
}

void tp_loaded_moment(tp_trig *moment, const tp_loaded *loaded, const tp_evaluation *e,
                      long point) {
  arb_t x, y, held;
  arb_init(x);
  arb_init(y);
  arb_init(held);
  tp_loaded_axis(x, y, loaded, e, point);
  tp_wrench_moment(moment, &loaded->sum, x, y, e->rung.bits);
  bond(held, x, y, false, loaded, e);
  arb_sub(moment->of + TP_ONE, moment->of + TP_ONE, held, e->rung.bits);
  arb_clear(x);
  arb_clear(y);
  arb_clear(held);
}

void tp_loaded_critical(arb_t degrees, tp_roots *roots, const tp_loaded *loaded, tp_evaluation *e,
                        long point) {
  tp_trig moment;
  arb_t level, sine, cosine;
  tp_trig_init(&moment);
  arb_init(level);
  arb_init(sine);
  arb_init(cosine);
  tp_loaded_moment(&moment, loaded, e, point);
  tp_roots_find(roots, &moment, loaded->limit, e->rung.bits);
  arb_one(cosine);
  tp_trig_evaluate(level, &moment, sine, cosine, e->rung.bits);
  bool always = false;
  if (!tp_roots_critical(degrees, &always, roots, level)) arb_set_si(degrees, always ? -180 : 180);
  if (!roots->certain) e->certain = false;
  tp_trig_clear(&moment);
  arb_clear(level);
  arb_clear(sine);
  arb_clear(cosine);
}

/* Sums of what stabilises and what overturns, both positive. */
typedef struct balance {
  arb_t stabilising, overturning;
  tp_evaluation *evaluation;
  tp_case *account; /* NULL: none is drawn up */
} balance;

static void add_to(balance *b, const char *name, tp_place place, const arb_t moment,
                   tp_load_side side) {
  const long bits = b->evaluation->rung.bits;
  if (side == TP_STABILISES) {
    arb_sub(b->stabilising, b->stabilising, moment, bits);
  } else {
    arb_add(b->overturning, b->overturning, moment, bits);
  }
  if (b->account == NULL) return;
  tp_load_result *own = b->account->loads + b->account->load_count++;
  *own = (tp_load_result){.name = name, .side = side};
  own->moment_nm = tp_ball_bounded(moment);
  tp_place_text(own->called_for_by, sizeof own->called_for_by, place);
}

static tp_load_side side_of(const arb_t moment, bool active, bool passive) {
  const bool overturns = arf_sgn(arb_midref(moment)) > 0;
  if (active) return overturns ? TP_OVERTURNS : TP_LESSENS_OVERTURNING;
  (void)passive; /* by its sign, like any other */
  return overturns ? TP_OVERTURNS : TP_STABILISES;
}

/* The weight by its two components, as in Eq. (2); then each load; then the bond. */
static void weigh(balance *b, const tp_loaded *loaded, long point, const arb_t sine,
                  const arb_t cosine) {
  tp_evaluation *e = b->evaluation;
  const long bits = e->rung.bits;
  tp_trig about, part;
  arb_t x, y, moment;
  tp_trig_init(&about);
  tp_trig_init(&part);
  arb_init(x);
  arb_init(y);
  arb_init(moment);
  tp_loaded_axis(x, y, loaded, e, point);
  for (long k = 0; k < loaded->count; k++) {
    const tp_load *own = loaded->items + k;
    tp_wrench_moment(&about, &own->wrench, x, y, bits);
    if (own->kind == TP_LOAD_WEIGHT) {
      arb_mul(moment, about.of + TP_COS, cosine, bits);
      add_to(b, "weight, normal", own->place, moment, side_of(moment, false, false));
      arb_mul(moment, about.of + TP_SIN, sine, bits);
      add_to(b, "weight, parallel", own->place, moment, side_of(moment, false, false));
      continue;
    }
    tp_trig_evaluate(moment, &about, sine, cosine, bits);
    add_to(b, tp_load_name(own->kind), own->place, moment,
           side_of(moment, own->active, own->passive));
  }
  if (e->problem->scene->loads.bond_kpa.given) {
    bond(moment, x, y, false, loaded, e);
    arb_neg(moment, moment);
    add_to(b, "bond", e->problem->scene->loads.bond_kpa.place, moment, TP_STABILISES);
  }
  tp_trig_clear(&about);
  tp_trig_clear(&part);
  arb_clear(x);
  arb_clear(y);
  arb_clear(moment);
}

static void balance_at(balance *b, const tp_loaded *loaded, tp_evaluation *e, long point) {
  arb_t sine, cosine;
  arb_init(sine);
  arb_init(cosine);
  arb_init(b->stabilising);
  arb_init(b->overturning);
  b->evaluation = e;
  tp_ball_sin_cos_degrees(sine, cosine, e->problem->scene->tilt_angle_deg.value, e->rung.bits);
  weigh(b, loaded, point, sine, cosine);
  arb_clear(sine);
  arb_clear(cosine);
}

static void balance_clear(balance *b) {
  arb_clear(b->stabilising);
  arb_clear(b->overturning);
}

void tp_loaded_pivot(tp_pivot *pivot, const tp_loaded *loaded, tp_evaluation *e, long point,
                     const arb_t degrees, const tp_roots *roots) {
  pivot->never = arb_equal_si(degrees, 180) != 0;
  pivot->always = arb_equal_si(degrees, -180) != 0;
  pivot->limit_count = 0;
  for (long k = 0; k < roots->count; k++) {
    if (arf_sgn(arb_midref(roots->degrees + k)) <= 0) continue;
    pivot->limits_deg[pivot->limit_count++] = tp_evaluation_result(e, roots->degrees + k);
  }
  pivot->fos_elements = (tp_fos){.state = TP_FOS_NOT_ASKED};
  pivot->fos_resultant = (tp_fos){.state = TP_FOS_NO_TILT};
  if (!e->problem->scene->tilt_angle_deg.given) return;
  balance b = {.account = NULL};
  balance_at(&b, loaded, e, point);
  pivot->fos_resultant.state = TP_FOS_NO_OVERTURNING;
  if (arb_is_positive(b.overturning)) {
    arb_div(b.stabilising, b.stabilising, b.overturning, e->rung.bits);
    pivot->fos_resultant.state = TP_FOS_NUMBER;
    pivot->fos_resultant.value = tp_evaluation_result(e, b.stabilising);
  } else if (!arb_is_nonpositive(b.overturning)) {
    e->certain = false;
  }
  balance_clear(&b);
}

long tp_loaded_account_count(const tp_scene *scene) {
  return tp_loads_count(&scene->loads) + 2; /* the weight twice, and the bond */
}

void tp_loaded_account(tp_case *result, const tp_loaded *loaded, tp_evaluation *e) {
  result->load_count = 0;
  if (!result->has_governing || !e->problem->scene->tilt_angle_deg.given) return;
  balance b = {.account = result};
  balance_at(&b, loaded, e, e->problem->contact.points[result->governing].point);
  balance_clear(&b);
}

/* The moment about a contact point at a tilt, the bond holding back against turning up-dip. */
static void moment_back(arb_t value, const tp_loaded *loaded, const tp_evaluation *e, long point,
                        const arb_t sine, const arb_t cosine) {
  tp_trig moment;
  arb_t x, y, held;
  tp_trig_init(&moment);
  arb_init(x);
  arb_init(y);
  arb_init(held);
  tp_loaded_axis(x, y, loaded, e, point);
  tp_wrench_moment(&moment, &loaded->sum, x, y, e->rung.bits);
  tp_trig_evaluate(value, &moment, sine, cosine, e->rung.bits);
  bond(held, x, y, true, loaded, e);
  arb_add(value, value, held, e->rung.bits);
  tp_trig_clear(&moment);
  arb_clear(x);
  arb_clear(y);
  arb_clear(held);
}

bool tp_loaded_falls_backwards(const tp_loaded *loaded, tp_evaluation *e, const bool *admissible) {
  const tp_problem *problem = e->problem;
  arb_t sine, cosine, value;
  arb_init(sine);
  arb_init(cosine);
  arb_init(value);
  tp_ball_sin_cos_degrees(sine, cosine, problem->scene->tilt_angle_deg.value, e->rung.bits);
  bool falls = false;
  for (long k = 0; k < problem->contact.point_count && !falls; k++) {
    if (!admissible[k]) continue;
    moment_back(value, loaded, e, problem->contact.points[k].point, sine, cosine);
    falls = arb_is_negative(value);
    if (!falls && !arb_is_positive(value)) e->certain = false;
  }
  arb_clear(sine);
  arb_clear(cosine);
  arb_clear(value);
  return falls;
}
