/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene solved at the points of a sweep. Points are shared out to threads in batches of a fixed
 * size; those of a batch are kept, and handed over in their order by the thread that calls. */

#include "batch/share.h"
#include "common/host.h"
#include "common/options.h"
#include "scene_varying/load_case.h"
#include "scene_varying/settings.h"
#include "solid_tilt/solve_solid.h"
#include "stability/tilts.h"
#include "sweep/axis.h"

#include <stdlib.h>

TP_OPTIONS_END(tp_sweep_options, level);

void tp_sweep_options_init(tp_sweep_options *options, size_t size) {
  const tp_solve_options solve = tp_solve_options_default();
  const tp_sweep_options defaults = {
      .size = sizeof defaults, .digits = solve.digits, .level = solve.level};
  tp_options_fill(options, size, &defaults);
}

/* So many points wait for each other; a thread takes one after the other. */
enum { BATCH = 64, CHUNK = 1, AXES = 2 };

/* A point that was solved, or failed. */
typedef struct outcome {
  tp_status status;
  tp_solution *solution;
  tp_block_system *system; /* of a scene of many blocks, instead */
  tp_solid *solid;         /* of one of a solid */
  tp_message message;
} outcome;

typedef struct sweep {
  const tp_scene *scene;
  size_t axis_count;
  tp_axis axes[AXES]; /* x, and y */
  tp_scene_key keys[AXES];
  tp_solve_options solve;
  size_t count, first; /* of all points; of the batch */
  outcome *outcomes;   /* of the batch */
} sweep;

/* ---- one point ---------------------------------------------------------------------------------
 */

static void free_settings(char *settings[AXES]) {
  for (int k = 0; k < AXES; k++) free(settings[k]);
}

static tp_status make_settings(char *settings[AXES], const sweep *s, size_t point,
                               tp_message *message) {
  const size_t at[AXES] = {point % s->axes[0].count, point / s->axes[0].count};
  for (size_t k = 0; k < AXES && k < s->axis_count; k++) {
    settings[k] = tp_axis_setting(s->axes + k, at[k]);
    if (settings[k] == NULL) return tp_fail_memory(message, "the sweep");
  }
  return TP_OK;
}

static tp_status solve_scene(outcome *own, const sweep *s, tp_scene *scene) {
  if (tp_scene_block_count(scene) > 0) {
    return tp_solve_block_system(&own->system, scene, &s->solve, &own->message);
  }
  if (tp_scene_is_solid(scene)) {
    return tp_solid_solve_scene(&own->solid, scene, false, &own->message);
  }
  scene->base.all_poses = false; /* a row has no place for them */
  return tp_solve_numbers(&own->solution, scene, &s->solve, &own->message);
}

static bool is_undecided(const outcome *own) {
  if (own->solid != NULL) return tp_solid_is_undecided(own->solid);
  return own->system != NULL ? tp_block_system_is_undecided(own->system)
                             : tp_solution_is_undecided(own->solution);
}

static tp_status solve_at(outcome *own, const sweep *s, char *settings[AXES]) {
  tp_scene *scene = NULL;
  tp_status status = tp_scene_set(&scene, s->scene, s->keys, (const char *const *)settings,
                                  s->axis_count, &own->message);
  if (status == TP_OK) status = solve_scene(own, s, scene);
  tp_scene_free(scene);
  return status == TP_OK && is_undecided(own) ? TP_UNDECIDED : status;
}

static tp_status solve_point(tp_workspace *workspace, const void *task, size_t number,
                             tp_message *message) {
  const sweep *s = task;
  outcome *own = s->outcomes + number;
  char *settings[AXES] = {NULL};
  (void)workspace;
  *own = (outcome){.status = make_settings(settings, s, s->first + number, message)};
  if (own->status == TP_OK) own->status = solve_at(own, s, settings);
  free_settings(settings);
  if (own->status != TP_OK && message != NULL) *message = own->message;
  return own->status;
}

/* ---- the points in their order -----------------------------------------------------------------
 */

static void count_point(tp_sweep_summary *summary, tp_status status) {
  summary->done += status == TP_OK;
  summary->without += status == TP_NO_ANSWER;
  summary->undecided += status == TP_UNDECIDED;
  summary->bad += status == TP_BAD_INPUT;
}

static const tp_settings *settings_of(const outcome *own) {
  return own->system != NULL     ? &own->system->settings
         : own->solid != NULL    ? &own->solid->settings
         : own->solution != NULL ? &own->solution->settings
                                 : NULL;
}

static tp_status hand_over(bool *goes_on, const sweep *s, size_t number, tp_sweep_sink sink,
                           tp_message *message) {
  const outcome *own = s->outcomes + number;
  tp_settings set = {.count = 0};
  char *settings[AXES] = {NULL};
  const tp_settings *solved = settings_of(own);
  tp_status status = TP_OK;
  if (solved == NULL) {
    status = make_settings(settings, s, s->first + number, message);
    if (status == TP_OK) {
      status = tp_scene_settings_with(&set, s->scene, s->keys, (const char *const *)settings,
                                      s->axis_count, message);
    }
  }
  if (status == TP_OK) {
    const tp_sweep_point point = {.index = s->first + number,
                                  .set = solved != NULL ? solved : &set,
                                  .status = own->status,
                                  .solution = own->solution,
                                  .system = own->system,
                                  .solid = own->solid,
                                  .message = solved == NULL ? own->message.text : ""};
    *goes_on = sink.take(sink.context, &point);
  }
  tp_settings_clear(&set);
  free_settings(settings);
  return status;
}

static tp_status run_batch(bool *goes_on, sweep *s, size_t threads, tp_sweep_summary *summary,
                           tp_sweep_sink sink, tp_message *message) {
  const size_t left = s->count - s->first, count = left < BATCH ? left : BATCH;
  tp_blocks_summary blocks;
  for (size_t k = 0; k < count; k++) s->outcomes[k] = (outcome){.status = TP_OK};
  tp_status status = tp_share_out(&blocks, solve_point, s, count, CHUNK, threads, message);
  for (size_t k = 0; k < count && status == TP_OK && *goes_on; k++) {
    count_point(summary, s->outcomes[k].status);
    status = hand_over(goes_on, s, k, sink, message);
  }
  for (size_t k = 0; k < count; k++) {
    tp_solution_free(s->outcomes[k].solution);
    tp_block_system_free(s->outcomes[k].system);
    tp_solid_free(s->outcomes[k].solid);
  }
  s->first += count;
  return status;
}

/* ---- the sweep ---------------------------------------------------------------------------------
 */

static tp_status read_axes(sweep *s, const tp_sweep_options *options, tp_message *message) {
  const char *const texts[AXES] = {options->x, options->y};
  tp_status status = TP_OK;
  s->count = 1;
  for (size_t k = 0; k < AXES && texts[k] != NULL && status == TP_OK; k++) {
    s->axis_count++;
    status = tp_axis_read(s->axes + k, s->scene, texts[k], message);
    s->keys[k] = s->axes[k].key;
    if (status == TP_OK) s->count *= s->axes[k].count;
  }
  if (status != TP_OK) return status;
  if (s->count > TP_SWEEP_MOST) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                     "the sweep has %zu points; at most 100 million are taken", s->count);
  }
  if (s->axis_count == AXES && tp_scene_key_same(s->keys, s->keys + 1)) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){0}, "x and y sweep the same number");
  }
  return TP_OK;
}

static tp_status run(sweep *s, const tp_sweep_options *options, tp_sweep_summary *summary,
                     tp_sweep_sink sink, tp_message *message) {
  tp_status status = tp_check_load_case(s->scene, message);
  if (status == TP_OK) status = read_axes(s, options, message);
  if (status == TP_OK && tp_scene_is_solid(s->scene)) { /* the surface once for all points */
    const tp_solid_body *body = NULL;
    status = tp_solid_body_of_scene(&body, s->scene, message);
  }
  if (status != TP_OK) return status;
  tp_sweep_summary sum = {.count = s->count};
  s->outcomes = calloc(BATCH, sizeof *s->outcomes);
  if (s->outcomes == NULL) return tp_fail_memory(message, "the sweep");
  bool goes_on = true;
  while (s->first < s->count && goes_on && status == TP_OK) {
    status = run_batch(&goes_on, s, options->threads, &sum, sink, message);
  }
  free(s->outcomes);
  if (status == TP_OK) *summary = sum;
  return status;
}

tp_status tp_sweep(tp_sweep_summary *summary, const tp_scene *scene,
                   const tp_sweep_options *options, tp_sweep_sink sink, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, summary);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, options);
  TP_REFUSE_NULL(message, sink.take);
  tp_sweep_options own = tp_sweep_options_default();
  TP_TAKE_OPTIONS(message, own, options);
  TP_REFUSE_NULL(message, options->x);
  sweep s = {.scene = scene, .solve = tp_solve_options_default()};
  s.solve.digits = options->digits;
  s.solve.level = options->level;
  s.solve.pivots = TP_PIVOTS_GOVERNING;
  s.solve.threads = 1;
  const tp_status status = run(&s, options, summary, sink, message);
  for (size_t k = 0; k < s.axis_count; k++) tp_axis_clear(s.axes + k);
  return status;
}
