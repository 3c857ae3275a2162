/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Boxes around runs of a profile's edges, in a binary tree: what none of a run can touch is passed
 * over as a whole. Nodes are numbered as in a heap, 2 k and 2 k + 1 below k, the whole from 1. */

#ifndef TP_REST_BOXES_H
#define TP_REST_BOXES_H

#include <stdbool.h>

typedef struct tp_edges_box {
  double low_u, high_u, low_v, high_v;
} tp_edges_box;

typedef struct tp_boxes {
  long count;  /* vertices; as many edges, the last without length */
  long leaves; /* a power of two; the leaves are the nodes from there on */
  tp_edges_box *nodes;
} tp_boxes;

/* Around the edges of a chain. False when memory is exhausted. */
bool tp_boxes_init(tp_boxes *boxes, const double *u, const double *v, long count);
void tp_boxes_clear(tp_boxes *boxes);

/* The edges of a leaf, named by their first vertices: from `*first` to before `*end`. */
void tp_boxes_edges(long *first, long *end, const tp_boxes *boxes, long leaf);

#endif
