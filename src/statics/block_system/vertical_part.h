/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The vertical part of an earthquake. On a tilted table it acts as it is given. Where blocks lie at
 * their place it may act or not, as for one block: with weights alone, of which the direction
 * decides, an upward part is the worse as they are shaken down-dip, and a downward one never is.
 * Up-dip either may be the worse: what it adds to the weights, or takes from them, changes how far
 * the earthquake turns their resultant away from the dip. So it may with strength or loads that are
 * given in forces: blocks that cohesion holds are held better as they weigh less. Then both are
 * solved, and the less safe of each result is reported. */

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
tp_vertical_part tp_scene_vertical_part(const tp_scene *scene, bool is_measured, bool towards_left);

/* Of a case with the vertical part and the same without: of each result the less safe one. What is
 * not taken of `without` is left in it, to be given back as that of a case. */
void tp_system_case_join(tp_system_case *with, tp_system_case *without);

#endif
