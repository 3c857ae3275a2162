/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The boundary sums in pairs of doubles, high + low, with a proven bound.
 *
 * Problem: the sums of ring_sums.h over n vertices that are integers, |u| <= U, |v| <= V <= 2^53.
 * Method: error-free transformations (Ogita, Rump and Oishi, Accurate sum and dot product, SIAM J.
 * Sci. Comput. 26, 2005): what a sum or a product in double loses is itself a double, found exactly
 * and added to a low part. The steps are those of ring_sums_pair_in.h, in the order of
 * ring_sums_kernel.h, where a term passes at most D additions (tp_ring_additions).
 * All numbers are integers below 2^250, so nothing underflows or overflows, and the transformations
 * are exact.
 *
 * Bound (w = 2^-53; the first-order terms are written, the second-order ones, w times smaller, are
 * within the last digit). The pair of a term is (x, y), |truth - x - y| <= z.
 *
 * 1. c = u v' - u' v. Products at most U V with errors at most w U V. High part s; the error of the
 *    difference at most w |s| <= 2.001 w U V, the difference of the two errors at most 2 w U V:
 *      low part |t| <= 4.01 w U V;     lost by two roundings, 2 w^2 and 4.01 w^2:  6.1 w^2 U V.
 * 2. (c' + c) u, vertex by vertex, c' of the edge before. High part |g| <= |s'| + |s|, low part
 *    |r| <= w (|s'| + |s|) + 8.02 w U V. Lost in g + r: both c, 12.2 w^2 U V; t' + t rounded,
 *    8.02 w^2 U V; r rounded, w |r|: together w^2 (28.3 U V + 1.01 (|s'| + |s|)). With the exact u:
 *      y = (error of u g) + u r,  |y| <= U w (2.01 (|s'| + |s|) + 8.03 U V);
 *      roundings of u r and of y: w^2 U (3.02 (|s'| + |s|) + 16.1 U V);
 *      z <= U w^2 (4.1 (|s'| + |s|) + 44.4 U V).
 *    Over the ring each |s| counts twice: with K = 2 U and M = sum |s|, sum |x| <= K M,
 *    sum |y| <= K w (2.01 M + 4.02 n U V) and sum z <= K w^2 (4.1 M + 22.2 n U V).
 * 3. q c for a form q, |q| <= K = 3 U^2, 3 V^2 or 6 U V. q = h + l; of the mixed form, in units of
 *    U V: products 1, 1, 2, 2, their errors 6 w in all; errors of the three sums 2, 4 and 6 w; so
 *    |l| <= 18.1 w = 3.02 w K. Roundings in l: 6, 12, 2, 4, 6 and 18.1, together 48.2 w^2 =
 *    8.1 w^2 K (doubling is exact). Of the squares, in units of U^2: errors of the products 3 w, of
 *    the sums 2 and 3 w, |l| <= 8.1 w = 2.7 w K, roundings 5 + 2 + 3 + 8.1 = 18.1 w^2 = 6.1 w^2 K.
 *    The larger values hold for all three. Then
 *      y = (error of h s) + (h t + l s),  |y| <= K w (4.04 |s| + 4.03 U V);
 *      lost: error of q, 8.2 w^2 K |s|; of c, 6.2 w^2 K U V; l t, 12.2 w^2 K U V; roundings of h t,
 *      l s, their sum and y, w^2 K (10.2 |s| + 12.1 U V):
 *      z <= K w^2 (18.5 |s| + 30.5 U V).
 *    So for every sum, K = 1, 2U, 2V, 3U^2, 3V^2, 6UV:  sum |x| <= 1.001 K M,
 *      sum |y| <= K w (4.04 M + 4.03 n U V),  sum z <= K w^2 (18.5 M + 30.5 n U V).
 * 4. Adding. At every addition the error of the high parts is at most w times the result, which is
 *    at most the sum of the |x| below it, so all errors together are at most 1.001 D w sum |x|.
 * They and the y go to low parts by at most 2 D additions each, which lose at most 2.001 D w (1.001
 * D w sum |x| + sum |y|).
 * 5. Together: K w^2 (M (2.01 D^2 + 8.1 D + 18.5) + n U V (8.1 D + 30.5))
 *           <= K w^2 (2.03 (D + 3)^2 M + 8.2 (D + 4) n U V), as D >= 4,
 *    M computed with relative error below D w, all with a margin of 1 %. The last addition of high
 *    and low is exact again. */

#include "block/ring_sums_kernel.h"

#include <float.h>

/* The same value, high part rounded to nearest. */
static tp_double_pair normalised(double high, double low) {
  const double sum = high + low, of_low = sum - high;
  return (tp_double_pair){sum, (high - (sum - of_low)) + (low - of_low)};
}

/* A sum from its two rows, and its bound from M and n U V, each times its factor. */
static inline void take_sum(tp_double_pair *sums, double *bounds, const double rows[TP_ROW_COUNT],
                            int sum, double added, double products) {
  const double unit = DBL_EPSILON / 2;
  const double scale = tp_ring_scale(sum, rows[TP_ROW_MOST_U], rows[TP_ROW_MOST_V]);
  sums[sum] = normalised(rows[TP_ROW_SUMS + 2 * sum], rows[TP_ROW_SUMS + 2 * sum + 1]);
  bounds[sum] = 1.01 * unit * unit * scale * (added + products);
}

void tp_ring_sums_compensated_first(tp_double_pair *sums, double *bounds, const double *u,
                                    const double *v, long count, tp_sums_plan plan) {
  double rows[TP_ROW_COUNT];
  tp_ring_rows(rows, &(tp_ring){u, v, count}, plan, true);

  const double most_u = rows[TP_ROW_MOST_U], most_v = rows[TP_ROW_MOST_V];
  const double additions = (double)tp_ring_additions(count);
  const double added = 2.03 * (additions + 3) * (additions + 3) * rows[TP_ROW_MEASURES];
  const double products = 8.2 * (additions + 4) * (double)count * most_u * most_v;
  take_sum(sums, bounds, rows, TP_A2, added, products);
  take_sum(sums, bounds, rows, TP_X6, added, products);
  take_sum(sums, bounds, rows, TP_Y6, added, products);
  if (plan.sum_count == TP_AREA_SUM_COUNT) return;
  take_sum(sums, bounds, rows, TP_XX12, added, products);
  take_sum(sums, bounds, rows, TP_YY12, added, products);
  take_sum(sums, bounds, rows, TP_XY24, added, products);
}

void tp_ring_sums_compensated(tp_double_pair sums[TP_SUM_COUNT], double bounds[TP_SUM_COUNT],
                              const double *u, const double *v, long count) {
  tp_ring_sums_compensated_first(sums, bounds, u, v, count,
                                 (tp_sums_plan){.sum_count = TP_SUM_COUNT});
}
