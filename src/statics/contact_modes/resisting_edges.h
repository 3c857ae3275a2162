/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Edges of the cones of forces that contacts of a node can exert, by friction between the least and
 * the greatest, where a block takes part that is not at rest. */

#ifndef TP_CONTACT_MODES_RESISTING_EDGES_H
#define TP_CONTACT_MODES_RESISTING_EDGES_H

#include "contact_modes/node.h"

/* An edge of a cone: n at an end, and so much of t. */
typedef struct tp_resisting_edge {
  const tp_force_column *normal, *along;
  tp_near shear;
  long contact;
  int end;
} tp_resisting_edge;

typedef struct tp_resisting_edges {
  long count;
  tp_resisting_edge *all;
} tp_resisting_edges;

/* False when memory is exhausted. */
bool tp_resisting_edges_init(tp_resisting_edges *edges, const tp_modes_node *node,
                             const tp_modes_question *question);
void tp_resisting_edges_clear(tp_resisting_edges *edges);

#endif
