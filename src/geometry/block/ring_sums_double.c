/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The boundary sums in double, with a proven bound.
 *
 * Problem: the sums of ring_sums.h over n vertices (u_k, v_k), |u| <= U, |v| <= V.
 * Method: c = u_k (v_{k+1} - v_k) - v_k (u_{k+1} - u_k), whose rounding error is proportional to
 * the edge and not to the distance from the origin; added in the order of ring_sums_kernel.h, where
 * a term passes at most D additions (tp_ring_additions: 4 for a triangle, 89 at most up to 10^9).
 *
 * Bound (unit roundoff w = 2^-53, standard model; Higham, Accuracy and Stability, 2nd ed., ch. 3
 * and 4). With the edge measure e_k = U |dv_k| + V |du_k|, |c_k| <= e_k:
 *   c has two rounded differences, two products and a difference:    |err| <= 3.1 w e_k
 *   u_k + u_{k+1} <= 2 U:                            term |err| <= 2 U (5.2 w) e_k
 *   u^2 + u u' + u'^2 <= 3 U^2, three roundings:     term |err| <= 3 U^2 (7.3 w) e_k
 *   the mixed form <= 6 U V, three roundings:        term |err| <= 6 U V (7.3 w) e_k
 * Every sum errs by at most (7.4 w + 1.0001 D w) K sum e_k, with K = 1, 2U, 2V, 3U^2, 3V^2, 6UV.
 * The sum of e_k is itself computed with relative error below (D + 4) w. Together (D + 8) w K
 * sum e_k, computed with a margin of 1 %.
 * Coordinates that were rounded (|du| <= w U, |dv| <= w V) move each c by at most 4.1 w U V and
 * each term by at most 4.1, 12.3, 24.7 or 50 w times the matching monomial in U and V.
 * Underflow: exact coordinates are integers and have none; of rounded ones U, V >= 1 is asked, and
 * what underflows then (2^-1074 times at most 2^159 in a term) is lost in the margin of 1 %. */

#include "block/ring_sums_kernel.h"

#include <float.h>
#include <math.h>

/* Of coordinates that were rounded. */
static void bound_rounded(double *bounds, double lost, double most_u, double most_v, long count,
                          int sum_count) {
  static const double moved[TP_SUM_COUNT] = {4.1, 6.2, 6.2, 8.3, 8.3, 8.4}; /* over K */
  const double unit = DBL_EPSILON / 2;
  const bool underflows = most_u < 1 || most_v < 1;
  for (int k = 0; k < sum_count; k++) {
    const double scale = tp_ring_scale(k, most_u, most_v);
    const double own = moved[k] * unit * scale * most_u * most_v * (double)count;
    bounds[k] = underflows ? INFINITY : 1.01 * (lost * scale + own);
  }
}

/* Sum by sum and not by loops: of a small ring their turns would cost as much as the sums. */
void tp_ring_sums_double_first(double *sums, double *bounds, const double *u, const double *v,
                               long count, bool exact, tp_sums_plan plan) {
  double rows[TP_ROW_COUNT];
  tp_ring_rows(rows, &(tp_ring){u, v, count}, plan, false);

  const bool all = plan.sum_count == TP_SUM_COUNT;
  sums[TP_A2] = rows[TP_ROW_SUMS + TP_A2];
  sums[TP_X6] = rows[TP_ROW_SUMS + TP_X6];
  sums[TP_Y6] = rows[TP_ROW_SUMS + TP_Y6];
  if (all) {
    sums[TP_XX12] = rows[TP_ROW_SUMS + TP_XX12];
    sums[TP_YY12] = rows[TP_ROW_SUMS + TP_YY12];
    sums[TP_XY24] = rows[TP_ROW_SUMS + TP_XY24];
  }
  const double unit = DBL_EPSILON / 2, most_u = rows[TP_ROW_MOST_U], most_v = rows[TP_ROW_MOST_V];
  const double measure = most_u * rows[TP_ROW_MEASURES + 1] + most_v * rows[TP_ROW_MEASURES];
  const double lost = (double)(tp_ring_additions(count) + 8) * unit * measure;
  if (!exact) {
    bound_rounded(bounds, lost, most_u, most_v, count, plan.sum_count);
    return;
  }
  bounds[TP_A2] = 1.01 * (lost * tp_ring_scale(TP_A2, most_u, most_v));
  bounds[TP_X6] = 1.01 * (lost * tp_ring_scale(TP_X6, most_u, most_v));
  bounds[TP_Y6] = 1.01 * (lost * tp_ring_scale(TP_Y6, most_u, most_v));
  if (all) {
    bounds[TP_XX12] = 1.01 * (lost * tp_ring_scale(TP_XX12, most_u, most_v));
    bounds[TP_YY12] = 1.01 * (lost * tp_ring_scale(TP_YY12, most_u, most_v));
    bounds[TP_XY24] = 1.01 * (lost * tp_ring_scale(TP_XY24, most_u, most_v));
  }
}

void tp_ring_sums_double(double sums[TP_SUM_COUNT], double bounds[TP_SUM_COUNT], const double *u,
                         const double *v, long count, bool exact) {
  tp_ring_sums_double_first(sums, bounds, u, v, count, exact,
                            (tp_sums_plan){.sum_count = TP_SUM_COUNT});
}
