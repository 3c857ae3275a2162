/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A quasi-static path of a body: the model, the path followed to its end, and the same path with
 * the weight fixed or moving, the difference of which is the softening (docs/tilt_path.md). */

#include "quasi_static/path.h"

#include "common/message.h"
#include "quasi_static/follow.h"

/* The mean closure of the whole contact by the weight. */
static double mean_closure_m(const tp_path_model *model) {
  double length = 0;
  for (long k = 0; k < model->count; k++) length += model->facets[k].length;
  return model->closure_m / length;
}

/* The same path with the weight in its place, or moving with the block: which of them collapses
 * how much sooner. */
static void add_softening(tp_path_result *result, tp_path_model *model,
                          const tp_path_settings *settings) {
  tp_path_result other = {0};
  const double unit = model->closure_m / model->body->extent_m;
  model->moves = settings->weight_moves ? 0 : unit;
  tp_path_follow(&other, model, settings, NULL);
  result->solves += other.solves;
  if (other.end == TP_RUN_NO_MEMORY) result->end = TP_RUN_NO_MEMORY;
  if (other.end != TP_RUN_MOVES) return;
  const double sooner = result->collapses_at - other.collapses_at;
  result->has_softening = true;
  result->softening = settings->weight_moves ? -sooner : sooner;
}

tp_status tp_path_run(tp_path_result *result, const tp_rigid_body *body,
                      const tp_path_settings *settings, tp_history *history, tp_message *message) {
  tp_path_model model;
  const tp_status ready = tp_path_model_init(&model, body, settings, message);
  if (ready != TP_OK) return ready;
  tp_path_result own = {.closure_m = mean_closure_m(&model)};
  tp_path_follow(&own, &model, settings, history);
  if (settings->asks_softening && own.end == TP_RUN_MOVES) add_softening(&own, &model, settings);
  tp_path_model_clear(&model);
  if (own.end == TP_RUN_NO_MEMORY) return tp_fail_memory(message, "the states of a path");
  *result = own;
  return TP_OK;
}
