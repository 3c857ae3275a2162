/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How the block of a scene lies before statics: shifted along its mated base, set down until it
 * rests, and what is near its profile taken for touching it, where the scene asks for that; and
 * turned into the frame of its base, where its coordinates are those of the world. A mated base has
 * its mean plane before the block is shifted along that, and other blocks as they rest. */

#ifndef TP_PROBLEM_LAY_H
#define TP_PROBLEM_LAY_H

#include "problem/jointed.h"
#include "problem/rested.h"
#include "problem/smoothed.h"
#include "problem/snapped.h"
#include "problem/world.h"

/* `*scene` is from then on the one that lies so; what was made for it are `*smoothed`,
 * `*jointed`, `*rested`, `*snapped` and `*world`, which stay as they are where nothing was, and are
 * the caller's to free also on failure. Rest and turn limit the digits that can be asked for. */
TP_MUST_USE tp_status tp_lay(const tp_scene **scene, tp_smoothed **smoothed, tp_jointed **jointed,
                             tp_rested **rested, tp_snapped **snapped, tp_world **world,
                             const tp_solve_options *options, tp_solution *solution,
                             tp_message *message);

#endif
