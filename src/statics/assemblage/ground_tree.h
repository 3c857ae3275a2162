/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A tree of contacts from the ground to every free block, each of which can exert any wrench: three
 * of its columns span all of them. */

#ifndef TP_ASSEMBLAGE_GROUND_TREE_H
#define TP_ASSEMBLAGE_GROUND_TREE_H

#include "assemblage/force_program.h"

typedef struct tp_tree_link {
  long number;     /* of the block that it leads to */
  long parent;     /* number of the block that it comes from; -1: ground */
  long columns[3]; /* of the program */
  int side;        /* which block of the columns' contact that is: 0 or 1 */
} tp_tree_link;

typedef struct tp_ground_tree {
  long count;          /* fewer than there are free blocks where some are not reached */
  tp_tree_link *links; /* parents before children */
} tp_ground_tree;

/* False when memory is exhausted. */
TP_MUST_USE bool tp_ground_tree_init(tp_ground_tree *tree, const tp_force_program *program);
void tp_ground_tree_clear(tp_ground_tree *tree);

/* The factors on the columns of a link that make up a wrench on its block, each enclosed. */
void tp_tree_link_share(tp_near factors[3], const tp_tree_link *link,
                        const tp_force_program *program, const tp_near wrench[3]);

#endif
