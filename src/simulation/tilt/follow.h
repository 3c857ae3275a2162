/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The motion of the block, to its end: after it began to move, of a release, under shaking. */

#ifndef TP_TILT_FOLLOW_H
#define TP_TILT_FOLLOW_H

#include "tilt/trial.h"

/* From rest at the tilt at which it began to move (the table goes on as it moved), or at that of
 * the release. Adds to the history, in time behind what it holds; says how it ended. */
TP_MUST_USE tp_status tp_tilting_follow(tp_tilting *tilting);

/* The mechanism by which a body moves: a translation slides, a turn about a point of the contact
 * topples, any other turn does both; within a hundredth of its extent, which is not proven. */
tp_mechanism tp_tilting_mechanism(tp_xy *centre, bool *has_centre, const tp_rigid_body *body,
                                  const tp_body_state *moving);

#endif
