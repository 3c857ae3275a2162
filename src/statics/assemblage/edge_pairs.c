/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A sweep from left to right over the boxes of all edges: those that are open meet in x, and are
 * looked at for y. Boxes are compared in whole numbers. Whether a block lies all within another is
 * asked of its first corner alone, by counting crossings of a ray. */

#define _GNU_SOURCE /* qsort_r */
#include "assemblage/edge_pairs.h"

#include <stdlib.h>

typedef struct boxed_edge {
  tp_edge_of_block edge;
  long left, right, low, high; /* points of the lattice with its extreme coordinates */
} boxed_edge;

static void set_box(boxed_edge *b, const tp_lattice *l) {
  const long p = b->edge.corner.point, q = b->edge.corner.next;
  const bool runs_right = fmpz_cmp(l->x + p, l->x + q) <= 0;
  const bool runs_up = fmpz_cmp(l->y + p, l->y + q) <= 0;
  b->left = runs_right ? p : q;
  b->right = runs_right ? q : p;
  b->low = runs_up ? p : q;
  b->high = runs_up ? q : p;
}

static int compare_left(const void *first, const void *second, void *lattice) {
  const tp_lattice *l = lattice;
  const boxed_edge *a = first, *b = second;
  return fmpz_cmp(l->x + a->left, l->x + b->left);
}

static bool meet_upright(const tp_lattice *l, const boxed_edge *a, const boxed_edge *b) {
  return fmpz_cmp(l->y + a->low, l->y + b->high) <= 0 &&
         fmpz_cmp(l->y + b->low, l->y + a->high) <= 0;
}

static tp_status sweep(tp_assemblage *a, const boxed_edge *edges, long count, long *open,
                       tp_edge_pair_call *pair, tp_message *message) {
  const tp_lattice *l = &a->lattice;
  long open_count = 0;
  tp_status status = TP_OK;
  for (long k = 0; k < count && status == TP_OK; k++) {
    long kept = 0;
    for (long o = 0; o < open_count && status == TP_OK; o++) {
      const boxed_edge *before = edges + open[o];
      if (fmpz_cmp(l->x + before->right, l->x + edges[k].left) < 0) continue;
      open[kept++] = open[o];
      if (before->edge.block == edges[k].edge.block || !meet_upright(l, before, edges + k))
        continue;
      status = pair(a, &before->edge, &edges[k].edge, message);
    }
    open[kept] = k;
    open_count = kept + 1;
  }
  return status;
}

/* Is the point strictly within the outline of a block, off its border? */
static bool is_within(const tp_lattice *l, const tp_rigid_block *block, long p) {
  bool within = false;
  for (long k = block->outline; k < block->end; k++) {
    const long next = k + 1 < block->end ? k + 1 : block->outline;
    const bool above = fmpz_cmp(l->y + k, l->y + p) > 0,
               after = fmpz_cmp(l->y + next, l->y + p) > 0;
    const int side = tp_lattice_cross(l, k, next, k, p);
    if (side == 0 && tp_lattice_dot(l, p, k, p, next) <= 0) return false;
    if (above != after && (side > 0) == after) within = !within;
  }
  return within;
}

/* The boxes of blocks. */
typedef struct boxed_block {
  long block, left, right, low, high;
} boxed_block;

static int compare_blocks(const void *first, const void *second, void *lattice) {
  const tp_lattice *l = lattice;
  const boxed_block *a = first, *b = second;
  return fmpz_cmp(l->x + a->left, l->x + b->left);
}

static void set_block_box(boxed_block *b, const tp_lattice *l, const tp_rigid_block *block) {
  b->left = b->right = b->low = b->high = block->outline;
  for (long p = block->outline; p < block->end; p++) {
    if (fmpz_cmp(l->x + p, l->x + b->left) < 0) b->left = p;
    if (fmpz_cmp(l->x + p, l->x + b->right) > 0) b->right = p;
    if (fmpz_cmp(l->y + p, l->y + b->low) < 0) b->low = p;
    if (fmpz_cmp(l->y + p, l->y + b->high) > 0) b->high = p;
  }
}

static tp_status ask_within(tp_assemblage *a, long inner, long outer, tp_edge_within_call *within,
                            tp_message *message) {
  const tp_rigid_block *block = a->blocks + inner;
  if (!is_within(&a->lattice, a->blocks + outer, block->outline)) return TP_OK;
  const tp_edge_of_block edge = {.block = inner,
                                 .corner = {block->end - 1, block->outline, block->outline + 1}};
  return within(a, &edge, outer, message);
}

static tp_status sweep_blocks(tp_assemblage *a, boxed_block *boxes, long *open,
                              tp_edge_within_call *within, tp_message *message) {
  const tp_lattice *l = &a->lattice;
  long open_count = 0;
  tp_status status = TP_OK;
  qsort_r(boxes, (size_t)a->count, sizeof *boxes, compare_blocks, &a->lattice);
  for (long k = 0; k < a->count && status == TP_OK; k++) {
    long kept = 0;
    for (long o = 0; o < open_count && status == TP_OK; o++) {
      const boxed_block *before = boxes + open[o];
      if (fmpz_cmp(l->x + before->right, l->x + boxes[k].left) < 0) continue;
      open[kept++] = open[o];
      if (fmpz_cmp(l->y + before->low, l->y + boxes[k].high) > 0 ||
          fmpz_cmp(l->y + boxes[k].low, l->y + before->high) > 0) {
        continue;
      }
      status = ask_within(a, boxes[k].block, before->block, within, message);
      if (status == TP_OK) status = ask_within(a, before->block, boxes[k].block, within, message);
    }
    open[kept] = k;
    open_count = kept + 1;
  }
  return status;
}

static tp_status each_block_within(tp_assemblage *a, tp_edge_within_call *within,
                                   tp_message *message) {
  boxed_block *boxes = calloc((size_t)a->count + 1, sizeof *boxes);
  long *open = calloc((size_t)a->count + 1, sizeof *open);
  if (boxes == NULL || open == NULL) {
    free(boxes);
    free(open);
    return tp_fail_memory(message, "the blocks");
  }
  for (long k = 0; k < a->count; k++) {
    boxes[k].block = k;
    set_block_box(boxes + k, &a->lattice, a->blocks + k);
  }
  const tp_status status = sweep_blocks(a, boxes, open, within, message);
  free(boxes);
  free(open);
  return status;
}

tp_status tp_edge_pairs_each(tp_assemblage *a, tp_edge_pair_call *pair, tp_edge_within_call *within,
                             tp_message *message) {
  long count = 0;
  for (long k = 0; k < a->count; k++) count += a->blocks[k].end - a->blocks[k].outline;
  boxed_edge *edges = calloc((size_t)count + 1, sizeof *edges);
  long *open = calloc((size_t)count + 1, sizeof *open);
  if (edges == NULL || open == NULL) {
    free(edges);
    free(open);
    return tp_fail_memory(message, "the edges");
  }
  long at = 0;
  for (long k = 0; k < a->count; k++) {
    const tp_rigid_block *b = a->blocks + k;
    for (long p = b->outline; p < b->end; p++) {
      const long before = p > b->outline ? p - 1 : b->end - 1;
      const long next = p + 1 < b->end ? p + 1 : b->outline;
      edges[at].edge = (tp_edge_of_block){.block = k, .corner = {before, p, next}};
      set_box(edges + at++, &a->lattice);
    }
  }
  qsort_r(edges, (size_t)count, sizeof *edges, compare_left, &a->lattice);
  tp_status status = sweep(a, edges, count, open, pair, message);
  free(open);
  free(edges);
  return status == TP_OK ? each_block_within(a, within, message) : status;
}
