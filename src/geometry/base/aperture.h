/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How open a joint is: the gap between the underside of a block and the profile below it, along y.
 *
 * Both are chains of straight edges, so that the gap is linear in x over each piece that an edge of
 * the underside shares with one of the profile. Gaps at the ends of pieces are exact rationals, and
 * so is which of them lie within the closure; sums over pieces, whose denominators have nothing in
 * common, are balls. Edges that run back, above the block's own overhang, count for the length of
 * the underside, and for no gap. */

#ifndef TP_BASE_APERTURE_H
#define TP_BASE_APERTURE_H

#include "plane/polyline.h"

#include <arb.h>

typedef struct tp_aperture {
  fmpq_t largest; /* of all gaps */
  arb_t length;   /* of the underside: the sum of |dx| of its edges */
  arb_t covered;  /* of what of it lies above the profile */
  arb_t area;     /* of the gap there */
  arb_t matched;  /* of that where the gap is the closure or less */
} tp_aperture;

void tp_aperture_init(tp_aperture *aperture);
void tp_aperture_clear(tp_aperture *aperture);

/* Of `count` edges of the outline, counter-clockwise from the vertex `first`, over the first
 * `points` of a chain that runs from left to right; `bits` are those of the balls. */
void tp_aperture_measure(tp_aperture *aperture, const tp_polyline *outline, long first, long count,
                         const tp_polyline *profile, long points, const fmpq_t closure, long bits);

#endif
