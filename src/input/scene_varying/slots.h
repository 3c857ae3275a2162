/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which number of a scene that was built in memory a key names: the keys of a scene file
 * (docs/scene.md), each with the place where the scene holds it and the rule of the call that sets
 * it. Of a scene that has not been given a number there is no such key. */

#ifndef TP_SCENE_VARYING_SLOTS_H
#define TP_SCENE_VARYING_SLOTS_H

#include "scene/check.h"

typedef struct tp_slot_row tp_slot_row;

/* A number: its row, the item of a list (from 0) and of a chain the point and the axis. */
typedef struct tp_slot {
  const tp_slot_row *row;
  const char *key; /* as it was asked for, borrowed */
  long item, point;
  int axis;
} tp_slot;

TP_MUST_USE tp_status tp_slot_find(tp_slot *slot, const tp_scene *scene, const char *key,
                                   tp_message *message);

/* The key of the slot in the table, with # for the numbers of items and points. */
const char *tp_slot_pattern(const tp_slot *slot);
/* Where the number was given. */
tp_place tp_slot_place(const tp_slot *slot, const tp_scene *scene);
void tp_slot_get(fmpq_t value, const tp_slot *slot, const tp_scene *scene);

/* Put numbers in, and then what follows from them; a scene in which that fails is of no use. */
TP_MUST_USE tp_status tp_slots_set(tp_scene *scene, const tp_slot *slots, const fmpq *values,
                                   size_t count, tp_message *message);

#endif
