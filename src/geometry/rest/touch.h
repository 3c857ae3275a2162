/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A point in which the block touches its base: a vertex of one on an edge, or a vertex, of the
 * other; and whether it stops the block from turning about another point.
 *
 * Let the block turn by an angle phi about P, counter-clockwise for turn 1. Of a vertex Q of the
 * block on an edge of the base with the outward normal n, with r = Q - P and r' = (-r_y, r_x), the
 * height over the edge's line is
 *     f(phi) = n . r (cos phi - 1) + turn n . r' sin phi:
 * it presses where f' = turn n . r' < 0 at phi = 0, or f' = 0 and f'' = -n . r < 0. Of a vertex of
 * the base on an edge of the block the block turns the other way round it, so that the sign of the
 * first order changes with that of n, and that of the second does not. Two corners that touch press
 * where every line that parts them does; a corner in a notch where one of the notch's edges does.
 */

#ifndef TP_REST_TOUCH_H
#define TP_REST_TOUCH_H

#include "rest/bodies.h"

/* Vertices by their number; an edge by that of the vertex it begins in. Not both are edges. */
typedef struct tp_touch {
  long block, base;
  bool on_block_edge, on_base_edge;
} tp_touch;

typedef struct tp_touches {
  long count, capacity;
  tp_touch *items;
  long listed, slot_count; /* items that the table below has; its size, a power of two */
  long *slots;             /* by a hash of the item: its number and 1; 0: free */
} tp_touches;

void tp_touches_clear(tp_touches *touches);

/* A vertex of the block (of the base, for `of_base`) lies on an edge of the other: noted once, and
 * as a vertex on a vertex where it lies in the edge's end. */
TP_MUST_USE tp_status tp_touches_add(tp_touches *touches, const tp_bodies *bodies, bool of_base,
                                     long vertex, long edge, tp_message *message);

/* Where it is: borrowed, as tp_bodies_point. */
tp_exact_point tp_touch_point(const tp_bodies *bodies, const tp_touch *touch);
const fmpq *tp_touch_x(const tp_bodies *bodies, const tp_touch *touch);
const fmpq *tp_touch_y(const tp_bodies *bodies, const tp_touch *touch);

/* Does it lie in the same point as another? */
bool tp_touch_is_in(const tp_bodies *bodies, const tp_touch *touch, const tp_touch *other);

/* Does it stop a turn, 1 or -1, about the point of another? */
bool tp_touch_stops(const tp_bodies *bodies, const tp_touch *touch, const tp_touch *about,
                    int turn);

#endif
