/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a scene may cost: all budgets in one table, which docs/budgets.md explains.
 *
 * A few bytes can ask for any amount of work: rows and columns of a block in a drawing, a count of
 * teeth, a stiffness that makes steps of nanoseconds. So that no small input costs more than some
 * 10 s or 1 GB, work is counted in units that do not depend on the machine, before it is begun
 * where it can be told then and while it is done else, and what goes beyond its budget is refused
 * by the number that asked for it. Of what a file writes out in full its own size is the measure.
 */

#ifndef TP_COMMON_BUDGET_H
#define TP_COMMON_BUDGET_H

enum {
  /* Points that curves, and blocks inserted, make of a drawing; or one a byte of its file, where
   * that is more. Some 5 microseconds and 400 bytes each (format/drawing_work.c). */
  TP_BUDGET_DRAWN_POINTS = 500000,
  /* Bits of a number of nested transforms: products of what a drawing's groups and lists of
   * transforms say (format/drawing_work.c). */
  TP_BUDGET_TRANSFORM_BITS = 4096,
  /* Points of a profile that is made by rule, some 400 bytes each, and worn or rested several times
   * that; and teeth of a block or a base, of two points with their facets
   * (scene/rule_self_affine.c, scene/check.c). */
  TP_BUDGET_PROFILE_POINTS = 500000,
  TP_BUDGET_TEETH = 500000,
  /* Rows of one bolt, each a load of its own (scene/check.c). */
  TP_BUDGET_ROWS = 1000,
  /* Work of a block that is set down: pairs that are looked at, of which the exact numbers of a
   * pose make some take long; several times that for all poses (rest/settle.c, basins.c). */
  TP_BUDGET_REST_PAIRS = 30000000,
  /* Pairs that doubles cannot tell apart, 56 bytes each; and those of them of which doubles tell
   * nothing at all, of a block and a profile of sizes that no double holds together: each is looked
   * at in exact numbers of hundreds of bits, some 4 microseconds (rest/candidates.c). */
  TP_BUDGET_REST_CANDIDATES = 4000000,
  TP_BUDGET_REST_BLIND = 500000,
  /* Steps of all runs of one direction on contact springs, and on rigid contacts: some 0.1 and 2
   * microseconds for each contact (tilt/cost.c). */
  TP_BUDGET_SPRING_STEPS = 100000000,
  TP_BUDGET_RIGID_STEPS = 4000000,
  /* Pairs of corners and faces that may touch (rigid_contact/system.c). */
  TP_BUDGET_RIGID_PAIRS = 1000000
};

#endif
