/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A tilt test of a scene: statics for the window, then the engine, a direction after the other. */

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
#include "tilt/facets.h"
#include "tilt/follow.h"
#include "tilt/overturning.h"
#include "tilt/path.h"
#include "tilt/result.h"
#include "tilt/settings.h"
#include "tilt/tractions.h"
#include "tilt/words.h"

#include <stdlib.h>
#include <string.h>

TP_OPTIONS_END(tp_tilt_options, smaller_count);

enum { MOST_MOMENTS = 1000000 };

void tp_tilt_options_init(tp_tilt_options *options, size_t size) {
  const tp_tilt_options defaults = {.size = sizeof defaults, .moments = 400, .smaller_count = 128};
  tp_options_fill(options, size, &defaults);
}

void tp_tilt_test_free(tp_tilt_test *test) {
  if (test == NULL) return;
  for (size_t k = 0; k < test->case_count; k++) {
    tp_tilt_case *own = test->cases + k;
    free(own->events);
    free(own->moments);
    free(own->reactions);
    free(own->facets);
    free(own->outline);
    free(own->base);
    free(own->overturning_ranges);
  }
  free(test->cases);
  tp_notes_clear(&test->notes);
  free(test->title);
  free(test);
}

/* ---- one direction -----------------------------------------------------------------------------
 */

/* What a scene is tested with. */
typedef struct stage {
  tp_tilt_test *test;
  const tp_problem *problem;
  const tp_tilt_options *options;
  tp_base_shaking *shaking; /* NULL: none */
  const tp_tilt_test_description *asked;
  tp_place place;   /* that calls for the test */
  tp_place of_step; /* for the time step of springs */
  tp_message *message;
} stage;

/* To a bracket, then on to the end. */
static tp_status run_dynamics(tp_tilting *tilting, double least_deg, double most_deg) {
  const tp_tilt_settings *s = tilting->settings;
  tp_tilt_case *own = tilting->own;
  own->end = TP_TILT_STANDS;
  tp_status status =
      s->protocol == TP_TILT_RAMP
          ? tp_tilting_ramp(tilting)
          : tp_tilting_bracket(tilting, tp_tilting_look, least_deg, most_deg, s->until_deg);
  if (status != TP_OK || !own->has_bracket) return status;
  tp_xy centre = {0, 0};
  /* rigid contacts are released at rest */
  if (s->engine == TP_TILT_RIGID &&
      !tp_tilt_engines_begin(&tilting->moves_off, tilting, own->lets_go_at_deg)) {
    tilting->moves_off = (tp_body_state){.turned = 0};
  }
  own->mechanism =
      tp_tilting_mechanism(&centre, &own->has_centre, tilting->body, &tilting->moves_off);
  own->has_mechanism = own->mechanism != TP_MECHANISM_UNDECIDED;
  own->centre_x_m = centre.x + tilting->body->origin.x;
  own->centre_y_m = centre.y + tilting->body->origin.y;
  return own->end == TP_TILT_STANDS ? tp_tilting_follow(tilting) : TP_OK;
}

/* Did it move and come through, so that weaker shaking may yet overturn it? */
static bool comes_through(const tp_tilting *tilting) {
  const tp_tilt_end end = tilting->own->end;
  return end == TP_TILT_RESTS || end == TP_TILT_MOVES;
}

static tp_status run_release(tp_tilting *tilting, const stage *g) {
  const tp_status status = tp_tilting_follow(tilting);
  tilting->own->converged = true;
  if (status != TP_OK || g->shaking == NULL) return status;
  if (g->options->overturning) return tp_tilting_overturning(tilting, g->shaking);
  const bool rigid = tilting->settings->engine == TP_TILT_RIGID;
  if (!rigid || g->options->smaller_count == 0 || !comes_through(tilting)) return TP_OK;
  return tp_tilting_overturning_below(tilting, g->shaking);
}

static tp_status run_case(tp_tilting *tilting, const stage *g) {
  tp_tilt_case *own = tilting->own;
  const tp_tilt_settings *s = tilting->settings;
  const double least = own->has_onset ? own->onset_deg - 0.4 * s->tolerance_deg : 0,
               most = own->has_limit ? own->limit_deg + 0.4 * s->tolerance_deg : 0;
  tp_tilt_engines engines;
  if (s->engine == TP_TILT_PATH) return tp_tilting_path(tilting, least, most);
  tp_status status =
      tp_tilt_dynamics_of(&tilting->engine, &engines, s, tilting->body, g->of_step, g->message);
  if (status == TP_OK) {
    status = s->protocol == TP_TILT_RELEASE ? run_release(tilting, g)
                                            : run_dynamics(tilting, least, most);
  }
  tilting->engine = (tp_tilt_dynamics){NULL, NULL};
  if (status != TP_OK) return status;
  status = tp_tilt_engines_notes(&g->test->notes, &engines, g->place, g->message);
  if (status != TP_OK || tilting->why.text[0] == '\0') return status;
  return tp_notes_add(&g->test->notes, g->message, TP_CAUTION, g->place, "a run is undecided: %s",
                      tilting->why.text);
}

static tp_status test_direction(tp_tilt_case *own, const tp_case *statics, const stage *g) {
  tp_rigid_body body;
  tp_status status = tp_rigid_body_init(&body, g->problem, statics->towards, g->message);
  if (status != TP_OK) return status;
  tp_tilting tilting = {.body = &body,
                        .settings = &g->test->settings,
                        .options = g->options,
                        .own = own,
                        .asked = g->asked,
                        .shaken = g->problem->scene->shaking,
                        .message = g->message};
  if (g->shaking != NULL) {
    tilting.shaking = &g->shaking->motion;
    tilting.shaking_s = tp_base_shaking_duration(g->shaking);
  }
  own->towards = statics->towards;
  tp_tilt_result_window(own, statics);
  tp_path_traction *tractions = NULL;
  status = tp_tilt_tractions_of(&tractions, &body, g->asked, g->message);
  tilting.tractions = tractions;
  if (status == TP_OK) status = run_case(&tilting, g);
  free(tractions);
  if (status == TP_OK) {
    tp_tilt_result_take(own, &tilting.history, &body);
    tp_tilt_result_place(own, g->test->settings.tolerance_deg);
    if (!tp_tilt_result_draw(own, &body) || !tp_tilt_facets_fill(own, &body, g->problem)) {
      status = tp_fail_memory(g->message, "the drawing");
    }
  }
  tp_history_clear(&tilting.history);
  tp_rigid_body_clear(&body);
  return status;
}

/* ---- the scene ---------------------------------------------------------------------------------
 */

static tp_status describe(tp_tilt_test *test, const tp_scene *scene, const tp_problem *problem,
                          const tp_base_shaking *shaking, tp_message *message) {
  test->settings = tp_tilt_settings_of(scene, problem->scene);
  test->length_unit = scene->length_unit;
  test->metres_per_unit = fmpq_get_d(scene->metres_per_unit);
  if (scene->title != NULL) {
    test->title = strdup(scene->title);
    if (test->title == NULL) return tp_fail_memory(message, "the test");
  }
  tp_status status = tp_scene_notes(&test->notes, scene, message);
  if (status == TP_OK) status = tp_problem_cautions(&test->notes, problem, message);
  for (int axis = 0; axis < TP_SHAKING_AXES && shaking != NULL; axis++) {
    const tp_shaking_peaks peaks = tp_base_acceleration_peaks(shaking->axes + axis);
    test->shaking[axis] =
        (tp_tilt_shaking){shaking->axes[axis].form != TP_SHAKING_NONE, peaks.acceleration_m_s2,
                          peaks.velocity_m_s, peaks.last_velocity_m_s, peaks.duration_s};
  }
  return status == TP_OK ? tp_tilt_notes(test, scene, message) : status;
}

/* On level ground both directions are one. */
static size_t count_directions(const tp_tilt_settings *s, size_t count) {
  return s->protocol == TP_TILT_RELEASE && s->release_deg == 0 && count > 1 ? 1 : count;
}

static tp_status test_problem(const stage *g, const tp_solution *statics) {
  tp_tilt_test *test = g->test;
  const size_t count = count_directions(&test->settings, statics->case_count);
  test->cases = calloc(count + 1, sizeof *test->cases);
  if (test->cases == NULL) return tp_fail_memory(g->message, "the test");
  tp_status status = TP_OK;
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    test->case_count++;
    status = test_direction(test->cases + k, statics->cases + k, g);
  }
  return status;
}

static tp_status fill(tp_tilt_test *test, const tp_scene *scene, const tp_tilt_options *options,
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
    const bool shaken = tp_scene_is_shaken(scene);
    if (shaken) status = tp_base_shaking_init(&shaking, scene, message);
    if (status == TP_OK) {
      status = describe(test, scene, &problem, shaken ? &shaking : NULL, message);
    }
    if (status == TP_OK) status = tp_solve_problem(statics, &problem, &solve, message);
    const tp_tilt_test_description *asked = &scene->tilt_test;
    const tp_place place = asked->place.file != NULL ? asked->place : scene->shaking_place;
    const stage g = {.test = test,
                     .problem = &problem,
                     .options = options,
                     .shaking = shaken ? &shaking : NULL,
                     .asked = asked,
                     .place = place,
                     .of_step = asked->time_step_s.given ? asked->time_step_s.place : place,
                     .message = message};
    if (status == TP_OK) status = test_problem(&g, statics);
    tp_base_shaking_clear(&shaking);
    tp_problem_clear(&problem);
  }
  tp_solution_free(statics);
  return status;
}

/* What a simulation needs of a scene. */
static tp_status check(const tp_scene *scene, const tp_tilt_options *options, tp_message *message) {
  if (options->moments < 2 || options->moments > MOST_MOMENTS) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){0}, "moments must lie between 2 and %d",
                     MOST_MOMENTS);
  }
  const tp_status status = tp_tilt_check_scene(scene, message);
  if (status != TP_OK) return status;
  if (options->overturning && !tp_scene_is_shaken(scene)) {
    return tp_refuse(message, TP_FAULT_KEY, scene->tilt_test.place,
                     "the shaking that overturns the block is requested, but the scene gives "
                     "no 'shaking'");
  }
  return tp_overturning_check(options, message);
}

tp_status tp_tilt_test_run(tp_tilt_test **test, const tp_scene *scene,
                           const tp_tilt_options *options, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, test);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, options);
  tp_tilt_options own = tp_tilt_options_default();
  TP_TAKE_OPTIONS(message, own, options);
  tp_status status = check(scene, options, message);
  if (status != TP_OK) return status;
  tp_tilt_test *filled = calloc(1, sizeof *filled);
  if (filled == NULL) return tp_fail_memory(message, "the test");
  filled->size = sizeof *filled;
  status = fill(filled, scene, options, message);
  if (status == TP_OK) {
    *test = filled;
  } else {
    tp_tilt_test_free(filled);
  }
  return status;
}
