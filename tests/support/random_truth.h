/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a random scene's numbers are, by triangles in rational numbers. */

#ifndef TP_TEST_RANDOM_TRUTH_H
#define TP_TEST_RANDOM_TRUTH_H

#include "random_scenes.h"

/* Do area, centroid, pivots, their critical angles and the governing one hold the truth? False,
 * with what does not in `why`. */
bool solution_is_true(char why[256], const tp_solution *solution, const random_scene *scene);

#endif
