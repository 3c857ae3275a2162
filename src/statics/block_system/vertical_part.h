/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The vertical part of an earthquake. On a tilted table it acts as it is given. Where blocks lie at
 * their place it may act or not, as for one block: with weights alone, of which the direction
 * decides, an upward part is the worse, and a downward one never is; beside strength or loads that
 * are given in forces either may be: blocks that cohesion holds are held better as they weigh less.
 * So both are solved there, and of each result the less safe is told. */

#ifndef TP_BLOCK_SYSTEM_VERTICAL_PART_H
#define TP_BLOCK_SYSTEM_VERTICAL_PART_H

#include "scene/scene.h"
#include "topple_block_system.h"

typedef enum tp_vertical_part {
  TP_VERTICAL_COUNTS,  /* it acts, or there is none */
  TP_VERTICAL_IS_LEFT, /* it does not act */
  TP_VERTICAL_MAY_ACT  /* both are to be solved */
} tp_vertical_part;

/* `is_measured`: as of tp_resultant_init. */
tp_vertical_part tp_scene_vertical_part(const tp_scene *scene, bool is_measured);

/* Of a case with the vertical part and the same without: of each result the less safe one. What is
 * not taken of `without` is left in it, to be given back as that of a case. */
void tp_system_case_join(tp_system_case *with, tp_system_case *without);

#endif
