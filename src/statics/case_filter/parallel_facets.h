/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Facets of an underside in doubles that are parallel exactly, as those of teeth of one size are.
 *
 * Of points on parallel facets that both edges of the friction cone, and so the normal, have
 * ordered alike by their moments, one between two others adds nothing: each of its edges is a mean
 * of theirs. No force that it bears, and no motion that it allows, is another for it, and where it
 * stays closed the other two do. */

#ifndef TP_CASE_FILTER_PARALLEL_FACETS_H
#define TP_CASE_FILTER_PARALLEL_FACETS_H

#include "case_filter/shape.h"

/* What is known of a block: its underside from its left end to its right one, which runs to the
 * right throughout and may be turned about at the end that is down-dip. */
typedef struct tp_block_underside {
  const double *x, *y;
  int count;                      /* of vertices */
  double origin_x, origin_y;      /* a point near by, exactly */
  tp_near centroid_x, centroid_y; /* from that point */
  tp_near gyration;               /* square of its radius */
} tp_block_underside;

/* a - b, with no error where it is exact. */
static inline tp_near tp_exact_difference(double a, double b) {
  const double rounded = a - b, back = rounded - a;
  const double rest = (a - (rounded - back)) - (b + back);
  if (rest == 0 && isfinite(rounded)) return (tp_near){rounded, 0};
  return tp_near_sub((tp_near){a, 0}, (tp_near){b, 0});
}

/* Is a b = c d, of numbers without error? False where one has some. */
bool tp_exact_products_equal(tp_near a, tp_near b, tp_near c, tp_near d);

/* Of the directions of their facets; zero of those that are certainly parallel. */
static inline tp_near tp_facets_cross(const tp_shape_point *a, const tp_shape_point *b) {
  const tp_near cross = tp_near_minus(tp_near_times(a->tx, b->ty), tp_near_times(a->ty, b->tx));
  const bool parallel =
      tp_near_sign(cross) == 0 && tp_exact_products_equal(a->tx, b->ty, a->ty, b->tx);
  return parallel ? (tp_near){0, 0} : cross;
}

/* Along a facet of the underside, from its left end: exactly so where differences are. */
static inline void tp_facet_direction(tp_shape_point *p, const tp_block_underside *u, int facet) {
  p->tx = tp_exact_difference(u->x[facet + 1], u->x[facet]);
  p->ty = tp_exact_difference(u->y[facet + 1], u->y[facet]);
}

/* Does a point, an end of facet point / 2, lie between two of those on facets parallel to its own,
 * for certain, by both edges of its friction cone? With tan(phi). */
bool tp_point_lies_between(const tp_block_underside *underside, int point, const int *others,
                           int count, double friction);

#endif
