/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Blocks of a scene by their names. */

#ifndef TP_SCENE_READING_BLOCK_NAMES_H
#define TP_SCENE_READING_BLOCK_NAMES_H

#include "scene_reading/read.h"

typedef struct tp_block_name {
  const char *name;
  long number;
} tp_block_name;

/* Those of all blocks, sorted, to be given back by free; refused where two are the same. */
TP_MUST_USE tp_status tp_block_names_sort(tp_block_name **names, const tp_reader *reader);

/* Is it the name of a block? */
bool tp_block_name_is(const tp_reader *reader, const char *name, const tp_block_name *names);

/* The number of the block that a node names. */
TP_MUST_USE tp_status tp_block_name_find(const tp_reader *reader, long *number, const tp_node *node,
                                         const tp_block_name *names);

#endif
