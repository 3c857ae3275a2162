/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* All points of a scene, turned. */

#ifndef TP_WORLD_TURN_H
#define TP_WORLD_TURN_H

#include "stability/world.h"

/* Put what turning will own out of a copy of a scene, which the scene itself owns. */
void tp_world_turned_reset(tp_scene *copy);

/* Fill the world's scene, reset before, with the turned points of `scene`, the ends of its contact
 * named by vertices of its outline where they are kept. False when memory is exhausted; what there
 * is by then is tp_world_turned_clear's too. */
TP_MUST_USE bool tp_world_turn_scene(tp_world *world, const tp_scene *scene, bool keeps_ends,
                                     long first, long last);
void tp_world_turned_clear(tp_scene *turned);

#endif
