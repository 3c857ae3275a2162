/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the tests of scenes in which numbers are others share. */

#ifndef TP_TEST_VARIED_SCENE_H
#define TP_TEST_VARIED_SCENE_H

#include "built_scene.h"

#define HEAD "topple: 1\nlength_unit: m\n"
#define RING "block: {outline: [[0, 0], [a, 0], [a, b], [0, b]], thickness: c}\n"
#define PARAMETERS(a, b, c) "parameters: {a: " a ", b: " b ", c: " c "}\n"
#define REST "friction_angle_deg: 30\ntilt: {towards: left, angle_deg: 10}\n"

tp_scene *read_text(const char *text);

tp_scene *with(const tp_scene *scene, const char *key, tp_exact value);

/* The report of its solution; frees the scene. */
char *solved(tp_scene *scene);

/* Built, 6 high. */
tp_scene *slab(double width);

#endif
