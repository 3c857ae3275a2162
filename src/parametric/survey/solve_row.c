/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The scene of a row solved: as it is, or the load case that its table names, or each of its load
 * cases, of which the one that governs is told, as tp_solve_load_cases chooses it. */

#include "survey/judge.h"
#include "survey/judge_system.h"

#include "common/message.h"
#include "scene/scene.h"
#include "topple_load_cases.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void tp_batch_row_clear(tp_batch_row *row) {
  free(row->name);
  free(row->remark);
  free(row->load_case);
  free(row->scene_name);
  free(row->scene);
  *row = (tp_batch_row){0};
}

static tp_status solve_blocks(tp_batch_row *row, tp_severity *severity, const tp_scene *scene,
                              const tp_solve_options *options, tp_message *message) {
  tp_block_system *system = NULL;
  tp_status status = tp_solve_block_system(&system, scene, options, message);
  if (status == TP_OK) status = tp_batch_judge_system(row, system, message);
  if (status == TP_OK) *severity = tp_batch_system_severity(system);
  tp_block_system_free(system);
  return status;
}

static tp_status solve(tp_batch_row *row, tp_severity *severity, tp_scene *scene,
                       const tp_solve_options *options, tp_message *message) {
  tp_solution *solution = NULL;
  if (tp_scene_block_count(scene) > 0) return solve_blocks(row, severity, scene, options, message);
  scene->base.all_poses = false; /* a row has no place for them */
  tp_status status = tp_solve(&solution, scene, options, message);
  if (status == TP_OK) status = tp_batch_judge(row, solution, message);
  if (status == TP_OK) *severity = tp_severity_of(solution->cases + tp_severity_worst(solution));
  tp_solution_free(solution);
  return status;
}

/* Fails, or lacks the factor required. */
static bool is_short(const tp_batch_row *row) {
  return row->standing == TP_BATCH_FAILS || row->standing == TP_BATCH_BELOW;
}

/* A block that does not stand is the worse one even where its case requires less than that. Both
 * rows are of load cases (solve_case), and have their names. */
static bool is_worse(const tp_batch_row *one, tp_severity of_one, const tp_batch_row *other,
                     tp_severity of_other) {
  if (one->standing != other->standing && !(is_short(one) && is_short(other))) {
    return one->standing < other->standing;
  }
  const int order = tp_severity_compare(of_one, of_other);
  return order != 0 ? order < 0 : strcmp(one->load_case, other->load_case) < 0;
}

/* The row names its load case, whatever it was judged by. */
static tp_status solve_case(tp_batch_row *row, tp_severity *severity, const tp_scene *scene,
                            const char *name, const tp_solve_options *options,
                            tp_message *message) {
  tp_scene *own = NULL;
  tp_status status = tp_scene_load_case(&own, scene, name, message);
  if (status == TP_OK) status = solve(row, severity, own, options, message);
  if (status == TP_OK && row->load_case == NULL) {
    row->load_case = strdup(name);
    if (row->load_case == NULL) status = tp_fail_memory(message, "a table");
  }
  tp_scene_free(own);
  return status;
}

static tp_status solve_cases(tp_batch_row *row, const tp_scene *scene, const char **failed,
                             const tp_solve_options *options, tp_message *message) {
  const size_t count = tp_scene_load_case_count(scene);
  tp_batch_row worst = {.load_case = NULL};
  tp_severity severity = {0}, other = {0};
  tp_status status = TP_OK;
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    tp_batch_row own = {.load_case = NULL};
    const char *name = tp_scene_load_case_name(scene, k);
    status = solve_case(&own, &other, scene, name, options, message);
    if (status != TP_OK) *failed = name;
    if (status == TP_OK && (k == 0 || is_worse(&own, other, &worst, severity))) {
      const tp_batch_row less = worst;
      worst = own;
      own = less;
      severity = other;
    }
    tp_batch_row_clear(&own);
  }
  if (status != TP_OK) {
    tp_batch_row_clear(&worst);
    return status;
  }
  worst.line = row->line;
  worst.name = row->name;
  free(row->remark);
  *row = worst;
  return TP_OK;
}

tp_status tp_batch_solve_scene(tp_batch_row *row, tp_scene *scene, const char *load_case,
                               char failed[TP_FAILED_CASE], const tp_solve_options *options,
                               tp_message *message) {
  const char *name = NULL;
  tp_severity severity;
  if (load_case != NULL) return solve_case(row, &severity, scene, load_case, options, message);
  if (tp_scene_load_case_count(scene) == 0) return solve(row, &severity, scene, options, message);
  const tp_status status = solve_cases(row, scene, &name, options, message);
  if (name != NULL) snprintf(failed, TP_FAILED_CASE, "%s", name);
  return status;
}
