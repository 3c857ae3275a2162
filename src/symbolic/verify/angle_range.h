/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Ranges of angle formulas over the domain of a claim. */

#ifndef TP_VERIFY_ANGLE_RANGE_H
#define TP_VERIFY_ANGLE_RANGE_H

#include "verify/question.h"

/* Do two angles of equal tangents have to be equal, by their ranges over the domain? */
bool tp_angles_in_reach(const tp_question *question);

/* The quadrant of a direction at a sample, 1 to 4; 0 where it is not known. */
int tp_direction_quadrant(const tp_name *name, const tp_claim_sample *sample, tp_subject *subject);

#endif
