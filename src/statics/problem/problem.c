/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Builds a problem in fixed order: block laid, section, base, lattice, check of the section, arcs,
 * rounded corners, contact, sole, pivots, loads, facet frictions and, where asked for, elements. */

#include "problem/problem.h"

#include "base/underside.h"
#include "block/check.h"
#include "load/check.h"
#include "load/loads.h"
#include "problem/admissible.h"
#include "problem/contact_width.h"
#include "problem/effects.h"
#include "problem/facet_besides.h"
#include "problem/water_site.h"
#include "scene/check.h"
#include "scene/partial_factors.h"
#include "scene_varying/load_case.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void tp_problem_clear(tp_problem *problem) {
  tp_section_clear(&problem->section);
  tp_base_clear(&problem->base);
  tp_lattice_clear(&problem->lattice);
  tp_contact_clear(&problem->contact);
  tp_facet_friction_clear(&problem->friction);
  tp_base_joint_clear(&problem->joint);
  tp_wetted_clear(problem->wetted);
  tp_wetted_clear(problem->wetted + 1);
  tp_elements_clear(&problem->elements);
  tp_corners_clear(&problem->corners);
  free(problem->admissible[0]);
  free(problem->admissible[1]);
  tp_placement_clear(&problem->placement);
  tp_on_face_free(problem->on_face);
  tp_chorded_free(problem->chorded);
  memset(problem, 0, sizeof *problem);
}

static tp_status put_on_lattice(tp_problem *problem, tp_message *message) {
  const long rings = problem->section.ring_count;
  const tp_polyline **chains = calloc((size_t)rings + 2, sizeof *chains);
  if (chains == NULL) return tp_fail_memory(message, "the lattice of points");
  for (long r = 0; r < rings; r++) chains[r] = problem->section.rings + r;
  chains[rings] = &problem->base.ring;
  chains[rings + 1] = &problem->section.element_corners;
  const tp_status status = tp_lattice_init(&problem->lattice, chains, rings + 2,
                                           problem->scene->metres_per_unit, message);
  free(chains);
  return status;
}

static tp_status find_pivots(tp_problem *problem, tp_message *message) {
  for (int d = 0; d < 2; d++) {
    problem->admissible[d] =
        calloc((size_t)problem->contact.point_count, sizeof *problem->admissible[d]);
    if (problem->admissible[d] == NULL) return tp_fail_memory(message, "the pivots");
    tp_admissible_find(problem->admissible[d], &problem->contact, &problem->lattice,
                       d == 0 ? TP_TOWARDS_LEFT : TP_TOWARDS_RIGHT);
  }
  return TP_OK;
}

long tp_problem_vertex_count(const tp_problem *problem) {
  return problem->lattice.start[problem->section.ring_count];
}

bool tp_problem_is_enclosed(const tp_problem *problem) {
  return problem->corners.count > 0 || problem->loaded || problem->section.ellipse != NULL ||
         problem->section.arc_tips.count > 0;
}

/* Products of lattice integers that sorting and summing elements may cost: half a second unasked,
 * some seconds where they are asked for (tp_lattice_work). */
static const double most_work_unasked = 2e9, most_work = 2e10;

/* Are the elements called for: by the option, or by a tilt angle of a block of moderate size? With
 * rounded corners or loads there is no form by elements. */
static bool wants_elements(const tp_problem *problem, const tp_solve_options *options) {
  if (tp_problem_is_enclosed(problem)) return false;
  if (options->elements) return true;
  return problem->scene->tilt_angle_deg.given &&
         tp_problem_vertex_count(problem) <= TP_ELEMENTS_UNASKED &&
         tp_lattice_work(&problem->lattice) <= most_work_unasked;
}

static tp_status find_elements(tp_problem *problem, tp_geom_triangulation *triangulation,
                               const tp_solve_options *options, tp_solution *solution,
                               tp_message *message) {
  const tp_section *section = &problem->section;
  const tp_effect_begin began = tp_effects_begin(solution);
  tp_status status = TP_OK;
  if (tp_lattice_work(&problem->lattice) > most_work) {
    return tp_refuse(
        message, TP_FAULT_RANGE, (tp_place){0},
        "over their common denominator the coordinates have %.0f digits, too many for an "
        "account by elements; leave out --elements, or round the coordinates",
        (double)problem->lattice.bits * log10(2));
  }
  if (triangulation->count == 0 && !tp_elements_are_given(section)) {
    status = tp_check_triangulate(triangulation, section, &problem->lattice, message);
  }
  if (status == TP_OK) {
    status = tp_elements_init(&problem->elements, section, &problem->lattice,
                              section->ring_count + 1, triangulation, message);
  }
  problem->has_elements = status == TP_OK;
  return tp_effects_entered(
      status, message,
      tp_effects_note(solution, "elements",
                      options->elements ? (tp_place){0} : problem->scene->tilt_angle_deg.place,
                      "--elements", began));
}

static tp_status round_corners(tp_problem *problem, const tp_solve_options *options,
                               tp_solution *solution, tp_message *message) {
  const tp_scene *scene = problem->scene;
  const tp_effect_begin began = tp_effects_begin(solution);
  const tp_base *base = &problem->base;
  const long ends[2] = {base->outline_first, (base->outline_first + base->mated_count) %
                                                 problem->section.rings[0].count};
  tp_status status =
      tp_corners_init(&problem->corners, &scene->block, scene->base.mated ? ends : NULL,
                      &problem->section, &problem->lattice, scene->metres_per_unit, message);
  status = tp_effects_entered(
      status, message,
      tp_effects_note(solution, "rounding", scene->block.rounded.place, "", began));
  if (status == TP_OK && problem->corners.count > 0 && options->elements) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, scene->block.rounded.place,
                     "the account by elements is for sharp corners; leave out --elements or the "
                     "rounding");
  }
  return status;
}

/* Refuse a contact on an arc, whose tangents stand in the ring: a facet, or a point that is no end
 * of the arc. */
static tp_status check_arcs_clear(const tp_problem *problem, tp_message *message) {
  const tp_section *section = &problem->section;
  const tp_lattice *l = &problem->lattice;
  const long count = section->rings[0].count;
  for (long k = 0; k < section->arc_tips.count; k++) {
    const bool inwards = section->arc_tips.items[k].inwards;
    const long tip = section->arc_tips.items[k].vertex;
    const long ends[2] = {(tip + count - 1) % count, (tip + 1) % count};
    for (long f = 0; f < problem->contact.facet_count; f++) {
      const tp_facet *facet = problem->contact.facets + f;
      for (int side = inwards ? 1 : 0; side < 2; side++) {
        const bool along = tp_lattice_cross(l, tip, ends[side], tip, facet->q0) == 0 &&
                           tp_lattice_cross(l, tip, ends[side], tip, facet->q1) == 0;
        const bool toward = tp_lattice_dot(l, tip, ends[side], tip, facet->q0) >= 0 &&
                            tp_lattice_dot(l, ends[side], tip, ends[side], facet->q1) >= 0 &&
                            tp_lattice_dot(l, tip, ends[side], tip, facet->q1) >= 0 &&
                            tp_lattice_dot(l, ends[side], tip, ends[side], facet->q0) >= 0;
        const bool own_end =
            facet->q0 == facet->q1 && (tp_lattice_same_point(l, facet->q0, ends[side]) ||
                                       (inwards && tp_lattice_same_point(l, facet->q0, tip)));
        if (!along || !toward || own_end) continue;
        return tp_refuse(message, TP_FAULT_GEOMETRY, problem->scene->block.arcs[0].place,
                         "the block touches its base on an arc; say where the contact ends, 'base: "
                         "{mated: true, between: [[x, y], [x, y]]}', or lower the base");
      }
    }
  }
  return TP_OK;
}

static void find_joint(tp_problem *problem) {
  const long first = problem->lattice.start[problem->section.ring_count];
  tp_base_joint_init(&problem->joint);
  tp_base_joint_find(&problem->joint, &problem->contact, &problem->sole, &problem->lattice,
                     (const long[2]){first, first + problem->base.edge_count});
}

/* By the up-dip end of the joint: behind a block that goes down-dip, before one that goes up-dip.
 */
static tp_status check_water(const tp_problem *problem, bool left, tp_message *message) {
  const int heel = left != problem->scene->loads.water.lifts_alone ? 1 : 0;
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  fmpq_div(x, problem->joint.x + heel, problem->scene->metres_per_unit);
  fmpq_div(y, problem->joint.y + heel, problem->scene->metres_per_unit);
  const tp_status status = tp_loads_check_water(problem->scene, &problem->section, x, y,
                                                left ? "left" : "right", message);
  fmpq_clear(x);
  fmpq_clear(y);
  return status;
}

bool tp_problem_has_wetted(const tp_problem *problem) {
  return tp_water_is_sited(&problem->scene->loads.water);
}

static tp_status meet_water(tp_problem *problem, bool left, const tp_solve_options *options,
                            tp_message *message) {
  if (!tp_problem_has_wetted(problem)) return check_water(problem, left, message);
  const tp_water_site site = {problem->scene, problem->section.rings, &problem->joint,
                              problem->placement.world};
  return tp_water_site_find(problem->wetted + (left ? 0 : 1), &site, left, options->digits,
                            message);
}

static tp_status check_loads(tp_problem *problem, const tp_solve_options *options,
                             tp_message *message) {
  const tp_scene *scene = problem->scene;
  problem->loaded = true;
  if (options->elements) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, scene->loads.place,
                     "the account by elements is for the weight alone; leave out --elements or the "
                     "loads");
  }
  const tp_contact *contact = &problem->contact;
  const tp_quantity *glued =
      scene->loads.cohesion_kpa.given ? &scene->loads.cohesion_kpa : &scene->loads.bond_kpa;
  bool has_length = false;
  for (long k = 0; k < contact->facet_count; k++) {
    has_length = has_length || contact->facets[k].q0 != contact->facets[k].q1;
  }
  if (glued->given && !has_length) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, glued->place,
                     "the block touches its base only in points: there is no contact to hold");
  }
  if (scene->loads.water.given) find_joint(problem);
  tp_status status = tp_loads_check(scene, &problem->section, message);
  if (status == TP_OK && scene->towards_left) status = meet_water(problem, true, options, message);
  if (status == TP_OK && scene->towards_right) {
    status = meet_water(problem, false, options, message);
  }
  return status;
}

static bool was_turned(const tp_problem *problem) {
  const tp_world *world = problem->placement.world;
  return world != NULL && (!world->unturned || world->level);
}

/* A block of one ring that was set down or turned was checked before, and is as simple after it:
 * its coordinates have hundreds of digits by then. */
static bool was_checked(const tp_problem *problem) {
  const bool moved_whole = problem->placement.rested != NULL || was_turned(problem);
  return moved_whole && problem->placement.snapped == NULL && problem->section.ring_count == 1;
}

static tp_facets_counted counted_facets(const tp_problem *problem) {
  const tp_base *base = &problem->base;
  const bool turned = was_turned(problem);
  if (problem->placement.jointed != NULL) {
    return (tp_facets_counted){problem->placement.jointed->base_first,
                               problem->placement.jointed->sole.count, true, turned};
  }
  if (base->mated_count == 0) return (tp_facets_counted){0, base->edge_count, false, turned};
  return (tp_facets_counted){base->mated_first, base->mated_count, true, turned};
}

static tp_status prepare(tp_problem *problem, const tp_solve_options *options,
                         tp_geom_triangulation *triangulation, tp_solution *solution,
                         tp_message *message) {
  const tp_scene *scene = problem->scene;
  tp_effect_begin began = tp_effects_begin(solution);
  tp_status status = tp_section_init(&problem->section, &scene->block, message);
  problem->section.threads =
      (int)(options->threads < TP_SUMS_THREADS ? options->threads : TP_SUMS_THREADS);
  if (status == TP_OK) {
    status = tp_notes_append(&solution->notes, &problem->section.notes, message);
  }
  if (status == TP_OK) status = tp_base_init(&problem->base, scene, &problem->section, message);
  if (status == TP_OK &&
      problem->placement.jointed != NULL) { /* facets are counted as before the shift */
    problem->base.mated_first = problem->placement.jointed->base_first;
    problem->base.mated_count = problem->placement.jointed->sole.count;
    problem->base.outline_first = problem->placement.jointed->sole.first;
  }
  if (status == TP_OK) status = put_on_lattice(problem, message);
  if (status == TP_OK && !was_checked(problem)) {
    status = tp_check_section(triangulation, &problem->section, &problem->lattice, message);
  }
  if (status == TP_OK && problem->base.none != NULL) {
    status = tp_underside_fail(problem->base.none, scene, message);
  }
  if (status != TP_OK) return status;
  status = tp_effects_entered(status, message,
                              tp_effects_note(solution, "outline", scene->block.place, "", began));
  if (status == TP_OK && scene->block.arc_count > 0) {
    began = tp_effects_begin(solution);
    status = tp_arcs_check(&problem->section, &problem->lattice, &scene->block,
                           scene->metres_per_unit, message);
    status = tp_effects_entered(
        status, message, tp_effects_note(solution, "arcs", scene->block.arcs[0].place, "", began));
  }
  if (status == TP_OK && scene->block.rounded.count > 0) {
    status = round_corners(problem, options, solution, message);
  }
  if (status != TP_OK) return status;

  began = tp_effects_begin(solution);
  status = tp_contact_init(&problem->contact, &problem->section, &problem->corners, &problem->base,
                           &problem->lattice, message);
  if (status == TP_OK && problem->placement.jointed != NULL) {
    problem->sole = problem->placement.jointed->sole;
  } else if (status == TP_OK && problem->placement.world != NULL &&
             problem->placement.world->level) {
    problem->sole = problem->placement.world->sole;
  } else if (status == TP_OK && !scene->base.mated) {
    status = tp_sole_find(&problem->sole, scene, &problem->section, message);
  }
  if (status == TP_OK) status = find_pivots(problem, message);
  if (status == TP_OK && scene->block.arc_count > 0) status = check_arcs_clear(problem, message);
  if (status == TP_OK && tp_loads_are_called_for(&scene->loads)) {
    status = check_loads(problem, options, message);
  }
  status = tp_effects_entered(status, message,
                              tp_effects_note(solution, "contact", scene->base.place,
                                              "a mated base, as none is given", began));
  if (status == TP_OK) {
    status = tp_contact_width_check(&problem->contact, &problem->lattice, scene, message);
  }
  if (status == TP_OK && scene->friction.facet_count > 0) {
    status = tp_facet_friction_init(&problem->friction, scene, &problem->base, &problem->lattice,
                                    &problem->contact, counted_facets(problem), solution, message);
    if (status == TP_OK) {
      status = tp_facet_besides_find(&problem->friction, scene, &problem->base, &problem->lattice,
                                     &problem->contact, &solution->notes, message);
    }
  }
  if (status == TP_OK && wants_elements(problem, options)) {
    status = find_elements(problem, triangulation, options, solution, message);
  }
  if (problem->base.mated) tp_base_drop_points(&problem->base); /* they are the block's own */
  return status;
}

/* Numbers of a scene of which no case is chosen, or without its partial factors, would be of
 * another design than the scene describes. */
static tp_status check_chosen(const tp_scene *scene, tp_message *message) {
  const tp_status status = tp_check_load_case(scene, message);
  if (status != TP_OK || scene->partial_factors == NULL || scene->factored) return status;
  return tp_refuse(
      message, TP_FAULT_KEY, scene->partial_factors->place,
      "partial factors belong to a solve, a sweep, a map or a study; leave them out of "
      "the scene here");
}

tp_status tp_problem_init(tp_problem *problem, const tp_scene *scene,
                          const tp_solve_options *options, tp_solution *solution,
                          tp_message *message) {
  tp_geom_triangulation triangulation = {0};
  memset(problem, 0, sizeof *problem);
  problem->scene = scene;
  tp_status status = TP_OK;
  if (scene->source == NULL) status = tp_check_built(scene, message);
  if (status == TP_OK) status = check_chosen(scene, message);
  if (status == TP_OK) {
    status = tp_chorded_init(&problem->chorded, scene, &solution->notes, message);
  }
  if (problem->chorded != NULL) problem->scene = scene = &problem->chorded->scene;
  if (status == TP_OK)
    status = tp_on_face_init(&problem->on_face, scene, &solution->notes, message);
  if (problem->on_face != NULL) problem->scene = &problem->on_face->scene;
  if (status == TP_OK) {
    status = tp_placement_init(&problem->placement, &problem->scene, options, solution, message);
  }
  if (status == TP_OK) status = prepare(problem, options, &triangulation, solution, message);
  if (status == TP_BAD_INPUT && problem->placement.snapped != NULL)
    tp_snapped_explain(scene, message);
  /* Euler: any triangulation of n vertices and h holes has n + 2 h - 2 triangles. */
  problem->triangle_count = triangulation.count;
  if (triangulation.count == 0 && status == TP_OK) {
    problem->triangle_count = (size_t)problem->lattice.start[1] - 2;
  }
  tp_geom_triangulation_clear(&triangulation);
  if (status != TP_OK) tp_problem_clear(problem);
  return status;
}

void tp_problem_thickness(fmpq_t metres, const tp_problem *problem) {
  const tp_quantity *thickness = &problem->scene->block.thickness;
  if (thickness->given) {
    fmpq_mul(metres, thickness->value, problem->scene->metres_per_unit);
  } else {
    fmpq_one(metres);
  }
}

void tp_problem_weight_factor(fmpq_t newton, const tp_problem *problem) {
  tp_problem_thickness(newton, problem);
  fmpq_mul(newton, newton, problem->section.weight_unit);
  fmpq_mul(newton, newton, problem->lattice.step_m);
  fmpq_mul(newton, newton, problem->lattice.step_m);
  fmpq_mul_ui(newton, newton, TP_KILO / 2); /* half of twice the area */
}
