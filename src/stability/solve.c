/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene in, the stability of its block out. */

#include "stability/solve.h"
#include "number/ladder.h"
#include "stability/effects.h"
#include "stability/loaded.h"

#include <stdlib.h>
#include <string.h>

tp_solve_options tp_solve_options_default(void) {
  return (tp_solve_options){
      .limit = true, .strength_reduction = true, .digits = 9, .level = TP_LEVEL_EXACT};
}

void tp_solution_free(tp_solution *solution) {
  if (solution == NULL) return;
  for (size_t k = 0; k < solution->case_count; k++) {
    free(solution->cases[k].pivots);
    free(solution->cases[k].account.elements);
    free(solution->cases[k].loads);
    free(solution->cases[k].limits);
  }
  tp_decimals_free(solution->decimals);
  free(solution->title);
  free(solution);
}

static tp_status describe_scene(tp_solution *solution, const tp_scene *scene, tp_message *message) {
  solution->length_unit = scene->length_unit;
  solution->metres_per_unit = fmpq_get_d(scene->metres_per_unit);
  solution->has_tilt_angle = scene->tilt_angle_deg.given;
  solution->tilt_angle_deg = tp_evaluation_rational(scene->tilt_angle_deg.value);
  solution->has_friction = scene->friction_angle_deg.given;
  solution->friction_angle_deg = tp_evaluation_rational(scene->friction_angle_deg.value);
  solution->friction_is_residual = scene->friction.load_dependent;
  if (scene->title == NULL) return TP_OK;
  solution->title = strdup(scene->title);
  return solution->title != NULL ? TP_OK : tp_fail_memory(message, "the solution");
}

static tp_bounded teeth_length(const tp_scene *scene, const fmpq_t value, long numerator,
                               const fmpq_t added, unsigned long denominator) {
  fmpq_t length;
  fmpz_t factor;
  fmpq_init(length);
  fmpz_init_set_si(factor, numerator);
  fmpq_mul_fmpz(length, value, factor);
  if (added != NULL) {
    fmpz_set_ui(factor, denominator);
    fmpq_t part;
    fmpq_init(part);
    fmpq_div_fmpz(part, added, factor);
    fmpq_add(length, length, part);
    fmpq_clear(part);
  }
  fmpq_mul(length, length, scene->metres_per_unit);
  const tp_bounded result = tp_evaluation_rational(length);
  fmpq_clear(length);
  fmpz_clear(factor);
  return result;
}

/* Both descriptions of a toothed block (section 5.1 of the paper): dx = N a, y = b + c / 2, A = c,
 * lambda = 2 a. */
static void describe_teeth(tp_solution *solution, const tp_scene *scene) {
  tp_teeth_result *result = &solution->teeth;
  const tp_teeth *teeth = &scene->block.teeth;
  result->known = scene->block.form == TP_OUTLINE_TEETH;
  if (!result->known) return;
  result->count = (size_t)teeth->count;
  result->width_m = teeth_length(scene, teeth->width, 1, NULL, 1);
  result->height_m = teeth_length(scene, teeth->height, 1, NULL, 1);
  result->depth_m = result->amplitude_m = teeth_length(scene, teeth->depth, 1, NULL, 1);
  result->block_width_m = teeth_length(scene, teeth->width, teeth->count, NULL, 1);
  result->mean_height_m = teeth_length(scene, teeth->height, 1, teeth->depth, 2);
  result->wavelength_m = teeth_length(scene, teeth->width, 2, NULL, 1);
  const bool right_valley = (teeth->count % 2 == 0) == teeth->left_end_valley;
  result->left_end = teeth->left_end_valley ? TP_PIVOT_VALLEY : TP_PIVOT_PEAK;
  result->right_end = right_valley ? TP_PIVOT_VALLEY : TP_PIVOT_PEAK;
}

/* What is exact about the pivots, once for all rungs. */
static void describe_pivots(tp_case *own, const tp_problem *problem) {
  for (size_t k = 0; k < own->pivot_count; k++) {
    const tp_contact_point *p = problem->contact.points + k;
    own->pivots[k] = (tp_pivot){.kind = p->kind,
                                .x_m = tp_evaluation_x(problem, p->point),
                                .y_m = tp_evaluation_y(problem, p->point)};
  }
}

static tp_status make_cases(tp_solution *solution, const tp_problem *problem, bool account,
                            tp_message *message) {
  const bool asked[2] = {problem->scene->towards_left, problem->scene->towards_right};
  for (int d = 0; d < 2; d++) {
    if (!asked[d]) continue;
    tp_case *own = solution->cases + solution->case_count++;
    own->towards = d == 0 ? TP_TOWARDS_LEFT : TP_TOWARDS_RIGHT;
    own->pivot_count = (size_t)problem->contact.point_count;
    own->pivots = calloc(own->pivot_count, sizeof *own->pivots);
    if (own->pivots == NULL) return tp_fail_memory(message, "the pivots");
    describe_pivots(own, problem);
    if (problem->loaded) {
      own->loads = calloc((size_t)tp_loaded_account_count(problem->scene), sizeof *own->loads);
      own->limits = calloc(own->pivot_count * TP_ROOTS_MAX, sizeof *own->limits);
      if (own->loads == NULL || own->limits == NULL) return tp_fail_memory(message, "the loads");
      for (size_t k = 0; k < own->pivot_count; k++) {
        own->pivots[k].limits_deg = own->limits + k * TP_ROOTS_MAX;
      }
    }
    if (!account) continue;
    own->account.elements =
        calloc((size_t)problem->elements.count + 1, sizeof *own->account.elements);
    if (own->account.elements == NULL) return tp_fail_memory(message, "the elements");
  }
  return TP_OK;
}

/* A limit that a lower rung made certain, its mechanism included. */
typedef struct kept_limit {
  bool settled;
  tp_direction_ball limit, back;
} kept_limit;

typedef struct climb {
  const tp_problem *problem;
  const tp_solve_options *options;
  tp_solution *solution;
  bool *settled[2];
  bool *admissible[2]; /* with rounded corners, at the present rung */
  tp_message *message;
  kept_limit *kept; /* by direction */
} climb;

/* False when memory is exhausted. */
static bool evaluate_motions(tp_evaluation *evaluation, tp_case *own, const climb *c) {
  const tp_scene *scene = c->problem->scene;
  kept_limit *kept = c->kept + own->towards;
  tp_direction_ball toppling, sliding;
  tp_direction_ball_init(&toppling);
  tp_direction_ball_init(&sliding);
  bool done = true;
  double began = tp_effects_now();
  tp_evaluate_pivots(evaluation, own, &toppling);
  if (c->problem->corners.count > 0) tp_evaluate_rolling(evaluation, own, &toppling);
  tp_effects_note(c->solution, "toppling", scene->tilt_place, "both directions, as none is given",
                  began);
  if (scene->friction_angle_deg.given) {
    began = tp_effects_now();
    tp_evaluate_sliding(evaluation, own, &sliding);
    tp_evaluate_toe(evaluation, own, &toppling);
    tp_effects_note(c->solution, "sliding", scene->friction_angle_deg.place, "", began);
  }
  const bool certain = evaluation->certain;
  evaluation->certain = true;
  if (scene->friction_angle_deg.given && c->options->limit && !kept->settled) {
    began = tp_effects_now();
    done = tp_evaluate_limit(evaluation, own, &kept->limit, &kept->back);
    tp_effects_note(c->solution, "limit", scene->friction_angle_deg.place, "", began);
  }
  tp_evaluate_mechanism(evaluation, own, &toppling, &sliding, &kept->limit, &kept->back);
  kept->settled = evaluation->certain;
  evaluation->certain = certain && evaluation->certain;
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
  tp_loaded_clear(&loaded);
  return done;
}

/* Where the axes of rounded corners lie decides which of them may govern. */
static void find_admissible(tp_evaluation *e, const climb *c) {
  const double began = tp_effects_now();
  for (int d = 0; d < 2; d++) {
    tp_evaluate_admissible(e, c->admissible[d], d == 0 ? TP_TOWARDS_LEFT : TP_TOWARDS_RIGHT);
    e->admissible[d] = c->admissible[d];
  }
  tp_effects_note(c->solution, "rounding", c->problem->scene->block.rounded.place, "", began);
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
                              .certain = true,
                              .settled = {c->settled[0], c->settled[1]},
                              .admissible = {c->problem->admissible[0], c->problem->admissible[1]}};
  const double began = tp_effects_now();
  tp_moments_init(&evaluation.moments);
  tp_evaluate_moments(&evaluation);
  if (c->problem->corners.count > 0) find_admissible(&evaluation, c);
  tp_evaluate_block(&evaluation, c->solution);
  tp_evaluate_contact(&evaluation, c->solution);
  evaluation.weight_per_area_pa = c->solution->contact.weight_per_nominal_area_pa;
  tp_effects_note(c->solution, "moments", c->problem->scene->block.place, "", began);
  bool done = true;
  for (size_t k = 0; k < c->solution->case_count && done; k++) {
    done = evaluate_case(&evaluation, c->solution->cases + k, c);
  }
  tp_moments_clear(&evaluation.moments);
  *certain = evaluation.certain;
  done = done && (evaluation.decimals == NULL || !tp_decimals_failed(evaluation.decimals));
  return done ? TP_OK : tp_fail_memory(c->message, "the loads, the limit or the digits");
}

/* What was computed on the ladder was computed at the level that it reached. */
static void note_level(tp_solution *solution, tp_rung reached) {
  solution->level = reached.level;
  solution->bits = reached.bits;
  static const char *const climbing[] = {"moments", "toppling", "sliding", "limit", "rounding"};
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
  }
  climb c = {problem,
             options,
             solution,
             {calloc(points, 1), calloc(points, 1)},
             {calloc(points, 1), calloc(points, 1)},
             message,
             kept};
  tp_rung reached = {TP_LEVEL_DOUBLE, 0};
  tp_status status = TP_OK;
  if (c.settled[0] == NULL || c.settled[1] == NULL || c.admissible[0] == NULL ||
      c.admissible[1] == NULL) {
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
    free(c.admissible[d]);
    tp_direction_ball_clear(&kept[d].limit);
    tp_direction_ball_clear(&kept[d].back);
  }
  return status;
}

tp_status tp_solve_problem(tp_solution *solution, const tp_problem *problem,
                           const tp_solve_options *options, tp_message *message) {
  tp_status status = describe_scene(solution, problem->scene, message);
  describe_teeth(solution, problem->scene);
  solution->loaded = problem->loaded;
  solution->digits = options->digits;
  if (status == TP_OK && options->digits > TP_DECIMALS_OF_DOUBLE) {
    solution->decimals = tp_decimals_new(options->digits);
    if (solution->decimals == NULL) status = tp_fail_memory(message, "the digits");
  }
  if (status == TP_OK) status = make_cases(solution, problem, options->elements, message);
  if (status == TP_OK) status = climb_ladder(problem, options, solution, message);
  return status;
}

static tp_status fill(tp_solution *solution, const tp_scene *scene, const tp_solve_options *options,
                      tp_message *message) {
  tp_problem problem;
  tp_status status = tp_problem_init(&problem, scene, options, solution, message);
  if (status != TP_OK) return status;
  status = tp_solve_problem(solution, &problem, options, message);
  tp_problem_clear(&problem);
  return status;
}

tp_status tp_solve(tp_solution **solution, const tp_scene *scene, const tp_solve_options *options,
                   tp_message *message) {
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
