/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Points that lie on edges of an outline whose vertices are moved: they go with their edge, at the
 * share of it at which they lie. */

#ifndef TP_PROBLEM_WITH_OUTLINE_H
#define TP_PROBLEM_WITH_OUTLINE_H

#include "plane/polyline.h"

typedef struct tp_moved_outline {
  const tp_polyline *before, *now; /* the same vertices */
} tp_moved_outline;

/* The move of a tp_point_map (scene/moved.h); `context` is a tp_moved_outline. */
void tp_move_with_outline(fmpq_t x, fmpq_t y, const void *context);

#endif
