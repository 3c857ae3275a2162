/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* In which unit the number of a key is: a length in that of the scene, any other in that which its
 * name ends in (friction_angle_deg, cohesion_kpa), or a number by itself (jrc, count). A parameter
 * is what it stands alone for. */

#ifndef TP_SCENE_UNIT_H
#define TP_SCENE_UNIT_H

#include "scene/scene.h"

/* Is it the key of a length? Of a parameter it is not known by its key. */
bool tp_key_is_length(const char *key);

/* Each place of the scene, below `parameters` excepted, where the parameter stands alone, by its
 * way; of a scene in memory none. */
void tp_parameter_uses(const tp_scene *scene, const char *parameter,
                       void (*look)(void *context, const char *way), void *context);

/* The scene's unit of length where the key is that of one, or of a parameter that stands for
 * lengths and nothing else; NULL: none is left to say. */
const char *tp_scene_unit(const tp_scene *scene, const char *key);

/* The same, and the unit that the name of the key ends in: deg, kPa, MPa, kN or kN/m3. NULL: it has
 * none, or none that is known; of no scene, where `scene` is NULL, a length has none. */
const char *tp_key_unit(const tp_scene *scene, const char *key);

#endif
