/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* From which starting positions a block comes to which end: basins, as intervals of its shift along
 * x from where its coordinates put it, over all shifts at which some part of it stands over the
 * profile.
 *
 * The block is settled exactly (rest/settle.h) at shifts no farther apart than a spacing: a basin
 * wider than it contains one of them, so none such is missed; one that is narrower may be. Between
 * neighbours that end differently the border is narrowed to 2^-TP_BASIN_BITS of the block's width:
 * the last shift that ends as the left basin does, and the first that ends as the right one. What
 * comes to light between them is a basin too. Shifts are tried first close on both sides of where a
 * vertex of the block lies over a point of the profile, or its centroid does, since the first
 * contact and the first turn change there; else in the middle. The work is bounded by
 * TP_BASIN_SETTLINGS; borders not narrowed by then stay as wide as they are, and say so. */

#ifndef TP_REST_BASINS_H
#define TP_REST_BASINS_H

#include "rest/endings.h"

enum { TP_BASIN_BITS = 40, TP_BASIN_SETTLINGS = 1 << 16 };

/* `first` and `last` lie in it, the farthest apart of all that were settled. */
typedef struct tp_basin_found {
  long ending;
  fmpq first, last;
} tp_basin_found;

typedef struct tp_basins {
  fmpq_t low, high; /* the shifts at which it stands over the profile */
  fmpq_t spacing;
  fmpq_t narrow; /* borders are as narrow as that */
  long settlings;
  tp_endings endings;
  long count, capacity;
  tp_basin_found *items; /* from left to right */
} tp_basins;

/* `settling` was set up; the last that it settled is arbitrary. On failure cleared. */
TP_MUST_USE tp_status tp_basins_find(tp_basins *basins, tp_settling *settling, tp_message *message);
void tp_basins_clear(tp_basins *basins);

/* From the border before a basin to that behind it: the middles of the shifts between which they
 * lie, and half of the widths of these. */
void tp_basins_border(fmpq_t middle, fmpq_t half, const tp_basins *basins, long before);

#endif
