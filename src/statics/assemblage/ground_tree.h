/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* An order of the free blocks from the ground on, in which each can be held by three columns of its
 * contacts with the ground and with blocks before it: three that span all wrenches. */

#ifndef TP_ASSEMBLAGE_GROUND_TREE_H
#define TP_ASSEMBLAGE_GROUND_TREE_H

#include "assemblage/force_program.h"

typedef struct tp_tree_link {
  long number;         /* of the block */
  long columns[3];     /* of the program */
  int sides[3];        /* which block of each column's contact it is: 0 or 1 */
  bool of_one_contact; /* all three */
} tp_tree_link;

typedef struct tp_ground_tree {
  long count;          /* fewer than there are free blocks where some are not reached */
  tp_tree_link *links; /* each block behind those that it rests on */
} tp_ground_tree;

/* False when memory is exhausted. */
TP_MUST_USE bool tp_ground_tree_init(tp_ground_tree *tree, const tp_force_program *program);
void tp_ground_tree_clear(tp_ground_tree *tree);

/* The factors on the columns of a link that make up a wrench on its block, each enclosed. */
void tp_tree_link_share(tp_near factors[3], const tp_tree_link *link,
                        const tp_force_program *program, const tp_near wrench[3]);

#endif
