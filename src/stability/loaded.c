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
  const tp_loads_description *d = &scene->loads;
  if (d->bond_kpa.given) tp_effects_note(solution, "bond", d->bond_kpa.place, "", began);
  if (d->cohesion_kpa.given)
    tp_effects_note(solution, "cohesion", d->cohesion_kpa.place, "", began);
  return true;
}

void tp_loaded_clear(tp_loaded *loaded) {
  for (long k = 0; k < loaded->count; k++) tp_wrench_clear(&loaded->items[k].wrench);
  free(loaded->items);
  tp_wrench_clear(&loaded->sum);
  arb_clear(loaded->limit);
}

void tp_loaded_metres(arb_t x, arb_t y, const tp_evaluation *e) {
  to_metres(x, e->problem->lattice.origin_x, e);
  to_metres(y, e->problem->lattice.origin_y, e);
}

void tp_loaded_axis(arb_t x, arb_t y, const tp_loaded *loaded, const tp_evaluation *e, long k) {
  tp_evaluation_axis(x, y, e, k);
  tp_loaded_metres(x, y, e);
  if (loaded->mirrored) arb_neg(x, x);
}

/* The moment of a tensile bond on a facet that opens as the block turns about the axis, overturning
 * or back: strength times thickness times the distance along the facet, summed over its length. */
static void facet_bond(arb_t sum, const tp_facet *f, const arb_t px, const arb_t py, bool back,
                       const tp_loaded *loaded, const tp_evaluation *e) {
  const long bits = e->rung.bits;
  arb_t x[2], y[2], dot, part;
  arb_init(dot);
  arb_init(part);
  for (int k = 0; k < 2; k++) {
    const bool begins = (k == 0) != loaded->mirrored;
    arb_init(x[k]);
    arb_init(y[k]);
    tp_evaluation_place(x[k], y[k], e, begins ? tp_facet_begin(f) : tp_facet_end(f));
    tp_loaded_metres(x[k], y[k], e);
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

void tp_loaded_bond(arb_t moment, const arb_t px, const arb_t py, bool back,
                    const tp_loaded *loaded, const tp_evaluation *e) {
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

void tp_loaded_moment(tp_trig *moment, const tp_loaded *loaded, const tp_evaluation *e, long k) {
  arb_t x, y, held;
  arb_init(x);
  arb_init(y);
  arb_init(held);
  tp_loaded_axis(x, y, loaded, e, k);
  tp_wrench_moment(moment, &loaded->sum, x, y, e->rung.bits);
  tp_loaded_bond(held, x, y, false, loaded, e);
  arb_sub(moment->of + TP_ONE, moment->of + TP_ONE, held, e->rung.bits);
  arb_clear(x);
  arb_clear(y);
  arb_clear(held);
}

void tp_loaded_critical(arb_t degrees, tp_roots *roots, const tp_loaded *loaded, tp_evaluation *e,
                        long k) {
  tp_trig moment;
  arb_t level, sine, cosine;
  tp_trig_init(&moment);
  arb_init(level);
  arb_init(sine);
  arb_init(cosine);
  tp_loaded_moment(&moment, loaded, e, k);
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
