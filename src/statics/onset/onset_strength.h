/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The factor of safety of the onset, by a change of all strength (motion/strength_change.h). */

#ifndef TP_ONSET_ONSET_STRENGTH_H
#define TP_ONSET_ONSET_STRENGTH_H

#include "onset/onset_question.h"
#include "onset/onset_result.h"

/* Is it asked for, so that the motions have to keep all modes? */
bool tp_onset_asks_strength(const tp_evaluation *evaluation);

/* Fills in that of the case at a tilt in degrees, once its limit is told; `can_begin`: a motion, by
 * some mode. What is open, or too dear, is left undecided. */
TP_MUST_USE tp_motion_outcome tp_onset_strength(const tp_onset_telling *telling,
                                                tp_onset_asked *asked, const arb_t tilt,
                                                bool can_begin);

#endif
