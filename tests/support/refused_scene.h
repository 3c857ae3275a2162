/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene that refused calls must leave as it was: what the tests of their arguments share. */

#ifndef TP_TEST_REFUSED_SCENE_H
#define TP_TEST_REFUSED_SCENE_H

#include "refused.h"

#include <stdlib.h>

#define E(number) tp_exact_of(number)
#define DO(call) ck_assert_msg((call) == TP_OK, "%s: %s", #call, message.text)

static const double square[] = {0, 0, 4, 0, 4, 6, 0, 6};
#define SQUARE tp_coordinates_of(square, 4)

static tp_scene *scene;

static void set_up(void) {
  scene = NULL;
  DO(tp_scene_new(&scene, "m", &message));
  DO(tp_scene_set_outline(scene, SQUARE, &message));
  DO(tp_scene_set_friction_angle_deg(scene, E(30), &message));
}

static void tear_down(void) {
  tp_scene_free(scene);
}

static char *solve(void) {
  tp_solution *solution = NULL;
  const tp_solve_options options = tp_solve_options_default();
  DO(tp_solve(&solution, scene, &options, &message));
  char *table = NULL;
  DO(tp_report_csv(&table, (const tp_solution *const *)&solution, 1));
  tp_solution_free(solution);
  return table;
}

#endif
