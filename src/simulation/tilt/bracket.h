/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The critical angle between a tilt at which the block stands and one at which it begins to move,
 * both of them run. Where statics expects it the search begins, but a run decides. Between the two
 * it goes by halves: that a block stands below a tilt at which it stands, and begins to move above
 * one at which it does, is supposed; where it does not hold the bracket is one of several. */

#ifndef TP_TILT_BRACKET_H
#define TP_TILT_BRACKET_H

#include "tilt/trial.h"

/* Does the block stand at this tilt? What is known of its motion where it does not is kept: each
 * such tilt lies below the one before. */
typedef tp_status tp_tilt_look(tp_tilt_verdict *verdict, tp_tilting *tilting, double angle_deg);

/* By dynamics, into tilting->moves_off. */
TP_MUST_USE tp_status tp_tilting_look(tp_tilt_verdict *verdict, tp_tilting *tilting,
                                      double angle_deg);

/* Into tilting->own. `least_deg` and `most_deg` are where to look first, `last` the largest tilt.
 */
TP_MUST_USE tp_status tp_tilting_bracket(tp_tilting *tilting, tp_tilt_look *by, double least_deg,
                                         double most_deg, double last);

/* A ramp at the table's speed to the last tilt, and the bracket about its collapse by tables that
 * stop before it. What happens up to the collapse goes into the history. */
TP_MUST_USE tp_status tp_tilting_ramp(tp_tilting *tilting);

#endif
