/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How the block of a scene lies before statics: shifted along its mated base, set down until it
 * rests, and what is near its profile taken for touching it, where the scene asks for that; and
 * turned into the frame of its base, where its coordinates are those of the world. A mated base has
 * its mean plane before the block is shifted along that, and other blocks as they rest. */

#ifndef TP_PROBLEM_PLACEMENT_H
#define TP_PROBLEM_PLACEMENT_H

#include "problem/jointed.h"
#include "problem/rested.h"
#include "problem/smoothed.h"
#include "problem/snapped.h"
#include "problem/world.h"

/* What was done to the scene so that its block lies in its place, a step each, with what a report
 * says of it; NULL where the scene does not ask for it. */
typedef struct tp_placement {
  tp_smoothed *smoothed; /* its sole was levelled */
  tp_jointed *jointed;   /* the block was shifted along its mated base */
  tp_rested *rested;     /* it was set down on its profile */
  tp_snapped *snapped;   /* what lies near its contact was moved there */
  tp_world *world;       /* the scene lies as it lies: it was turned into the frame of its base */
} tp_placement;

/* Into an empty placement; `*scene` is from then on the one that lies so, borrowed from it. On
 * failure too it is the caller's to clear. Rest and turn limit the digits that can be asked for. */
TP_MUST_USE tp_status tp_placement_init(tp_placement *placement, const tp_scene **scene,
                                        const tp_solve_options *options, tp_solution *solution,
                                        tp_message *message);
void tp_placement_clear(tp_placement *placement);

#endif
