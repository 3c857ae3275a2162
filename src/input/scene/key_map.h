/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The maps of a scene file: which keys each has, and where the scene has their numbers and truths.
 * The build makes them of core/terms/keys.csv. */

#ifndef TP_SCENE_KEY_MAP_H
#define TP_SCENE_KEY_MAP_H

#include "scene/check.h"

#include <stddef.h>

/* A tp_quantity, an fmpq_t without a place, or a bool. */
typedef enum tp_key_kind { TP_KEY_QUANTITY, TP_KEY_NUMBER, TP_KEY_TRUTH } tp_key_kind;

/* A value of the scene, or of the item of a list that the map is. */
typedef struct tp_key_value {
  const char *key;
  tp_key_kind kind;
  size_t offset;
  tp_rule rule;        /* of a number */
  const char *example; /* of a key that must be given, as "width: 50"; else NULL */
} tp_key_value;

/* A map: its keys, up to a NULL, and `count` values. */
typedef struct tp_key_map {
  const char *const *keys;
  const tp_key_value *values;
  size_t count;
} tp_key_map;

#endif
