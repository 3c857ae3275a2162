/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Growing list of facets, the common point of two edges that touch, and the side of a point along a
 * facet's direction by the sign of a dot product. */

#include "base/facets.h"

#include "common/grow.h"

#include <stdlib.h>

bool tp_facets_append(tp_facets *facets, tp_facet facet) {
  tp_facet *more = tp_grow(facets->items, facets->count, &facets->capacity, sizeof *more);
  if (more == NULL) return false;
  facets->items = more;
  facets->items[facets->count++] = facet;
  return true;
}

void tp_facets_clear(tp_facets *facets) {
  for (long k = 0; k < facets->count; k++) free(facets->items[k].rounding);
  free(facets->items);
  *facets = (tp_facets){.count = 0};
}

/* A lattice has no more points than an int32_t counts. */
tp_facet tp_facet_of(long q0, long q1, long t0, long t1, long base_edge) {
  return (tp_facet){.q0 = (int32_t)q0,
                    .q1 = (int32_t)q1,
                    .t0 = (int32_t)t0,
                    .t1 = (int32_t)t1,
                    .base_edge = (int32_t)base_edge};
}

static bool is_on(const tp_lattice *l, long point, long from, long to) {
  return tp_lattice_cross(l, from, to, from, point) == 0 &&
         tp_lattice_dot(l, from, point, from, to) >= 0 &&
         tp_lattice_dot(l, to, point, to, from) >= 0;
}

long tp_facet_touch(const tp_lattice *l, long a0, long a1, long b0, long b1) {
  if (is_on(l, a0, b0, b1)) return a0;
  if (is_on(l, a1, b0, b1)) return a1;
  return is_on(l, b0, a0, a1) ? b0 : b1;
}

tp_outline_point tp_facet_begin(const tp_facet *facet) {
  return (tp_outline_point){facet->q0, facet->rounding != NULL ? facet->rounding->cut0 : NULL,
                            true};
}

tp_outline_point tp_facet_end(const tp_facet *facet) {
  if (facet->q0 == facet->q1) return tp_facet_begin(facet);
  return (tp_outline_point){facet->q1, facet->rounding != NULL ? facet->rounding->cut1 : NULL,
                            false};
}

int tp_facet_contacts(tp_outline_point points[2], const tp_facet *facet) {
  points[0] = tp_facet_begin(facet);
  points[1] = tp_facet_end(facet);
  return facet->t0 == facet->t1 ? 0 : facet->q0 == facet->q1 ? 1 : 2;
}

bool tp_facet_ends_in(const tp_lattice *lattice, const tp_facet *facet, tp_outline_point point) {
  return tp_outline_point_is_same(lattice, tp_facet_begin(facet), point) ||
         tp_outline_point_is_same(lattice, tp_facet_end(facet), point);
}

int tp_facet_side(const tp_lattice *lattice, const tp_facet *facet, tp_outline_point p,
                  tp_outline_point q) {
  if (p.cut == NULL && q.cut == NULL) {
    return tp_lattice_dot(lattice, p.point, q.point, facet->t0, facet->t1);
  }
  return tp_outline_point_along(lattice, p, q, facet->t0, facet->t1);
}
