/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Preparation of a case filter from a scene: tests whether the scene is of the simple kind that
 * filters take (one friction angle, loads that turn with the tilt), solves its contact exactly, and
 * rounds shape, pivots and facets to doubles with bounds. */

#include "case_filter/case_filter.h"

#include "evaluation/friction.h"
#include "number/ball.h"
#include "onset/onset_question.h"
#include "stability/solution.h"
#include "stability/static_state.h"

#include <math.h>
#include <stdlib.h>

/* Balls of the preparation; what they tell is rounded to doubles. */
enum { BITS = 256 };

/* Which way it lets go is known: on a table by its tilt, of a block that lies on a slope by the
 * dip, under an earthquake that acts down-dip alone (stability/earthquakes.c). */
static bool goes_one_way(const tp_scene *scene) {
  const tp_loads_description *loads = &scene->loads;
  if (!tp_scene_lies_in_place(scene)) return scene->towards_left != scene->towards_right;
  return !loads->vertical.given && (!loads->horizontal.given || loads->direction_given);
}

/* Under loads that turn with the tilt, with one friction angle, on the tilt as it is given. */
static bool is_plain(const tp_scene *scene) {
  return scene->friction_angle_deg.given && scene->friction.facet_count == 0 &&
         !scene->base.all_poses && scene->partial_factors == NULL && tp_load_plan_fits(scene) &&
         !tp_smoothed_is_asked(scene) && goes_one_way(scene);
}

static tp_near near_of(const arb_t ball) {
  return arb_is_zero(ball) ? (tp_near){0, 0} : tp_ball_near(ball);
}

/* The shape's unit of length is 2^this lattice steps: about the size of the contact, as a lattice
 * that was turned has steps of no size. */
static slong unit_of(const tp_cones *cones) {
  double most = 0;
  for (long k = 1; k < cones->count; k++) {
    arb_t apart;
    arb_init(apart);
    const arb_struct own = tp_cones_x(cones, k), first = tp_cones_x(cones, 0);
    arb_sub(apart, &own, &first, BITS);
    most = fmax(most, tp_ball_log2_above(apart));
    arb_clear(apart);
  }
  return (slong)most;
}

/* Lattice steps over the question's scale, from the centroid, in units. */
static tp_near from_centroid(const arb_t own, const arb_t scale, const arb_t centroid, slong unit) {
  arb_t rest;
  arb_init(rest);
  arb_div(rest, centroid, scale, BITS);
  arb_sub(rest, own, rest, BITS);
  arb_mul_2exp_si(rest, rest, -unit);
  const tp_near near = near_of(rest);
  arb_clear(rest);
  return near;
}

/* Along a facet, of any length. */
static void set_direction(tp_shape_point *p, const fmpz_t tx, const fmpz_t ty) {
  const slong along = (slong)fmpz_bits(tx), up = (slong)fmpz_bits(ty);
  arb_t part;
  arb_init(part);
  arb_set_fmpz(part, tx);
  arb_mul_2exp_si(part, part, along > up ? -along : -up);
  p->tx = near_of(part);
  arb_set_fmpz(part, ty);
  arb_mul_2exp_si(part, part, along > up ? -along : -up);
  p->ty = near_of(part);
  arb_clear(part);
}

static void set_shape(tp_case_shape *shape, const tp_onset_asked *asked, slong unit) {
  const tp_motion_question *q = &asked->question;
  arb_t square;
  arb_init(square);
  arb_div(square, q->gyration, q->scale, BITS);
  arb_div(square, square, q->scale, BITS);
  arb_mul_2exp_si(square, square, -2 * unit);
  shape->gyration = near_of(square);
  for (long k = 0; k < asked->cones.count; k++) {
    tp_shape_point *p = shape->points + k;
    const arb_struct x = tp_cones_x(&asked->cones, k), y = tp_cones_y(&asked->cones, k);
    p->x = from_centroid(&x, q->scale, q->x, unit);
    p->y = from_centroid(&y, q->scale, q->y, unit);
    set_direction(p, asked->cones.tx + k, asked->cones.ty + k);
  }
  arb_clear(square);
}

static void set_pivots(tp_case_filter *f, const tp_evaluation *e, tp_direction towards) {
  const tp_problem *problem = e->problem;
  tp_certainty any = {0};
  for (long site = 0; site < problem->contact.point_count; site++) {
    for (long k = 0; k < f->plan.point_count; k++) {
      if (f->plan.points[k].site != site) continue;
      tp_filter_pivot *own = f->pivots + f->pivot_count++;
      *own = (tp_filter_pivot){.point = k, .admissible = problem->admissible[towards][site]};
      tp_result_point(&own->x_m, &own->y_m, e,
                      tp_contact_on_outline(problem->contact.points + site), &any);
      break;
    }
  }
}

/* Points of one facet follow one another, its left end in the scene first. */
static void set_facets(tp_case_filter *f, const tp_problem *problem, tp_direction towards) {
  for (long k = 0; k < f->plan.point_count; k++) {
    const long facet = f->plan.points[k].facet;
    if (k > 0 && f->plan.points[k - 1].facet == facet) continue;
    const bool has_two = k + 1 < f->plan.point_count && f->plan.points[k + 1].facet == facet;
    const tp_facet *own = problem->contact.facets + facet;
    const tp_lattice *l = &problem->lattice;
    f->facets[f->facet_count++] =
        (tp_filter_facet){.point = k,
                          .down_dip = towards == TP_TOWARDS_RIGHT && has_two ? k + 1 : k,
                          .is_level = fmpz_equal(l->y + own->t0, l->y + own->t1)};
  }
}

/* Every facet runs up-dip, and one at least has a length. */
static bool is_ordinary(const tp_case_filter *f, const tp_problem *problem) {
  bool has_length = false;
  for (int k = 0; k < f->facet_count; k++) {
    const long point = f->facets[k].point, facet = f->plan.points[point].facet;
    if (facet < 0 || tp_near_sign(f->shape.points[point].tx) <= 0) return false;
    has_length =
        has_length || problem->contact.facets[facet].q0 != problem->contact.facets[facet].q1;
  }
  for (long k = 0; k < problem->contact.point_count;
       k++) { /* one without a plan's point: a corner */
    bool found = !problem->admissible[0][k] && !problem->admissible[1][k];
    for (int p = 0; p < f->pivot_count && !found; p++) {
      found = f->plan.points[f->pivots[p].point].site == k;
    }
    if (!found) return false;
  }
  return has_length;
}

/* `*fits` is false where it is none for a filter. */
static tp_status prepare(tp_case_filter *f, bool *fits, const tp_evaluation *e,
                         const tp_scene_key *keys, size_t count, tp_message *message) {
  const tp_problem *problem = e->problem;
  const tp_direction towards = problem->scene->towards_left ? TP_TOWARDS_LEFT : TP_TOWARDS_RIGHT;
  tp_status status = tp_contact_plan_init(&f->plan, fits, e, towards, message);
  if (status != TP_OK || !*fits) return status;
  tp_onset_asked asked;
  if (!tp_onset_asked_init(&asked, e, towards, NULL)) return tp_fail_memory(message, "the contact");
  const slong unit = unit_of(&asked.cones);
  set_shape(&f->shape, &asked, unit);
  f->varies = count > 0;
  f->variable_count = count;
  f->rests = tp_static_state_counts(problem->scene);
  *fits = tp_load_plan_init(&f->loads, e, &asked, towards, unit) &&
          tp_capacity_plan_init(&f->capacities, e, &asked, &f->plan, f->varies);
  tp_onset_asked_clear(&asked);
  const tp_bounded tilt = tp_result_rational(problem->scene->tilt_angle_deg.value);
  f->tilt_deg = (tp_near){tilt.value, tilt.error};
  set_pivots(f, e, towards);
  set_facets(f, problem, towards);
  *fits = *fits && is_ordinary(f, problem) && tp_shape_complete(&f->shape, &f->plan);
  if (f->varies && tp_load_plan_knows_outline(&f->loads)) *fits = false;
  if (!*fits || !f->varies) return TP_OK;
  return tp_outline_map_init(&f->map, fits, problem, towards, &f->plan, keys, count, message);
}

/* Do corners or arcs leave points that are none of the lattice? */
static bool is_rounded(const tp_problem *problem) {
  return problem->corners.count > 0 || problem->section.ellipse != NULL ||
         problem->section.arc_tips.count > 0;
}

static tp_status prepare_scene(tp_case_filter *f, bool *fits, const tp_scene *scene,
                               const tp_scene_key *keys, size_t count, tp_message *message) {
  tp_solve_options options = tp_solve_options_default();
  options.threads = 1;
  tp_problem problem;
  tp_solution *solution = tp_solution_new();
  if (solution == NULL) return tp_fail_memory(message, "the solution");
  tp_message why = {.text = ""};
  tp_status status = tp_problem_init(&problem, scene, &options, solution, &why);
  if (status == TP_OK) {
    tp_evaluation e;
    tp_evaluation_init(&e, &problem, (tp_rung){TP_LEVEL_BALL, BITS}, &options);
    if (!is_rounded(&problem) && !tp_friction_is_load_dependent(&e)) {
      status = prepare(f, fits, &e, keys, count, message);
    }
    tp_evaluation_clear(&e);
    tp_problem_clear(&problem);
  } else if (status != TP_OUT_OF_MEMORY) {
    status = TP_OK; /* a solve tells what is wrong with it */
  } else if (message != NULL) {
    *message = why;
  }
  tp_solution_free(solution);
  return status;
}

tp_status tp_case_filter_new(tp_case_filter **filter, const tp_scene *scene,
                             const tp_scene_key *keys, size_t count, tp_message *message) {
  *filter = NULL;
  if (!is_plain(scene)) return TP_OK;
  tp_case_filter *own = calloc(1, sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "the filter");
  bool fits = false;
  const tp_status status = prepare_scene(own, &fits, scene, keys, count, message);
  if (status == TP_OK && fits) {
    *filter = own;
  } else {
    free(own);
  }
  return status;
}
