/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The program of forces between blocks by a primal-dual interior point method with Mehrotra's
 * predictor and corrector (Mehrotra 1992), in doubles. The normal equations are as sparse as the
 * blocks touch each other, and factorised once a step. Nothing here is certain: its iterates,
 * forces above zero and twists that open every contact, are what assemblage/load_bracket.h proves a
 * bracket from. */

#ifndef TP_ASSEMBLAGE_INTERIOR_POINT_H
#define TP_ASSEMBLAGE_INTERIOR_POINT_H

#include "assemblage/force_program.h"

typedef struct tp_interior_start tp_interior_start; /* assemblage/interior_start.h */

typedef struct tp_interior_iterate {
  const double *forces; /* by column */
  double load;          /* s */
  const double *twists; /* by row: velocities of the blocks, of the collapse at the end */
  double gap;           /* of s, as it is here */
} tp_interior_iterate;

/* Called after each step; true: that is enough. */
typedef bool tp_interior_watch(void *context, const tp_interior_iterate *iterate);

/* Where a search begins: from points of programs of near states, among which this one is at `at`;
 * its own are kept there too. */
typedef struct tp_interior_from {
  tp_interior_start *start; /* NULL: from nothing, and none are kept */
  double at;
} tp_interior_from;

/* Step until the watch has enough, or no step gets any further. `began_near`: from such a point. */
TP_MUST_USE tp_status tp_interior_point(bool *began_near, const tp_force_program *program,
                                        const tp_interior_from *from, tp_interior_watch *watch,
                                        void *context, tp_message *message);

/* From forces above zero, which hold a lesser load, towards the centre of those that hold this one,
 * by Newton's method for the greatest product of all (Boyd and Vandenberghe 2004, section 10.3):
 * near the collapse more exact than the above, as the load is no unknown. The twists are zero. */
TP_MUST_USE tp_status tp_interior_centre(const tp_force_program *program, const double *forces,
                                         double load, tp_interior_watch *watch, void *context,
                                         tp_message *message);

#endif
