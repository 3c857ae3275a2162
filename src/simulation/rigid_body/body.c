/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Mass, radius of gyration, friction, closed contacts and loads of a problem evaluated in balls
 * relative to the centroid and rounded once to doubles. */

#include "rigid_body/body.h"

#include "evaluation/friction.h"
#include "evaluation/loaded.h"
#include "number/ball.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void tp_rigid_body_clear(tp_rigid_body *body) {
  tp_boundary_clear(&body->outline);
  tp_boundary_clear(&body->base);
  free(body->friction);
  free(body->closed);
  memset(body, 0, sizeof *body);
}

/* ---- what is not simulated
 * ------------------------------------------------------------------------------- */

static tp_status check(const tp_problem *problem, tp_message *message) {
  const tp_scene *scene = problem->scene;
  const tp_friction_description *f = &scene->friction;
  if (!scene->friction_angle_deg.given) {
    return tp_refuse(message, TP_FAULT_KEY, scene->tilt_place,
                     "a simulation needs the friction of the contact: give 'friction_angle_deg'");
  }
  if (f->load_dependent) {
    return tp_refuse(message, TP_FAULT_KEY, scene->friction_angle_deg.place,
                     "a simulation has no friction that depends on the normal stress; give the "
                     "friction angle at the stress of the block: 'friction_angle_deg'");
  }
  const tp_quantity *strengths[2] = {&scene->loads.cohesion_kpa, &scene->loads.bond_kpa};
  for (int k = 0; k < 2; k++) {
    if (fmpq_is_zero(strengths[k]->value)) continue;
    return tp_refuse(message, TP_FAULT_KEY, strengths[k]->place,
                     "a simulation has no cohesion and no bond of the contact: leave '%s' out",
                     k == 0 ? "cohesion_kpa" : "bond_kpa");
  }
  return TP_OK;
}

/* ---- friction
 * ------------------------------------------------------------------------------------------- */

static double tangent_of(const fmpq *degrees, long bits) {
  arb_t angle;
  arb_init(angle);
  arb_set_fmpq(angle, degrees, bits);
  tp_friction_tangent(angle, angle, bits);
  const double tangent = tp_local_nearest(angle);
  arb_clear(angle);
  return tangent;
}

static bool set_friction(tp_rigid_body *body, const tp_local *local) {
  const tp_problem *problem = local->e.problem;
  const tp_scene *scene = problem->scene;
  const double own = tangent_of(scene->friction_angle_deg.value, local->e.rung.bits);
  body->friction = malloc((size_t)body->base.count * sizeof *body->friction);
  if (body->friction == NULL) return false;
  for (long k = 0; k < body->base.count; k++) {
    const long edge = body->base.edges[k].number - 1;
    const long entry = edge < 0 ? -1 : tp_facet_friction_entry(&problem->friction, edge);
    body->friction[k] =
        entry < 0 ? own
                  : tangent_of(scene->friction.facets[entry].angle_deg.value, local->e.rung.bits);
  }
  return true;
}

/* ---- contacts
 * ------------------------------------------------------------------------------------------- */

/* The unit vector along a facet: its ends' difference is exact before it is rounded. */
static tp_xy direction(const tp_local *local, const tp_facet *facet) {
  const tp_lattice *l = &local->e.problem->lattice;
  const long bits = local->e.rung.bits;
  arb_t x, y, size;
  arb_init(x);
  arb_init(y);
  arb_init(size);
  arb_set_fmpz(x, l->x + facet->t1);
  arb_set_fmpz(y, l->y + facet->t1);
  arb_sub_fmpz(x, x, l->x + facet->t0, bits);
  arb_sub_fmpz(y, y, l->y + facet->t0, bits);
  arb_hypot(size, x, y, bits);
  arb_div(x, x, size, bits);
  arb_div(y, y, size, bits);
  const tp_xy unit = {tp_local_nearest(x), tp_local_nearest(y)};
  arb_clear(x);
  arb_clear(y);
  arb_clear(size);
  return unit;
}

static void add_facet(tp_rigid_body *body, const tp_local *local, long k) {
  const tp_problem *problem = local->e.problem;
  const tp_facet *facet = problem->contact.facets + k;
  tp_outline_point ends[2];
  const int count = tp_facet_contacts(ends, facet);
  if (count == 0) return;
  const fmpq *own = tp_friction_own(problem, k);
  const bool of_profile = facet->base_edge >= 0 && facet->base_edge < problem->base.edge_count;
  tp_closed_point point = {
      .at = tp_local_outline_point(local, ends[0]),
      .tangent = direction(local, facet),
      .facet = of_profile ? facet->base_edge + 1 : 0,
      .friction = tangent_of(own != NULL ? own : problem->scene->friction_angle_deg.value,
                             local->e.rung.bits)};
  point.normal = tp_xy_left(point.tangent);
  const tp_xy end = tp_local_outline_point(local, ends[count - 1]);
  point.share_m = hypot(end.x - point.at.x, end.y - point.at.y) / 2;
  body->closed[body->closed_count++] = point;
  point.at = end;
  if (count == 2) body->closed[body->closed_count++] = point;
}

static bool set_contacts(tp_rigid_body *body, const tp_local *local) {
  const long facets = local->e.problem->contact.facet_count;
  body->closed = calloc(2 * (size_t)facets + 1, sizeof *body->closed);
  for (long k = 0; k < facets && body->closed != NULL; k++) add_facet(body, local, k);
  return body->closed != NULL;
}

/* ---- mass and loads
 * ------------------------------------------------------------------------------------- */

/* int r^2 about the centroid over the area: (XX12 + YY12) / 12 over A2 / 2, less that of the
 * centroid. */
static void set_gyration(arb_t square_m2, const tp_local *local) {
  const arb_struct *sums = local->e.moments.weighted;
  const long bits = local->e.rung.bits;
  arb_t own;
  arb_init(own);
  arb_add(square_m2, sums + TP_XX12, sums + TP_YY12, bits);
  arb_div(square_m2, square_m2, sums + TP_A2, bits);
  arb_div_ui(square_m2, square_m2, 6, bits);
  arb_mul(own, local->x, local->x, bits);
  arb_addmul(own, local->y, local->y, bits);
  arb_sub(square_m2, square_m2, own, bits);
  tp_evaluation_to_metres(square_m2, &local->e, 2);
  arb_clear(own);
}

static void set_mass(tp_rigid_body *body, const tp_local *local) {
  const tp_problem *problem = local->e.problem;
  arb_t value;
  fmpq_t thickness;
  arb_init(value);
  fmpq_init(thickness);
  tp_evaluation_weight(value, &local->e);
  body->mass_kg = tp_local_nearest(value) / TP_GRAVITY_M_S2;
  set_gyration(value, local);
  body->inertia_kg_m2 = body->mass_kg * tp_local_nearest(value);
  tp_problem_thickness(thickness, problem);
  body->thickness_m = fmpq_get_d(thickness);
  fmpq_clear(thickness);
  arb_clear(value);
  body->weighed = problem->scene->block.unit_weight_kn_m3.given;
}

static void set_functions(double of[TP_BASIS], const tp_trig *f, bool mirrored) {
  for (int k = 0; k < TP_BASIS; k++) of[k] = (mirrored ? -1 : 1) * tp_local_nearest(f->of + k);
}

/* All loads but the first, the weight, about the centroid. */
static bool set_loads(tp_rigid_body *body, const tp_local *local) {
  tp_loaded loaded;
  tp_wrench sum;
  tp_trig moment;
  arb_t x, y;
  if (!local->e.problem->loaded) return true;
  if (!tp_loaded_init(&loaded, &local->e, body->towards)) return false;
  const long bits = local->e.rung.bits;
  tp_wrench_init(&sum);
  tp_trig_init(&moment);
  arb_init(x);
  arb_init(y);
  for (long k = 1; k < loaded.count; k++) {
    tp_trig_add(&sum.x, &loaded.items[k].wrench.x, bits);
    tp_trig_add(&sum.y, &loaded.items[k].wrench.y, bits);
    tp_trig_add(&sum.moment, &loaded.items[k].wrench.moment, bits);
  }
  arb_set(x, local->x);
  arb_set(y, local->y);
  tp_loaded_metres(x, y, &local->e);
  if (loaded.mirrored) arb_neg(x, x);
  tp_wrench_moment(&moment, &sum, x, y, bits);
  body->loads.given = loaded.count > 1;
  set_functions(body->loads.x_n, &sum.x, loaded.mirrored);
  set_functions(body->loads.y_n, &sum.y, false);
  set_functions(body->loads.moment_nm, &moment, loaded.mirrored);
  tp_wrench_clear(&sum);
  tp_trig_clear(&moment);
  arb_clear(x);
  arb_clear(y);
  tp_loaded_clear(&loaded);
  return true;
}

static void set_origin(tp_rigid_body *body, const tp_local *local) {
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  arb_set(x, local->x);
  arb_set(y, local->y);
  tp_loaded_metres(x, y, &local->e);
  body->origin = (tp_xy){tp_local_nearest(x), tp_local_nearest(y)};
  arb_clear(x);
  arb_clear(y);
}

tp_status tp_rigid_body_init(tp_rigid_body *body, const tp_problem *problem, tp_direction towards,
                             tp_message *message) {
  tp_local local;
  memset(body, 0, sizeof *body);
  const tp_status status = check(problem, message);
  if (status != TP_OK) return status;
  body->towards = towards;
  tp_local_init(&local, problem);
  const bool done = tp_boundary_of_block(&body->outline, &local) &&
                    tp_boundary_of_base(&body->base, &local) && set_friction(body, &local) &&
                    set_contacts(body, &local) && set_loads(body, &local);
  if (done) {
    set_mass(body, &local);
    set_origin(body, &local);
    body->extent_m = tp_boundary_reach(&body->outline);
  }
  tp_local_clear(&local);
  if (done) return TP_OK;
  tp_rigid_body_clear(body);
  return tp_fail_memory(message, "the simulation's block");
}
