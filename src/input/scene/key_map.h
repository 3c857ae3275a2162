/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The maps of a scene file: which keys each has, and where the scene has the numbers among them.
 * The build makes them of core/terms/keys.csv. */

#ifndef TP_SCENE_KEY_MAP_H
#define TP_SCENE_KEY_MAP_H

#include "scene/check.h"

#include <stddef.h>

/* A tp_quantity of the scene, or of the item of a list that the map is. */
typedef struct tp_key_number {
  const char *key;
  size_t offset;
  tp_rule rule;
} tp_key_number;

/* A map: its keys, up to a NULL, and `count` numbers. */
typedef struct tp_key_map {
  const char *const *keys;
  const tp_key_number *numbers;
  size_t count;
} tp_key_map;

#endif
