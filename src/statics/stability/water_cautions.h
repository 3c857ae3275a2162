/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What is said of water that is sited: what its scene leaves open, and where it stands above the
 * block or below it. */

#ifndef TP_STABILITY_WATER_CAUTIONS_H
#define TP_STABILITY_WATER_CAUTIONS_H

#include "common/notes.h"
#include "problem/problem.h"

TP_MUST_USE tp_status tp_water_cautions(tp_notes *notes, const tp_problem *problem,
                                        tp_message *message);

/* Of any water that lifts a block which goes left or right: heel and toe of its base joint, the
 * pressures there and its length; and a caution where a `height` leaves an open gap before them. */
TP_MUST_USE tp_status tp_water_note_joint(tp_notes *notes, const tp_problem *problem, bool left,
                                          tp_message *message);

#endif
