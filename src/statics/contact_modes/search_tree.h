/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How a search divided its nodes, so that the next one, of a question that is little else, can
 * divide them alike and need not find out by linear programs. Nothing is concluded from it. */

#ifndef TP_CONTACT_MODES_SEARCH_TREE_H
#define TP_CONTACT_MODES_SEARCH_TREE_H

#include "contact_modes/mode_set.h"

#include "topple_basics.h"

/* A node is a chain of steps: what was left out of a contact before the node was divided; then the
 * parts of one contact, each with the node that it became. */
typedef struct tp_tree_step {
  long contact;
  tp_mode_set own, of_twin;
  bool is_part; /* else left out */
  long child;   /* the first step of that node; -1: it was refuted as it was */
  long next;    /* -1: none */
} tp_tree_step;

typedef struct tp_search_tree {
  long count, room;
  tp_tree_step *steps;
} tp_search_tree;

/* A node as it is told. */
typedef struct tp_tree_node {
  long first, last; /* -1: of no steps */
} tp_tree_node;

void tp_search_tree_clear(tp_search_tree *tree);

/* As the last step of a node, and what follows it as well. Where memory is exhausted the node is
 * told without, so that more is found out anew. */
void tp_search_tree_add(tp_search_tree *tree, tp_tree_node *node, tp_tree_step step);

/* Of steps from `part` on the first of which these modes are part; -1: of none. */
long tp_search_tree_part(const tp_search_tree *tree, long part, tp_mode_set own,
                         tp_mode_set of_twin);

/* A node with all below it, copied into another tree; its first step. */
long tp_search_tree_copy(tp_search_tree *to, const tp_search_tree *from, long first);

#endif
