/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The full verdicts of many blocks: of each by doubles with bounds, where these tell it, else of a
 * scene solved as any other, what was asked read off and all of it freed, so that memory does not
 * grow with their number. */

#include "batch/block_scene.h"
#include "batch/blocks.h"
#include "batch/share.h"
#include "batch/verdict_filter.h"
#include "evaluation/case_numbers.h"
#include "stability/tilts.h"

#include <math.h>

/* Blocks handed out at once: each is ten to some hundred microseconds of work. */
enum { CHUNK = 32 };

typedef struct verdict_task {
  const tp_verdict_columns *columns;
  const tp_outlines *outlines;
  tp_numbers friction_angle_deg, tilt_angle_deg;
  tp_direction towards;
  tp_solve_options options;
  bool filters; /* all that the filter tells is asked for */
  tp_turning_task turning;
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

static tp_bounded bounded(tp_near number) {
  return (tp_bounded){.value = number.value, .error = number.error};
}

static tp_bounded factor_of(tp_fos_told fos) {
  return fos.state == TP_FOS_NUMBER ? bounded(fos.value) : none;
}

/* At the block's tilt. */
static void put_at(const tp_verdict_columns *c, size_t block, const tp_case_told_at *at) {
  if (c->mechanism != NULL) c->mechanism[block] = at->mechanism;
  tp_columns_put(c->fos, c->fos_error, block, factor_of(at->fos));
  if (c->fos_mechanism != NULL) c->fos_mechanism[block] = at->fos_mechanism;
  if (c->fos_definition != NULL) c->fos_definition[block] = at->fos_definition;
  tp_columns_put(c->fos_moments, c->fos_moments_error, block, factor_of(at->by_moments));
  tp_columns_put(c->fos_sliding, c->fos_sliding_error, block, factor_of(at->by_shear));
}

static void put_told(const tp_verdict_columns *c, size_t block, const tp_block_told *told) {
  const tp_case_told *of = &told->of;
  if (c->mechanism != NULL) c->mechanism[block] = of->limit;
  if (c->first != NULL) c->first[block] = of->limit;
  if (c->limit_kind != NULL) c->limit_kind[block] = TP_LIMIT_AT_ANGLE;
  if (c->onset_kind != NULL) c->onset_kind[block] = of->never ? TP_ONSET_NEVER : TP_ONSET_AT_ANGLE;
  tp_columns_put(c->first_angle_deg, c->first_error_deg, block, bounded(of->limit_deg));
  tp_columns_put(c->critical_angle_deg, c->critical_error_deg, block, bounded(of->moments_deg));
  tp_columns_put(c->limit_angle_deg, c->limit_error_deg, block, bounded(of->limit_deg));
  tp_columns_put(c->onset_angle_deg, c->onset_error_deg, block,
                 of->never ? none : bounded(of->onset_deg));
  if (told->has_tilt) put_at(c, block, &told->at);
}

static double angle_of(tp_numbers numbers, size_t block) {
  return numbers.each != NULL ? numbers.each[block] : numbers.all;
}

static tp_status set_angle(tp_scene *scene, tp_numbers numbers, size_t block,
                           tp_status (*set)(tp_scene *, tp_exact, tp_message *),
                           tp_message *message) {
  const double angle = angle_of(numbers, block);
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
  if (status == TP_OK) status = tp_solve_numbers(&solution, scene, &t->options, message);
  tp_scene_free(scene);
  if (status != TP_OK) return status;
  put_case(t->columns, block, solution->cases);
  if (tp_solution_is_undecided(solution)) status = TP_UNDECIDED;
  tp_solution_free(solution);
  return status;
}

static tp_status filter(const verdict_task *t, tp_workspace *workspace, size_t block,
                        tp_message *message) {
  tp_block_told told;
  tp_case_filter own;
  if (!t->filters) return TP_UNDECIDED;
  const tp_status status = tp_verdict_filter(
      &told, &own, workspace, tp_outlines_at(t->outlines, block), &t->turning,
      angle_of(t->friction_angle_deg, block), angle_of(t->tilt_angle_deg, block), message);
  if (status == TP_OK) put_told(t->columns, block, &told);
  return status;
}

static tp_status find(tp_workspace *workspace, const void *task, size_t block,
                      tp_message *message) {
  const verdict_task *t = task;
  put_nothing(t->columns, block);
  tp_status status = filter(t, workspace, block, message);
  if (status == TP_UNDECIDED) {
    workspace->summary.climbed++;
    status = solve(t, block, message);
  }
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
  verdict_task task = {.columns = columns,
                       .outlines = outlines,
                       .friction_angle_deg = friction_angle_deg,
                       .tilt_angle_deg = tilt_angle_deg,
                       .towards = options->towards,
                       .options = tp_solve_options_default()};
  task.options.limit = options->limit;
  task.options.strength_reduction = options->strength_reduction;
  task.options.pivots = TP_PIVOTS_GOVERNING;
  task.filters = options->limit && options->strength_reduction;
  task.turning = (tp_turning_task){.towards = options->towards,
                                   .simple = options->simple,
                                   .kernel = tp_scan_kernel_choose(TP_INSTRUCTIONS_BEST)};
  return tp_share_out(summary, find, &task, outlines->count, CHUNK, options->threads, message);
}
