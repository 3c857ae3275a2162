/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Points of a problem in the coordinates of its drawing, those that the scene is given in.
 *
 * A problem is solved along its mean plane, or level as the block lies (problem/world.h): its
 * points are turned. What a user is told of them are the coordinates of the drawing, turned back by
 * the inverse of the same exact numbers, so that a vertex comes back as it was given, to its last
 * digit. Components of forces and motions, arms and second moments stay along the axes of the
 * problem. */

#ifndef TP_PROBLEM_DRAWN_H
#define TP_PROBLEM_DRAWN_H

#include "problem/problem.h"

/* Do the two have the same coordinates? */
bool tp_drawn_is_same(const tp_problem *problem);

/* A point of the problem becomes that of the drawing, in scene lengths; in metres. */
void tp_drawn_point(fmpq_t x, fmpq_t y, const tp_problem *problem);
void tp_drawn_ball(arb_t x_m, arb_t y_m, const tp_problem *problem, long bits);

/* The direction of the problem's x in the drawing: its cosine and sine, which are those of an angle
 * but for a share of 1e-76; and the angle, counter-clockwise. */
void tp_drawn_axis(fmpq_t cosine, fmpq_t sine, const tp_problem *problem);
void tp_drawn_axis_degrees(arb_t degrees, const tp_problem *problem);

#endif
