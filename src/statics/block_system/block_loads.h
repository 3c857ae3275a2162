/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What acts on many blocks besides their weights and an earthquake: water, pressures, surcharges,
 * bolts and forces, each as a wrench on one block, of the room of loads (load/wrench.h). */

#ifndef TP_BLOCK_SYSTEM_BLOCK_LOADS_H
#define TP_BLOCK_SYSTEM_BLOCK_LOADS_H

#include "assemblage/force_program.h"
#include "block_system/block_faces.h"
#include "load/setting.h"

/* One load on one block. */
typedef struct tp_block_load {
  tp_system_load_kind kind;
  bool active; /* of a support: it is taken from what drives; else it rests */
  long block;
  tp_wrench wrench; /* about the block's own point, in N and N m per metre of thickness; its tilt is
                       below zero where the right side is lowered */
} tp_block_load;

static inline bool tp_block_load_is_water(const tp_block_load *load) {
  return load->kind == TP_SYSTEM_LOAD_WATER_IN_JOINTS ||
         load->kind == TP_SYSTEM_LOAD_WATER_ON_FACES;
}

/* All of them, as the blocks are seen in a case that goes to one side. A pressure or a force drives
 * blocks where its parts to the side and off the base are together above zero; so does water, all
 * of it as one. Active bolts and support pressures are taken from what drives, and so go with it.
 * What turns with gravity does not drive, nor do passive supports. */
typedef struct tp_block_loads {
  bool left;  /* the side */
  bool omits; /* water before faces that it would hold is left out */
  long count, room;
  tp_block_load *items;
  tp_applied_load *applied; /* by row, in units of the assemblage; NULL: there are none */
  tp_applied_load *resting; /* of these, those that do not drive blocks to the side, */
  tp_near *pushing;         /* and those that do */
  tp_bounded *water;        /* by contact: what the water in it pushes by, in N per metre */
} tp_block_loads;

/* Does a scene of many blocks call for any? */
bool tp_block_loads_are_called_for(const tp_scene *scene);

/* Refused: loads that do not act on their blocks, bolts that hold nowhere. On failure cleared. */
TP_MUST_USE tp_status tp_block_loads_init(tp_block_loads *loads, const tp_placed_blocks *blocks,
                                          bool left, tp_message *message);
void tp_block_loads_clear(tp_block_loads *loads);

/* One more on a block that is free, or its opposite; nothing of one that is fixed. The wrench of
 * `load` is about the origin, and stays the caller's. */
TP_MUST_USE tp_status tp_block_loads_add(tp_block_loads *loads, const tp_placed_blocks *blocks,
                                         const tp_block_load *load, bool reversed,
                                         tp_message *message);

/* Water in joints and on faces (block_system/block_water.c). */
TP_MUST_USE tp_status tp_block_water_add(tp_block_loads *loads, const tp_placed_blocks *blocks,
                                         const tp_load_setting *setting, tp_message *message);

/* The blocks that the head of a bolt of a row and its far end hold in
 * (block_system/block_bolts.c). Refused: it does not hold the two. */
TP_MUST_USE tp_status tp_block_bolt_ends(long *head, long *into, const tp_placed_blocks *blocks,
                                         const tp_anchor_description *anchor, long row,
                                         tp_message *message);

#endif
