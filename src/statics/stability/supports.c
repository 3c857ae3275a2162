/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Of bolts of force F at a spacing s in n rows, per metre n F / s, and on a thickness d n F d / s;
 * without a spacing n F on the thickness. Of a pressure from p0 to p1 on a line of length l the
 * force is (p0 + p1) l d / 2. Rationals, but for lengths along a line or a ray, which are balls. */

#include "stability/supports.h"

#include "evaluation/certainty.h"
#include "load/bolt_way.h"
#include "scene/anchor.h"

#include <stdlib.h>

enum { BITS = 192 };

static tp_bounded in_metres(const fmpq_t length, const tp_scene *scene) {
  fmpq_t metres;
  fmpq_init(metres);
  fmpq_mul(metres, length, scene->metres_per_unit);
  const tp_bounded result = tp_result_rational(metres);
  fmpq_clear(metres);
  return result;
}

static tp_bounded quotient(const fmpq_t a, const fmpq_t b) {
  fmpq_t share;
  fmpq_init(share);
  fmpq_div(share, a, b);
  const tp_bounded result = tp_result_rational(share);
  fmpq_clear(share);
  return result;
}

/* The least of all rows. */
static tp_bounded bond_length(const tp_problem *problem, const tp_anchor_description *a) {
  fmpq_t x, y, direction;
  arb_t way, least, own;
  fmpq_init(x);
  fmpq_init(y);
  fmpq_init(direction);
  arb_init(way);
  arb_init(least);
  arb_init(own);
  tp_anchor_direction(direction, problem->scene, a);
  for (long row = 0; row < tp_anchor_rows(a); row++) {
    tp_anchor_point(x, y, a, row);
    (void)tp_bolt_way(way, problem->section.rings, x, y, direction, BITS);
    arb_set_fmpq(own, a->length.value, BITS);
    arb_sub(own, own, way, BITS);
    if (row == 0) arb_set(least, own);
    arb_min(least, least, own, BITS);
  }
  arb_set_fmpq(own, problem->scene->metres_per_unit, BITS);
  arb_mul(least, least, own, BITS);
  const tp_bounded result = tp_ball_bounded(least);
  fmpq_clear(x);
  fmpq_clear(y);
  fmpq_clear(direction);
  arb_clear(way);
  arb_clear(least);
  arb_clear(own);
  return result;
}

static void describe_bolts(tp_support *own, const tp_anchor_description *a,
                           const tp_problem *problem) {
  const tp_scene *scene = problem->scene;
  const tp_quantity *force = tp_anchor_bolt_force(a);
  fmpq_t total, thickness;
  fmpq_init(total);
  fmpq_init(thickness);
  tp_problem_thickness(thickness, problem);
  tp_anchor_row_force(total, scene, a);
  fmpq_mul_si(total, total, tp_anchor_rows(a));
  *own = (tp_support){.passive = a->passive,
                      .force_kn = tp_result_rational(force->value),
                      .rows = (size_t)tp_anchor_rows(a),
                      .has_spacing = a->spacing.given,
                      .force_kn_m = quotient(total, thickness),
                      .total_kn = tp_result_rational(total),
                      .has_capacity = a->capacity_kn.given,
                      .has_length = a->length.given};
  if (own->has_spacing) own->spacing_m = in_metres(a->spacing.value, scene);
  if (own->has_capacity) {
    own->capacity_kn = tp_result_rational(a->capacity_kn.value);
    own->utilisation = quotient(force->value, a->capacity_kn.value);
  }
  if (own->has_length) {
    own->length_m = in_metres(a->length.value, scene);
    own->bond_length_m = bond_length(problem, a);
  }
  fmpq_clear(total);
  fmpq_clear(thickness);
}

static void describe_pressure(tp_support *own, const tp_line_load *load,
                              const tp_problem *problem) {
  fmpq_t dx, dy;
  arb_t length, factor;
  fmpq_init(dx);
  fmpq_init(dy);
  arb_init(length);
  arb_init(factor);
  fmpq_sub(dx, load->x1.value, load->x0.value);
  fmpq_sub(dy, load->y1.value, load->y0.value);
  fmpq_mul(dx, dx, dx);
  fmpq_addmul(dx, dy, dy);
  arb_set_fmpq(length, dx, BITS);
  arb_sqrt(length, length, BITS);
  fmpq_add(dx, load->first_kpa.value, load->last_kpa.value);
  fmpq_div_2exp(dx, dx, 1);
  fmpq_mul(dx, dx, problem->scene->metres_per_unit);
  arb_set_fmpq(factor, dx, BITS);
  arb_mul(length, length, factor, BITS);
  *own = (tp_support){
      .is_pressure = true, .passive = load->passive, .force_kn_m = tp_ball_bounded(length)};
  tp_problem_thickness(dx, problem);
  arb_set_fmpq(factor, dx, BITS);
  arb_mul(length, length, factor, BITS);
  own->total_kn = tp_ball_bounded(length);
  fmpq_clear(dx);
  fmpq_clear(dy);
  arb_clear(length);
  arb_clear(factor);
}

tp_status tp_describe_supports(tp_solution *solution, const tp_problem *problem,
                               tp_message *message) {
  const tp_loads_description *loads = &problem->scene->loads;
  bool any = loads->support_count > 0;
  for (long k = 0; k < loads->anchor_count && !any; k++) {
    any = tp_anchor_is_bolt(loads->anchors + k);
  }
  if (!any) return TP_OK;
  const size_t most = (size_t)(loads->support_count + loads->anchor_count);
  solution->supports = calloc(most, sizeof *solution->supports);
  if (solution->supports == NULL) return tp_fail_memory(message, "the supports");
  for (long k = 0; k < loads->anchor_count; k++) {
    describe_bolts(solution->supports + solution->support_count++, loads->anchors + k, problem);
  }
  for (long k = 0; k < loads->support_count; k++) {
    describe_pressure(solution->supports + solution->support_count++, loads->supports + k, problem);
  }
  return TP_OK;
}
