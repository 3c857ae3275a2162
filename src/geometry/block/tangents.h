/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where rounding leaves an edge, exactly.
 *
 * With u and w the edges after and before a corner v of radius r, X = u x w and D = u . w, the
 * tangent points lie at l = r (|u| |w| + D) / X from v (l = r / tan(theta / 2)):
 *
 *     v + (r / X) (|w| + (D / |u|^2) |u|) u   and   v + (r / X) (|u| + (D / |w|^2) |w|) w.
 *
 * |u| and |w| are roots of whole numbers, so that every question about these points is the sign of
 * a sum of square roots (number/surd.h). */

#ifndef TP_BLOCK_TANGENTS_H
#define TP_BLOCK_TANGENTS_H

#include "block/corners.h"

/* A point of the rounded outline: of the lattice, or where rounding has cut off the outline there a
 * tangent point of that corner, on the edge after its vertex or before it. */
typedef struct tp_outline_point {
  long point;
  const tp_corner *cut; /* NULL: the point itself */
  bool after;
} tp_outline_point;

bool tp_outline_point_is_same(const tp_lattice *lattice, tp_outline_point a, tp_outline_point b);

/* Sign of (q - p) . (t1 - t0), t0 and t1 points of the lattice. */
int tp_outline_point_along(const tp_lattice *lattice, tp_outline_point p, tp_outline_point q,
                           long t0, long t1);

/* Sign of the distance of a point of the edge after a corner, or before it, from its vertex less
 * l: below zero where rounding has cut the point off. */
int tp_tangent_compare(const tp_corner *corner, bool after, const tp_lattice *lattice, long point);

/* Sign of the length of an edge less what the corners at its ends take up of it; either may be
 * NULL. */
int tp_tangents_room(const tp_corner *start, const tp_corner *end, const tp_lattice *lattice);

#endif
