/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The boundary sums in double, with a proven bound.
 *
 * Problem: the sums of ring_sums.h over n vertices (u_k, v_k), |u| <= U, |v| <= V.
 * Method: c = u_k (v_{k+1} - v_k) - v_k (u_{k+1} - u_k), whose rounding error is proportional to
 * the edge and not to the distance from the origin; eight lanes in chunks of 512 edges, chunks
 * added pairwise. The order of all operations is fixed, so the bits do not depend on the machine.
 *
 * Bound (unit roundoff w = 2^-53, standard model; Higham, Accuracy and Stability, 2nd ed., ch. 3
 * and 4). With the edge measure e_k = U |dv_k| + V |du_k|, |c_k| <= e_k:
 *   c has two rounded differences, two products and a difference:    |err| <= 3.1 w e_k
 *   u_k + u_{k+1} <= 2 U:                            term |err| <= 2 U (5.2 w) e_k
 *   u^2 + u u' + u'^2 <= 3 U^2, three roundings:     term |err| <= 3 U^2 (7.3 w) e_k
 *   the mixed form <= 6 U V, three roundings:        term |err| <= 6 U V (7.3 w) e_k
 * Every term passes at most 64 additions in its lane, 3 to join the lanes and 64 between chunks,
 * 131 in all, so every sum errs by at most (8 w + 131.1 w) K sum e_k, with K = 1, 2U, 2V, 3U^2,
 * 3V^2, 6UV. The sum of e_k is itself computed with relative error below 135 w. Together
 * 140 w K sum e_k, computed with a margin of 1 %.
 * Coordinates that were rounded (|du| <= w U, |dv| <= w V) move each c by at most 4.1 w U V and
 * each term by at most 4.1, 12.3, 24.7 or 50 w times the matching monomial in U and V.
 * No underflow: nonzero exact coordinates are integers, rounded ones have their largest near 2^53.
 * Cost: about 1 ns a vertex in cache. */

#include "block/ring_sums.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { LANES = 8, CHUNK = 512, LEVELS = 64, MEASURE_U = TP_SUM_COUNT, MEASURE_V, ROWS };

/* One edge into the lanes: six sums and the two measures sum |du|, sum |dv|. */
static inline void add_edge(double lanes[ROWS][LANES], int lane, double u0, double v0, double u1,
                            double v1) {
  const double du = u1 - u0, dv = v1 - v0;
  const double c = u0 * dv - v0 * du;
  const double u = u0 + u1, v = v0 + v1;
  lanes[TP_A2][lane] += c;
  lanes[TP_X6][lane] += u * c;
  lanes[TP_Y6][lane] += v * c;
  lanes[TP_XX12][lane] += (u1 * u + u0 * u0) * c;
  lanes[TP_YY12][lane] += (v1 * v + v0 * v0) * c;
  lanes[TP_XY24][lane] += ((u0 * v1 + u1 * v0) + 2 * (u0 * v0 + u1 * v1)) * c;
  lanes[MEASURE_U][lane] += fabs(du);
  lanes[MEASURE_V][lane] += fabs(dv);
}

/* Edges from … to - 1, none of them the closing one. */
static void add_chunk(double rows[ROWS], const double *u, const double *v, long from, long to) {
  double lanes[ROWS][LANES];
  memset(lanes, 0, sizeof lanes);
  long k = from;
  for (; k + LANES <= to; k += LANES) {
    for (int lane = 0; lane < LANES; lane++) {
      add_edge(lanes, lane, u[k + lane], v[k + lane], u[k + lane + 1], v[k + lane + 1]);
    }
  }
  for (; k < to; k++) add_edge(lanes, (int)(k - from) % LANES, u[k], v[k], u[k + 1], v[k + 1]);
  for (int row = 0; row < ROWS; row++) {
    const double *l = lanes[row];
    rows[row] = ((l[0] + l[1]) + (l[2] + l[3])) + ((l[4] + l[5]) + (l[6] + l[7]));
  }
}

/* Pairwise sum of chunks: level k holds the sum of 2^k chunks where bit k of `filled` is set. */
typedef struct pyramid {
  double rows[LEVELS][ROWS];
  unsigned long filled;
} pyramid;

static void pyramid_add(pyramid *p, double rows[ROWS]) {
  int level = 0;
  for (; (p->filled >> level & 1) != 0; level++) {
    for (int row = 0; row < ROWS; row++) rows[row] += p->rows[level][row];
  }
  memcpy(p->rows[level], rows, sizeof p->rows[level]);
  p->filled++; /* clears the levels below and sets this one */
}

static void pyramid_total(const pyramid *p, double rows[ROWS]) {
  memset(rows, 0, ROWS * sizeof *rows);
  for (int level = 0; level < LEVELS; level++) {
    if ((p->filled >> level & 1) == 0) continue;
    for (int row = 0; row < ROWS; row++) rows[row] += p->rows[level][row];
  }
}

static double largest(const double *values, long count) {
  double most = 0;
  for (long k = 0; k < count; k++) most = fmax(most, fabs(values[k]));
  return most;
}

void tp_ring_sums_double(double sums[TP_SUM_COUNT], double bounds[TP_SUM_COUNT], const double *u,
                         const double *v, long count, bool exact) {
  pyramid p;
  p.filled = 0;
  double rows[ROWS];
  for (long from = 0; from + 1 < count; from += CHUNK) {
    const long to = from + CHUNK < count - 1 ? from + CHUNK : count - 1;
    add_chunk(rows, u, v, from, to);
    pyramid_add(&p, rows);
  }
  if (count > 0) { /* the closing edge */
    const double ends_u[2] = {u[count - 1], u[0]}, ends_v[2] = {v[count - 1], v[0]};
    add_chunk(rows, ends_u, ends_v, 0, 1);
    pyramid_add(&p, rows);
  }
  pyramid_total(&p, rows);
  memcpy(sums, rows, TP_SUM_COUNT * sizeof *sums);

  const double unit = DBL_EPSILON / 2, most_u = largest(u, count), most_v = largest(v, count);
  const double measure = most_u * rows[MEASURE_V] + most_v * rows[MEASURE_U];
  const double scale[TP_SUM_COUNT] = {
      1, 2 * most_u, 2 * most_v, 3 * most_u * most_u, 3 * most_v * most_v, 6 * most_u * most_v};
  static const double moved[TP_SUM_COUNT] = {4.1, 6.2, 6.2, 8.3, 8.3, 8.4}; /* over `scale` */
  for (int k = 0; k < TP_SUM_COUNT; k++) {
    double bound = 140 * unit * scale[k] * measure;
    if (!exact) bound += moved[k] * unit * scale[k] * most_u * most_v * (double)count;
    bounds[k] = 1.01 * bound;
  }
}
