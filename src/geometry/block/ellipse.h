/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A block whose section is an ellipse cut off by a flat that it rests on: a boulder.
 *
 * For geometry it stands as a polygon around it that touches it along the flat; its moments are
 * those of the ellipse itself, in closed form. With the half-axes 1 the flat is at -cos b, sin b =
 * flat / width, and the piece cut off has area b - sin b cos b,   first moment -2/3 sin^3 b, int
 * Y^2 = b/4 - sin 4b / 16,   int X^2 = b/4 - sin 2b / 6 + sin 4b / 48; the whole has area pi and
 * second moments pi / 4. Scaling by the half-axes gives the rest, and where it is turned so do the
 * moments about its centre: int (c x + s y)^2 = c^2 int x^2 + s^2 int y^2, and so on. */

#ifndef TP_BLOCK_ELLIPSE_H
#define TP_BLOCK_ELLIPSE_H

#include "block/ring_sums.h"
#include "plane/lattice.h"
#include "scene/scene.h"

/* The polygon around it, from the left end of the flat counter-clockwise. False when memory is
 * exhausted. */
TP_MUST_USE bool tp_ellipse_hull(tp_polyline *outline, const tp_ellipse *ellipse, tp_mark mark);

/* Boundary sums of the ellipse, in lattice units. */
void tp_ellipse_sums(arb_struct sums[TP_SUM_COUNT], const tp_ellipse *ellipse,
                     const tp_lattice *lattice, const fmpq_t metres_per_unit, long bits);

#endif
