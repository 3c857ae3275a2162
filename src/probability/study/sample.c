/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Solves one sample with its further tilts (stability/tilts.h), or takes the row from
 * study/sample_filter.h where that is certain; invalid samples keep the reason. */

#include "study/sample.h"

#include "block_system/system.h"
#include "evaluation/case_numbers.h"
#include "number/ratio.h"
#include "stability/tilts.h"
#include "study/outcome.h"
#include "study/sample_filter.h"
#include "study/solid_sample.h"
#include "study/system_sample.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- results as numbers ------------------------------------------------------------------------
 */

typedef tp_case_state number_of(tp_bounded *value, const tp_case *own);

static double number(number_of *of, const tp_case *own) {
  tp_bounded value = {0};
  switch (of(&value, own)) {
  case TP_CASE_NUMBER:
    return value.value;
  case TP_CASE_ALWAYS:
    return INFINITY;
  case TP_CASE_NEVER:
    return -INFINITY;
  default:
    return NAN;
  }
}

static void take_case(tp_study_row *row, const tp_solution *solution) {
  const tp_case *c = solution->cases;
  const tp_factor *factor = tp_case_factor(c);
  row->quantities[TP_STUDY_MOMENTS_DEG] = number(tp_case_moments_deg, c);
  row->quantities[TP_STUDY_ONSET_DEG] = number(tp_case_onset_deg, c);
  row->quantities[TP_STUDY_LIMIT_DEG] = number(tp_case_limit_deg, c);
  row->quantities[TP_STUDY_FOS] = number(tp_case_fos, c);
  row->fos_moments = number(tp_case_fos_moments, c);
  row->fos_sliding = number(tp_case_fos_sliding, c);
  if (c->has_toppling_pivot) {
    row->pivot_x_m = c->pivots[c->toppling_pivot].x_m.value;
    row->pivot_y_m = c->pivots[c->toppling_pivot].y_m.value;
  }
  if (solution->has_tilt_angle) row->tilt_deg = solution->tilt_angle_deg.value;
  row->first = tp_study_outcome_name(tp_study_outcome_of(c->first));
  if (c->limit.kind != TP_LIMIT_NOT_ASKED) {
    row->limit_mechanism = c->limit.kind == TP_LIMIT_NOWHERE
                               ? "holds nowhere"
                               : tp_study_outcome_name(tp_study_outcome_of(c->limit.mechanism));
  }
  if (factor != NULL) {
    row->fos_mechanism = tp_study_outcome_name(tp_study_outcome_of(factor->mechanism));
    row->fos_definition = (int)factor->definition;
  }
}

/* ---- scenes ------------------------------------------------------------------------------------
 */

/* Nothing is known of it yet, at any tilt. */
static void clear(tp_study_row *row, size_t tilts, tp_study_outcome outcome) {
  for (size_t k = 0; k < TP_STUDY_QUANTITIES; k++) row->quantities[k] = NAN;
  for (size_t k = 0; k <= tilts; k++) row->at[k] = (tp_study_at){outcome, NAN};
  row->fos_moments = row->fos_sliding = NAN;
  row->pivot_x_m = row->pivot_y_m = row->tilt_deg = NAN;
  row->first = row->limit_mechanism = row->fos_mechanism = "";
  row->fos_definition = row->design = -1;
  row->open = false;
  row->why = NULL;
}

/* Room for the numbers of a scene: the variables, and the tilt; and for the further tilts. */
typedef struct numbers {
  tp_scene_key *keys;
  fmpq *values;
  size_t count;
  fmpq *degrees;
  tp_solution **solutions;
  size_t tilts;
} numbers;

/* To be ended also on failure. */
static tp_status start(numbers *n, const tp_study *study, size_t tilts, tp_message *message) {
  const size_t count = study->variable_count + 1;
  *n = (numbers){.keys = calloc(count, sizeof *n->keys),
                 .values = calloc(count, sizeof *n->values),
                 .degrees = calloc(tilts + 1, sizeof *n->degrees),
                 .solutions = calloc(tilts + 1, sizeof(tp_solution *))};
  if (n->keys == NULL || n->values == NULL || n->degrees == NULL || n->solutions == NULL) {
    return tp_fail_memory(message, "a sample");
  }
  n->count = count;
  n->tilts = tilts;
  for (size_t k = 0; k < count; k++) fmpq_init(n->values + k);
  for (size_t k = 0; k < tilts; k++) fmpq_init(n->degrees + k);
  for (size_t k = 0; k < study->variable_count; k++) n->keys[k] = study->variables[k].key;
  n->keys[count - 1] = study->tilt_key;
  for (size_t k = 0; k < tilts; k++) {
    if (tp_ratio_read_double(n->degrees + k, study->tilts[k])) continue;
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0}, "a tilt is not a number");
  }
  return TP_OK;
}

static void end(numbers *n) {
  for (size_t k = 0; k < n->count; k++) fmpq_clear(n->values + k);
  for (size_t k = 0; k < n->tilts; k++) fmpq_clear(n->degrees + k);
  for (size_t k = 0; k < n->tilts; k++) tp_solution_free(n->solutions[k]);
  free(n->solutions);
  free(n->degrees);
  free(n->values);
  free(n->keys);
}

static tp_status vary(tp_scene **scene, const tp_study *study, const numbers *n, size_t count,
                      tp_message *message) {
  return tp_scene_vary(scene, study->scene, n->keys, n->values, count, message);
}

/* The scene with the first `count` of the numbers, solved; with its further tilts where `tilts` is
 * not NULL. */
static tp_status solve(tp_solution **solution, tp_tilts *tilts, const tp_study *study,
                       const numbers *n, size_t count, tp_message *message) {
  tp_scene *scene = NULL;
  tp_solve_options options = tp_solve_options_default();
  options.pivots = TP_PIVOTS_GOVERNING;
  options.threads = 1;
  tp_status status = vary(&scene, study, n, count, message);
  if (status == TP_OK) {
    scene->base.all_poses = false; /* a study takes each at the position that it draws */
    status = tilts != NULL ? tp_solve_tilts(solution, tilts, scene, &options, message)
                           : tp_solve_numbers(solution, scene, &options, message);
  }
  tp_scene_free(scene);
  return status;
}

/* An invalid row, by the first reason. */
static tp_status refuse(tp_study_row *row, const char *why, tp_message *message) {
  if (row->why == NULL) row->why = strdup(why);
  return row->why != NULL ? TP_OK : tp_fail_memory(message, "a sample");
}

/* What of a status is the sample's own makes the row; the rest is a failure. */
static tp_status take_status(tp_study_row *row, tp_study_at *at, tp_status status,
                             const tp_message *why, tp_message *message) {
  if (status == TP_UNDECIDED) {
    at->outcome = TP_STUDY_UNDECIDED;
    return TP_OK;
  }
  if (status == TP_BAD_INPUT || status == TP_NO_ANSWER) return refuse(row, why->text, message);
  if (message != NULL) *message = *why;
  return status;
}

static void take_tilt(tp_study_row *row, size_t k, const tp_solution *solution) {
  row->at[k].outcome = tp_study_outcome_of(solution->cases[0].mechanism);
  row->at[k].fos = number(tp_case_fos, solution->cases);
  row->open = row->open || tp_solution_is_undecided(solution);
}

/* Of many blocks, with the first `count` of the numbers, into the place `at` of the row. */
static tp_status solve_system(tp_study_row *row, size_t at, const tp_study *study, const numbers *n,
                              size_t count, tp_message *message) {
  tp_scene *scene = NULL;
  tp_block_system *system = NULL;
  tp_message why = {.text = ""};
  const tp_solve_options options = tp_solve_options_default();
  tp_status status = vary(&scene, study, n, count, &why);
  /* a factor that is required must also be excluded from being too small by motions */
  const bool all = study->scene->required_fos.given ||
                   tp_block_system_cheap_motions(study->scene) == TP_MOTIONS_ALL;
  const tp_motions_sought motions = all ? TP_MOTIONS_ALL : TP_MOTIONS_AS_THEY_LIE;
  if (status == TP_OK) status = tp_block_system_solve(&system, scene, &options, motions, &why);
  if (status == TP_OK) {
    tp_study_take_system(row, at, system);
  } else {
    status = take_status(row, row->at + at, status, &why, message);
  }
  tp_block_system_free(system);
  tp_scene_free(scene);
  return status;
}

/* Of a solid, likewise. */
static tp_status solve_solid(tp_study_row *row, size_t at, const tp_study *study, const numbers *n,
                             size_t count, tp_message *message) {
  tp_scene *scene = NULL;
  tp_solid *solid = NULL;
  tp_message why = {.text = ""};
  tp_status status = vary(&scene, study, n, count, &why);
  if (status == TP_OK) status = tp_solid_solve_scene(&solid, scene, false, &why);
  if (status == TP_OK) {
    tp_study_take_solid(row, at, solid);
  } else {
    status = take_status(row, row->at + at, status, &why, message);
  }
  tp_solid_free(solid);
  tp_scene_free(scene);
  return status;
}

/* At the scene's own tilt, and what that tells of the further ones. Upright there are loads that
 * are refused, so that a scene for itself has to be asked. */
static tp_status solve_own(tp_study_row *row, const tp_study *study, numbers *n,
                           tp_message *message) {
  tp_solution *solution = NULL;
  tp_message why = {.text = ""};
  tp_tilts tilts = {n->tilts, n->degrees, n->solutions};
  if (tp_study_is_of_many(study)) return solve_system(row, 0, study, n, n->count - 1, message);
  if (tp_study_is_of_solid(study)) return solve_solid(row, 0, study, n, n->count - 1, message);
  if (n->tilts > 0 && fmpq_cmp_si(n->degrees + n->tilts - 1, 90) == 0) tilts.count--;
  const tp_status status = solve(&solution, &tilts, study, n, n->count - 1, &why);
  if (status != TP_OK) return take_status(row, row->at, status, &why, message);
  take_tilt(row, 0, solution);
  take_case(row, solution);
  tp_solution_free(solution);
  return TP_OK;
}

/* At the k-th tilt of the study. */
static tp_status solve_at(tp_study_row *row, const tp_study *study, numbers *n, size_t k,
                          tp_message *message) {
  tp_message why = {.text = ""};
  if (n->solutions[k] == NULL) {
    fmpq_set(n->values + n->count - 1, n->degrees + k);
    if (tp_study_is_of_many(study)) return solve_system(row, k + 1, study, n, n->count, message);
    if (tp_study_is_of_solid(study)) return solve_solid(row, k + 1, study, n, n->count, message);
    const tp_status status = solve(n->solutions + k, NULL, study, n, n->count, &why);
    if (status != TP_OK) return take_status(row, row->at + k + 1, status, &why, message);
  }
  take_tilt(row, k + 1, n->solutions[k]);
  return TP_OK;
}

tp_status tp_study_solve(tp_study_row *row, const tp_study *study, size_t tilts,
                         tp_message *message) {
  row->told_by = TP_TOLD_BY_DOUBLES;
  if (tp_sample_filter_tell(row, study, tilts)) return TP_OK;
  row->told_by = TP_TOLD_BY_LADDER;
  numbers n;
  clear(row, tilts, TP_STUDY_INVALID);
  tp_status status = start(&n, study, tilts, message);
  for (size_t k = 0; k < study->variable_count && status == TP_OK && row->why == NULL; k++) {
    if (!tp_ratio_read_double(n.values + k, row->values[k])) {
      status = refuse(row, "a number is outside of the range that a scene takes", message);
    }
  }
  if (status == TP_OK && row->why == NULL) status = solve_own(row, study, &n, message);
  /* what makes no scene at its own tilt makes none at another */
  const bool makes_scene = row->at[0].outcome != TP_STUDY_INVALID;
  for (size_t k = 0; k < tilts && status == TP_OK && makes_scene; k++) {
    status = solve_at(row, study, &n, k, message);
  }
  end(&n);
  return status;
}

tp_status tp_study_solve_with(tp_study_row *row, const tp_study *study, const tp_scene_key *key,
                              double value, tp_message *message) {
  fmpq number;
  tp_scene_key own = *key;
  numbers n = {
      .keys = &own, .values = &number, .count = 2}; /* one, and the tilt, which is not set */
  clear(row, 0, TP_STUDY_INVALID);
  fmpq_init(&number);
  const tp_status status =
      tp_ratio_read_double(&number, value)
          ? solve_own(row, study, &n, message)
          : refuse(row, "a number is outside of the range that a scene takes", message);
  fmpq_clear(&number);
  return status;
}
