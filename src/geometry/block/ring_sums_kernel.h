/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the fast sums of ring_sums.h are made of.
 *
 * Edge k of a ring of n vertices goes from vertex k to vertex k + 1, the last one to vertex 0.
 * Edges are added in eight lanes, edge k in lane k mod 8; lanes in chunks of 512 edges; chunks
 * pairwise in blocks of 512 chunks; then the lanes of a block are joined, and blocks pairwise. The
 * order of all operations is a matter of n alone, so neither the width of the registers nor the
 * number of threads changes a bit of the result. */

#ifndef TP_BLOCK_RING_SUMS_KERNEL_H
#define TP_BLOCK_RING_SUMS_KERNEL_H

#include "block/ring_sums.h"

enum { TP_LANES = 8, TP_CHUNK_EDGES = 512, TP_BLOCK_EDGES = 512 * TP_CHUNK_EDGES };

/* What is gathered in every lane: the largest |u| and |v|; two measures, whose meaning is the
 * kernel's; from TP_ROW_SUMS on the sums, in a row each or, as pairs, in two: high, low. */
enum {
  TP_ROW_MOST_U,
  TP_ROW_MOST_V,
  TP_ROW_MEASURES,
  TP_ROW_SUMS = TP_ROW_MEASURES + 2,
  TP_ROW_COUNT = TP_ROW_SUMS + 2 * TP_SUM_COUNT
};

typedef struct tp_ring {
  const double *u, *v;
  long count;
} tp_ring;

/* The edges first … first + count - 1 of a ring, at least one, at most TP_BLOCK_EDGES; every row
 * joined over the lanes. */
typedef void (*tp_ring_kernel)(double rows[TP_ROW_COUNT], const tp_ring *ring, long first,
                               long count);

/* The kernel for this plan: double, or pairs. */
tp_ring_kernel tp_ring_kernel_choose(tp_sums_plan plan, bool pairs);

/* The rows of the whole ring, in double or (`pairs`) in pairs. */
void tp_ring_rows(double rows[TP_ROW_COUNT], const tp_ring *ring, tp_sums_plan plan, bool pairs);

/* K of a sum, by which its bounds scale: 1, 2 U, 2 V, 3 U^2, 3 V^2, 6 U V. */
static inline double tp_ring_scale(int sum, double most_u, double most_v) {
  switch (sum) {
  case TP_X6:
    return 2 * most_u;
  case TP_Y6:
    return 2 * most_v;
  case TP_XX12:
    return 3 * most_u * most_u;
  case TP_YY12:
    return 3 * most_v * most_v;
  case TP_XY24:
    return 6 * most_u * most_v;
  default:
    return 1;
  }
}

/* The additions that a term passes at most on its way into its sum: in the lane and between lanes;
 * of a ring of more than one chunk between chunks and between blocks, too. */
long tp_ring_additions_of_chunks(long count);
static inline long tp_ring_additions(long count) {
  return count <= TP_CHUNK_EDGES ? (count + TP_LANES - 1) / TP_LANES + 3
                                 : tp_ring_additions_of_chunks(count);
}

#endif
