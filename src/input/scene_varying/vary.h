/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The numbers of a scene by their keys, and scenes in which some of them are others.
 *
 * Of a scene that was read from a file its nodes are read again, with a list of what stands in
 * place of some: parameters, expressions and rules follow as they do in the file, the nodes stay as
 * they are, and chains of points that no such number bears upon are shared. A scene that was built
 * in memory is copied, with its chains shared, and the number put where the table of keys says
 * (scene_varying/slot_table.c). Threads may do so with one scene at the same time. */

#ifndef TP_SCENE_VARYING_VARY_H
#define TP_SCENE_VARYING_VARY_H

#include "scene_reading/key.h"
#include "scene_varying/slots.h"

/* A key of a scene, looked up: where it stands in the scene. */
typedef struct tp_scene_key {
  const tp_node *node; /* in its file; NULL: in memory, */
  tp_slot slot;        /* there */
} tp_scene_key;

/* `text` outlives the key. Bad input where there is no such number, with the nearest key. */
TP_MUST_USE tp_status tp_scene_key_find(tp_scene_key *key, const tp_scene *scene, const char *text,
                                        tp_message *message);
/* Where the number was given. */
tp_place tp_scene_key_place(const tp_scene_key *key, const tp_scene *scene);
TP_MUST_USE tp_status tp_scene_key_value(fmpq_t value, const tp_scene_key *key,
                                         const tp_scene *scene, tp_message *message);
/* What it bears upon. */
TP_MUST_USE tp_status tp_scene_key_reach(tp_reach *reach, const tp_scene_key *key,
                                         const tp_scene *scene, tp_message *message);

bool tp_scene_key_same(const tp_scene_key *one, const tp_scene_key *other);

/* The scene with `values` for the numbers of `count` keys. */
TP_MUST_USE tp_status tp_scene_vary(tp_scene **varied, const tp_scene *scene,
                                    const tp_scene_key *keys, const fmpq *values, size_t count,
                                    tp_message *message);
/* The same by settings (scene/setting.h), which it keeps. */
TP_MUST_USE tp_status tp_scene_set(tp_scene **varied, const tp_scene *scene,
                                   const tp_scene_key *keys, const char *const *settings,
                                   size_t count, tp_message *message);

#endif
