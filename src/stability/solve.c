/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene in, the stability of its block out. */

#include "stability/solve.h"
#include "host.h"
#include "notes.h"
#include "number/ladder.h"
#include "stability/cautions.h"
#include "stability/effects.h"
#include "stability/governing.h"
#include "stability/loaded.h"
#include "stability/onset.h"
#include "stability/solution.h"

#include <stdlib.h>
#include <string.h>

tp_solve_options tp_solve_options_default(void) {
  return (tp_solve_options){
      .limit = true, .strength_reduction = true, .digits = 9, .level = TP_LEVEL_EXACT};
}

/* A limit and an onset that a lower rung made certain, each, the mechanism included. */
typedef struct kept_limit {
  bool settled, onset_settled;
  tp_direction_ball limit, back;
  tp_onset_found onset;
} kept_limit;

typedef struct climb {
  const tp_problem *problem;
  const tp_solve_options *options;
  tp_solution *solution;
  bool *settled[2];
  tp_message *message;
  kept_limit *kept; /* by direction */
  tp_work *work;
} climb;

/* By contact forces, what is not settled yet. False when memory is exhausted. */
static bool evaluate_statics(tp_evaluation *evaluation, tp_case *own, kept_limit *kept,
                             const climb *c) {
  const tp_place place = c->problem->scene->friction_angle_deg.place;
  bool done = true;
  if (!kept->settled) {
    const tp_effect_begin began = tp_effects_begin(c->solution);
    evaluation->certain = true;
    done = tp_evaluate_limit(evaluation, own, &kept->limit, &kept->back);
    kept->settled = evaluation->certain;
    tp_effects_note(c->solution, "limit", place, "", began);
  }
  if (done && !kept->onset_settled) {
    const tp_effect_begin began = tp_effects_begin(c->solution);
    evaluation->certain = true;
    done = tp_evaluate_onset(evaluation, own, &kept->onset);
    kept->onset_settled = evaluation->certain;
    tp_effects_note(c->solution, "onset", place, "", began);
  }
  if (done && kept->settled && kept->onset_settled) {
    tp_onset_meet_limit(own, evaluation, &kept->onset, &kept->limit);
  }
  return done;
}

/* False when memory is exhausted. */
static bool evaluate_motions(tp_evaluation *evaluation, tp_case *own, const climb *c) {
  const tp_scene *scene = c->problem->scene;
  kept_limit *kept = c->kept + own->towards;
  tp_direction_ball toppling, sliding;
  tp_direction_ball_init(&toppling);
  tp_direction_ball_init(&sliding);
  bool done = true;
  tp_effect_begin began = tp_effects_begin(c->solution);
  tp_evaluate_pivots(evaluation, own, &toppling);
  if (c->problem->corners.count > 0) tp_evaluate_rolling(evaluation, own, &toppling);
  tp_effects_note(c->solution, "toppling", scene->tilt_place, "both directions, as none is given",
                  began);
  if (scene->friction_angle_deg.given) {
    began = tp_effects_begin(c->solution);
    tp_evaluate_sliding(evaluation, own, &sliding);
    tp_evaluate_toe(evaluation, own, &toppling);
    tp_effects_note(c->solution, "sliding", scene->friction_angle_deg.place, "", began);
  }
  const bool certain = evaluation->certain;
  if (scene->friction_angle_deg.given && c->options->limit) {
    done = evaluate_statics(evaluation, own, kept, c);
  } else {
    kept->settled = kept->onset_settled = true;
  }
  const bool statics[2] = {kept->settled, kept->onset_settled};
  evaluation->certain = true;
  tp_evaluate_mechanism(evaluation, own, &toppling, &sliding,
                        &(tp_statics){&kept->limit, &kept->back, &kept->onset});
  kept->settled = statics[0] && evaluation->certain;
  kept->onset_settled = statics[1] && evaluation->certain;
  evaluation->certain = certain && kept->settled && kept->onset_settled;
  if (c->options->elements) tp_evaluate_account(evaluation, own, &toppling);
  tp_direction_ball_clear(&toppling);
  tp_direction_ball_clear(&sliding);
  return done;
}

/* A case, under its loads where the scene calls for some. */
static bool evaluate_case(tp_evaluation *evaluation, tp_case *own, const climb *c) {
  evaluation->loaded = NULL;
  if (!c->problem->loaded) {
    return evaluate_motions(evaluation, own, c);
  }
  tp_loaded loaded;
  if (!tp_loaded_init(&loaded, evaluation, own->towards, c->solution)) return false;
  evaluation->loaded = &loaded;
  const bool done = evaluate_motions(evaluation, own, c);
  tp_loaded_account(own, &loaded, evaluation);
  tp_loaded_overtops(own, evaluation);
  tp_loaded_clear(&loaded);
  return done;
}

static tp_status step(void *context, tp_rung rung, bool *certain) {
  const climb *c = context;
  if (tp_problem_is_enclosed(c->problem) && rung.level == TP_LEVEL_EXACT)
    rung.level = TP_LEVEL_BALL;
  tp_evaluation evaluation = {.problem = c->problem,
                              .rung = rung,
                              .digits = c->options->digits,
                              .decimals = c->solution->decimals,
                              .reduces_strength = c->options->strength_reduction,
                              .tells_ranges = c->options->motion_ranges,
                              .certain = true,
                              .work = c->work,
                              .settled = {c->settled[0], c->settled[1]}};
  const tp_effect_begin began = tp_effects_begin(c->solution);
  tp_moments_init(&evaluation.moments);
  arb_init(evaluation.weight_per_area_pa);
  tp_evaluate_moments(&evaluation);
  tp_evaluate_block(&evaluation, c->solution);
  tp_evaluate_contact(&evaluation, c->solution);
  tp_effects_note(c->solution, "moments", c->problem->scene->block.place, "", began);
  bool done = true;
  for (size_t k = 0; k < c->solution->case_count && done; k++) {
    done = evaluate_case(&evaluation, c->solution->cases + k, c);
  }
  tp_moments_clear(&evaluation.moments);
  arb_clear(evaluation.weight_per_area_pa);
  *certain = evaluation.certain;
  c->solution->open_number = evaluation.open_number;
  done = done && (evaluation.decimals == NULL || !tp_decimals_failed(evaluation.decimals));
  return done ? TP_OK : tp_fail_memory(c->message, "the loads, the limit or the digits");
}

/* What was computed on the ladder was computed at the level that it reached. */
static void note_level(tp_solution *solution, tp_rung reached) {
  solution->level = reached.level;
  solution->bits = reached.bits;
  static const char *const climbing[] = {"moments", "toppling", "sliding", "limit", "onset"};
  for (size_t k = 0; k < solution->effect_count; k++) {
    for (size_t c = 0; c < sizeof climbing / sizeof climbing[0]; c++) {
      if (strcmp(solution->effects[k].name, climbing[c]) == 0) {
        solution->effects[k].level = reached.level;
      }
    }
  }
}

static tp_status climb_ladder(const tp_problem *problem, const tp_solve_options *options,
                              tp_solution *solution, tp_message *message) {
  const size_t points = (size_t)problem->contact.point_count;
  kept_limit kept[2] = {{0}, {0}};
  for (int d = 0; d < 2; d++) {
    tp_direction_ball_init(&kept[d].limit);
    tp_direction_ball_init(&kept[d].back);
    tp_onset_found_init(&kept[d].onset);
  }
  tp_work work = {.spent = 0};
  climb c = {problem, options, solution, {calloc(points, 1), calloc(points, 1)},
             message, kept,    &work};
  tp_rung reached = {TP_LEVEL_DOUBLE, 0};
  tp_status status = TP_OK;
  if (c.settled[0] == NULL || c.settled[1] == NULL) {
    status = tp_fail_memory(message, "the pivots");
  } else {
    status = tp_ladder_climb(step, &c, options->level, options->digits, &reached);
    note_level(solution, reached);
  }
  if (status == TP_UNDECIDED) {
    (void)tp_fail(message, TP_UNDECIDED, (tp_place){problem->scene->path, 0, 0},
                  "undecided at %ld bits%s%s: a number is not certain to %d digit%s", reached.bits,
                  options->level < TP_LEVEL_EXACT ? " of level " : "",
                  options->level < TP_LEVEL_EXACT ? tp_level_name(options->level) : "",
                  options->digits, options->digits == 1 ? "" : "s");
  }
  for (int d = 0; d < 2; d++) {
    free(c.settled[d]);
    tp_direction_ball_clear(&kept[d].limit);
    tp_direction_ball_clear(&kept[d].back);
    tp_onset_found_clear(&kept[d].onset);
  }
  return status;
}

tp_status tp_solve_problem(tp_solution *solution, const tp_problem *problem,
                           const tp_solve_options *options, tp_message *message) {
  const tp_status status = tp_solution_describe(solution, problem, options, message);
  if (status != TP_OK) return status;
  const tp_status climbed = climb_ladder(problem, options, solution, message);
  if (climbed == TP_OK) tp_solution_govern(solution);
  return climbed;
}

static tp_status fill(tp_solution *solution, const tp_scene *scene, const tp_solve_options *options,
                      tp_message *message) {
  tp_problem problem;
  tp_status status = tp_notes_append(&solution->notes, &scene->notes, message);
  if (status == TP_OK) status = tp_problem_init(&problem, scene, options, solution, message);
  if (status != TP_OK) return status;
  status = tp_problem_cautions(&solution->notes, &problem, message);
  if (status == TP_OK) status = tp_solve_problem(solution, &problem, options, message);
  tp_problem_clear(&problem);
  return status;
}

tp_status tp_solve(tp_solution **solution, const tp_scene *scene, const tp_solve_options *options,
                   tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, solution);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, options);
  if (options->digits < 1 || options->digits > TP_DIGITS_MAX) {
    return tp_fail(message, TP_BAD_INPUT, (tp_place){0}, "digits must lie between 1 and %d",
                   TP_DIGITS_MAX);
  }
  if ((int)options->level < 0 || (int)options->level >= TP_LEVELS) {
    return tp_fail(message, TP_BAD_INPUT, (tp_place){0}, "there is no such level of arithmetic");
  }
  tp_solution *filled = calloc(1, sizeof *filled);
  if (filled == NULL) return tp_fail_memory(message, "the solution");
  const tp_status status = fill(filled, scene, options, message);
  if (status == TP_OK) {
    *solution = filled;
  } else {
    tp_solution_free(filled);
  }
  return status;
}
