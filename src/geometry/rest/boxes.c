/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Heap-numbered binary tree of bounding boxes over runs of eight edges of the profile. */

#include "rest/boxes.h"

#include "number/binary.h"

#include <math.h>
#include <stdlib.h>

enum { LEAF_EDGES = 8 };

static double smaller(double held, double other) {
  return other < held ? other : held;
}

void tp_boxes_edges(long *first, long *end, const tp_boxes *boxes, long leaf) {
  *first = (leaf - boxes->leaves) * LEAF_EDGES;
  *end = *first + LEAF_EDGES < boxes->count ? *first + LEAF_EDGES : boxes->count;
}

static tp_edges_box around(const double *u, const double *v, long first, long last) {
  tp_edges_box box = {INFINITY, -INFINITY, INFINITY, -INFINITY};
  for (long k = first; k <= last; k++) {
    box.low_u = smaller(box.low_u, u[k]);
    box.high_u = tp_larger(box.high_u, u[k]);
    box.low_v = smaller(box.low_v, v[k]);
    box.high_v = tp_larger(box.high_v, v[k]);
  }
  return box;
}

static tp_edges_box join(const tp_edges_box *a, const tp_edges_box *b) {
  return (tp_edges_box){smaller(a->low_u, b->low_u), tp_larger(a->high_u, b->high_u),
                        smaller(a->low_v, b->low_v), tp_larger(a->high_v, b->high_v)};
}

bool tp_boxes_init(tp_boxes *boxes, const double *u, const double *v, long count) {
  *boxes = (tp_boxes){.count = count, .leaves = 1};
  while (boxes->leaves * LEAF_EDGES < count) boxes->leaves *= 2;
  boxes->nodes = calloc(2 * (size_t)boxes->leaves, sizeof *boxes->nodes);
  if (boxes->nodes == NULL) return false;
  for (long leaf = boxes->leaves; leaf < 2 * boxes->leaves; leaf++) {
    long first, end;
    tp_boxes_edges(&first, &end, boxes, leaf);
    boxes->nodes[leaf] = around(u, v, first, end < count ? end : count - 1);
  }
  for (long k = boxes->leaves - 1; k > 0; k--) {
    boxes->nodes[k] = join(boxes->nodes + 2 * k, boxes->nodes + 2 * k + 1);
  }
  return true;
}

void tp_boxes_clear(tp_boxes *boxes) {
  free(boxes->nodes);
  *boxes = (tp_boxes){0};
}
