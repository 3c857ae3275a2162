/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the tests of threads share: what one says is compared with what is said among others. */

#ifndef TP_TEST_THREADS_STAGE_H
#define TP_TEST_THREADS_STAGE_H

#include "crowd.h"
#include "sayings.h"

/* What each thread has said. */
extern sayings *of_thread[THREADS + 1];

void expect_same_sayings(const sayings *alone, const sayings *among, const char *what);

/* Scenes in memory, which threads make too: NULL where one cannot be made. */
tp_scene *built(tp_scene *scene, tp_status status);
tp_scene *build_square(double friction_angle_deg);
tp_solution *solve_in_thread(const tp_scene *scene);

#endif
