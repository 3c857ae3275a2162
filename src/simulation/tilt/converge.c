/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A tilt test of a scene at several values of each of its settings, one setting after the other;
 * where one was refined the next are varied about that. */

#include "tilt/converge.h"

#include "common/host.h"
#include "common/notes.h"
#include "common/options.h"
#include "problem/problem.h"
#include "scene/check_tilt_test.h"
#include "shaking/shaking.h"
#include "stability/cautions.h"
#include "stability/solution.h"
#include "stability/solve.h"
#include "tilt/bracket.h"
#include "tilt/engines.h"
#include "tilt/follow.h"
#include "tilt/overturning.h"
#include "tilt/path.h"
#include "tilt/result.h"
#include "tilt/settings.h"
#include "tilt/tractions.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of a factor on the shaking: five times the share to which it is bracketed. */
static const double asked_of_factor = 5e-3;

/* Settings in the order in which they are varied: what others may be refined for comes first. */
static const tp_converge_setting order[TP_CONVERGE_SETTINGS] = {
    TP_CONVERGE_STIFFNESS,    TP_CONVERGE_STIFFNESS_RATIO, TP_CONVERGE_TIME_STEP,
    TP_CONVERGE_DAMPING,      TP_CONVERGE_ROUNDING,        TP_CONVERGE_STEP_TOLERANCE,
    TP_CONVERGE_LEAST_BOUNCE, TP_CONVERGE_TOLERANCE};

void tp_tilt_convergence_free(tp_tilt_convergence *convergence) {
  if (convergence == NULL) return;
  for (size_t k = 0; k < convergence->case_count; k++) {
    free(convergence->cases[k].settings);
    free(convergence->cases[k].levels);
  }
  free(convergence->cases);
  for (size_t k = 0; k < convergence->source_count; k++) free(convergence->sources[k]);
  free(convergence->sources);
  tp_notes_clear(&convergence->notes);
  free(convergence->title);
  free(convergence);
}

/* ---- one level ---------------------------------------------------------------------------------
 */

typedef struct stage {
  const tp_rigid_body *body;
  const tp_tilt_options *options;
  tp_base_shaking *shaking;                    /* NULL: none */
  const tp_tilt_test_description *description; /* of the scene */
  const tp_path_traction *tractions;           /* of the path; NULL: none */
  tp_place place;
  tp_message *message;
} stage;

/* The bracket, and nothing after it; where to look first is between `least` and `most`. */
static tp_status run_once(tp_tilt_case *found, const tp_converge_run *run, double least,
                          double most, const stage *g) {
  tp_tilting tilting = {.body = g->body,
                        .settings = &run->settings,
                        .options = g->options,
                        .tractions = g->tractions,
                        .own = found,
                        .weight_moves = run->weight_moves,
                        .path_tolerance_deg = run->path_tolerance_deg,
                        .asked = g->description,
                        .budgets = 10, /* its finest are dearer, and asked for */
                        .message = g->message};
  tp_tilt_engines engines;
  tp_status status = TP_OK;
  if (g->shaking != NULL) {
    tilting.shaking = &g->shaking->motion;
    tilting.shaking_s = tp_base_shaking_duration(g->shaking);
  }
  if (run->settings.engine == TP_TILT_PATH) {
    status = tp_tilting_path(&tilting, least, most);
  } else {
    status = tp_tilt_dynamics_of(&tilting.engine, &engines, &run->settings, g->body, g->place,
                                 g->message);
    engines.rigid.tolerance = run->step_tolerance;
    engines.rigid.least_bounce = run->least_bounce;
    if (status == TP_OK) {
      const tp_tilt_protocol protocol = run->settings.protocol;
      status = protocol == TP_TILT_RELEASE ? tp_tilting_overturning(&tilting, g->shaking)
               : protocol == TP_TILT_RAMP  ? tp_tilting_ramp(&tilting)
                                           : tp_tilting_bracket(&tilting, tp_tilting_look, least,
                                                                most, run->settings.until_deg);
    }
    tilting.engine = (tp_tilt_dynamics){NULL, NULL};
  }
  tp_history_clear(&tilting.history);
  return status;
}

/* What is short is run several times, and told by the quickest. */
static tp_status run_level(tp_converge_level *level, const tp_converge_run *run, double least,
                           double most, const stage *g) {
  enum { REPEATS = 5 };
  static const double short_s = 5e-3;
  *level = (tp_converge_level){
      .setting = run->setting, .value = run->value, .own = run->own, .seconds = INFINITY};
  for (int k = 0; k < REPEATS && (k == 0 || level->seconds < short_s); k++) {
    tp_tilt_case found = {.end = TP_TILT_STANDS, .converged = true};
    const tp_status status = run_once(&found, run, least, most, g);
    free(found.overturning_ranges);
    if (status != TP_OK) return status;
    const bool factor = run->settings.protocol == TP_TILT_RELEASE;
    level->known = found.converged && (factor ? found.has_overturning : found.has_bracket);
    level->bracket_least = !level->known ? 0 : factor ? found.spared_by : found.stands_at_deg;
    level->bracket_most = !level->known ? 0 : factor ? found.overturned_by : found.lets_go_at_deg;
    level->runs = found.runs;
    level->seconds = fmin(level->seconds, found.seconds);
  }
  return TP_OK;
}

/* ---- one setting -------------------------------------------------------------------------------
 */

/* The base from which settings are varied: as the scene has them, or as they were refined. */
typedef struct base {
  tp_converge_run run;
  double most; /* of its bracket */
} base;

/* Where to look first: about the tilts of statics, a bracket wide and not even on both sides, so
 * that no run is at the very tilt at which a block neither stands nor goes. What a width of the
 * bracket costs is told by a search that expects nothing. */
static tp_status look_about(tp_converge_level *level, const tp_converge_run *run,
                            const tp_tilt_convergence_case *own, const tp_tilt_convergence *c,
                            const stage *g) {
  const double below = 0.11 * c->asked, above = 0.13 * c->asked;
  const bool nothing = run->setting == TP_CONVERGE_TOLERANCE && run->value > 0;
  return run_level(level, run, own->has_onset && !nothing ? own->onset_deg - below : 0,
                   own->has_limit && !nothing ? own->limit_deg + above : 0, g);
}

/* The levels of one setting, behind those of the case. A value that the engine refuses is left out,
 * as contacts that are too soft to carry the block. */
static tp_status run_setting(tp_tilt_convergence_case *own, base *from, tp_converge_setting setting,
                             const tp_tilt_convergence *c, const stage *g) {
  tp_converge_run runs[TP_CONVERGE_MOST_LEVELS], kept[TP_CONVERGE_MOST_LEVELS];
  const size_t count = tp_converge_runs(runs, setting, &from->run, c->quantity, g->body);
  tp_converge_finding *finding = own->settings + own->setting_count;
  const double asked = c->asked * (c->quantity == TP_CONVERGE_ANGLE ? 1 : from->most);
  *finding = (tp_converge_finding){.setting = setting, .first = own->level_count};
  for (size_t k = 0; k < count; k++) {
    tp_converge_level *level = own->levels + own->level_count;
    const tp_status status = look_about(level, runs + k, own, c, g);
    if (status == TP_BAD_INPUT && !runs[k].own) continue;
    if (status != TP_OK) return status;
    kept[finding->count++] = runs[k];
    own->level_count++;
    if (tp_converge_settled(own->levels + finding->first, finding->count, asked)) {
      break;
    }
  }
  if (finding->count < 2) { /* nothing to compare with */
    own->level_count = finding->first;
    return TP_OK;
  }
  own->setting_count++;
  tp_converge_judge(finding, own->levels, asked);
  if (finding->verdict != TP_CONVERGE_REFINED) return TP_OK;
  for (size_t k = 0; k < finding->count; k++) {
    const tp_converge_level *level = own->levels + finding->first + k;
    if (level->value != finding->needed) continue;
    const double width = from->run.settings.tolerance_deg;
    *from = (base){kept[k], level->bracket_most};
    from->run.settings.tolerance_deg = width;
    from->run.path_tolerance_deg = 0;
  }
  return TP_OK;
}

static tp_status run_settings(tp_tilt_convergence_case *own, const tp_tilt_convergence *c,
                              const stage *g) {
  base from = {.run = tp_converge_own(&c->settings)};
  tp_converge_level level;
  const tp_status status = look_about(&level, &from.run, own, c, g);
  if (status != TP_OK || !level.known) return status;
  own->known = true;
  own->as_set_least = level.bracket_least;
  own->as_set_most = from.most = level.bracket_most;
  for (int k = 0; k < TP_CONVERGE_SETTINGS; k++) {
    const tp_status of_setting = run_setting(own, &from, order[k], c, g);
    if (of_setting != TP_OK) return of_setting;
  }
  return TP_OK;
}

static tp_status run_direction(tp_tilt_convergence_case *own, const tp_case *statics,
                               const tp_problem *problem, tp_tilt_convergence *c, stage *g) {
  tp_rigid_body body;
  tp_tilt_case window = {.end = TP_TILT_STANDS};
  own->settings = calloc(TP_CONVERGE_SETTINGS, sizeof *own->settings);
  own->levels = calloc(TP_CONVERGE_SETTINGS * TP_CONVERGE_MOST_LEVELS, sizeof *own->levels);
  if (own->settings == NULL || own->levels == NULL) return tp_fail_memory(g->message, "the levels");
  tp_status status = tp_rigid_body_init(&body, problem, statics->towards, g->message);
  if (status != TP_OK) return status;
  tp_tilt_result_window(&window, statics);
  own->towards = statics->towards;
  own->has_onset = window.has_onset;
  own->has_limit = window.has_limit;
  own->onset_deg = window.onset_deg;
  own->limit_deg = window.limit_deg;
  g->body = &body;
  tp_path_traction *tractions = NULL;
  status = tp_tilt_tractions_of(&tractions, &body, g->description, g->message);
  g->tractions = tractions;
  if (status == TP_OK) status = run_settings(own, c, g);
  free(tractions);
  tp_converge_summarise(own);
  tp_rigid_body_clear(&body);
  return status;
}

/* ---- the scene ---------------------------------------------------------------------------------
 */

static tp_status describe(tp_tilt_convergence *c, const tp_scene *scene, const tp_problem *problem,
                          tp_message *message) {
  c->settings = tp_tilt_settings_of(scene, problem->scene);
  const bool release = c->settings.protocol == TP_TILT_RELEASE;
  c->quantity = release ? TP_CONVERGE_OVERTURNING : TP_CONVERGE_ANGLE;
  c->asked = release ? asked_of_factor : c->settings.tolerance_deg;
  if (release && !tp_scene_is_shaken(scene)) {
    return tp_refuse(message, TP_FAULT_KEY, scene->tilt_test.place,
                     "a block that is released has no critical angle that could converge: take "
                     "'protocol: steps' or 'ramp'");
  }
  if (scene->title != NULL) {
    c->title = strdup(scene->title);
    if (c->title == NULL) return tp_fail_memory(message, "the title");
  }
  tp_status status = tp_scene_copy_sources(&c->sources, &c->source_count, scene, message);
  if (status == TP_OK) status = tp_scene_notes(&c->notes, scene, message);
  return status == TP_OK ? tp_problem_cautions(&c->notes, problem, message) : status;
}

static tp_status run_directions(tp_tilt_convergence *c, const tp_solution *statics,
                                const tp_problem *problem, stage *g) {
  const bool level = c->settings.protocol == TP_TILT_RELEASE && c->settings.release_deg == 0;
  const size_t count = level && statics->case_count > 1 ? 1 : statics->case_count;
  c->cases = calloc(count + 1, sizeof *c->cases);
  if (c->cases == NULL) return tp_fail_memory(g->message, "the cases");
  tp_status status = TP_OK;
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    c->case_count++;
    status = run_direction(c->cases + k, statics->cases + k, problem, c, g);
  }
  return status;
}

static tp_status fill(tp_tilt_convergence *c, const tp_scene *scene, const tp_tilt_options *options,
                      tp_message *message) {
  const tp_solve_options solve = {.size = sizeof solve,
                                  .limit = true,
                                  .digits = 9,
                                  .level = TP_LEVEL_EXACT,
                                  .pivots = TP_PIVOTS_GOVERNING};
  tp_solution *statics = tp_solution_new();
  tp_problem problem;
  tp_base_shaking shaking = {.motion = {NULL, NULL, NULL}};
  if (statics == NULL) return tp_fail_memory(message, "the solution");
  tp_status status = tp_problem_init(&problem, scene, &solve, statics, message);
  if (status == TP_OK) {
    const bool shaken = tp_scene_is_shaken(scene), asked = scene->tilt_test.place.file != NULL;
    stage g = {.options = options,
               .shaking = shaken ? &shaking : NULL,
               .description = &scene->tilt_test,
               .place = asked ? scene->tilt_test.place : scene->shaking_place,
               .message = message};
    status = describe(c, scene, &problem, message);
    if (status == TP_OK && shaken) status = tp_base_shaking_init(&shaking, scene, message);
    if (status == TP_OK) status = tp_solve_problem(statics, &problem, &solve, message);
    if (status == TP_OK) status = run_directions(c, statics, &problem, &g);
    tp_base_shaking_clear(&shaking);
    tp_problem_clear(&problem);
  }
  tp_solution_free(statics);
  return status;
}

tp_status tp_tilt_converge(tp_tilt_convergence **convergence, const tp_scene *scene,
                           const tp_tilt_options *options, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, convergence);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, options);
  tp_tilt_options own = tp_tilt_options_default();
  TP_TAKE_OPTIONS(message, own, options);
  own.moments = 2; /* nothing is drawn of them */
  tp_status status = tp_tilt_check_scene(scene, message);
  if (status == TP_OK) status = tp_overturning_check(options, message);
  if (status != TP_OK) return status;
  tp_tilt_convergence *filled = calloc(1, sizeof *filled);
  if (filled == NULL) return tp_fail_memory(message, "the account of convergence");
  filled->size = sizeof *filled;
  status = fill(filled, scene, &own, message);
  if (status == TP_OK) {
    *convergence = filled;
  } else {
    tp_tilt_convergence_free(filled);
  }
  return status;
}
