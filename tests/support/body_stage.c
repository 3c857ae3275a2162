/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "body_stage.h"

#include <check.h>
#include <string.h>

/* The problem is the body's alone: it may go before the body does. */
static tp_status init_body(tp_rigid_body *body, const tp_scene *scene, tp_direction towards,
                           tp_message *message) {
  tp_problem problem;
  tp_solution *noted = calloc(1, sizeof *noted);
  ck_assert_ptr_nonnull(noted);
  const tp_solve_options options = tp_solve_options_default();
  tp_status status = tp_problem_init(&problem, scene, &options, noted, message);
  ck_assert_msg(status == TP_OK, "%s", message->text);
  status = tp_rigid_body_init(body, &problem, towards, message);
  tp_problem_clear(&problem);
  tp_solution_free(noted);
  return status;
}

void body_stage_init(body_stage *stage, const char *text, tp_direction towards) {
  tp_message message = {.text = ""};
  memset(stage, 0, sizeof *stage);
  const tp_solve_options options = tp_solve_options_default();
  tp_status status = tp_scene_read_text(&stage->scene, text, "scene", &message);
  if (status == TP_OK) status = tp_solve(&stage->solution, stage->scene, &options, &message);
  if (status == TP_OK) status = init_body(&stage->body, stage->scene, towards, &message);
  ck_assert_msg(status == TP_OK, "%s", message.text);
}

void body_stage_clear(body_stage *stage) {
  tp_rigid_body_clear(&stage->body);
  tp_solution_free(stage->solution);
  tp_scene_free(stage->scene);
}

tp_status body_stage_refused(const char *text, tp_message *message) {
  tp_scene *scene = NULL;
  tp_rigid_body body;
  ck_assert_msg(tp_scene_read_text(&scene, text, "scene", message) == TP_OK, "%s", message->text);
  const tp_status status = init_body(&body, scene, TP_TOWARDS_LEFT, message);
  tp_rigid_body_clear(&body);
  tp_scene_free(scene);
  return status;
}
