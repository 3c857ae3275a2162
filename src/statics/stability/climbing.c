/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Results kept from one precision to the next, and a copy of the state for each further tilt that
 * shares the limit and the onset of the first precision. */

#include "stability/climbing.h"

#include "number/ball.h"
#include "stability/solution.h"

#include <stdlib.h>

static bool settled_init(tp_direction_settled *own, long pivots) {
  *own = (tp_direction_settled){.pivots = calloc((size_t)pivots, sizeof *own->pivots)};
  tp_direction_ball_init(&own->limit_angle);
  tp_direction_ball_init(&own->back_angle);
  tp_onset_found_init(&own->onset_found);
  return own->pivots != NULL;
}

static void settled_clear(tp_direction_settled *own) {
  free(own->pivots);
  tp_direction_ball_clear(&own->limit_angle);
  tp_direction_ball_clear(&own->back_angle);
  tp_onset_found_clear(&own->onset_found);
}

/* Of one tilt, the scene's own or a further one. */
static tp_status begin(tp_climbing *c, tp_solution *solution, const tp_problem *problem,
                       const tp_solve_options *options, tp_message *message) {
  const long pivots = problem->contact.point_count;
  *c = (tp_climbing){
      .solution = solution, .problem = problem, .options = options, .message = message};
  const bool left = settled_init(c->settled, pivots), right = settled_init(c->settled + 1, pivots);
  return left && right ? TP_OK : tp_fail_memory(message, "the pivots");
}

/* ---- further tilts -----------------------------------------------------------------------------
 */

static void at_tilt_clear(tp_at_tilt *at) {
  fmpq_clear(at->scene.tilt_angle_deg.value);
  tp_solution_free(at->climbing.solution);
  settled_clear(at->climbing.settled);
  settled_clear(at->climbing.settled + 1);
}

/* To be cleared also on failure. */
static tp_status at_tilt_init(tp_at_tilt *at, const fmpq_t degrees, const tp_climbing *own,
                              tp_message *message) {
  at->scene = *own->problem->scene;
  fmpq_init(at->scene.tilt_angle_deg.value);
  fmpq_set(at->scene.tilt_angle_deg.value, degrees);
  at->problem = *own->problem;
  at->problem.scene = &at->scene;
  tp_solution *solution = tp_solution_new();
  const tp_status status = begin(&at->climbing, solution, &at->problem, own->options, message);
  if (status != TP_OK) return status;
  return solution != NULL ? tp_solution_describe(solution, &at->problem, own->options, message)
                          : tp_fail_memory(message, "the solution");
}

static tp_status add_tilts(tp_climbing *c, const tp_tilts *tilts, tp_message *message) {
  c->others = calloc(tilts->count + 1, sizeof *c->others);
  c->tilts.items = calloc(tilts->count + 1, sizeof *c->tilts.items);
  if (c->others == NULL || c->tilts.items == NULL) return tp_fail_memory(message, "the tilts");
  tp_status status = TP_OK;
  for (size_t k = 0; k < tilts->count && status == TP_OK; k++) {
    status = at_tilt_init(c->others + c->other_count++, tilts->degrees + k, c, message);
  }
  return status;
}

/* Alone are told: what keeps texts, or makes an account by elements; and a scene that is turned
 * from the world's frame, whose tilt is not the problem's, or whose water stands at a level, which
 * another tilt wets otherwise. */
static bool may_share(const tp_climbing *c) {
  return c->solution->decimals == NULL && c->problem->placement.world == NULL &&
         !c->options->elements && !tp_problem_has_wetted(c->problem) &&
         c->problem->scene->tilt_angle_deg.given;
}

tp_status tp_climbing_init(tp_climbing *c, tp_solution *solution, const tp_problem *problem,
                           const tp_solve_options *options, const tp_tilts *tilts,
                           tp_message *message) {
  const tp_status status = begin(c, solution, problem, options, message);
  if (status != TP_OK || tilts == NULL || !may_share(c)) return status;
  return add_tilts(c, tilts, message);
}

void tp_climbing_clear(tp_climbing *c) {
  settled_clear(c->settled);
  settled_clear(c->settled + 1);
  for (size_t k = 0; k < c->other_count; k++) at_tilt_clear(c->others + k);
  free(c->others);
  free(c->tilts.items);
}

/* ---- at the first rung -------------------------------------------------------------------------
 */

void tp_climbing_begin_tilts(tp_climbing *c, const tp_evaluation *e) {
  for (size_t k = 0; k < c->other_count; k++) {
    tp_at_tilt *at = c->others + k;
    tp_evaluation *own = &at->evaluation;
    *own = *e;
    own->problem = &at->problem;
    own->work = &at->climbing.work;
    arb_init(own->tilt_sine);
    arb_init(own->tilt_cosine);
    tp_ball_sin_cos_degrees(own->tilt_sine, own->tilt_cosine, at->scene.tilt_angle_deg.value,
                            e->rung.bits);
  }
  c->tilts.count = c->other_count;
}

void tp_climbing_take_case(tp_climbing *c, size_t number, const struct tp_loaded *loaded) {
  for (size_t k = 0; k < c->tilts.count; k++) {
    tp_at_tilt *at = c->others + k;
    tp_case *result = at->climbing.solution->cases + number;
    at->evaluation.loaded = loaded;
    c->tilts.items[k] =
        (tp_further_tilt){&at->evaluation, result,
                          &at->climbing.settled[result->towards].onset_found, &at->certainty};
  }
}

static void copy_angle(tp_direction_ball *copy, const tp_direction_ball *angle) {
  arb_set(copy->sine, angle->sine);
  arb_set(copy->cosine, angle->cosine);
  arb_set(copy->degrees, angle->degrees);
  arb_set(copy->inclination, angle->inclination);
  copy->adds = angle->adds;
  copy->exact_direction = angle->exact_direction;
}

void tp_climbing_share(tp_climbing *c, tp_direction towards) {
  const tp_direction_settled *own = c->settled + towards;
  for (size_t k = 0; k < c->tilts.count; k++) {
    tp_direction_settled *at = c->others[k].climbing.settled + towards;
    copy_angle(&at->limit_angle, &own->limit_angle);
    copy_angle(&at->back_angle, &own->back_angle);
    at->limit = at->onset = true;
  }
}

void tp_climbing_end_tilts(tp_climbing *c, bool certain) {
  for (size_t k = 0; k < c->tilts.count; k++) {
    arb_clear(c->others[k].evaluation.tilt_sine);
    arb_clear(c->others[k].evaluation.tilt_cosine);
  }
  if (c->tilts.count > 0) c->shares = certain && tp_further_is_cheap(&c->work);
  c->tilts.count = 0;
}

void tp_climbing_hand_out(tp_tilts *tilts, tp_climbing *c) {
  for (size_t k = 0; k < c->other_count; k++) {
    tp_at_tilt *at = c->others + k;
    tp_solution *told = at->climbing.solution;
    if (!c->shares || at->certainty.open) continue;
    told->block = c->solution->block;
    told->contact = c->solution->contact;
    told->level = c->solution->level;
    told->bits = c->solution->bits;
    tilts->solutions[k] = told;
    at->climbing.solution = NULL;
  }
}
