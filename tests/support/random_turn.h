/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A random scene turned with its base. */

#ifndef TP_TEST_RANDOM_TURN_H
#define TP_TEST_RANDOM_TURN_H

#include "compare_solutions.h"
#include "random_scenes.h"

/* Block and base together, counter-clockwise where the leg is positive, by a Pythagorean angle.
 * False: it does not apply to this scene. */
bool random_turn(random_scene *scene, relation *r, random_numbers *state);

#endif
