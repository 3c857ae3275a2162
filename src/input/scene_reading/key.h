/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The way to a node of a scene by its keys, and what in the scene a number bears upon. A miss names
 * the nearest key by Levenshtein's distance (scene_reading/keys.c). */

#ifndef TP_SCENE_READING_KEY_H
#define TP_SCENE_READING_KEY_H

#include "scene/node.h"

/* The scalar at a way like block.rounded.corners.1.radius (entries of lists count from 1), or of a
 * parameter by its name alone. Bad input where there is none, with the nearest key that there is.
 */
TP_MUST_USE tp_status tp_key_find(const tp_node **node, const tp_node *root, const char *key,
                                  const char *file, tp_message *message);

/* What a number bears upon: itself, and of a parameter every number that names it, by way of others
 * too. More at worst, never less. */
typedef struct tp_reach {
  bool friction; /* friction_angle_deg, friction, loads.cohesion_kpa: what holds against sliding */
  bool tilt;     /* tilt.angle_deg */
  bool other;    /* anything else */
} tp_reach;

TP_MUST_USE tp_status tp_key_reach(tp_reach *reach, const tp_node *root, const tp_node *number,
                                   tp_message *message);

#endif
