/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene with some of its numbers replaced. */

#ifndef TP_VARIED_H
#define TP_VARIED_H

#include "scene/scene.h"

enum { TP_VARIED_MAX = 2 };

typedef struct tp_varied {
  const char *path;
  tp_node *root; /* borrowed, as are the numbers in it */
  size_t count;
  tp_node *numbers[TP_VARIED_MAX];
  tp_solve_options options;
} tp_varied;

/* Solve the scene with `values` for the numbers. The nodes are as before when it returns. */
TP_MUST_USE tp_status tp_varied_solve(tp_solution **solution, const tp_varied *scene,
                                      const double *values, tp_message *message);

/* The scene as it is: does it tilt one way, and what is the first number's own value? */
TP_MUST_USE tp_status tp_varied_check(double *own, const tp_varied *scene, tp_message *message);

/* Does the scene give the friction of its contact? */
bool tp_varied_has_friction(const tp_varied *scene);

#endif
