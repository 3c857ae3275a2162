/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The full verdicts of many blocks: a scene of each, solved as any other, what was asked read off
 * and all of it freed, so that memory does not grow with their number. */

#include "batch/block_scene.h"
#include "batch/blocks.h"
#include "batch/share.h"
#include "evaluation/case_numbers.h"

#include <math.h>

/* Blocks handed out at once: each is some hundred microseconds of work. */
enum { CHUNK = 8 };

typedef struct verdict_task {
  const tp_verdict_columns *columns;
  const tp_outlines *outlines;
  tp_numbers friction_angle_deg, tilt_angle_deg;
  tp_direction towards;
  tp_solve_options options;
} verdict_task;

static const tp_bounded none = {.value = NAN, .error = NAN};

/* Of a block that has no solution. */
static void put_nothing(const tp_verdict_columns *c, size_t block) {
  if (c->mechanism != NULL) c->mechanism[block] = TP_MECHANISM_UNDECIDED;
  if (c->first != NULL) c->first[block] = TP_MECHANISM_UNDECIDED;
  if (c->limit_kind != NULL) c->limit_kind[block] = TP_LIMIT_UNDECIDED;
  if (c->onset_kind != NULL) c->onset_kind[block] = TP_ONSET_UNDECIDED;
  tp_columns_put(c->first_angle_deg, c->first_error_deg, block, none);
  tp_columns_put(c->critical_angle_deg, c->critical_error_deg, block, none);
  tp_columns_put(c->limit_angle_deg, c->limit_error_deg, block, none);
  tp_columns_put(c->onset_angle_deg, c->onset_error_deg, block, none);
  tp_columns_put(c->fos, c->fos_error, block, none);
  if (c->fos_mechanism != NULL) c->fos_mechanism[block] = TP_MECHANISM_UNDECIDED;
  if (c->fos_definition != NULL) c->fos_definition[block] = TP_FOS_BY_MOMENTS;
  tp_columns_put(c->fos_moments, c->fos_moments_error, block, none);
  tp_columns_put(c->fos_sliding, c->fos_sliding_error, block, none);
}

static void put_case(const tp_verdict_columns *c, size_t block, const tp_case *own) {
  const tp_pivot *pivot = own->has_toppling_pivot ? own->pivots + own->toppling_pivot : NULL;
  const bool limit = own->limit.kind == TP_LIMIT_AT_ANGLE;
  const bool onset = own->onset.kind == TP_ONSET_AT_ANGLE;
  const tp_fos *fos = &own->governing_fos.fos;
  const tp_factor *factor = tp_case_factor(own);
  tp_bounded moments = none, sliding = none;
  (void)tp_case_fos_moments(&moments, own);
  (void)tp_case_fos_sliding(&sliding, own);
  if (c->mechanism != NULL) c->mechanism[block] = own->mechanism;
  if (c->first != NULL) c->first[block] = own->first;
  if (c->limit_kind != NULL) c->limit_kind[block] = own->limit.kind;
  if (c->onset_kind != NULL) c->onset_kind[block] = own->onset.kind;
  tp_columns_put(c->first_angle_deg, c->first_error_deg, block,
                 own->has_first_angle ? own->first_angle_deg : none);
  tp_columns_put(c->critical_angle_deg, c->critical_error_deg, block,
                 pivot != NULL ? pivot->critical_angle_deg : none);
  tp_columns_put(c->limit_angle_deg, c->limit_error_deg, block,
                 limit ? own->limit.critical_angle_deg : none);
  tp_columns_put(c->onset_angle_deg, c->onset_error_deg, block,
                 onset ? own->onset.critical_angle_deg : none);
  tp_columns_put(c->fos, c->fos_error, block, fos->state == TP_FOS_NUMBER ? fos->value : none);
  if (c->fos_mechanism != NULL && factor != NULL) c->fos_mechanism[block] = factor->mechanism;
  if (c->fos_definition != NULL && factor != NULL) c->fos_definition[block] = factor->definition;
  tp_columns_put(c->fos_moments, c->fos_moments_error, block, moments);
  tp_columns_put(c->fos_sliding, c->fos_sliding_error, block, sliding);
}

static tp_status set_angle(tp_scene *scene, tp_numbers numbers, size_t block,
                           tp_status (*set)(tp_scene *, tp_exact, tp_message *),
                           tp_message *message) {
  const double angle = numbers.each != NULL ? numbers.each[block] : numbers.all;
  return isnan(angle) ? TP_OK : set(scene, tp_exact_of(angle), message);
}

static tp_status solve(const verdict_task *t, size_t block, tp_message *message) {
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_status status =
      tp_block_scene_new(&scene, tp_outlines_at(t->outlines, block), t->towards, message);
  if (status != TP_OK) return status;
  status = set_angle(scene, t->friction_angle_deg, block, tp_scene_set_friction_angle_deg, message);
  if (status == TP_OK) {
    status = set_angle(scene, t->tilt_angle_deg, block, tp_scene_set_tilt_angle_deg, message);
  }
  if (status == TP_OK) status = tp_solve(&solution, scene, &t->options, message);
  tp_scene_free(scene);
  if (status != TP_OK) return status;
  put_case(t->columns, block, solution->cases);
  if (tp_solution_is_undecided(solution)) status = TP_UNDECIDED;
  tp_solution_free(solution);
  return status;
}

static tp_status find(tp_workspace *workspace, const void *task, size_t block,
                      tp_message *message) {
  (void)workspace;
  const verdict_task *t = task;
  put_nothing(t->columns, block);
  const tp_status status = solve(t, block, message);
  if (t->columns->status != NULL) t->columns->status[block] = status;
  return status;
}

tp_status tp_blocks_solve(const tp_verdict_columns *columns, tp_blocks_summary *summary,
                          const tp_outlines *outlines, tp_numbers friction_angle_deg,
                          tp_numbers tilt_angle_deg, const tp_blocks_options *options,
                          tp_message *message) {
  TP_GUARD_HOST;
  tp_blocks_options own = tp_blocks_options_default();
  TP_BLOCKS_BEGIN(message, columns, summary, outlines, own, options);
  verdict_task task = {columns,        outlines,         friction_angle_deg,
                       tilt_angle_deg, options->towards, tp_solve_options_default()};
  task.options.limit = options->limit;
  task.options.strength_reduction = options->strength_reduction;
  task.options.pivots = TP_PIVOTS_GOVERNING;
  return tp_share_out(summary, find, &task, outlines->count, CHUNK, options->threads, message);
}
