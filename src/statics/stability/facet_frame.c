/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Components of a wrench along the direction of motion and normal to the facet, and the cohesion
 * force c times the whole contact area (docs/mechanics.md section 5). */

#include "stability/facet_frame.h"

#include "load/setting.h"
#include "stability/contact_length.h"
#include "stability/friction.h"

/* Cohesion times the length of the contact and the thickness, N. */
static void set_cohesion(arb_t force, const tp_evaluation *e) {
  const tp_problem *problem = e->problem;
  const long bits = e->rung.bits;
  fmpq_t factor;
  fmpq_init(factor);
  tp_contact_length_in_balls(force, e);
  tp_problem_thickness(factor, problem);
  fmpq_mul(factor, factor, problem->lattice.step_m);
  fmpq_mul(factor, factor, problem->scene->loads.cohesion_kpa.value);
  fmpq_mul_ui(factor, factor, TP_KILO);
  arb_mul_fmpz(force, force, fmpq_numref(factor), bits);
  arb_div_fmpz(force, force, fmpq_denref(factor), bits);
  fmpq_clear(factor);
}

void tp_facet_frame_init(tp_facet_frame *f, const tp_evaluation *e, const fmpz_t run,
                         const fmpz_t rise, const arb_t friction) {
  const long bits = e->rung.bits;
  arb_t size;
  arb_init(size);
  arb_init(f->run);
  arb_init(f->rise);
  arb_init(f->friction);
  arb_init(f->cohesion);
  arb_set_fmpz(f->run, run);
  arb_set_fmpz(f->rise, rise);
  arb_hypot(size, f->run, f->rise, bits);
  tp_friction_tangent(f->friction, friction, bits);
  if (e->problem->scene->loads.cohesion_kpa.given) set_cohesion(f->cohesion, e);
  arb_mul(f->cohesion, f->cohesion, size, bits);
  arb_clear(size);
}

void tp_facet_frame_clear(tp_facet_frame *f) {
  arb_clear(f->run);
  arb_clear(f->rise);
  arb_clear(f->friction);
  arb_clear(f->cohesion);
}

void tp_facet_frame_resolve(tp_trig *along, tp_trig *pressing, const tp_wrench *wrench,
                            const tp_facet_frame *f, long bits) {
  tp_trig_submul(along, &wrench->x, f->run, bits);
  tp_trig_addmul(along, &wrench->y, f->rise, bits);
  tp_trig_submul(pressing, &wrench->x, f->rise, bits);
  tp_trig_submul(pressing, &wrench->y, f->run, bits);
}
