/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Creation and release of a solution: cases, pivots, descriptions of the scene and of teeth (both
 * descriptions of section 5.1 of the paper), facet frictions. */

#include "stability/solution.h"

#include "common/notes.h"
#include "evaluation/loaded.h"
#include "evaluation/pivot_list.h"
#include "evaluation/stages.h"
#include "onset/onset.h"
#include "problem/effects.h"
#include "scene_reading/result_unit.h"
#include "scene_varying/settings.h"
#include "stability/supports.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* In one piece. */
typedef struct whole {
  tp_solution solution;
  tp_case cases[2];
} whole;

tp_solution *tp_solution_new(void) {
  whole *own = calloc(1, sizeof *own);
  if (own == NULL) return NULL;
  own->solution.size = sizeof own->solution;
  own->solution.case_size = sizeof own->cases[0];
  own->solution.cases = own->cases;
  return &own->solution;
}

void tp_solution_free(tp_solution *solution) {
  if (solution == NULL) return;
  for (size_t k = 0; k < solution->case_count; k++) {
    free(solution->cases[k].pivots);
    free(solution->cases[k].elements.account);
    tp_loaded_account_clear(solution->cases + k);
    free(solution->cases[k].loads);
    free(solution->cases[k].limits);
    tp_onset_clear(&solution->cases[k].onset);
  }
  free(solution->poses.poses);
  free(solution->poses.basins);
  tp_decimals_free(solution->decimals);
  tp_notes_clear(&solution->notes);
  tp_settings_clear(&solution->settings);
  tp_effects_clear(solution);
  free(solution->friction_facets);
  free(solution->supports);
  free(solution->title);
  free(solution->load_case);
  free(solution->partial_factors);
  free(solution);
}

bool tp_solution_is_undecided(const tp_solution *solution) {
  if (solution == NULL || solution->open_number) return true;
  for (size_t k = 0; k < solution->case_count; k++) {
    const tp_case *own = solution->cases + k;
    if (own->mechanism == TP_MECHANISM_UNDECIDED || own->first == TP_MECHANISM_UNDECIDED ||
        own->limit.fos.state == TP_FOS_UNDECIDED || own->onset.fos.state == TP_FOS_UNDECIDED)
      return true;
  }
  return false;
}

/* The title says the load case, so that every output does. */
static tp_status describe_names(tp_solution *solution, const tp_scene *scene, tp_message *message) {
  const char *title = scene->title, *own = scene->load_case;
  bool done = true;
  if (own != NULL) {
    const size_t size = (title != NULL ? strlen(title) : 0) + strlen(own) + sizeof ", case ";
    solution->load_case = strdup(own);
    solution->title = malloc(size);
    done = solution->load_case != NULL && solution->title != NULL;
    if (done) {
      snprintf(solution->title, size, "%s%scase %s", title != NULL ? title : "",
               title != NULL ? ", " : "", own);
    }
  } else if (title != NULL) {
    solution->title = strdup(title);
    done = solution->title != NULL;
  }
  return done ? TP_OK : tp_fail_memory(message, "the solution");
}

static tp_status describe_scene(tp_solution *solution, const tp_scene *scene, tp_message *message) {
  solution->length_unit = scene->length_unit;
  solution->metres_per_unit = fmpq_get_d(scene->metres_per_unit);
  solution->result_units = tp_result_units_of(scene);
  if (solution->result_units.length.name != NULL) {
    solution->length_unit = solution->result_units.length.name;
    solution->metres_per_unit = solution->result_units.length.si;
  }
  solution->has_tilt_angle = scene->tilt_angle_deg.given;
  solution->tilt_angle_deg = tp_result_rational(scene->tilt_angle_deg.value);
  solution->has_friction = scene->friction_angle_deg.given;
  solution->friction_angle_deg = tp_result_rational(scene->friction_angle_deg.value);
  solution->friction_is_residual = scene->friction.load_dependent;
  solution->friction_is_patton =
      scene->friction.roughness_angle_deg.given && !scene->friction.load_dependent;
  return describe_names(solution, scene, message);
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
  const tp_bounded result = tp_result_rational(length);
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

static tp_status make_cases(tp_solution *solution, const tp_problem *problem,
                            const tp_solve_options *options, tp_message *message) {
  const bool asked[2] = {problem->scene->towards_left, problem->scene->towards_right};
  for (int d = 0; d < 2; d++) {
    if (!asked[d]) continue;
    tp_case *own = solution->cases + solution->case_count++;
    own->towards = d == 0 ? TP_TOWARDS_LEFT : TP_TOWARDS_RIGHT;
    if (!tp_pivots_list(own, problem, options->pivots)) {
      return tp_fail_memory(message, "the pivots");
    }
    if (problem->loaded) {
      own->loads = calloc((size_t)tp_loaded_account_count(problem->scene), sizeof *own->loads);
      if (own->loads == NULL) return tp_fail_memory(message, "the loads");
    }
    if (!options->elements) continue;
    own->elements.account =
        calloc((size_t)problem->elements.count + 1, sizeof *own->elements.account);
    if (own->elements.account == NULL) return tp_fail_memory(message, "the elements");
  }
  return TP_OK;
}

static tp_status describe_facets(tp_solution *solution, const tp_problem *problem,
                                 tp_message *message) {
  const tp_facet_friction *f = &problem->friction;
  if (f->entry_count == 0) return TP_OK;
  solution->friction_facets = calloc((size_t)f->entry_count, sizeof *solution->friction_facets);
  if (solution->friction_facets == NULL) return tp_fail_memory(message, "the friction of facets");
  for (long k = 0; k < f->entry_count; k++) {
    solution->friction_facets[solution->friction_facet_count++] = (tp_facet_friction_result){
        .first = (size_t)f->firsts[k],
        .last = (size_t)f->lasts[k],
        .touching = (size_t)f->touching[k],
        .angle_deg = tp_result_rational(problem->scene->friction.facets[k].angle_deg.value)};
  }
  return TP_OK;
}

tp_status tp_solution_describe(tp_solution *solution, const tp_problem *problem,
                               const tp_solve_options *options, tp_message *message) {
  tp_status status = describe_scene(solution, problem->scene, message);
  if (status == TP_OK) status = describe_facets(solution, problem, message);
  if (status == TP_OK) status = tp_describe_supports(solution, problem, message);
  if (status != TP_OK) return status;
  describe_teeth(solution, problem->scene);
  tp_describe_frame(solution, problem);
  tp_describe_rest(solution, problem);
  tp_describe_joint(solution, problem);
  tp_describe_within(solution, problem);
  tp_describe_smoothed(solution, problem);
  solution->loaded = problem->loaded;
  solution->digits = options->digits;
  if (options->digits > TP_DECIMALS_OF_DOUBLE) {
    solution->decimals = tp_decimals_new(options->digits);
    if (solution->decimals == NULL) return tp_fail_memory(message, "the digits");
  }
  return make_cases(solution, problem, options, message);
}
