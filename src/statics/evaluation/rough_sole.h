/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Roughness that is no strength. The facets of a digitised sole climb over each other, and a block
 * on its mated base gains by that what only rock would give it: where they come from the
 * digitising, or where the friction angle is that of the rough joint, it is not there. */

#ifndef TP_EVALUATION_ROUGH_SOLE_H
#define TP_EVALUATION_ROUGH_SOLE_H

#include "problem/problem.h"

/* Caution where a mated outline has asperities whose sides are shorter than half of the contact,
 * and what governs at the scene's tilt, or without one the limit, is larger than sliding with these
 * levelled into the mean plane. Of a solution that is complete. */
TP_MUST_USE tp_status tp_rough_sole_cautions(tp_notes *notes, const tp_solution *solution,
                                             const tp_problem *problem, tp_message *message);

#endif
