/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the tests of scenes built in memory share. */

#ifndef TP_TEST_BUILT_SCENE_H
#define TP_TEST_BUILT_SCENE_H

#include "suite.h"

#include "topple.h"

extern tp_message message;

#define DO(call) ck_assert_msg((call) == TP_OK, "%s: %s", #call, message.text)
#define E(number) tp_exact_of(number)
#define T(text) tp_exact_text(text)

tp_scene *new_scene(const char *unit);

/* The report of a solution, without what ran and what called for it; the caller's to free. */
char *solve(const tp_scene *scene, int digits);

/* Frees both. */
void expect_equal(char *one, char *other);

/* Has the scene the solution of the file, to 9 and to 30 digits? Frees the scene. */
void expect_same(tp_scene *built, const char *text);

#define SQUARE "topple: 1\nlength_unit: m\nblock:\n  outline: [[0, 0], [4, 0], [4, 6], [0, 6]]\n"

#endif
