/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How a block begins to move in one mode under given loads: w = sum mu M r + sum lambda (-e), with
 * factors that are not negative. Of more than three generators every solution lies between those by
 * three of them.
 *
 * Under cohesion and bonds (motion/strength.h) what is fixed counts as a load; the shear of a line
 * that sticks, within its bounds, and the pulls on a facet that slides are further generators. A
 * pull adds friction, without bound, so that the least of a slide's accelerations says nothing:
 * there it is the greatest, with no more pull than balance needs. */

#ifndef TP_MOTION_ACCELERATIONS_H
#define TP_MOTION_ACCELERATIONS_H

#include "motion/motion.h"
#include "motion/start.h"

/* `strength` is that of the mode, over what the loads are over, or NULL. */
TP_MUST_USE tp_motion_outcome tp_start_find(tp_start *start, const tp_motion_question *question,
                                            const tp_motions *motions, const tp_motion_mode *mode,
                                            const tp_vector *loads, const tp_strength *strength);

#endif
