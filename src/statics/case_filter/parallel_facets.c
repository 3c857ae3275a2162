/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What rounding has left of a difference or of a product of doubles is a double itself (Knuth,
 * Dekker), so that two products are told equal by both parts. */

#include "case_filter/parallel_facets.h"

#include <math.h>

/* None of them so small that the rest of a product is none. */
bool tp_exact_products_equal(tp_near a, tp_near b, tp_near c, tp_near d) {
  static const double least = 1e-200;
  const double one = a.value * b.value, other = c.value * d.value;
  return a.error == 0 && b.error == 0 && c.error == 0 && d.error == 0 && one == other &&
         fabs(one) > least && isfinite(one) &&
         fma(a.value, b.value, -one) == fma(c.value, d.value, -other);
}

/* By how much more the moment of an edge n + f t is at another point: 1, -1, or open. */
static int order_of(const tp_block_underside *u, int point, int other, const tp_shape_point *t,
                    tp_near f) {
  const int at = point / 2 + point % 2, to = other / 2 + other % 2;
  const tp_near dx = tp_exact_difference(u->x[to], u->x[at]);
  const tp_near dy = tp_exact_difference(u->y[to], u->y[at]);
  const tp_near ex = tp_near_minus(tp_near_times(f, t->tx), t->ty);
  const tp_near ey = tp_near_plus(tp_near_times(f, t->ty), t->tx);
  return tp_near_sign(tp_near_minus(tp_near_times(dx, ey), tp_near_times(dy, ex)));
}

bool tp_point_lies_between(const tp_block_underside *u, int point, const int *others, int count,
                           double friction) {
  static const double apart = 1e-14; /* tan(phi) is closer than this share of it */
  const tp_near f = {friction, apart * friction};
  bool below = false, above = false;
  tp_shape_point own;
  tp_facet_direction(&own, u, point / 2);
  for (int k = 0; k < count; k++) {
    tp_shape_point other;
    tp_facet_direction(&other, u, others[k] / 2);
    if (!tp_near_is_zero(tp_facets_cross(&own, &other))) continue;
    const int order = order_of(u, point, others[k], &own, f);
    if (order == 0 || order_of(u, point, others[k], &own, tp_near_neg(f)) != order) continue;
    below = below || order < 0;
    above = above || order > 0;
  }
  return below && above;
}
