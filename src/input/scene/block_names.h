/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Blocks of a scene by their names. */

#ifndef TP_SCENE_BLOCK_NAMES_H
#define TP_SCENE_BLOCK_NAMES_H

#include "scene/scene.h"

typedef struct tp_block_name {
  const char *name;
  long number;
} tp_block_name;

/* Those of all blocks, sorted, to be given back by free; refused where two are the same. */
TP_MUST_USE tp_status tp_block_names_sort(tp_block_name **names, const tp_scene *scene,
                                          tp_message *message);

/* Is it the name of a block? */
bool tp_block_name_is(const tp_scene *scene, const char *name, const tp_block_name *names);

/* The number of the block that a node names. */
TP_MUST_USE tp_status tp_block_name_find(long *number, const tp_scene *scene, const tp_node *node,
                                         const tp_block_name *names, tp_message *message);

#endif
