/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene of the examples and its solution, for tests of arguments. */

#ifndef TP_TEST_EXAMPLE_SCENE_H
#define TP_TEST_EXAMPLE_SCENE_H

#include "topple.h"

tp_scene *example_scene(void);
tp_solution *example_solution(const tp_scene *scene);

#endif
