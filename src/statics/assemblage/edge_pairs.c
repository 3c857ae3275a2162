/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A sweep from left to right over the boxes of all edges, and one over those of blocks: boxes that
 * are open meet in x, and are looked at for y, in whole numbers. Whether a block lies all within
 * another is asked of its first corner alone, by counting crossings of a ray. */

#define _GNU_SOURCE /* qsort_r */
#include "assemblage/edge_pairs.h"

#include <stdlib.h>

/* The points of the lattice with the extreme coordinates of an edge or a block. */
typedef struct box {
  long item, left, right, low, high;
} box;

static box box_of(long item, long point) {
  return (box){item, point, point, point, point};
}

static void widen(box *b, const tp_lattice *l, long point) {
  if (fmpz_cmp(l->x + point, l->x + b->left) < 0) b->left = point;
  if (fmpz_cmp(l->x + point, l->x + b->right) > 0) b->right = point;
  if (fmpz_cmp(l->y + point, l->y + b->low) < 0) b->low = point;
  if (fmpz_cmp(l->y + point, l->y + b->high) > 0) b->high = point;
}

static int compare_left(const void *first, const void *second, void *lattice) {
  const tp_lattice *l = lattice;
  const box *a = first, *b = second;
  return fmpz_cmp(l->x + a->left, l->x + b->left);
}

static bool meet_upright(const tp_lattice *l, const box *a, const box *b) {
  return fmpz_cmp(l->y + a->low, l->y + b->high) <= 0 &&
         fmpz_cmp(l->y + b->low, l->y + a->high) <= 0;
}

/* What is looked for among edges, and among blocks. */
typedef struct pairing {
  tp_assemblage *assemblage;
  tp_edge_of_block *edges;
  tp_edge_pair_call *pair;
  tp_edge_within_call *within;
} pairing;

typedef tp_status meeting(const pairing *p, long item, long other, tp_message *message);

static tp_status sweep(const pairing *p, box *boxes, long count, meeting *meet,
                       tp_message *message) {
  tp_lattice *l = &p->assemblage->lattice;
  long *open = calloc((size_t)count + 1, sizeof *open), open_count = 0;
  if (open == NULL) return tp_fail_memory(message, "the boxes of blocks");
  tp_status status = TP_OK;
  qsort_r(boxes, (size_t)count, sizeof *boxes, compare_left, l);
  for (long k = 0; k < count && status == TP_OK; k++) {
    long kept = 0;
    for (long o = 0; o < open_count && status == TP_OK; o++) {
      const box *before = boxes + open[o];
      if (fmpz_cmp(l->x + before->right, l->x + boxes[k].left) < 0) continue;
      open[kept++] = open[o];
      if (meet_upright(l, before, boxes + k)) {
        status = meet(p, before->item, boxes[k].item, message);
      }
    }
    open[kept] = k;
    open_count = kept + 1;
  }
  free(open);
  return status;
}

static tp_status meet_edges(const pairing *p, long item, long other, tp_message *message) {
  const tp_edge_of_block *edge = p->edges + item, *than = p->edges + other;
  return edge->block != than->block ? p->pair(p->assemblage, edge, than, message) : TP_OK;
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

static tp_status ask_within(const pairing *p, long inner, long outer, tp_message *message) {
  const tp_assemblage *a = p->assemblage;
  const tp_rigid_block *block = a->blocks + inner;
  if (!is_within(&a->lattice, a->blocks + outer, block->outline)) return TP_OK;
  return p->within(p->assemblage, inner, outer, message);
}

static tp_status meet_blocks(const pairing *p, long item, long other, tp_message *message) {
  const tp_status status = ask_within(p, item, other, message);
  return status == TP_OK ? ask_within(p, other, item, message) : status;
}

/* Edges of all blocks with their boxes, and the boxes of blocks. */
static void set_boxes(const pairing *p, box *of_edges, box *of_blocks) {
  const tp_assemblage *a = p->assemblage;
  long at = 0;
  for (long k = 0; k < a->count; k++) {
    const tp_rigid_block *b = a->blocks + k;
    of_blocks[k] = box_of(k, b->outline);
    for (long point = b->outline; point < b->end; point++) {
      const long before = point > b->outline ? point - 1 : b->end - 1;
      const long next = point + 1 < b->end ? point + 1 : b->outline;
      p->edges[at] = (tp_edge_of_block){.block = k, .corner = {before, point, next}};
      of_edges[at] = box_of(at, point);
      widen(of_edges + at++, &a->lattice, next);
      widen(of_blocks + k, &a->lattice, point);
    }
  }
}

tp_status tp_edge_pairs_each(tp_assemblage *a, tp_edge_pair_call *pair, tp_edge_within_call *within,
                             tp_message *message) {
  const long count = a->edge_count;
  box *of_edges = calloc((size_t)count + 1, sizeof *of_edges);
  box *of_blocks = calloc((size_t)a->count + 1, sizeof *of_blocks);
  const pairing p = {a, calloc((size_t)count + 1, sizeof *p.edges), pair, within};
  tp_status status = of_edges != NULL && of_blocks != NULL && p.edges != NULL
                         ? TP_OK
                         : tp_fail_memory(message, "the boxes of blocks");
  if (status == TP_OK) {
    set_boxes(&p, of_edges, of_blocks);
    status = sweep(&p, of_edges, count, meet_edges, message);
  }
  if (status == TP_OK) status = sweep(&p, of_blocks, a->count, meet_blocks, message);
  free(of_edges);
  free(of_blocks);
  free(p.edges);
  return status;
}
