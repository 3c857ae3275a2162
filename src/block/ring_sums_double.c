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
 * Underflow: exact coordinates are integers and have none; of rounded ones U, V >= 1 is asked, and
 * what underflows then (2^-1074 times at most 2^159 in a term) is lost in the margin of 1 %.
 * Cost: about 2 ns a vertex in cache, at the pace of the adders of a plain x86-64. */

#include "block/ring_sums.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { LANES = 8, CHUNK = 512, LEVELS = 64 };
enum { MEASURE_U = TP_SUM_COUNT, MEASURE_V, ADDED, MOST_U = ADDED, MOST_V, ROWS };

/* As many lanes as a register of the plainest machine holds; any divisor of LANES gives the same
 * bits. Operations on them are elementwise. */
enum { WIDTH = 2 };
typedef double vector __attribute__((vector_size(8 * WIDTH)));
typedef long long vector_bits __attribute__((vector_size(8 * WIDTH)));

static inline vector load(const double *values) {
  vector v;
  memcpy(&v, values, sizeof v);
  return v;
}

static inline vector absolute(vector v) {
  return (vector)((vector_bits)v & 0x7fffffffffffffff);
}

static inline vector larger(vector a, vector b) {
  const vector_bits first = a > b;
  return (vector)(((vector_bits)a & first) | ((vector_bits)b & ~first));
}

/* WIDTH edges into their lanes: six sums, the two measures sum |du|, sum |dv|, the largest |u|
 * and |v| of their first ends. */
static inline void add_edges(vector rows[ROWS], vector u0, vector v0, vector u1, vector v1) {
  const vector du = u1 - u0, dv = v1 - v0;
  const vector c = u0 * dv - v0 * du;
  const vector u = u0 + u1, v = v0 + v1;
  rows[TP_A2] += c;
  rows[TP_X6] += u * c;
  rows[TP_Y6] += v * c;
  rows[TP_XX12] += (u1 * u + u0 * u0) * c;
  rows[TP_YY12] += (v1 * v + v0 * v0) * c;
  rows[TP_XY24] += ((u0 * v1 + u1 * v0) + 2 * (u0 * v0 + u1 * v1)) * c;
  rows[MEASURE_U] += absolute(du);
  rows[MEASURE_V] += absolute(dv);
  rows[MOST_U] = larger(absolute(u0), rows[MOST_U]);
  rows[MOST_V] = larger(absolute(v0), rows[MOST_V]);
}

/* The last edges, fewer than LANES: those that are missing are points at the origin, which add
 * zero. */
static inline void add_rest(vector rows[ROWS], const double *u, const double *v, long count) {
  double ends[4][WIDTH] = {0};
  for (long k = 0; k < count && k < WIDTH; k++) {
    ends[0][k] = u[k];
    ends[1][k] = v[k];
    ends[2][k] = u[k + 1];
    ends[3][k] = v[k + 1];
  }
  add_edges(rows, load(ends[0]), load(ends[1]), load(ends[2]), load(ends[3]));
}

/* `count` edges, none of them the closing one; edge k goes to lane k modulo LANES. The chunk lies
 * in the nearest cache and is passed once for every WIDTH lanes, so that their sums stay in
 * registers. */
static void add_chunk(double rows[ROWS], const double *u, const double *v, long count) {
  double lanes[ROWS][LANES];
  const long whole = count / LANES * LANES;
  for (long lane = 0; lane < LANES; lane += WIDTH) {
    vector part[ROWS] = {0};
    for (long k = lane; k < whole; k += LANES) {
      add_edges(part, load(u + k), load(v + k), load(u + k + 1), load(v + k + 1));
    }
    const long rest = whole + lane;
    if (rest < count) add_rest(part, u + rest, v + rest, count - rest);
    for (int row = 0; row < ROWS; row++) memcpy(lanes[row] + lane, part + row, sizeof(vector));
  }
  for (int row = 0; row < ADDED; row++) {
    const double *l = lanes[row];
    rows[row] = ((l[0] + l[1]) + (l[2] + l[3])) + ((l[4] + l[5]) + (l[6] + l[7]));
  }
  for (int row = ADDED; row < ROWS; row++) {
    rows[row] = 0;
    for (int lane = 0; lane < LANES; lane++) rows[row] = fmax(rows[row], lanes[row][lane]);
  }
}

/* Pairwise sum of chunks: level k holds the sum of 2^k chunks where bit k of `filled` is set. */
typedef struct pyramid {
  double rows[LEVELS][ROWS];
  unsigned long filled;
} pyramid;

static void join(double rows[ROWS], const double others[ROWS]) {
  for (int row = 0; row < ADDED; row++) rows[row] += others[row];
  for (int row = ADDED; row < ROWS; row++) rows[row] = fmax(rows[row], others[row]);
}

static void pyramid_add(pyramid *p, double rows[ROWS]) {
  int level = 0;
  for (; (p->filled >> level & 1) != 0; level++) join(rows, p->rows[level]);
  memcpy(p->rows[level], rows, sizeof p->rows[level]);
  p->filled++; /* clears the levels below and sets this one */
}

static void pyramid_total(const pyramid *p, double rows[ROWS]) {
  memset(rows, 0, ROWS * sizeof *rows);
  for (int level = 0; level < LEVELS; level++) {
    if ((p->filled >> level & 1) != 0) join(rows, p->rows[level]);
  }
}

void tp_ring_sums_double(double sums[TP_SUM_COUNT], double bounds[TP_SUM_COUNT], const double *u,
                         const double *v, long count, bool exact) {
  pyramid p;
  p.filled = 0;
  double rows[ROWS];
  for (long from = 0; from + 1 < count; from += CHUNK) {
    const long left = count - 1 - from;
    add_chunk(rows, u + from, v + from, left < CHUNK ? left : CHUNK);
    pyramid_add(&p, rows);
  }
  if (count > 0) { /* the closing edge */
    const double ends_u[2] = {u[count - 1], u[0]}, ends_v[2] = {v[count - 1], v[0]};
    add_chunk(rows, ends_u, ends_v, 1);
    pyramid_add(&p, rows);
  }
  pyramid_total(&p, rows);
  memcpy(sums, rows, TP_SUM_COUNT * sizeof *sums);

  const double unit = DBL_EPSILON / 2, most_u = rows[MOST_U], most_v = rows[MOST_V];
  const double measure = most_u * rows[MEASURE_V] + most_v * rows[MEASURE_U];
  const double scale[TP_SUM_COUNT] = {
      1, 2 * most_u, 2 * most_v, 3 * most_u * most_u, 3 * most_v * most_v, 6 * most_u * most_v};
  static const double moved[TP_SUM_COUNT] = {4.1, 6.2, 6.2, 8.3, 8.3, 8.4}; /* over `scale` */
  for (int k = 0; k < TP_SUM_COUNT; k++) {
    double bound = 140 * unit * scale[k] * measure;
    if (!exact) bound += moved[k] * unit * scale[k] * most_u * most_v * (double)count;
    const bool underflows = !exact && (most_u < 1 || most_v < 1);
    bounds[k] = underflows ? INFINITY : 1.01 * bound;
  }
}
