/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What is read off one outline of a batch in doubles: its extremes, the ends of its underside, and
 * what turning about one of them does to the facets between them. Vectors of whatever instruction
 * set the machine has, the same bits by each (outline_scan.c). */

#ifndef TP_BATCH_OUTLINE_SCAN_H
#define TP_BATCH_OUTLINE_SCAN_H

#include "batch/outlines.h"
#include "batch/share.h"
#include "block/ring_sums.h"

/* The vertices, apart. */
typedef struct tp_scan {
  double *x, *y; /* as given; behind them there is room to go on with those of the beginning */
  double *u, *v; /* about an origin, in a scale: exact but for the rounding of a subtraction */
  long count;
  double least_x, most_x, least_y, most_y;
  long first, last; /* the least x + y and the largest x - y; -1: doubles do not tell */
} tp_scan;

/* Facets of the underside from a pivot on: `count` edges from vertex `from` on, in the order of the
 * outline; `forward` where that leads away from the pivot, which is at one end of them. */
typedef struct tp_scan_chain {
  long from, count, pivot;
  bool forward, rightwards; /* rightwards from the pivot */
} tp_scan_chain;

/* Turning about the pivot, in the sense in which its side goes down, each facet opens or slides
 * along itself (clear); some facet certainly does not (blocked); or doubles leave that open, or a
 * facet runs back. */
typedef enum tp_scan_answer { TP_SCAN_CLEAR, TP_SCAN_BLOCKED, TP_SCAN_OPEN } tp_scan_answer;

typedef struct tp_scan_kernel tp_scan_kernel; /* of an instruction set */

/* Of the best instruction set of this machine, or of one that is present. */
const tp_scan_kernel *tp_scan_kernel_choose(tp_instructions instructions);

/* Room for the vertices, and all but u and v; false when memory is exhausted. */
TP_MUST_USE bool tp_scan_read(tp_scan *scan, tp_workspace *workspace, tp_vertices vertices,
                              const tp_scan_kernel *kernel);

/* u and v about an origin, times a power of two. */
void tp_scan_shift(tp_scan *scan, double origin_x, double origin_y, double scale,
                   const tp_scan_kernel *kernel);

tp_scan_answer tp_scan_turn(const tp_scan *scan, tp_scan_chain chain, const tp_scan_kernel *kernel);

/* The power of two by which both extents come to at least 4, so that no product of theirs
 * underflows; 0 where they are out of the range in which that can be (1e-100 to 1e100, one at most
 * 1e50 times the other). */
double tp_scan_scale(const tp_scan *scan);

#endif
