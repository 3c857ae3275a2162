/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene with some of its numbers replaced, solved. The scene itself stays as it is. */

#ifndef TP_STABILITY_VARIED_H
#define TP_STABILITY_VARIED_H

#include "scene_varying/vary.h"

enum { TP_VARIED_MAX = 2 };

typedef struct tp_varied {
  const tp_scene *scene;
  size_t count;
  tp_scene_key keys[TP_VARIED_MAX]; /* of the numbers */
  tp_solve_options options;
} tp_varied;

/* The scene with `values` for the numbers, each the decimal of 17 digits that names it; and that
 * solved. */
TP_MUST_USE tp_status tp_varied_scene(tp_scene **scene, const tp_varied *varied,
                                      const double *values, tp_message *message);
TP_MUST_USE tp_status tp_varied_solve(tp_solution **solution, const tp_varied *varied,
                                      const double *values, tp_message *message);

/* The scene as it is: does it tilt one way, and what is the first number's own value? */
TP_MUST_USE tp_status tp_varied_check(double *own, const tp_varied *varied, tp_message *message);

#endif
